#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page as one file: inline.py PAGE_DIRECTORY WASM OUTPUT

index.html of the directory with everything it needs inside, so that it runs from file:// as from any server:
- modules, those that js/app.js reaches: data: URLs in the import map, one each. They import each other as "tdsp/NAME" or "./NAME", which is the same;
- the worker: its modules joined to one plain script, for a worker knows no import map;
- style sheets; the WebAssembly module (gzip, base64); gallery/gallery.json, each scene of it, named by its path from the root of the repository, in the place of its name.
What cannot be taken inside is an error that names it: a page that fetches something is not one file.
"""
import base64
import gzip
import json
import os
import pathlib
import re
import sys

START = "app.js"
WORKER = "worker.js"
CARRIED = {"inlined.js": "inlined_page.js"}
IMPORT = re.compile(r'''(\bfrom\s*|\bimport\s*\(?\s*)(["'])(?:tdsp|\.)/([\w.-]+)\2''')
STATEMENT = re.compile(r'^import\b[^;]*;[^\S\n]*\n', re.M)
EXPORTED = re.compile(r'^export\s+(?:\{[^}]*\};[^\S\n]*\n)?', re.M)
TOP_LEVEL = re.compile(r'^(?:async )?(?:const|let|var|class|function) (\w+)', re.M)
COMMENT = re.compile(r'/\*.*?\*/|^\s*//[^\n]*', re.S | re.M)


class Refused(Exception):
    """What keeps the page from being one file."""


def read(path):
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise Refused(f"{path}: {error.strerror}") from error


def imports_of(text):
    return [match[3] for match in IMPORT.finditer(COMMENT.sub(" ", text))]


def modules_from(directory, start):
    """Name and text of `start` and all it reaches, each behind what it imports."""
    found = {}

    def visit(name, by):
        if name in found:
            return
        found[name] = None
        path = directory / CARRIED.get(name, name)
        if not path.exists():
            raise Refused(f"{by} imports {name}, which is not in {directory}")
        text = read(path)
        for other in imports_of(text):
            visit(other, path)
        del found[name]
        found[name] = text

    visit(start, "the page")
    return found


def data_url(kind, text):
    return f"data:{kind};base64," + base64.b64encode(text.encode()).decode()


def import_map(modules):
    urls = {}
    for name, text in modules.items():
        text = IMPORT.sub(lambda match: f"{match[1]}{match[2]}tdsp/{match[3]}{match[2]}", text)
        urls["tdsp/" + name] = data_url("text/javascript", f"{text}//# sourceURL=tdsp/{name}\n")
    return json.dumps({"imports": urls}, indent=0)


def joined(modules):
    """The modules as one plain script. Their names share one scope, so that none may be there twice."""
    seen, parts = {}, []
    for name, text in modules.items():
        text = EXPORTED.sub("", STATEMENT.sub("", text))
        if re.search(r"^(?:import|export)\b", text, re.M):
            raise Refused(f"{name}: an import or export that joining the worker's modules does not know")
        for top in TOP_LEVEL.findall(text):
            if top in seen:
                raise Refused(f"{name} and {seen[top]} both have a {top} at their top level, and the worker joins them")
            seen[top] = name
        parts.append(text)
    return '"use strict";\n(() => {\n' + "".join(parts) + "})();\n"


def gallery_of(directory):
    root = pathlib.Path(__file__).resolve().parents[2]
    return [{**entry, "scene": json.loads(read(root / entry["scene"]))} for entry in json.loads(read(directory / "gallery.json"))]


def script(kind, name, text):
    if "</script" in text.lower() or "<!--" in text:
        raise Refused(f"{name}: a text that would end its script element")
    return f'<script type="{kind}" id="{name}">{text}</script>\n'


def carried(directory, wasm):
    packed = base64.b64encode(gzip.compress(wasm.read_bytes(), 9, mtime=0)).decode()
    gallery = json.dumps(gallery_of(directory / "gallery"), ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
    worker = joined(modules_from(directory / "js", WORKER))
    return (script("application/octet-stream", "inlined-wasm", packed) + script("text/plain", "inlined-worker", worker)
            + script("application/json", "inlined-gallery", gallery))


def replace_one(pattern, text, put, what):
    """What `put` makes of the one match."""
    found = list(re.finditer(pattern, text, re.S))
    if len(found) != 1:
        raise Refused(f"index.html: {len(found)} of {what}, where one is needed")
    return text[:found[0].start()] + put + text[found[0].end():]


def inline(directory, wasm):
    page = read(directory / "index.html")
    modules = modules_from(directory / "js", START)
    page = re.sub(r'<link rel="stylesheet" href="([\w./-]+)"\s*/?>', lambda match: f"<style>\n{read(directory / match[1])}</style>", page)
    page = replace_one(r'<script type="importmap">.*?</script>', page, f'<script type="importmap">{import_map(modules)}</script>', "import map")
    start = carried(directory, wasm) + f'<script type="module">import "tdsp/{START}";</script>'
    page = replace_one(rf'<script type="module" src="js/{START}"></script>', page, start, "module script")
    left = re.search(r'<(?:link|script|img|source|iframe)\b[^>]*\s(?:src|href)="(?!data:|#)[^"]*"[^>]*>', page)
    if left:
        raise Refused(f"index.html: {left[0]} is not inside the page")
    return page


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    directory, wasm, output = (pathlib.Path(argument) for argument in sys.argv[1:])
    try:
        page = inline(directory, wasm)
    except (Refused, OSError, ValueError) as error:
        sys.exit(f"inline.py: {error}")
    output.parent.mkdir(parents=True, exist_ok=True)
    partial = output.with_name(output.name + ".part")
    partial.write_text(page, encoding="utf-8")
    os.replace(partial, output)


if __name__ == "__main__":
    main()
