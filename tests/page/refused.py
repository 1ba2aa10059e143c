#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The scenes that tests/cli/test_scenes.py has the command refuse, as JSON for tests in other languages: [[name, content in base64], ...]."""
import base64
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
import test_scenes  # noqa: E402

cases = {**test_scenes.SYNTAX, **test_scenes.MEANING}
contents = {name: case[0] if isinstance(case[0], bytes) else case[0].encode() for name, case in cases.items()}
print(json.dumps([[name, base64.b64encode(content).decode()] for name, content in contents.items()]))
