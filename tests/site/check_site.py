#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check the site that `make docs` made: every link inside it leads somewhere, every page of the checkout is in it, and no markup shows.

    check_site.py DIRECTORY OF THE HTML
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools" / "docs"))
import pages  # noqa: E402

# What a page shows as text when Doxygen did not understand it: a command of its own, a Markdown link, a fence.
MARKUP = re.compile(r"[@\\](?:ref|subpage|anchor|param|return)\b|\]\([\w./#-]+\)|```|\{#\w+")
# What it shows when something was written for HTML that Doxygen took for text.
ESCAPED = re.compile(r"&(?:#\d+|lt|gt|amp|quot);|</?(?:code|a|img)\b")

TITLE = re.compile(r'^ *\[ "[^"]*\\\\[^"]*", "docs_.*', re.M)


class Reader(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.text, self.all, self.quoted, self.script = [], set(), [], [], 0, 0
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors |= {values[key] for key in ("id", "name") if values.get(key)}
        self.links += [values[key] for key in ("href", "src") if values.get(key)]
        self.script += tag in ("script", "style")
        self.quoted += tag in ("script", "style", "pre", "code")

    def handle_endtag(self, tag):
        self.script -= tag in ("script", "style")
        self.quoted -= tag in ("script", "style", "pre", "code")

    def handle_data(self, data):
        if self.script <= 0:
            self.all.append(data)
        if self.quoted <= 0:
            self.text.append(data)


def site_pages(folder):
    return {p.name: Reader(p.read_text(encoding="utf-8")) for p in sorted(folder.glob("*.html"))}


def problem(folder, found, page, link):
    if re.match(r"[a-z]+:", link):
        return None
    target, _, anchor = urllib.parse.unquote(link).partition("#")
    if not target:
        target = page
    if not (folder / target).is_file():
        return f"{link}: no such file"
    if anchor and target in found and anchor not in found[target].anchors:
        return f"{link}: no such place"
    return None


def say(problems, name):
    print(f"not ok site: {name}\n    " + "\n    ".join(problems[:20]) if problems else f"ok site: {name}")
    return not problems


def missing(folder):
    names = {"mainpage": "index", "docs_math": "docs_math"}
    wanted = {path: names.get(pages.page_name(path), pages.page_name(path)) for path in pages.pages()}
    return [path for path, name in wanted.items() if not (folder / f"{re.sub('_', '__', name) if name != 'index' else name}.html").is_file()
            and not (folder / f"{name}.html").is_file()]


def main(folder):
    found = site_pages(folder)
    links = [(page, link) for page, reader in found.items() for link in reader.links]
    broken = [f"{page}: {wrong}" for page, link in links if (wrong := problem(folder, found, page, link))]
    shown = [f"{page}: {match[0]}" for page, reader in found.items() for match in [MARKUP.search(" ".join(reader.text))] if match]
    shown += [f"{page}: {match[0]}" for page, reader in found.items() for match in [ESCAPED.search("".join(reader.all))] if match]
    # The tree at the left shows titles as they are written.
    shown += [f"{p.name}: {match[0]}" for p in folder.glob("*.js") for match in [TITLE.search(p.read_text(encoding="utf-8"))] if match]
    fine = say(missing(folder), f"{len(pages.pages())} pages of the checkout are in it")
    fine &= say(broken if links else ["no links at all"], f"{len(links)} links of {len(found)} pages lead somewhere")
    fine &= say(shown, "no markup shows")
    return int(not fine)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
