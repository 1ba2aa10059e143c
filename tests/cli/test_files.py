#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files and the terminal: what cannot be read or written, what survives failure, what Ctrl-C leaves behind, and when there is a progress bar."""
import os
import pathlib
import pty
import signal
import subprocess
import threading
import time

from harness import TDSP, built, done, expect, expect_equal, fails, main, scene, test, write


@test
def a_missing_file_is_the_system_s_failure_and_is_named():
    for arguments in [("arrive", "no.json", 0), ("depart", "no.json", 0), ("path", "no.json", 0), ("build", "no.json", "-o", "t"),
                      ("query", "no.tdsp", 0), ("info", "no.tdsp"), ("verify", scene(), "no.json"), ("plot", "no.json", "-o", "a.svg"),
                      ("embed", "no.tdsp", "-o", "a.c")]:
        fails(4, ["cannot read no.", "No such file"], *arguments)


@test
def a_directory_is_no_input():
    os.mkdir("folder")
    fails(4, ["folder", "directory"], "arrive", "folder", 0)


@test
def outputs_that_cannot_be_written_are_the_system_s_failure():
    table = built()
    os.mkdir("folder")
    for arguments in [("build", "scene.json"), ("plot", "scene.json"), ("embed", table), ("generate", "crowd", "--n", 3)]:
        suffix = ".svg" if arguments[0] == "plot" else ""
        fails(4, ["cannot write", "nowhere"], *arguments, "-o", "nowhere/x" + suffix)
    fails(4, ["cannot write", "folder"], "build", "scene.json", "-o", "folder")
    expect_equal(sorted(os.listdir()), ["folder", "scene.json", "t.tdsp"])


@test
def a_full_standard_output_is_noticed():
    for arguments in [("arrive", scene(), "0"), ("--help",), ("--version",), ("help", "--json"), ("generate", "crowd", "--n", "3"), ("info", built())]:
        with open("/dev/full", "w") as full:
            ended = subprocess.run([TDSP, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE)
        expect_equal(ended.returncode, 4, str(arguments))
        expect(b"cannot write standard output" in ended.stderr, ended.stderr)


@test
def an_existing_output_survives_every_failure():
    bad = write("bad.json", "{")
    covered = scene("covered.json", discs=[{"center": [-10, 1], "radius": 2, "growth": 0}])
    endless = scene("endless.json", discs=[])
    for name, arguments, status in [("t.tdsp", ("build", bad), 3), ("t.tdsp", ("build", covered), 1), ("t.tdsp", ("build", endless), 2),
                                    ("t.tdsp", ("build", scene(), "--epsilon", 5), 2), ("a.svg", ("plot", bad), 3), ("a.c", ("embed", bad), 3)]:
        write(name, "precious")
        done(*arguments, "-o", name, status=status)
        expect_equal(pathlib.Path(name).read_text(), "precious", str(arguments))


@test
def nothing_but_the_output_is_left():
    built()
    done("plot", "scene.json", "-o", "a.svg")
    done("embed", "t.tdsp", "-o", "a.c")
    done("generate", "crowd", "--n", 3, "-o", "c.json")
    expect_equal(sorted(os.listdir()), ["a.c", "a.svg", "c.json", "scene.json", "t.tdsp"])


@test
def an_output_replaces_what_was_there_and_keeps_its_permissions():
    write("t.tdsp", "old")
    os.chmod("t.tdsp", 0o640)
    built()
    expect(pathlib.Path("t.tdsp").read_bytes() != b"old", "not replaced")
    expect_equal(os.stat("t.tdsp").st_mode & 0o777, 0o640)


@test
def a_new_output_has_the_permissions_that_umask_leaves():
    before = os.umask(0o027)
    try:
        built()
    finally:
        os.umask(before)
    expect_equal(os.stat("t.tdsp").st_mode & 0o777, 0o640)


@test
def a_symbolic_link_stays_one():
    os.mkdir("real")
    os.symlink("real/t.tdsp", "link.tdsp")
    built(table="link.tdsp")
    built(table="link.tdsp")
    expect(os.path.islink("link.tdsp"), "the link is gone")
    done("info", "real/t.tdsp")


@test
def an_output_that_is_an_input_is_refused():
    table = built()
    os.link("scene.json", "same.svg")
    fails(2, ["replace the input"], "build", "scene.json", "-o", "./scene.json")
    fails(2, ["replace the input"], "plot", "scene.json", "-o", "same.svg")
    fails(2, ["replace the input"], "embed", table, "-o", table)
    done("arrive", "scene.json", 0)


@test
def a_pipe_is_written_through_and_stays_a_pipe():
    os.mkfifo("pipe.svg")
    read = []
    reader = threading.Thread(target=lambda: read.append(pathlib.Path("pipe.svg").read_bytes()))
    reader.start()
    done("plot", scene(), "-o", "pipe.svg")
    reader.join(60)
    expect(read and read[0].startswith(b"<?xml"), "nothing came through")
    expect(pathlib.Path("pipe.svg").is_fifo(), "the pipe is gone")


def slow_build(**streams):
    """A build that takes minutes, running."""
    done("generate", "crowd", "--n", 250, "--seed", 3, "--growth", 0.05, "-o", "crowd.json")
    return subprocess.Popen([TDSP, "build", "crowd.json", "-o", "t.tdsp", "--epsilon", "1e-7"], **streams)


@test
def interrupting_a_build_leaves_nothing_behind():
    running = slow_build(stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    time.sleep(1)
    expect(running.poll() is None, "the build was too fast to interrupt")
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=60)
    expect(running.returncode != 0, "success in spite of the signal")
    expect_equal([out, err], [b"", b""])
    expect_equal(sorted(os.listdir()), ["crowd.json"])


def read_terminal(master, running, seconds):
    """What comes out of a terminal within so many seconds."""
    os.set_blocking(master, False)
    seen, end = b"", time.time() + seconds
    while time.time() < end and running.poll() is None:
        try:
            seen += os.read(master, 65536)
        except BlockingIOError:
            time.sleep(0.05)
    return seen


@test
def a_terminal_gets_a_progress_bar_and_a_clean_line_on_interruption():
    master, slave = pty.openpty()
    running = slow_build(stdout=subprocess.DEVNULL, stderr=slave)
    seen = read_terminal(master, running, 2)
    running.send_signal(signal.SIGINT)
    running.wait(60)
    try:
        seen += os.read(master, 65536)
    except BlockingIOError:
        pass
    os.close(slave)
    os.close(master)
    expect(b"build [" in seen and b"%" in seen, seen[-200:])
    expect(seen.endswith(b"\r\x1b[K"), seen[-200:])
    expect_equal(sorted(os.listdir()), ["crowd.json"])


@test
def without_a_terminal_there_is_no_progress_bar():
    running = slow_build(stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    time.sleep(1.5)
    running.kill()
    expect_equal(running.communicate(timeout=60), (b"", b""))


@test
def names_that_the_locale_cannot_write_are_names():
    """GOption would turn an argument into UTF-8, and refuse one that is none."""
    environment = dict(os.environ, LC_ALL="C")
    file = scene()
    table = os.fsdecode(b"\xe9t\xe9.tdsp")
    os.rename(built(), table)
    for arguments in [("query", table, "0"), ("query", table, "--arrive-by", "33"), ("margin", file, "0", "--path", table), ("info", table)]:
        found = subprocess.run([TDSP, *arguments], env=environment, capture_output=True)
        expect_equal(found.returncode, 0, f"{arguments}: {found.stderr}")


@test
def a_circle_of_links_is_no_output_and_stays():
    table = built()
    os.symlink("a", "b")
    os.symlink("b", "a")
    fails(4, ["cannot write a: Too many levels of symbolic links"], "embed", table, "-o", "a")
    expect_equal((os.readlink("a"), os.readlink("b")), ("b", "a"))


main()
