# SPDX-License-Identifier: MIT
"""From the Markdown of docs/ to scdoc: what manual pages are made of, so that nothing is written twice.

Known is what docs/ uses: headings, paragraphs, bullets, numbered lists, tables, fenced and indented code, and in lines code, strong, emphasis and links.
"""
import re

INLINE = re.compile(r"`([^`]+)`|\*\*(.+?)\*\*|(?<![\w*])\*([^*\s](?:[^*]*[^*\s])?)\*(?![\w*])|!?\[((?:[^]`]|`[^`]*`)*)\]\(([^)\s]*)\)")


def escape(text):
    """Plain text: nothing in it formats."""
    text = re.sub(r"([\\*_+<`\[\]#|~])", r"\\\1", text)
    return re.sub(r"^([-.':])", r"\\\1", text) if re.match(r"[-:]", text) else text


def inline(text, link=lambda target: None):
    """One line of text. `link` gives what stands for a link, or None: its words."""
    def one(match):
        code, strong, emphasis, words, target = match.groups()
        if code is not None:
            return f"*{escape(code)}*"
        if strong is not None:
            return f"*{escape(strong.replace('`', ''))}*"
        if emphasis is not None:
            return f"_{escape(emphasis)}_"
        return link(target) or inline(words, link)

    pieces, at = [], 0
    for match in INLINE.finditer(text):
        pieces += [escape(text[at:match.start()]), one(match)]
        at = match.end()
    return "".join(pieces + [escape(text[at:])])


def cells(line):
    return [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))]


def blocks(text):
    """(kind, lines) for each block: heading, code, table, item, paragraph."""
    lines, at, found = text.splitlines(), 0, []
    while at < len(lines):
        line, begin = lines[at], at
        if not line.strip():
            at += 1
            continue
        if line.startswith("```"):
            at += 1
            while not lines[at].startswith("```"):
                at += 1
            at += 1
            found.append(("code", lines[begin + 1:at - 1]))
            continue
        if line.startswith("    "):
            while at < len(lines) and (lines[at].startswith("    ") or not lines[at].strip()):
                at += 1
            found.append(("code", "\n".join(line[4:] for line in lines[begin:at]).rstrip("\n").split("\n")))
            continue
        if line.startswith("#"):
            found.append(("heading", [line]))
            at += 1
            continue
        kind = "table" if line.startswith("|") else "item" if re.match(r"- |\d+\. ", line) else "paragraph"
        at += 1
        while at < len(lines) and lines[at].strip() and not re.match(r"```|#", lines[at]):
            if (kind == "table") != lines[at].startswith("|") or re.match(r"- |\d+\. ", lines[at]):
                break
            at += 1
        found.append((kind, lines[begin:at]))
    return found


def _table(lines, link):
    """Two columns are a list of terms; more are a table."""
    rows = [cells(line) for line in lines if not re.fullmatch(r"[|\s:-]+", line)]
    head, rows = rows[0], rows[1:]
    if len(head) == 2:
        return "\n".join(f"{inline(row[0], link)}\n\t{inline(row[1], link)}\n" for row in rows)
    written = []
    for number, row in enumerate([head] * any(head) + rows):
        marks = ["["] * (len(row) - 1) + ["<"]
        for column, cell in enumerate(row):
            shown = inline(cell, link) or "\\ "
            shown = f"*{escape(cell)}*" if number == 0 and any(head) and cell else shown
            written.append(f"{'|' if column == 0 else ':'}{marks[column]} {shown}")
    return "\n".join(written) + "\n"


def render(kind, lines, link=lambda target: None):
    """One block as scdoc, with an empty line behind it."""
    if kind == "code":
        return "```\n" + "\n".join(lines) + "\n```\n"
    if kind == "table":
        return _table(lines, link)
    if kind == "heading":
        depth, _, words = lines[0].partition(" ")
        words = re.sub(r"[`*]", "", words)
        return f"# {words.upper()}\n" if len(depth) <= 2 else f"## {words}\n"
    text = " ".join(line.strip() for line in lines)
    if kind == "item":
        bullet, _, text = text.partition(" ")
        return f"{'-' if bullet == '-' else '.'} {inline(text, link)}\n"
    return inline(text, link) + "\n"


def convert(text, link=lambda target: None):
    """A whole text. Items of one list follow each other without an empty line."""
    found, written = blocks(text), []
    for number, (kind, lines) in enumerate(found):
        written.append(render(kind, lines, link))
        if kind != "item" or number + 1 == len(found) or found[number + 1][0] != "item":
            written.append("\n")
    return "".join(written)
