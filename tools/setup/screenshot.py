#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Take a picture of a page in chromium once an expression holds in it: screenshot.py PAGE[#FRAGMENT] PICTURE WIDTH HEIGHT light|dark EXPRESSION

Speaks the browser's own protocol over its pipe, messages of JSON that end with a zero byte, so that it needs nothing but Python and chromium.
"""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--hide-scrollbars",
         "--remote-debugging-pipe"]
PATIENCE = 90  # seconds


class Browser:
    def __init__(self, profile):
        theirs_in, self.to = os.pipe()
        self.come_from, theirs_out = os.pipe()
        # The browser reads from descriptor 3 and writes to 4, whatever numbers the pipes have here.
        shell = f"exec 3<&{theirs_in} 4>&{theirs_out}; exec \"$@\""
        command = ["bash", "-c", shell, "bash", "chromium", *FLAGS, f"--user-data-dir={profile}", "about:blank"]
        self.process = subprocess.Popen(command, pass_fds=(theirs_in, theirs_out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(theirs_in)
        os.close(theirs_out)
        self.pending, self.calls, self.session = b"", 0, None

    def message(self):
        while b"\0" not in self.pending:
            more = os.read(self.come_from, 1 << 20)
            if not more:
                sys.exit("screenshot: the browser ended")
            self.pending += more
        text, self.pending = self.pending.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        """The result of a method; events meanwhile are let pass."""
        self.calls += 1
        request = {"id": self.calls, "method": method, "params": parameters, **({"sessionId": self.session} if self.session else {})}
        os.write(self.to, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.calls:
                if "error" in answer:
                    sys.exit(f"screenshot: {method}: {answer['error']['message']}")
                return answer["result"]

    def value(self, expression):
        return self.call("Runtime.evaluate", expression=expression)["result"].get("value")


def take(browser, page, width, height, colours, expression):
    target = browser.call("Target.createTarget", url="about:blank")["targetId"]
    browser.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
    browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
    browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}, {"name": "prefers-color-scheme", "value": colours}])
    file, mark, fragment = page.partition("#")
    browser.call("Page.navigate", url=pathlib.Path(file).resolve().as_uri() + mark + fragment)
    end = time.monotonic() + PATIENCE
    while not browser.value(f"document.readyState === 'complete' && Boolean({expression})"):
        if time.monotonic() > end:
            sys.exit(f"screenshot: after {PATIENCE} s there is still not: {expression}")
        time.sleep(0.2)
    time.sleep(1)  # what is drawn in the next frames
    return base64.b64decode(browser.call("Page.captureScreenshot", format="png")["data"])


def main(page, picture, width, height, colours, expression):
    profile = tempfile.mkdtemp()
    browser = Browser(profile)
    try:
        pathlib.Path(picture).write_bytes(take(browser, page, int(width), int(height), colours, expression))
    finally:
        browser.process.kill()
        browser.process.wait()
        shutil.rmtree(profile, ignore_errors=True)


main(*sys.argv[1:])
