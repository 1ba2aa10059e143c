#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hold docs/schema to the command: check_schemas.py COMMAND [EVERY]

What the command prints with --json is valid, with no member that the schema does not have. Every scene of the project is valid. And scenes broken in every
place in every way are refused by the schema where the command refuses them, and only there, but for what a schema cannot say (SAID_BY_THE_COMMAND_ONLY); of the broken
scenes each EVERYth is tried, all by default.
"""
import copy
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import warnings

warnings.simplefilter("ignore", DeprecationWarning)
try:
    import jsonschema
except ImportError:
    # Debian's package belongs to Debian's Python.
    if sys.executable == "/usr/bin/python3":
        sys.exit("jsonschema is missing: 'make packages' installs it")
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMAS = ROOT / "docs/schema"
SCENES = ROOT / "examples/scenes"

# Reasons of the command that compare numbers with each other.
SAID_BY_THE_COMMAND_ONLY = ("shrinks", "times must increase", "rates for")

failed = 0


def check(sentence, problems):
    global failed
    print(f"{'not ok' if problems else 'ok'} schemas: {sentence}")
    for problem in problems[:5]:
        print(f"    {problem}")
    failed += bool(problems)


def strict(schema):
    """The same without members that are not named: later versions may add some, this one has none."""
    if isinstance(schema, list):
        return [strict(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    made = {key: strict(value) for key, value in schema.items()}
    if schema.get("type") == "object" and "properties" in schema:
        made["unevaluatedProperties"] = False
    return made


def with_common(schema, common):
    """The same with what it uses of common.json inside, so that no validator has to look for a file."""
    def within(part, own):
        if isinstance(part, list):
            return [within(one, own) for one in part]
        if not isinstance(part, dict):
            return part
        made = {key: within(value, own) for key, value in part.items()}
        if "$ref" in made:
            made["$ref"] = made["$ref"].replace("#/$defs/" if own else "common.json#/$defs/", "#/$defs/common_")
        return made

    shared = {f"common_{name}": within(part, True) for name, part in common["$defs"].items()}
    return {**within(schema, False), "$defs": {**within(schema.get("$defs", {}), False), **shared}}


def validators(change):
    documents = {path.stem: change(json.loads(path.read_text(encoding="utf-8"))) for path in sorted(SCHEMAS.glob("*.json"))}
    common = documents.pop("common")
    return {name: jsonschema.Draft202012Validator(with_common(document, common)) for name, document in documents.items()}


def problems_of(validator, value):
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:160]}" for error in validator.iter_errors(value)]


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)


# ---------------------------------------------------------------------------------------------------------------- outputs

def output_lines():
    """Command lines that together print every form of every output; earlier ones make what later ones read."""
    scene, curved, wall = SCENES / "two-discs.json", SCENES / "fires-accelerating.json", "wall.json"
    forecast, road = SCENES / "fires-forecast.json", SCENES / "fire-oregon-c.json"
    build = ["build", scene, "-o", "t.tdsp"]
    return [
        ("generate", "wall", "--n", 30, "-o", wall), ("generate", "crowd", "--seed", 2**64 - 1, "-o", "crowd.json"),
        ("arrive", scene, 0, 9.85, 100), ("arrive", road, 50, "--within", 0.01), ("arrive", scene, 100, "--within", 1), ("arrive", curved, 5),
        ("depart", scene, 5, 33, 1000), ("depart", curved, 600), ("margin", scene, 5, 12, 100, "--deadline", 30), ("margin", scene, 5), ("margin", curved, 5),
        ("path", scene, 20), ("path", curved, 5), ("path", scene, 100), ("path", scene, 20, "--at", 7), ("path", scene, 100, "--at", 7),
        ("path", scene, 20, "--within", 0.1), ("jumps", scene), ("jumps", road), ("envelope", scene), ("envelope", wall, "--resolution", 1),
        tuple(build), (*build, "--guarantee", "arrival", "--sampling", "geometric", "--epsilon", 0.1), (*build, "--guarantee", "absolute", "--delta", 1),
        ("build", scene, "-o", "none.tdsp", "--from", "0,3"), ("build", forecast, "-o", "curved.tdsp", "--epsilon", 0.1),
        ("matrix", scene, "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm"),
        ("matrix", scene, "--sources", "covered.csv", "--destinations", "to.csv", "-o", "none.tdspm"),
        ("query", "t.tdsp", 0, 100), ("query", "t.tdsp", "--arrive-by", 0, 33), ("query", "m.tdspm", "--from", 0, "--to", 0, 5),
        ("info", "t.tdsp"), ("info", "curved.tdsp"), ("info", "m.tdspm"), ("path", "t.tdsp", 5), ("path", "t.tdsp", 500), ("path", "t.tdsp", 5, "--at", 7),
        ("verify", scene, "t.tdsp"), ("verify", road, "t.tdsp"), ("verify", scene, "m.tdspm"), ("verify", scene, "path.json"),
        ("plot", scene, "-o", "a.svg"), ("plot", "t.tdsp", "-o", "a.svg"), ("plot", scene, "-o", "a.svg", "--depart", 100),
        ("convert", SCENES / "fires-made-up.geojson", "--speed", 6, "-o", "fires.json"), ("convert", scene, "-o", "scene.csv"),
        ("convert", "path.json", "--scene", scene, "-o", "path.csv"), ("embed", "t.tdsp", "-o", "t.c"), ("help",), ("help", "arrive"),
        ("view", scene, "-o", "a.html", "--no-open"), ("view", "t.tdsp", "-o", "a.html", "--no-open"),
    ]


def check_outputs(program, schemas):
    pathlib.Path("from.csv").write_text("-10,0,gate\n-10,5\n0,3\n")
    pathlib.Path("covered.csv").write_text("0,3\n")
    pathlib.Path("to.csv").write_text("10,0,school\n")
    pathlib.Path("page.html").write_text('<script type="application/json" id="given">null</script></html>\n')
    os.environ["TDSP_PAGE"] = os.path.abspath("page.html")
    pathlib.Path("path.json").write_text(run(program, "path", SCENES / "two-discs.json", 20, "--json").stdout)
    commands = {"help"} | {command["name"] for command in json.loads(run(program, "help", "--json").stdout)["commands"]}
    printed = {command: [] for command in commands}
    for line in output_lines():
        done = run(program, *line, "--json")
        said = done.stdout if done.returncode in (0, 1) and done.stdout else None
        printed[line[0]].append((" ".join(map(str, line)), said, f"exit status {done.returncode}: {done.stderr}"))
    for command, outputs in sorted(printed.items()):
        if command not in schemas:
            check(f"{command} has a schema", [f"docs/schema/{command}.json is missing"])
            continue
        problems = [f"{line}: {problem}" for line, said, why in outputs for problem in (problems_of(schemas[command], json.loads(said)) if said else [why])]
        check(f"{len(outputs)} outputs of {command} are valid", problems or ([] if outputs else ["no line above prints one"]))
        check(f"an empty object is no output of {command}", [] if problems_of(schemas[command], {}) else ["it is valid"])


# ----------------------------------------------------------------------------------------------------------------- scenes

VALUES = [None, True, "x", "", 0, 1, -1, 0.5, 1e100, 1.1e100, -1.1e100, [], [0], [0, 0], [0, 91], [181, 0], [-180, 90], [0, 0, 0], [1, "2"], [None, 1], [0.1] * 8, [0.1] * 9, {}, {"times": [0], "rates": [1]},
          {"times": [0, 5], "rates": [1]}, {"times": [], "rates": []}, {"times": [1], "rates": [1]}, {"times": [0, 5], "rates": [1, -1]}, {"times": [0]}]
BASES = [
    {"name": "n", "units": {"length": "m", "time": "s"}, "robot": {"speed": 1, "radius": 0.25}, "source": [-10, 0], "destination": [10, 0],
     "discs": [{"center": [0, 3], "radius": 1, "growth": 0.1}]},
    {"robot": {"speed": 1}, "source": [-10, 0], "destination": [10, 0],
     "georeference": {"origin": [-120, 44], "projection": "azimuthal equidistant", "ellipsoid": "WGS84"},
     "discs": [{"center": [0, 3], "radius": 1, "growth": {"times": [0, 5], "rates": [0.1, 0.2]}}, {"center": [0, -3], "radius": 1, "growth": [0.1, 0.01]}]},
]


def places(value, before=()):
    """The path of everything inside a value, itself first."""
    yield before
    for key, part in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield from places(part, (*before, key))


def broken(base):
    """The base with one place replaced by each value, or taken away."""
    for place in places(base):
        for value in VALUES:
            changed = copy.deepcopy(base)
            if place:
                inside = changed
                for key in place[:-1]:
                    inside = inside[key]
                inside[place[-1]] = value
            yield changed if place else value
        if place:
            changed = copy.deepcopy(base)
            inside = changed
            for key in place[:-1]:
                inside = inside[key]
            del inside[place[-1]]
            yield changed


def check_broken(program, schema, every):
    disagreed, refused, accepted = [], 0, 0
    for scene in itertools.islice(itertools.chain.from_iterable(map(broken, BASES)), 0, None, every):
        done = subprocess.run([program, "arrive", "-", "0"], input=json.dumps(scene), capture_output=True, text=True, check=False)
        is_refused = done.returncode == 3
        if is_refused and any(reason in done.stderr for reason in SAID_BY_THE_COMMAND_ONLY):
            continue
        refused, accepted = refused + is_refused, accepted + (not is_refused)
        if is_refused == schema.is_valid(scene):
            disagreed.append(f"{json.dumps(scene)}: exit status {done.returncode}: {done.stderr.strip()}")
    check(f"{refused} broken scenes are refused by command and schema, {accepted} are taken by both", disagreed or ([] if refused > 200 and accepted > 20 else ["too few"]))


def scenes():
    for folder in ("examples", "tests"):
        for path in sorted((ROOT / folder).rglob("*.json")):
            content = json.loads(path.read_text(encoding="utf-8"))
            if isinstance(content, dict) and "discs" in content and "robot" in content:
                yield path.relative_to(ROOT), content


def check_scenes(program, schema):
    found = dict(scenes())
    check(f"{len(found)} scenes of examples and tests are valid", [f"{path}: {problem}" for path, content in found.items() for problem in problems_of(schema, content)]
          or ([] if found else ["there are none"]))
    kinds = json.loads(run(program, "help", "generate", "--json").stdout)["arguments"]["KIND"]["words"]
    made = {kind: json.loads(run(program, "generate", kind, "--n", 9).stdout) for kind in kinds}
    check(f"{len(made)} made-up scenes are valid", [f"{kind}: {problem}" for kind, content in made.items() for problem in problems_of(schema, content)])


def main(program, every="1"):
    program = os.path.abspath(program)
    lenient, schemas = validators(lambda schema: schema), validators(strict)
    check("each is a schema of draft 2020-12", [f"{name}: {error}" for name, validator in lenient.items() for error in
                                                jsonschema.Draft202012Validator(jsonschema.Draft202012Validator.META_SCHEMA).iter_errors(validator.schema)])
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        check_outputs(program, schemas)
        os.chdir("/")
    check_scenes(program, lenient["scene"])
    check_broken(program, lenient["scene"], int(every))
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
