# SPDX-License-Identifier: MIT
"""What a page was given to show: the JSON in one of its elements."""
import html.parser
import json
import pathlib

ELEMENT = '<script type="application/json" id="given">'


class _Given(html.parser.HTMLParser):
    """What a browser finds in the element."""

    def __init__(self, text):
        super().__init__()
        self.given, self.within = "", False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.within = tag == "script" and dict(attributes).get("id") == "given"

    def handle_endtag(self, tag):
        self.within = False

    def handle_data(self, data):
        if self.within:
            self.given += data


def given(name):
    return json.loads(_Given(pathlib.Path(name).read_text(encoding="utf-8")).given)
