#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tdsp view: a scene or a table in the page, byte for byte, and opened where that can be."""
import base64
import json
import os
import pathlib
import shutil
import socket
import stat
import time

import harness
from harness import TWO_DISCS, built, done, expect, expect_equal, fails, main, scene, test, write
from given import ELEMENT, given

STAND_IN = f"<!doctype html>\n<title>page</title>\n{ELEMENT}null</script>\n<script>const other = 'null';</script>\n</html>\n"


def native(function):
    """A test of the command on a machine of its own: emulated it is a script that starts the emulator, and what GLib opens files with is there for this machine only."""
    return function if os.environ.get("EMULATOR") else test(function)


def page(text=STAND_IN):
    """From now on this is the page, and nothing is there to open it with."""
    os.environ["TDSP_PAGE"] = os.path.abspath(write("page", text))
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        os.environ.pop(name, None)
    os.environ["XDG_CACHE_HOME"] = os.path.abspath("cache")


@test
def a_scene_is_put_into_the_page_and_nothing_else_is_changed():
    page()
    result = done("view", scene(), "-o", "a.html", "--no-open")
    expect_equal((result.out, result.err), ("a.html\n", ""))
    expect_equal(given("a.html"), {"name": "scene.json", "scene": TWO_DISCS})
    before, after = STAND_IN.split("null</script>", 1)
    text = pathlib.Path("a.html").read_text()
    expect(text.startswith(before) and text.endswith("</script>" + after), text)


@test
def a_table_is_put_into_the_page_with_every_byte():
    page()
    table = built()
    done("view", table, "-o", "a.html", "--no-open")
    found = given("a.html")
    expect_equal((found["name"], sorted(found)), ("t.tdsp", ["name", "table"]))
    expect(base64.b64decode(found["table"]) == pathlib.Path(table).read_bytes(), "the bytes differ")


@test
def no_name_or_text_in_a_scene_ends_the_element():
    page()
    nasty = "</script><script>alert(1)</script><!-- <script> \\ \" \u2028 é"
    pathlib.Path("<b>&.json").write_text("\ufeff" + json.dumps({**TWO_DISCS, "name": nasty}, ensure_ascii=False))
    done("view", "<b>&.json", "-o", "a.html", "--no-open")
    expect_equal(given("a.html"), {"name": "<b>&.json", "scene": {**TWO_DISCS, "name": nasty}})
    expect("<script>alert" not in pathlib.Path("a.html").read_text(), "a tag of the scene's name")


@test
def a_scene_comes_from_standard_input_too():
    page()
    done("view", "-", "-o", "a.html", "--no-open", stdin=json.dumps(TWO_DISCS))
    expect_equal(given("a.html"), {"name": "standard input", "scene": TWO_DISCS})


@test
def without_a_name_it_goes_to_the_cache_and_to_the_same_file_the_next_time():
    page()
    first, second = done("view", scene(), "--no-open").out, done("view", "./scene.json", "--no-open").out
    expect(first.startswith(os.path.abspath("cache/tdsp") + "/scene.json-") and first.endswith(".html\n"), first)
    expect_equal(first, second)
    expect_equal(stat.S_IMODE(os.stat("cache/tdsp").st_mode), 0o700)
    os.mkdir("other")
    shutil.copy("scene.json", "other/scene.json")
    expect(done("view", "other/scene.json", "--no-open").out != first, "two scenes share a file")
    write("no-folder", "")
    os.environ["XDG_CACHE_HOME"] = os.path.abspath("no-folder")
    os.environ["TMPDIR"] = os.path.abspath("other")
    expect(done("view", "scene.json", "--no-open").out.startswith(os.path.abspath("other/tdsp")), "not in the temporary directory")
    os.environ["TMPDIR"] = os.path.abspath("no-folder")
    fails(4, ["no folder", "-o"], "view", "scene.json", "--no-open")
    del os.environ["TMPDIR"]


@test
def what_is_wrong_never_reaches_the_page():
    page()
    write("cut.tdsp", pathlib.Path(built()).read_bytes()[:-1])
    write("path.json", done("path", "scene.json", 5, "--json").out)
    write("broken.json", "{\"robot\": ")
    wrong = scene("wrong.json", robot={"speed": 0})
    for name, fragments in [("cut.tdsp", ["cut.tdsp"]), ("path.json", ["path.json"]), ("broken.json", ["broken.json"]), (wrong, ["wrong.json", "speed"]),
                            (write("x", "hello"), ["neither JSON nor a table"])]:
        said = fails(3, fragments, "view", name, "-o", "a.html").err
        expect_equal(said.split(": ", 1)[1], done("arrive" if name != "cut.tdsp" else "info", name, *([0] if name != "cut.tdsp" else []), status=3).err.split(": ", 1)[1])
    fails(4, ["none.json"], "view", "none.json", "-o", "a.html")
    fails(2, ["replace the input"], "view", "scene.json", "-o", "scene.json")
    fails(2, ["too few"], "view")
    fails(2, ["too many"], "view", "scene.json", "t.tdsp")
    fails(4, ["nowhere/a.html"], "view", "scene.json", "-o", "nowhere/a.html")
    expect(not os.path.exists("a.html") and not os.path.exists("cache"), os.listdir())


@test
def no_page_or_another_one_is_told():
    page()
    for text in ("", "<!doctype html>", STAND_IN.replace("null<", "{}<"), STAND_IN.replace("given", "taken")):
        page(text)
        fails(3, ["page: not the page of this command", ELEMENT], "view", scene(), "-o", "a.html")
    page(STAND_IN[:-1])
    fails(3, ["page: cut short"], "view", "scene.json", "-o", "a.html")
    os.environ["TDSP_PAGE"] = "nowhere.html"
    fails(4, ["nowhere.html"], "view", "scene.json", "-o", "a.html")


@native
def the_page_is_looked_for_beside_the_command_and_where_it_was_installed():
    page()
    scene()
    os.environ["TDSP_PAGE"] = ""  # as if it were not there
    os.makedirs("prefix/bin")
    command, harness.TDSP = harness.TDSP, shutil.copy(harness.TDSP, "prefix/bin/tdsp")
    try:
        here = os.path.abspath("prefix")
        fails(4, [f"{here}/bin/page/index.html", f"{here}/share/tdsp/page.html", "make page", "TDSP_PAGE"], "view", "scene.json", "-o", "a.html")
        for place in ("share/tdsp/page.html", "bin/page/index.html"):
            os.makedirs(os.path.dirname(f"prefix/{place}"))
            write(f"prefix/{place}", f"<!-- {place} -->{STAND_IN}")
            done("view", "scene.json", "-o", "a.html", "--no-open")
            expect(place in pathlib.Path("a.html").read_text(), f"not the page of {place}")
    finally:
        harness.TDSP = command


@test
def without_a_display_it_says_how_to_open_it():
    page()
    result = done("view", scene(), "-o", "a.html", "--json")
    expect_equal(result.json, {"file": "a.html", "of": "scene", "opened": False})
    expect("no display" in result.err and "open a.html in a browser" in result.err, result)
    os.environ["DISPLAY"] = os.environ["WAYLAND_DISPLAY"] = ""
    expect_equal(done("view", "scene.json", "-o", "a.html", "--json").err, result.err, "displays without a name")
    expect_equal(done("view", built(), "-o", "a.html", "--json").json, {"file": "a.html", "of": "table", "opened": False})


def desktop(program):
    """A desktop whose one program opens any file, and a screen that nobody looks at."""
    os.makedirs("data/applications")
    os.makedirs("config")
    kinds = ["text/html", "text/plain", "application/xhtml+xml", "application/octet-stream", "application/x-zerosize"]
    write("data/applications/browser.desktop", f"[Desktop Entry]\nType=Application\nName=Browser\nExec={program} %u\nMimeType={';'.join(kinds)};\n")
    write("config/mimeapps.list", "[Default Applications]\n" + "".join(f"{kind}=browser.desktop\n" for kind in kinds))
    os.environ.update(DISPLAY=":77", XDG_DATA_HOME=os.path.abspath("data"), XDG_CONFIG_HOME=os.path.abspath("config"))


def opened_file(name, seconds=10):
    """What the desktop's program wrote, once it has."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if os.path.exists(name) and os.path.getsize(name):
            return pathlib.Path(name).read_text()
        time.sleep(0.02)
    raise AssertionError("nothing was opened")


@native
def on_a_desktop_its_program_opens_the_file_and_nobody_waits_for_that():
    """A program that holds our output would keep whoever reads it waiting."""
    page()
    write("browser", "#!/bin/sh\necho noise\necho \"$1\" > opened.part\nmv opened.part opened\nexec sleep 5\n")
    os.chmod("browser", 0o755)
    desktop(os.path.abspath("browser"))
    begun = time.monotonic()
    result = done("view", scene(), "-o", "a page.html", "--json")
    expect_equal(result.json, {"file": "a page.html", "of": "scene", "opened": True})
    expect_equal(result.err, "")
    expect(time.monotonic() - begun < 4, "it waited for the browser")
    place = os.path.abspath("a page.html")  # a program of %u may be given a local file as a path
    expect(opened_file("opened").strip() in (place, "file://" + place.replace(" ", "%20")), pathlib.Path("opened").read_text())
    os.remove("opened")
    expect_equal(done("view", "scene.json", "-o", "b.html", "--json", "--no-open").json["opened"], False)
    expect(not os.path.exists("opened"), "opened in spite of --no-open")


@test
def a_desktop_that_cannot_open_it_is_no_failure():
    page()
    desktop("/nowhere/browser")
    result = done("view", scene(), "-o", "a.html", "--json")
    expect_equal(result.json["opened"], False)
    expect("cannot open it" in result.err and "open a.html in a browser" in result.err, result)
    del os.environ["DISPLAY"]
    os.environ["WAYLAND_DISPLAY"] = "wayland-7"
    expect_equal(done("view", "scene.json", "-o", "a.html", "--json").err, result.err, "by Wayland")


@test
def a_desktop_whose_bus_never_answers_is_not_waited_for():
    """Connecting to the bus waited for ever, before there was anything that could be given up."""
    page()
    desktop("/nowhere/browser")
    with socket.socket(socket.AF_UNIX) as bus:
        bus.bind("bus")
        bus.listen()
        os.environ.update(DBUS_SESSION_BUS_ADDRESS="unix:path=" + os.path.abspath("bus"), GTK_USE_PORTAL="1")
        result = done("view", scene(), "-o", "a.html", "--json", timeout=60)
    expect_equal(result.json["opened"], False)
    expect("does not answer" in result.err and "open a.html in a browser" in result.err, result)


main()
