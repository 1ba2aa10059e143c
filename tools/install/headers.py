# SPDX-License-Identifier: MIT
"""The public headers as text: what each is for, and each declaration with its comment."""
import dataclasses
import re

COMMENT = r"/\*\*?(?P<comment>(?:(?!\*/).)*)\*/\n"
# A declaration reaches to an empty line, to a comment in the first column, or to what ends the header.
DECLARATION = re.compile(rf"(?:{COMMENT})?^(?P<code>(?:TDSP_API|typedef|#define TDSP_\w+ )(?:(?!\n\n|\n/\*|\n#endif|\n#ifdef).)*)", re.S | re.M)


@dataclasses.dataclass(frozen=True)
class Declaration:
    comment: str
    code: str

    def shown(self):
        """The code, without the members of a type whose members are nobody's business."""
        name = re.match(r"typedef struct (\w+) \{", self.code)
        return f"typedef struct {name[1]} {name[1]};" if name and "rivate" in self.comment else self.code


def _plain(comment):
    """A comment's text without its stars."""
    return "\n".join(re.sub(r"^\s*\* ?", "", line).rstrip() for line in (comment or "").strip().splitlines())


def purpose(text):
    """The comment that a header opens with, behind that of its licence."""
    comments = re.finditer(COMMENT, text.partition("#ifndef")[0], re.S)
    return next(_plain(found["comment"]) for found in comments if "SPDX" not in found["comment"])


def declarations(text):
    behind_guard = text[text.index("#define") :].partition("\n")[2]
    return [Declaration(_plain(found["comment"]), found["code"]) for found in DECLARATION.finditer(behind_guard)]


def functions(text):
    """All names that a header exports, in its order."""
    return re.findall(r"^TDSP_API [^(;]*?\b(tdsp_\w+)\(", text, re.M)
