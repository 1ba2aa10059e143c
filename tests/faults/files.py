#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every operation of the command on files fails in turn, is done in part, or is where a signal comes (tests/faults/shim.c), and memory is refused
to the library in its midst: what is told, what survives, what is left behind. SHIM_EVERY=N: of the steps of long work every N-th only, and the more
requests for memory have been refused, the fewer of those that follow.

An operation that fails has exit status 4 and a message that names the file and the reason. The old output survives to the byte until the new one
is whole. Only after SIGKILL may a temporary file be left: .tdsp- and six characters, in the output's directory.
"""
import errno
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import harness  # noqa: E402
from harness import built, done, expect, expect_equal, main, scene, test, write  # noqa: E402

SHIMMED = os.environ["TDSP_SHIMMED"]
EVERY = int(os.environ.get("SHIM_EVERY", "1"))
OLD = b"what was there before"
TEMPORARY = re.compile(r"\.tdsp-.{6}")
TOLD = {"open": (errno.EACCES, errno.EMFILE, errno.EIO), "read": (errno.EIO, errno.EISDIR), "print": (errno.ENOSPC, errno.EIO, errno.EPIPE),
        "mkstemp": (errno.ENOSPC, errno.EACCES), "write": (errno.ENOSPC, errno.EIO, errno.EDQUOT, errno.EFBIG), "fchmod": (errno.EPERM,),
        "fsync": (errno.EIO, errno.ENOSPC), "close-out": (errno.EIO, errno.ENOSPC), "rename": (errno.EACCES, errno.EIO, errno.ENOSPC),
        "open-out": (errno.EACCES,), "threads": (errno.EAGAIN,), "draw": (errno.ENOMEM,)}
STUCK = ("write", "print")  # may also take nothing and say nothing: an I/O error
CAIRO = {errno.ENOMEM: "out of memory"}
UNNOTICED = {"open": (errno.EINTR,), "read": (errno.EINTR, "short"), "write": (errno.EINTR, "short"), "print": (errno.EINTR, "short"),
             "close": (errno.EIO,)}
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)

# name: arguments, the output or none, what standard input is
COMMANDS = {
    "build": (("build", "scene.json", "-o", "out", "--threads", 1, "--epsilon", 0.1), "out", None),
    "build by two": (("build", "scene.json", "-o", "out", "--threads", 2, "--epsilon", 0.1, "--json"), "out", None),
    "build from a pipe": (("build", "-", "-o", "out", "--threads", 1, "--epsilon", 0.5), "out", "scene.json"),
    "matrix": (("matrix", "scene.json", "--sources", "from.csv", "--destinations", "to.csv", "-o", "out", "--threads", 1, "--epsilon", 0.5), "out", None),
    "plot a scene": (("plot", "scene.json", "-o", "out.svg"), "out.svg", None),
    "plot a table": (("plot", "t.tdsp", "-o", "out.png"), "out.png", None),
    "view": (("view", "scene.json", "-o", "out.html", "--no-open"), "out.html", None),
    "embed": (("embed", "t.tdsp", "-o", "out.c"), "out.c", None),
    "embed to a device": (("embed", "t.tdsp", "-o", "/dev/null"), None, None),
    "generate to a file": (("generate", "crowd", "--n", 3, "-o", "out.json"), "out.json", None),
    "generate": (("generate", "crowd", "--n", 3), None, None),
    "convert a scene": (("convert", "fires.geojson", "--speed", 6, "-o", "out.json", "--json"), "out.json", None),
    "convert a scene from a pipe": (("convert", "-", "--scene", "scene.json", "--name", "piped", "--units", "m,s"), None, "discs.csv"),
    "convert a path": (("convert", "p.json", "--scene", "scene.json", "--origin", "9,44", "--epoch", "2026-06-01T12:00:00Z", "-o", "out.gpx"), "out.gpx", None),
    "query": (("query", "t.tdsp", "--times", "times.csv"), None, None),
    "query from a pipe": (("query", "t.tdsp", "--times", "-", "--json"), None, "times.csv"),
    "arrive": (("arrive", "scene.json", 0, 5, "--json"), None, None),
    "depart": (("depart", "scene.json", 40, "--json"), None, None),
    "path": (("path", "t.tdsp", 5, "--json"), None, None),
    "margin": (("margin", "scene.json", 5, "--path", "p.json"), None, None),
    "jumps": (("jumps", "scene.json"), None, None),
    "envelope": (("envelope", "scene.json", "--resolution", 1), None, None),
    "info": (("info", "t.tdsp"), None, None),
    "verify": (("verify", "scene.json", "t.tdsp"), None, None),
    "verify again by searching": (("verify", "scene.json", "t.tdsp", "--deep", 3, "--json"), None, None),
}
# What a process that a limit or a signal ends has measured would not be written whole.
UNMEASURED = {**os.environ, "LLVM_PROFILE_FILE": os.devnull}
# More that ask the library in other ways: of these the memory is refused, too.
HUNGRY = {
    "matrix by two": (("matrix", "scene.json", "--sources", "from.csv", "--destinations", "to.csv", "-o", "out", "--threads", 2), "out", None),
    "arrive nearly": (("arrive", "scene.json", 0, 5, "--within", 0.1), None, None),
    "path of a scene": (("path", "scene.json", 5), None, None),
    "path nearly": (("path", "scene.json", 5, "--within", 0.1, "--json"), None, None),
    "margin of a departure": (("margin", "scene.json", 5), None, None),
    "margin of a table's path": (("margin", "scene.json", 5, "--path", "t.tdsp", "--deadline", 90), None, None),
    "plot that moves": (("plot", "scene.json", "-o", "out.svg", "--animate", "--jumps", "--depart", 9.8, "--beside", 9.9), "out.svg", None),
    "plot with jumps": (("plot", "scene.json", "-o", "out.svg", "--jumps", "--depart", 12), "out.svg", None),
    "verify a path again by searching": (("verify", "scene.json", "p.json", "--deep", 1), None, None),
    "verify a matrix": (("verify", "scene.json", "m.tdspm"), None, None),
}
injected = {"told": 0, "unnoticed": 0, "ended": 0, "signals": 0, "refusals of memory": 0}


def inputs():
    built(table="t.tdsp")
    write("from.csv", "-10,0,west\n-9,1\n")
    write("to.csv", "10,0,east\n")
    write("times.csv", "0\n5\n# no more\n9\n")
    write("discs.csv", "x,y,radius,growth\n0,3,1,0.1\n")
    write("fires.geojson", (harness.SCENES / "fires-made-up.geojson").read_bytes().strip())
    os.environ["TDSP_PAGE"] = os.path.abspath(write("page.html", '<script type="application/json" id="given">null</script></html>\n'))
    write("p.json", done("path", "scene.json", 5, "--json").out)
    done("matrix", "scene.json", "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--epsilon", 0.5)


def run(name, at=None, what=None, **more):
    """The shimmed command in the current folder: its result, and the operations as pairs of kind and object."""
    arguments, output, stdin = {**COMMANDS, **HUNGRY}[name]
    if output:
        write(output, OLD)
    pathlib.Path("log").unlink(missing_ok=True)
    environment = {**os.environ, "SHIM_LOG": "log", **more}
    if at:
        environment |= {"SHIM_AT": str(at), "SHIM_DO": str(what)}
    with open(stdin or os.devnull) as file:
        ended = subprocess.run([SHIMMED, *map(str, arguments)], stdin=file, capture_output=True, timeout=300, env=environment)
    log = [line.split(" ", 2)[1:] for line in pathlib.Path("log").read_text().splitlines()]
    pathlib.Path("log").unlink()
    return harness.Result(ended), log


def content(name):
    output = {**COMMANDS, **HUNGRY}[name][1]
    return pathlib.Path(output).read_bytes() if output else None


def without_seconds(text):
    return re.sub(r"seconds\"?:? +[0-9.e-]+|\"\w*seconds\": [0-9.e-]+", "seconds", text)


def file_of(name, log, at):
    """What a message about operation `at` has to name."""
    kind = log[at - 1][0]
    if kind in ("print", "threads", "draw"):
        return {"print": "standard output", "threads": "cannot start 2 threads", "draw": "cannot draw"}[kind]
    arguments = COMMANDS[name][0]
    if kind not in ("open", "read"):
        return arguments[arguments.index("-o") + 1]
    if kind == "read" and not any(entry[0] == "open" for entry in log[:at]) or kind == "read" and log[at - 1][1] == "0":
        return "standard input"
    return next(entry[1] for entry in reversed(log[:at]) if entry[0] == "open")


class Command:
    """A command, how it goes undisturbed, and what it may do when disturbed."""

    def __init__(self, name):
        self.name = name
        self.clean, self.log = run(name)
        expect_equal(self.clean.status, 0, f"{name} undisturbed: {self.clean}")
        self.new = content(name)
        self.files = sorted(os.listdir())

    def left_alone(self, case):
        expect_equal(sorted(os.listdir()), self.files, f"{case}: files")

    def told(self, at, code):
        result, _ = run(self.name, at, code)
        kind, case = self.log[at - 1][0], f"{self.name}, operation {at} {self.log[at - 1]}, {code}"
        reason = CAIRO[code] if kind == "draw" else os.strerror(errno.EIO if code == "end" else code)
        expect_equal(result.status, 4, f"{case}: {result}")
        for words in (file_of(self.name, self.log, at), reason):
            expect(words in result.err, f"{case}: no {words!r} in {result}")
        expect(kind == "print" or result.out == "", f"{case}: results in spite of failure: {result}")
        expect_equal(content(self.name), self.new if kind == "print" else OLD if self.new else None, f"{case}: output")
        self.left_alone(case)
        injected["told"] += 1

    def unnoticed(self, at, what):
        result, _ = run(self.name, at, what, SHIM_ON="1") if what == "short" else run(self.name, at, what)
        case = f"{self.name}, operation {at} {self.log[at - 1]}, {what}"
        expect_equal(result.status, 0, f"{case}: {result}")
        expect_equal(content(self.name), self.new, f"{case}: output")
        expect_equal(without_seconds(result.out), without_seconds(self.clean.out), f"{case}: results")
        self.left_alone(case)
        injected["unnoticed"] += 1

    def ended(self, at):
        """The file ends where it should go on, or where it ends anyway."""
        result, log = run(self.name, at, "end")
        case = f"{self.name}, operation {at} {self.log[at - 1]}, end of file"
        expect(result.status in (0, 3), f"{case}: {result}")
        expect(result.status == 0 or file_of(self.name, self.log, at) in result.err, f"{case}: unnamed: {result}")
        expect_equal(content(self.name), self.new if result.status == 0 else OLD if self.new else None, f"{case}: output")
        self.left_alone(case)
        injected["ended"] += 1

    def interrupted(self, at, number):
        result, _ = run(self.name, at, f"kill {int(number)}")
        case = f"{self.name}, operation {at} {self.log[at - 1]}, {number.name}"
        expect_equal(result.status, -number, f"{case}: {result}")
        expect(content(self.name) in ((OLD, self.new) if self.new else (None,)), f"{case}: output is neither old nor new")
        left = [name for name in sorted(os.listdir()) if name not in self.files]
        if number == signal.SIGKILL:
            expect(all(TEMPORARY.fullmatch(name) for name in left) and len(left) <= 1, f"{case}: left {left}")
            for name in left:
                os.unlink(name)
        self.left_alone(case)
        injected["signals"] += 1

    def without_memory(self, at):
        """Request `at` for memory is refused, which is told, unless there is another way. False when there is no such request."""
        result, log = run(self.name, SHIM_MEMORY=str(at))
        if not any(kind == "memory" for kind, _ in log):
            return False
        case = f"{self.name}, without request {at} for memory"
        expect(result.status in (0, 4), f"{case}: {result}")
        if result.status == 4:
            expect("there is not enough memory" in result.err, f"{case}: untold: {result}")
            expect(result.out == "", f"{case}: results in spite of failure: {result}")
        else:
            expect_equal(without_seconds(result.out), without_seconds(self.clean.out), f"{case}: results")
        expect_equal(content(self.name), self.new if result.status == 0 else OLD if self.new else None, f"{case}: output")
        self.left_alone(case)
        injected["refusals of memory"] += 1
        return True

    def signal_places(self):
        """All operations; of the steps of long work every EVERY-th."""
        steps = [at for at, (kind, _) in enumerate(self.log, 1) if kind == "progress"]
        dropped = set(steps) - set(steps[::EVERY])
        return [at for at in range(1, len(self.log) + 1) if at not in dropped]


def disturb(name):
    inputs()
    command = Command(name)
    for at, (kind, _) in enumerate(command.log, 1):
        for code in TOLD.get(kind, ()) + (("end",) if kind in STUCK else ()):
            command.told(at, code)
        for what in UNNOTICED.get(kind, ()):
            command.unnoticed(at, what)
        if kind == "read":
            command.ended(at)
    for i, at in enumerate(command.signal_places()):
        for number in SIGNALS if EVERY == 1 else SIGNALS[i % 2::2]:
            command.interrupted(at, number)


def starve(name):
    inputs()
    command = Command(name)
    at = 1
    while command.without_memory(at):
        at += 1 + at * EVERY // 80


for one in COMMANDS:
    harness.add(f"{one} survives whatever happens to its files", lambda one=one: disturb(one))
for one in (*COMMANDS, *HUNGRY):
    harness.add(f"{one} tells when there is no memory", lambda one=one: starve(one))


# ------------------------------------------------------------------------------------------------------------- without a shim

def commands_with_results():
    inputs()
    return [list(map(str, arguments)) for arguments, _, stdin in COMMANDS.values() if not stdin]


@test
def a_full_standard_output_is_noticed_by_every_command_and_by_its_help():
    for arguments in commands_with_results():
        for call in (arguments, [arguments[0], "--help"]):
            with open("/dev/full", "w") as full:
                ended = subprocess.run([harness.TDSP, *call], stdout=full, stderr=subprocess.PIPE)
            silent = arguments[0] == "plot" or call[:2] == ["generate", "crowd"] and "-o" in call or arguments[0] == "embed" or arguments[0] == "convert" and "-o" in call
            if silent and call is arguments and ended.returncode == 0:
                continue
            expect_equal(ended.returncode, 4, str(call))
            expect(b"cannot write standard output: No space left on device" in ended.stderr, f"{call}: {ended.stderr}")


@test
def a_standard_stream_that_is_closed_and_cannot_be_replaced_ends_the_command():
    inputs()
    environment = {**os.environ, "SHIM_AT": "1", "SHIM_DO": str(int(errno.EACCES))}
    ended = subprocess.run(["sh", "-c", '"$0" arrive scene.json 0 <&-', SHIMMED], env=environment, capture_output=True)
    expect_equal((ended.returncode, ended.stdout), (4, b""), str(ended))


@test
def a_full_device_as_the_output_is_told():
    inputs()
    for arguments in (("build", "scene.json"), ("embed", "t.tdsp"), ("generate", "crowd", "--n", 3), ("convert", "scene.json", "--format", "csv")):
        result = done(*arguments, "-o", "/dev/full", status=4)
        expect("cannot write /dev/full: No space left on device" in result.err, result)


@test
def a_directory_is_no_input_anywhere():
    inputs()
    os.mkdir("folder")
    for arguments, _, stdin in COMMANDS.values():
        for i, word in enumerate(arguments):
            if str(word) not in ("scene.json", "t.tdsp", "from.csv", "to.csv", "times.csv", "p.json", "fires.geojson") or stdin:
                continue
            changed = [*arguments[:i], "folder", *arguments[i + 1:]]
            result = done(*changed, status=4)
            expect("folder" in result.err and "directory" in result.err, f"{changed}: {result}")


@test
def an_input_that_comes_piece_by_piece_is_read_whole():
    inputs()
    for source, arguments in (("scene.json", ("arrive", "pipe", 5, "--json")), ("t.tdsp", ("query", "pipe", 5)), ("t.tdsp", ("info", "pipe")),
                              ("discs.csv", ("convert", "pipe", "--scene", "scene.json"))):
        whole = pathlib.Path(source).read_bytes()
        os.mkfifo("pipe")

        def feed():
            with open("pipe", "wb", buffering=0) as pipe:
                for i in range(0, len(whole), 1 + len(whole) // 7):
                    pipe.write(whole[i:i + 1 + len(whole) // 7])
                    time.sleep(0.02)
        writer = threading.Thread(target=feed)
        writer.start()
        result = done(*arguments)
        writer.join(60)
        expect_equal(without_seconds(result.out).replace("pipe", source), without_seconds(done(arguments[0], source, *arguments[2:]).out), str(arguments))
        os.unlink("pipe")


@test
def a_file_cut_short_or_grown_is_invalid_input_that_is_named():
    inputs()
    for source, call in (("scene.json", ("arrive", "cut", 5)), ("t.tdsp", ("query", "cut", 5)), ("t.tdsp", ("embed", "cut", "-o", "out.c")),
                         ("t.tdsp", ("verify", "scene.json", "cut")), ("scene.json", ("build", "cut", "-o", "out")),
                         ("fires.geojson", ("convert", "cut", "--speed", 6))):
        whole = pathlib.Path(source).read_bytes()
        for length in sorted({0, 1, 7, 8, len(whole) // 2, len(whole) - 1}):
            write("cut", whole[:length])
            expect("cut" in done(*call, status=3).err, f"{call} at {length}")
        write("cut", whole + b"more")
        expect("cut" in done(*call, status=3).err, f"{call} grown")


@test
def a_file_over_the_limit_of_sizes_is_told_and_not_died_of():
    inputs()
    write("out", OLD)
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))  # noqa: E731
    for call in (("build", "scene.json", "-o", "out"), ("embed", "t.tdsp", "-o", "out")):
        ended = subprocess.run([harness.TDSP, *call], preexec_fn=limit, env=UNMEASURED, capture_output=True)
        expect_equal(ended.returncode, 4, f"{call}: {ended}")
        expect(b"cannot write out: File too large" in ended.stderr, f"{call}: {ended}")
        expect_equal(pathlib.Path("out").read_bytes(), OLD)
    with open("printed", "wb") as printed:
        ended = subprocess.run([harness.TDSP, "generate", "crowd", "--n", "99"], preexec_fn=limit, env=UNMEASURED, stdout=printed, stderr=subprocess.PIPE)
    expect_equal(ended.returncode, 4, str(ended))
    expect(b"cannot write standard output: File too large" in ended.stderr, str(ended))
    expect(not [name for name in os.listdir() if TEMPORARY.fullmatch(name)], os.listdir())


@test
def closed_standard_streams_are_errors_and_nobody_else_s_files():
    inputs()
    new = pathlib.Path("t.tdsp").read_bytes()
    for closed in ((0,), (1,), (2,), (0, 1), (1, 2), (0, 1, 2)):
        shell = " ".join(f"{i}>&-" for i in closed)
        write("out", OLD)
        ended = subprocess.run(["sh", "-c", f'"$0" build scene.json -o out {shell}', harness.TDSP], capture_output=True)
        expect_equal(ended.returncode, 4 if 1 in closed else 0, f"{shell}: {ended}")
        expect_equal(pathlib.Path("out").read_bytes(), new, shell)
        ended = subprocess.run(["sh", "-c", f'"$0" arrive - 0 {shell}', harness.TDSP], stdin=open("scene.json"), capture_output=True)
        expect_equal(ended.returncode, 4 if {0, 1} & set(closed) else 0, f"arrive {shell}: {ended}")


@test
def an_output_pipe_that_nobody_reads_can_be_interrupted():
    inputs()
    os.mkfifo("pipe")
    for number in (signal.SIGINT, signal.SIGTERM):
        running = subprocess.Popen([harness.TDSP, "embed", "t.tdsp", "-o", "pipe"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.5)
        expect(running.poll() is None, "it did not wait for a reader")
        running.send_signal(number)
        try:
            running.communicate(timeout=20)
        finally:
            running.kill()
        expect_equal(running.returncode, -number)


@test
def a_reader_that_goes_away_is_told_as_the_reason():
    done("generate", "crowd", "--n", 3000, "-o", "many.json")
    os.mkfifo("pipe")
    reader = threading.Thread(target=lambda: open("pipe", "rb").close())
    reader.start()
    result = done("generate", "crowd", "--n", 30000, "-o", "pipe", status=4)
    reader.join(60)
    expect("cannot write pipe: Broken pipe" in result.err, result)


@test
def a_signal_at_any_moment_leaves_the_old_output_or_the_new():
    inputs()
    write("out", OLD)
    call = [harness.TDSP, "build", "scene.json", "-o", "out", "--epsilon", "1e-3", "--threads", "4"]
    begin = time.time()
    subprocess.run(call, check=True, stdout=subprocess.DEVNULL)
    whole, new = time.time() - begin, pathlib.Path("out").read_bytes()
    for i in range(60 // EVERY + 10):
        number = (signal.SIGINT, signal.SIGTERM)[i % 2]
        write("out", OLD)
        running = subprocess.Popen(call, env=UNMEASURED, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(whole * ((i * 0.618034) % 1) * 1.1)
        running.send_signal(number)
        running.communicate(timeout=60)
        expect(running.returncode in (0, -number), f"ended with {running.returncode}")
        expect(pathlib.Path("out").read_bytes() in (OLD, new), "neither old nor new")
        expect(not [name for name in os.listdir() if TEMPORARY.fullmatch(name)], os.listdir())
        injected["signals"] += 1


def say():
    print(", ".join(f"{count} {what}" for what, count in injected.items()))


harness.add("faults were injected", lambda: (say(), expect(all(injected.values()), injected)))
main()
