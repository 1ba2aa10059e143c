# SPDX-License-Identifier: MIT
"""A test program as a mutant sees it: its conditional instructions, where in the sources they stand, and how to turn each for good.

A conditional instruction is a jump, a set or a move. To take it always, or never, is a change of its own bytes that leaves its
length alone, so that nothing is compiled or linked again. Inline functions of headers are compiled, not inlined, into each
file; the copies in one program are one function here, and are changed together.
"""
import collections
import hashlib
import json
import os
import pathlib
import re
import resource
import signal
import struct
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDERS = ("src/base/", "src/geom/", "src/table/", "src/query/")
CONDITION = re.compile(r"(j(?!mp)|set|cmov)[a-z]+$")
# The tests take little memory; a mutant may want any amount.
MEMORY = 4 << 30

NOPS = {2: b"\x66\x90", 3: b"\x0f\x1f\x00", 4: b"\x0f\x1f\x40\x00", 5: b"\x0f\x1f\x44\x00\x00", 6: b"\x66\x0f\x1f\x44\x00\x00"}

# One condition in the code: its line, what the instruction is, and its addresses in this program (one a copy) with its bytes.
Site = collections.namedtuple("Site", "line mnemonic places")


def changed(code, always):
    """The bytes of a conditional instruction when its condition holds always, or never."""
    rex, rest = (code[:1], code[1:]) if code[0] & 0xf0 == 0x40 else (b"", code)
    kind = rest[0] & 0xf0 if len(code) == 2 else rest[1] & 0xf0
    if len(code) == 2 and kind == 0x70:
        return b"\xeb" + code[1:] if always else NOPS[2]
    if rest[0] == 0x0f and kind == 0x80 and len(code) == 6:
        return b"\x90\xe9" + code[2:] if always else NOPS[6]
    if rest[0] == 0x0f and kind == 0x90 and len(rest) == 3 and rest[2] >= 0xc0:
        return rex + bytes((0xc6, 0xc0 | rest[2] & 7, always))
    if rest[0] == 0x0f and kind == 0x40:
        return b"\x90" + rex + b"\x8b" + rest[2:] if always else NOPS.get(len(code)) or NOPS[4] + NOPS[len(code) - 4]
    raise SystemExit(f"mutation: no way to change the instruction {code.hex(' ')}")


def bodies(path):
    """(file, function, [(line, mnemonic, address, bytes) of each conditional instruction]) of each copy of each function in the program."""
    out = subprocess.run(["objdump", "-dlw", "-j", ".text", path], check=True, stdout=subprocess.PIPE, text=True).stdout
    for block in re.split(r"^[0-9a-f]+ (?=<)", out, flags=re.M)[1:]:
        head, _, rest = block.partition(">:\n")
        file, line, conditions = None, 0, []
        for row in rest.split("\n"):
            place = re.match(r"(/.*):(\d+)(?: \(discriminator \d+\))?$", row)
            if place:
                file, line = file or os.path.relpath(place[1], ROOT), int(place[2])
            parts = row.split("\t")
            if len(parts) > 2 and CONDITION.match(parts[2].split()[0]):
                conditions.append((line, parts[2].split()[0], int(parts[0].strip()[:-1], 16), bytes.fromhex(parts[1])))
        if file and file.startswith(FOLDERS):
            yield file, head[1:], conditions


def sites_of(path):
    """Site by (file, function, number in it); copies of a function must be alike."""
    copies = collections.defaultdict(list)
    for file, function, conditions in bodies(path):
        copies[file, function].append(conditions)
    found = {}
    for (file, function), alike in copies.items():
        shapes = {tuple((line, mnemonic) for line, mnemonic, _, _ in conditions) for conditions in alike}
        if len(shapes) > 1:
            raise SystemExit(f"mutation: the copies of {function}() of {file} in {path} differ")
        for number, (line, mnemonic) in enumerate(shapes.pop()):
            found[file, function, number] = Site(line, mnemonic, [(conditions[number][2], conditions[number][3]) for conditions in alike])
    return found


def segments(code):
    """(address, offset in the file, length) of what an ELF file of 64 bits loads."""
    start, size, count = struct.unpack_from("<Q", code, 32)[0], *struct.unpack_from("<HH", code, 54)
    for at in range(start, start + size * count, size):
        kind, _, offset, address, _, length = struct.unpack_from("<IIQQQQ", code, at)
        if kind == 1:
            yield address, offset, length


class Program:
    """A test program, what it holds and reaches, and how long it takes when nothing is changed."""

    def __init__(self, path, work, hits):
        self.path, self.name = pathlib.Path(path), pathlib.Path(path).name
        self.code = self.path.read_bytes()
        self.digest = hashlib.sha256(self.code).hexdigest()[:16]
        self.work = pathlib.Path(work)
        self.work.mkdir(parents=True, exist_ok=True)
        known = self.work / f"{self.name}-{self.digest}.json"
        if not known.exists():
            known.write_text(json.dumps(self.look(hits)))
        told = json.loads(known.read_text())
        self.seconds = told["seconds"]
        self.sites = {tuple(key): Site(line, mnemonic, [(at, bytes.fromhex(code)) for at, code in places]) for key, line, mnemonic, places in told["sites"]}
        reached = set(told["reached"])
        self.reached = {key for key, site in self.sites.items() if any(at in reached for at, _ in site.places)}

    def look(self, hits):
        before = os.times()
        if self.run(self.path, 600) != 0:
            raise SystemExit(f"mutation: {self.path} fails unchanged")
        after = os.times()
        sites = sites_of(self.path)
        listed = self.work / f"{self.name}.addresses"
        listed.write_text("".join(f"{at:x}\n" for site in sites.values() for at, _ in site.places))
        met = subprocess.run([hits, listed, self.path], check=True, stdout=subprocess.PIPE, cwd=ROOT, text=True).stdout
        return {"seconds": max(0.0, after.children_user + after.children_system - before.children_user - before.children_system),
                "sites": [[key, site.line, site.mnemonic, [[at, code.hex()] for at, code in site.places]] for key, site in sites.items()],
                "reached": [int(row, 16) for row in met.split()]}

    @staticmethod
    def run(path, seconds):
        """
        Its exit status; a number below 0 says which signal ended it, so SIGPROF's that it took more seconds of the processor. One that reports a
        failed test is not waited for: 1.
        """
        def limit():
            signal.setitimer(signal.ITIMER_PROF, seconds)
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        with subprocess.Popen([path], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              preexec_fn=limit) as process:
            for line in process.stderr:
                if b"[  FAILED  ]" in line:
                    process.kill()
                    return 1
            return process.wait()

    def kills(self, key, always):
        """How it ends with the condition changed: None when it notices nothing."""
        code = bytearray(self.code)
        loaded = list(segments(self.code))
        for address, found in self.sites[key].places:
            start, offset, _ = next(s for s in loaded if s[0] <= address < s[0] + s[2])
            at = address - start + offset
            code[at:at + len(found)] = changed(found, always)
        mutant = self.work / f"mutant-{os.getpid()}"
        mutant.write_bytes(code)
        mutant.chmod(0o755)
        status = self.run(mutant, 0.5 + 4 * self.seconds)
        if status == 0:
            return None
        return "fails" if status > 0 else "takes too long" if status == -signal.SIGPROF else "crashes"
