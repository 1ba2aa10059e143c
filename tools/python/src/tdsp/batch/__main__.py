# SPDX-License-Identifier: MIT
"""The command: python -m tdsp.batch scenes|pairs|resume|status.

Exit status: 0 done; 1 done, and some items ended in an error, which their rows say; 2 usage; 3 invalid input; 4 the system failed, run it again.
"""
from __future__ import annotations

import argparse
import json
import logging
import math
import os
import sys
import time
from typing import Any, Optional

try:
    import distributed
    import pyarrow  # noqa: F401
except ImportError as error:
    sys.exit(f"tdsp.batch: {error}: pip install tdsp[batch]")

from ..errors import DataError, TdspError, UsageError
from ..sampler import Options
from . import plan as plans
from .plan import Item, Plan, Questions
from .run import Outcome, run
from .work import found_part, items_file


def times(text: str) -> list[float]:
    """Times, separated by commas."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r}: must be numbers, separated by commas") from None


def parser() -> argparse.ArgumentParser:
    whole = argparse.ArgumentParser(prog="python -m tdsp.batch", description="Thousands of scenes, or of pairs of places in one scene, over a Dask cluster. "
                                    "Whatever is killed, the same command goes on where it stopped.")
    commands = whole.add_subparsers(dest="command", required=True)
    scenes = commands.add_parser("scenes", help="ask the same of many scenes")
    scenes.add_argument("paths", nargs="+", metavar="PATH", help=".json file, .jsonl file with a scene a line, or a folder of them")
    pairs = commands.add_parser("pairs", help="ask the same of many pairs of places in one scene")
    pairs.add_argument("scene", metavar="SCENE")
    pairs.add_argument("--pairs", metavar="FILE", help="a pair a line: sx,sy,dx,dy and a name")
    pairs.add_argument("--sources", metavar="FILE", help="a place a line: x,y and a name; with --destinations: all pairs")
    pairs.add_argument("--destinations", metavar="FILE")
    for command in (scenes, pairs):
        _ask_arguments(command)
    resume = commands.add_parser("resume", help="go on with a batch that was stopped")
    resume.add_argument("output", metavar="OUT")
    for command in (scenes, pairs, resume):
        _run_arguments(command)
    status = commands.add_parser("status", help="how far a batch is")
    status.add_argument("output", metavar="OUT")
    status.add_argument("--json", action="store_true")
    return whole


def _ask_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("-o", "--output", required=True, metavar="OUT", help="folder of the results; every worker must see it")
    command.add_argument("--departures", type=times, default=[], metavar="T,T,...", help="ask for the earliest arrivals")
    command.add_argument("--arrivals", type=times, default=[], metavar="A,A,...", help="ask for the latest departures; inf: the last of all")
    command.add_argument("--tables", action="store_true", help="build a table of each item")
    command.add_argument("--guarantee", default="travel", choices=["travel", "arrival", "absolute"])
    command.add_argument("--epsilon", type=float, default=0.01, metavar="E")
    command.add_argument("--delta", type=float, default=0.0, metavar="D")
    command.add_argument("--sampling", default="adaptive", choices=["adaptive", "geometric"])
    command.add_argument("--horizon", type=float, default=math.inf, metavar="H")
    command.add_argument("--part", type=int, default=16, metavar="N", help="items a part: what is done or not done as one (default 16)")


def _run_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument("--workers", type=int, default=os.cpu_count() or 1, metavar="N", help="processes on this machine (default: one for each core)")
    command.add_argument("--scheduler", metavar="ADDRESS", help="a Dask scheduler that runs already, in the place of processes here")
    command.add_argument("--retries", type=int, default=3, metavar="N", help="how often a part that fails is tried again (default 3)")
    command.add_argument("--json", action="store_true", help="print the outcome as JSON")


def make_plan(arguments: argparse.Namespace) -> Plan:
    if arguments.command == "resume":
        return Plan.load(arguments.output)
    options = Options(arguments.guarantee, arguments.epsilon, arguments.delta, arguments.sampling, arguments.horizon)
    questions = Questions(arguments.departures, arguments.arrivals, arguments.tables, options)
    return Plan.make(_items(arguments), questions, arguments.part)


def _items(arguments: argparse.Namespace) -> list[Item]:
    if arguments.command == "scenes":
        return plans.read_scenes(arguments.paths)
    lists = arguments.sources, arguments.destinations
    if arguments.pairs and not any(lists):
        return plans.read_pairs(arguments.scene, pairs=arguments.pairs)
    if arguments.pairs or not all(lists):
        raise UsageError("pairs: --pairs, or --sources and --destinations")
    return plans.read_pairs(arguments.scene, plans.read_places(arguments.sources), plans.read_places(arguments.destinations))


class Bar:
    """A line on a terminal; nothing where standard error is none."""

    def __init__(self) -> None:
        self.begun, self.first = time.monotonic(), -1

    def __call__(self, done: int, all: int, errors: int) -> None:
        if not sys.stderr.isatty():
            return
        self.first = done if self.first < 0 else self.first
        seconds = time.monotonic() - self.begun
        left = f", {seconds / (done - self.first) * (all - done):.0f} s left" if done > self.first else ""
        bar = "#" * (30 * done // all)
        print(f"\r[{bar:30}] {done}/{all} items, {errors} with errors{left}    ", end="\n" if done == all else "", file=sys.stderr, flush=True)


def cluster(arguments: argparse.Namespace) -> Any:
    if arguments.scheduler:
        return distributed.Client(arguments.scheduler, set_as_default=False)
    local = distributed.LocalCluster(n_workers=arguments.workers, threads_per_worker=1, processes=True, dashboard_address=None,
                                     silence_logs=logging.CRITICAL)
    return distributed.Client(local, set_as_default=False)


def print_outcome(outcome: Outcome, output: str, seconds: float, as_json: bool) -> None:
    if as_json:
        print(json.dumps({"items": outcome.items, "errors": outcome.errors, "parts": outcome.parts, "found": outcome.found, "seconds": seconds,
                          "worker_seconds": outcome.seconds, "unfinished": len(outcome.unfinished), "output": output}))
        return
    before = f", {outcome.found} of them done before" if outcome.found else ""
    print(f"{output}: {outcome.items} items in {outcome.parts} parts{before}; {outcome.errors} with errors; {seconds:.1f} s")


def report(arguments: argparse.Namespace, plan: Plan) -> int:
    begun = time.monotonic()
    client = cluster(arguments)
    try:
        outcome = run(plan, arguments.output, client, retries=arguments.retries, progress=Bar())
    finally:
        inside = client.cluster
        client.close()
        if inside is not None:
            inside.close()
    print_outcome(outcome, arguments.output, time.monotonic() - begun, arguments.json)
    for part, reason in list(outcome.unfinished.items())[:5]:
        print(f"tdsp.batch: part {part} is not done: {reason}", file=sys.stderr)
    return 4 if outcome.unfinished else int(outcome.errors > 0)


def status(output: str, as_json: bool) -> int:
    plan = Plan.load(output)
    done = [found_part(output, part) for part in range(plan.parts) if items_file(output, part).exists()]
    items, errors = sum(part.items for part in done), sum(part.errors for part in done)
    if as_json:
        print(json.dumps({"items": items, "of": len(plan.items), "parts": len(done), "of_parts": plan.parts, "errors": errors}))
    else:
        print(f"{output}: {items} of {len(plan.items)} items, {len(done)} of {plan.parts} parts; {errors} with errors")
    return 0


def main(argv: Optional[list[str]] = None) -> int:
    arguments = parser().parse_args(argv)
    try:
        if arguments.command == "status":
            return status(arguments.output, arguments.json)
        if arguments.workers < 1 or arguments.retries < 0:
            raise UsageError("--workers is at least 1, --retries at least 0")
        return report(arguments, make_plan(arguments))
    except UsageError as error:
        print(f"tdsp.batch: {error}", file=sys.stderr)
        return 2
    except DataError as error:
        print(f"tdsp.batch: {error}", file=sys.stderr)
        return 3
    except (TdspError, OSError) as error:
        print(f"tdsp.batch: {error}", file=sys.stderr)
        return 4
    except KeyboardInterrupt:
        print("\ntdsp.batch: stopped; the same command goes on from here", file=sys.stderr)
        return 4


if __name__ == "__main__":
    sys.exit(main())
