#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reader on Cortex-M3, M4F and M7: run in qemu, compared with this machine, and held to budgets.

    firmware.py show FOLDER     run the example and print what the reader takes
    firmware.py check FOLDER    compare everything, hold it to the budgets, and docs/embedding.md to what was printed

FOLDER has a folder for each core, with robot.elf, measure.elf, answers.elf, mathematics.elf and libtdsp-query.a, and `host` with the first two for this machine. Sizes are of
our own objects, after --gc-sections, by functions that are called: our mathematics (src/base/math_*.c), and what the C library and the compiler bring, are counted apart.
"""
import functools
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "portable"))
import reader  # noqa: E402

CORES = {"m3": ("Cortex-M3", "mps2-an385", ["-mcpu=cortex-m3", "-mthumb"]),
         "m4f": ("Cortex-M4F", "mps2-an386", ["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"]),
         "m7": ("Cortex-M7", "mps2-an500", ["-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard"])}
SOFT = ("m3", "m4f") # doubles in software
QEMU = ["qemu-system-arm", "-nographic", "-monitor", "none", "-serial", "none", "-semihosting-config", "enable=on,target=native"]

# Bytes of code and constants that our mathematics may take: less than newlib's took, with what it brings, 10,613 on the M3.
MATHEMATICS = 6144
# What a firmware calls: (name, functions, most bytes of code and constants without the mathematics).
PATHS = ["tdsp_table_leg", "tdsp_table_path", "tdsp_table_position"]
USES = [("look-up", ["tdsp_table_arrival"], 2048),
        ("look-up in floats", ["tdsp_table_arrival_float"], 2048),
        ("look-up, opened by reopen", ["tdsp_table_reopen", "tdsp_table_arrival"], None),
        ("with path and position, opened by reopen", ["tdsp_table_reopen", "tdsp_table_arrival", *PATHS], 8192),
        ("opening that checks every byte", ["tdsp_table_open"], None),
        ("all of these, and the way back", ["tdsp_table_open", "tdsp_table_reopen", "tdsp_table_arrival", "tdsp_table_arrival_float",
                                            "tdsp_table_departure", *PATHS], None)]
# Of measure.c: (name there, name here, most bytes of our frames without the mathematics, most in all and found used, most instructions on an M4F). All but 256 and 600
# are what was reached, rounded up: it shall not grow unnoticed.
COSTS = [("arrival", "look-up", 256, 256, 600), ("arrival_float", "look-up in floats", 256, 256, 600), ("departure", "latest departure", 256, 256, None),
         ("position", "position on a leg of any kind", 256, 352, None), ("reopen", "reopen", 640, 640, None), ("open", "opening that checks every byte", 896, 896, None)]
# What measure.c does not call: most bytes of our frames without the mathematics.
OTHERS = {"tdsp_table_leg": 256, "tdsp_table_path": 256, "tdsp_leg_position": 288, "tdsp_path_position": 320}
OUR_MATHEMATICS = ("math_", "reduce_") # how its functions begin that others call
FUNCTIONS = {"arrival": "tdsp_table_arrival", "arrival_float": "tdsp_table_arrival_float", "departure": "tdsp_table_departure",
             "position": "tdsp_table_position", "reopen": "tdsp_table_reopen", "open": "tdsp_table_open"}


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace", timeout=300, **options)


def report(name, problem, good=""):
    print(f"not ok firmware {name}: {problem}" if problem else f"ok firmware {name}{': ' + good if good else ''}")
    return bool(problem)


# ------------------------------------------------------------------------------------------------------------ running

def play(core, program, *options, cwd=None):
    """What a program prints on a core, or why not."""
    done = run(QEMU[0], "-M", CORES[core][1], *options, *QEMU[1:], "-kernel", program.resolve(), cwd=cwd)
    return done.stdout if done.returncode == 0 else f"exit status {done.returncode}: {done.stdout[-300:]} {done.stderr[-300:]}"


@functools.lru_cache(None)
def measured(folder, core):
    return play(core, folder / core / "measure.elf", "-icount", "shift=0").splitlines()


def numbers(lines, kind):
    """{name: its first number} of lines `KIND NAME [most] NUMBER ...`."""
    found = {}
    for line in lines:
        words = line.replace(" most ", " ").split()
        if words[:1] == [kind]:
            found[words[1]] = int(words[2])
    return found


def compare_robot(folder, core):
    here, there = run(folder / "host" / "robot").stdout, play(core, folder / core / "robot.elf")
    return report(f"{CORES[core][0]}: the example prints what it prints here", "" if here == there and "there between" in here else there[-300:])


def compare_bits(folder, core):
    """Arrivals and latest departures, in doubles and in floats, and places, to the bit."""
    kinds = ("rows", "arrival", "departure", "place")
    here, there = run(folder / "host" / "measure").stdout.splitlines(), measured(folder, core)
    exact, found = ([line for line in lines if line.startswith(kinds)] for lines in (here, there))
    places = sum(line.startswith("place") for line in exact)
    wrong = next((f"{b}, not {a}" for a, b in zip(exact, found) if a != b), "" if len(exact) == len(found) > 200 and places > 60 else f"{len(found)} lines, not {len(exact)}")
    return report(f"{CORES[core][0]}: look-ups and places are those of this machine, to the bit", wrong, f"{len(exact)} lines, {places} of places")


def compare_mathematics(folder, core):
    """Our own mathematics, as recorded: all of it where doubles are in hardware. In software what the reader calls, for there a sum may be off: libgcc's addition for ARM
    rounds a power of two less a number of 2^-33 to 2^-32 of it one unit in the last place too low in 145 of 265 cases tried, which exp meets."""
    kinds = ("sin ", "cos ", "sine of both ", "cosine of both ", "log ", "log1p ") if core in SOFT else ("",)
    recorded = [line for line in (reader.GOLDEN / "mathematics.txt").read_text().splitlines() if line.startswith(kinds)]
    found = [line for line in play(core, folder / core / "mathematics.elf").splitlines() if line.startswith(kinds)]
    wrong = next((f"{a!r}, not {b!r}" for a, b in zip(found, recorded) if a != b), "" if len(found) == len(recorded) else f"{len(found)} lines, not {len(recorded)}")
    return report(f"{CORES[core][0]}: our mathematics gives the recorded bits", wrong, f"{len(recorded)} lines")


def compare_golden(folder, core):
    """The golden files, read by the core itself, answered as recorded."""
    refused, sound = reader.files(reader.GOLDEN / "refused"), reader.sound()
    recorded = sorted((reader.GOLDEN / "refused.txt").read_text().splitlines()) + (reader.GOLDEN / "answers.txt").read_text().splitlines()
    with tempfile.TemporaryDirectory() as scratch:
        for path in refused + sound:
            (pathlib.Path(scratch) / path.name).write_bytes(path.read_bytes())
        (pathlib.Path(scratch) / "files.txt").write_text("".join(path.name + "\n" for path in refused + sound))
        found = play(core, folder / core / "answers.elf", cwd=scratch).splitlines()
    wrong = [f"{a!r}, not {b!r}" for a, b in zip(found, recorded) if a != b]
    if len(found) != len(recorded):
        wrong.append(f"{len(found)} lines, not {len(recorded)}: {found[-1:]}")
    return report(f"{CORES[core][0]}: golden files, sound and broken, are answered as recorded", wrong[0] if wrong else "", f"{len(recorded)} lines")


# -------------------------------------------------------------------------------------------------------------- sizes

# A long name stands on a line of its own.
SECTION = re.compile(r"^ (\.(?:text|rodata|data|bss)\S*)\s+0x\w+\s+(0x\w+) (\S+)$", re.M)


@functools.lru_cache(None)
def sizes(folder, core, functions):
    """Bytes after linking: our code and constants without mathematics, our mathematics, our data, and what the C library and the compiler bring for them."""
    with tempfile.TemporaryDirectory() as scratch:
        image, listing = pathlib.Path(scratch) / "x.elf", pathlib.Path(scratch) / "x.map"
        done = run("arm-none-eabi-gcc", *CORES[core][2], "-nostartfiles", "--specs=nosys.specs", "-Wl,--gc-sections", f"-Wl,-e,{functions[0]}",
                   *(f"-Wl,-u,{name}" for name in functions), folder / core / "libtdsp-query.a", "-lm", f"-Wl,-Map,{listing}", "-o", image)
        if done.returncode:
            sys.exit(f"not ok firmware sizes: {done.stderr}")
        text = listing.read_text()
    ours = mathematics = data = others = 0
    for section, size, origin in SECTION.findall(text[text.index("Linker script and memory map"):]):
        mine, computes = "libtdsp-query.a(" in origin, "libtdsp-query.a(math_" in origin
        if section.startswith((".data", ".bss")):
            data += int(size, 16) * mine
        else:
            ours += int(size, 16) * (mine and not computes)
            mathematics += int(size, 16) * computes
            others += int(size, 16) * (not mine)
    return ours, mathematics, data, others


# -------------------------------------------------------------------------------------------------------------- stack

NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "[^"]*?(\d+) bytes \((static|dynamic[^)]*)\)', re.M)
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', re.M)


JUMP = re.compile(r"^\w+ R_ARM_THM_(JUMP24|CALL)\s+(\S+)", re.M)


def jumps(path):
    """(caller, callee) that an object only jumps to: a last call, before which the caller gives its frame back."""
    kinds = {}
    for section in run("arm-none-eabi-objdump", "-r", path).stdout.split("RELOCATION RECORDS FOR [")[1:]:
        for kind, callee in JUMP.findall(section):
            kinds.setdefault((section[:section.index("]")].removeprefix(".text."), callee.removeprefix(".text.")), set()).add(kind)
    return {pair for pair, found in kinds.items() if found == {"JUMP24"}}


@functools.lru_cache(None)
def graph(folder, core):
    """Of each function its frame, whom it calls, and whom it jumps to."""
    frames, calls, last = {}, {}, {}
    for path in (folder / core / "src").rglob("*.ci"):
        text, jumped = path.read_text(), jumps(path.with_suffix(".o"))
        frames.update({name: int(size) for name, size, _ in NODE.findall(text)})
        for caller, callee in EDGE.findall(text):
            pair = (caller.split(":")[-1], callee.split(":")[-1])
            (last if pair in jumped else calls).setdefault(caller, set()).add(callee)
    return frames, calls, last


def chain(folder, core, name, without=()):
    """The stack of our own functions from this one down, by the compiler's frames; `without` those whose names begin so."""
    frames, calls, last = graph(folder, core)
    if name.split(":")[-1].startswith(without):
        return 0
    below, after = (max((chain(folder, core, callee, without) for callee in kind.get(name, ())), default=0) for kind in (calls, last))
    return max(frames.get(name, 0) + below, after)


def depths(folder, core, name):
    """The deepest stack of our own functions without the mathematics, and what it adds."""
    own = chain(folder, core, name, OUR_MATHEMATICS)
    return own, chain(folder, core, name) - own


# ------------------------------------------------------------------------------------------------------------ reports

def size_rows(folder):
    rows = ["| what is called | " + " | ".join(name for name, _, _ in CORES.values()) + " | budget |", "|---|" + "---|" * (len(CORES) + 1)]
    for name, functions, budget in USES:
        found = [sizes(folder, core, tuple(functions)) for core in CORES]
        rows.append(f"| {name} | " + " | ".join(f"{ours} + {mathematics} + {others}" for ours, mathematics, _, others in found) + f" | {budget or ''} |")
    return rows


def cost_rows(folder):
    rows = ["| a call | " + " | ".join(f"{name}: instructions, stack" for name, _, _ in CORES.values()) + " |", "|---|" + "---|" * len(CORES)]
    for key, name, *_ in COSTS:
        cells = []
        for core in CORES:
            lines, (own, mathematics) = measured(folder, core), depths(folder, core, FUNCTIONS[key])
            cells.append(f"{numbers(lines, 'instructions')[key]}, {own}{f' + {mathematics}' if mathematics else ''} ({numbers(lines, 'stack')[key]})")
        rows.append(f"| {name} | " + " | ".join(cells) + " |")
    return rows


def check_sizes(folder, core):
    bad = False
    for name, functions, budget in USES:
        ours, mathematics, data, others = sizes(folder, core, tuple(functions))
        problem = f"{data} bytes of data" if data else f"{ours} bytes of code, over {budget}" if budget and ours > budget else ""
        problem = problem or (f"{mathematics} bytes of mathematics, over {MATHEMATICS}" if mathematics > MATHEMATICS else "")
        bad |= report(f"{CORES[core][0]}: {name}", problem, f"{ours} bytes of code{f' of {budget}' if budget else ''}, no data, beside {mathematics} of our mathematics "
                      f"and {others} of the C library and the compiler")
    return bad


def check_costs(folder, core):
    lines, bad = measured(folder, core), False
    instructions, stacks = numbers(lines, "instructions"), numbers(lines, "stack")
    for name, most in OTHERS.items():
        own, mathematics = depths(folder, core, name)
        bad |= report(f"{CORES[core][0]}: stack of {name}()", f"{own} bytes, over {most}" if not 0 < own <= most else "", f"{own} bytes of {most}, and {mathematics} of our mathematics")
    for key, name, most_own, most_stack, most in COSTS:
        own, mathematics = depths(folder, core, FUNCTIONS[key])
        if key not in instructions or key not in stacks:
            bad |= report(f"{CORES[core][0]}: {name} was measured", " ".join(lines[-1:]) or "nothing was printed")
            continue
        over = f"{own} bytes of our frames, over {most_own}" if not 0 < own <= most_own else ""
        used = max(own + mathematics, stacks[key])
        bad |= report(f"{CORES[core][0]}: stack of {name}", over or (f"{used} bytes, over {most_stack}" if used > most_stack else ""),
                      f"{own} bytes of our frames of {most_own}, {mathematics} of our mathematics; {stacks[key]} were used, with the C library's, of {most_stack}")
        limit = most if core == "m4f" else None
        bad |= report(f"{CORES[core][0]}: instructions of {name}", f"{instructions[key]}, over {limit}" if limit and instructions[key] > limit else "",
                      f"{instructions[key]} at most{f', of {limit}' if limit else ''}")
    return bad


def check_rows(folder):
    rows = next((line.split() for line in run(folder / "host" / "measure").stdout.splitlines() if line.startswith("rows")), ["rows", "0"])
    return report("the table that is measured has 256 rows or a few more", "" if 256 <= int(rows[1]) <= 288 else " ".join(rows), " ".join(rows))


def compiler():
    return run("arm-none-eabi-gcc", "-dumpfullversion").stdout.strip()


def figures(row):
    return [int(number) for number in re.findall(r"\d+", row[row.index("|", 1):])]


def is_shown(row, page):
    """Does the page have this row, its figures within 3 % or 16?"""
    label, found = row[:row.index("|", 1) + 1], figures(row)
    shown = [figures(line) for line in page.splitlines() if line.startswith(label) and line.count("|") == row.count("|")]
    return any(len(others) == len(found) and all(abs(x - y) <= max(16, 0.03 * x) for x, y in zip(found, others)) for others in shown)


def check_page(folder):
    """The tables of docs/embedding.md, where they were made with this compiler."""
    page = (ROOT / "docs" / "embedding.md").read_text()
    named = re.search(r"arm-none-eabi-gcc (\S+),", page)
    if not named or named.group(1) != compiler():
        return report("docs/embedding.md says which compiler its figures are of", "" if named else "it names none", f"{named and named.group(1)}, this is {compiler()}")
    wrong = [row for rows in (size_rows(folder), cost_rows(folder)) for row in rows if not is_shown(row, page)]
    return report("docs/embedding.md has these figures", f"it should have {wrong[0]!r}; `make firmware` prints all" if wrong else "")


def show(folder):
    print(run(folder / "host" / "robot").stdout)
    for core, (name, board, _) in CORES.items():
        same = play(core, folder / core / "robot.elf") == run(folder / "host" / "robot").stdout
        print(f"{name} ({board} in qemu) prints {'the same' if same else 'something else'}")
    print(f"\nBytes of code and constants, ours + our mathematics + the C library's and the compiler's (arm-none-eabi-gcc {compiler()}, -Os):\n")
    print("\n".join(size_rows(folder)))
    print("\nInstructions at most, and stack of our own frames (what was used of it, with the C library's), in a table of 256 rows:\n")
    print("\n".join(cost_rows(folder)))
    return 0


def main():
    job, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    if job == "show":
        return show(folder)
    bad = [check_rows(folder)]
    for core in CORES:
        bad += [test(folder, core) for test in (compare_robot, compare_bits, compare_mathematics, compare_golden, check_sizes, check_costs)]
    bad.append(check_page(folder))
    return int(any(bad))


if __name__ == "__main__":
    sys.exit(main())
