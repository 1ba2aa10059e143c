#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tdsp view with the page as it is built, found beside the command."""
import json
import os

from given import given
from harness import SCENES, built, done, expect_equal, main, test

os.environ.pop("TDSP_PAGE", None)


@test
def the_page_as_built_takes_every_shipped_scene():
    for file in sorted(SCENES.rglob("*.json")):
        done("view", file, "-o", "a.html", "--no-open")
        expect_equal(given("a.html"), {"name": file.name, "scene": json.loads(file.read_text(encoding="utf-8"))})


@test
def the_page_as_built_takes_a_table():
    done("view", built(), "-o", "a.html", "--no-open")
    expect_equal(given("a.html")["name"], "t.tdsp")


main()
