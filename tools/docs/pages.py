#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Make the Markdown pages ready for Doxygen, or what they link to ready for the site.

    pages.py pages DIRECTORY    write the pages there, with names and links that Doxygen follows
    pages.py files DIRECTORY    copy the files of the checkout that pages link to there, below files/

The pages are written for people who read them in the checkout: links are paths, anchors are made from headings. Here each heading gets a name,
and a link to it that name. A file that is no page is copied, and linked as it is.
"""
import html
import os
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))
import check_links  # noqa: E402  (one notion of an anchor for both)

ORDER = ("guide cookbook cli python ffi embedding format math sampler oracles numerics testing results packaging").split()
MARKUP = re.compile(r"(?P<fence>^(?P<f>```|~~~).*?^(?P=f)[ ]*$)|(?P<indented>(?:^    [^\n]*\n|^\n(?=    ))+)|(?P<code>`+)(?P<inner>(?:(?!\n\n).)+?)(?P=code)|(?P<comment><!--.*?-->\n?)"
                    r"|(?P<image>!\[(?P<alt>[^\]]*)\]\((?P<picture>[^)\s]+)\))|(?P<img><img[^>]*>)"
                    r"|(?P<link>\[(?P<text>(?:[^\[\]`]|`[^`]*`)*)\]\((?P<target>[^)\s]+)\))|(?P<heading>^(?P<level>#{1,6})[ ]+(?P<title>.*?)[ ]*$)"
                    r"|(?P<special>[@\\]|(?<![\w&])#(?=\w)|%(?=\w)|<(?!/?(?:sub|sup|br|details|summary)\b))", re.M | re.S)


def pages():
    """Paths of all pages in the order of the site, relative to the checkout."""
    docs = [f"docs/{name}.md" for name in ORDER]
    rest = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "docs").glob("*.md") if str(p.relative_to(ROOT)) not in docs)
    chapters = (ROOT / "docs/math.md").read_text(encoding="utf-8")
    math = sorted((ROOT / "docs/math").glob("*.md"), key=lambda p: (chapters.find(f"math/{p.name}"), p.name))
    below = [str(p.relative_to(ROOT)) for p in [*math, *sorted((ROOT / "docs/decisions").glob("*.md"))]]
    return ["README.md", *docs, *rest, *below]


def page_name(path):
    return "mainpage" if path == "README.md" else re.sub(r"\W", "_", path[:-3])


def anchor_of(path, anchor):
    return f"{page_name(path)}-{anchor}"


def slug(title, seen):
    """As check_links.anchors() makes them."""
    name = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
    count = seen.get(name, 0)
    seen[name] = count + 1
    return f"{name}-{count}" if count else name


class Page:
    def __init__(self, path):
        self.path, self.seen, self.linked, self.titled = path, {}, set(), False
        self.all = pages()

    def resolve(self, target):
        """The path in the checkout that a relative link names."""
        return os.path.relpath(os.path.normpath(ROOT / pathlib.Path(self.path).parent / target), ROOT)

    def link(self, text, target):
        if re.match(r"[a-z]+:", target):
            return f"[{text}]({target})"
        file, _, anchor = target.partition("#")
        path = self.resolve(file) if file else self.path
        if path in self.all:
            name = anchor_of(path, anchor) if anchor else page_name(path)
            plain = re.sub(r"[`\"]", "", text)
            return f'@ref {"index" if name == "mainpage" else name} "{plain}"'
        if path in ("docs/math", "docs/decisions"):
            return f'@ref {"docs_math" if path == "docs/math" else "docs_decisions"} "{re.sub("[`]", "", text)}"'
        inside = re.sub(r"`([^`]*)`", lambda m: code(m[1]), text)
        if re.fullmatch(r"include/tdsp/\w+\.h", path):
            return f'<a href="{header_page(path)}">{inside}</a>'
        self.linked.add(path)
        return f'<a href="files/{path}{"/index.html" if (ROOT / path).is_dir() else ""}">{inside}</a>'

    def picture(self, source, alt):
        path = self.resolve(source)
        self.linked.add(path)
        return f'<img src="files/{path}" alt="{html.escape(alt)}" class="picture"/>'

    def heading(self, level, title):
        name = anchor_of(self.path, slug(title, self.seen))
        text = re.sub(r"[@\\]", r"\\\g<0>", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title))
        if not self.titled:
            self.titled = True
            text = re.sub(r"^(\d+)\.", r"\1 ·", text)  # a title, not the first item of a list
            return f"# {text} {{#{page_name(self.path)}}}\n\n@anchor {name}\n"
        return f"{level} {text} {{#{name}}}"

    def replace(self, m):
        if m["fence"]:
            return re.sub(r"^```(\w+)[^\n]*", lambda k: "```" + {"console": "", "sh": "", "c": "{.c}", "cpp": "{.cpp}", "python": "{.py}"}.get(k[1], ""), m["fence"])
        if m["indented"]:
            return m["indented"]
        if m["code"]:
            return code(m["inner"])
        if m["comment"]:
            return ""
        if m["image"]:
            return self.picture(m["picture"], m["alt"])
        if m["img"]:
            return self.picture(re.search(r'src="([^"]*)"', m["img"])[1], (re.search(r'alt="([^"]*)"', m["img"]) or ["", ""])[1])
        if m["link"]:
            return self.link(m["text"], m["target"])
        if m["heading"]:
            return self.heading(m["level"], m["title"])
        return {"<": "&lt;", "%": "%%"}.get(m["special"], "\\" + m["special"])

    def converted(self):
        return MARKUP.sub(self.replace, (ROOT / self.path).read_text(encoding="utf-8"))


def code(text):
    """Code in a line: between two backticks, in which a quotation mark ends nothing; a bar in a table, which has to be escaped there, as HTML."""
    if r"\|" in text:
        return f"<code>{html.escape(text.strip(), quote=False)}</code>"
    return f"``{text.strip()}``"


def header_page(path):
    return re.sub(r"_", "__", pathlib.Path(path).name.replace(".h", "_8h.html")).replace("__8h", "_8h")


def decisions():
    rows = [f"- @subpage {page_name(path)}" for path in pages() if path.startswith("docs/decisions/")]
    return "# Decisions {#docs_decisions}\n\nWhat was decided, why, and its price.\n\n" + "\n".join(rows) + "\n"


def contents(path):
    """What hangs below a page in the tree at the left."""
    if path == "docs/README.md":
        below = [p for p in pages() if re.fullmatch(r"docs/\w+\.md", p) and p != path]
        names = [page_name(p) for p in below] + ["docs_decisions"]
    elif path == "docs/math.md":
        names = [page_name(p) for p in pages() if p.startswith("docs/math/")]
    else:
        return ""
    return "\n\n## Pages {#" + page_name(path) + "-pages-of-the-site}\n\n" + "\n".join(f"- @subpage {name}" for name in names) + "\n"


def write_pages(out):
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for number, path in enumerate(pages()):
        (out / f"{number:02}-{page_name(path)}.md").write_text(Page(path).converted() + contents(path), encoding="utf-8")
    (out / "99-decisions.md").write_text(decisions(), encoding="utf-8")


def listing(folder, path):
    """An index of a folder's files, for who opens it."""
    names = sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file() and p.name != "index.html")
    rows = "\n".join(f'<li><a href="{html.escape(n)}">{html.escape(n)}</a></li>' for n in names)
    return f'<!DOCTYPE html>\n<meta charset="utf-8"><title>{html.escape(path)}</title>\n<h1>{html.escape(path)}</h1>\n<ul>\n{rows}\n</ul>\n'


def write_files(out):
    linked = set()
    for path in pages():
        page = Page(path)
        page.converted()
        linked |= page.linked
    for path in sorted(linked):
        source, target = ROOT / path, out / "files" / path
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__", "node_modules", "target"))
        else:
            shutil.copyfile(source, target)
    for path in sorted(p for p in linked if (ROOT / p).is_dir()):
        (out / "files" / path / "index.html").write_text(listing(out / "files" / path, path), encoding="utf-8")


if __name__ == "__main__":
    {"pages": write_pages, "files": write_files}[sys.argv[1]](pathlib.Path(sys.argv[2]))
