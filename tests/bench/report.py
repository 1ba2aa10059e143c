# SPDX-License-Identifier: MIT
"""docs/results.md and its pictures, from the CSV files of the bench."""
import math
import statistics

import chart
from common import read_csv

# Fitted from here: below, what does not depend on n outweighs the rest.
FIT_FROM = 1000
KINDS = ("random", "crowd", "mixed", "wall", "sealed", "fenced")
WITHOUT_PATH = ("sealed", "fenced")

TOP = """# Results

Made by `make bench` from [the CSV files](results) that it writes; do not edit. Times are medians of repeated runs after one to warm up, on one thread unless it
says otherwise; what takes long is run once. Bars in the pictures are the range over the seeds of the worlds, quartiles over the runs for look-up.
"""

SCALING = """## Cost over the number of discs

Worlds of `tdsp generate` in which the unit of thought is the mean spacing, so that they become larger and not harder. *sealed*: `random` with a closed ring of
three spacings' radius around the destination. *fenced*: with a ring half as wide as the scene. Neither has a path, and what is timed is the proof.

- *index*: a scene is made from its discs. *forward*: the first question to a new solver, the earliest arrival for departure 0. *within 1 %*: the same, but the
  travel time may exceed by a hundredth a lower bound that comes with it. *neighbour*: the earliest arrival for a departure later by a hundredth of the journey than the one asked before. *reverse*: the first question to a new solver, the latest departure for an arrival.
- A series ends where its question took over a second, or at 1,000,000 discs. Exponents *b* of *time ~ n^b* are fitted from 1,000 discs on.
"""

EPSILON = """## Rows and oracle calls over epsilon

The paper bounds the oracle calls by (2 / epsilon) ln(a_last / a_0): a_0 is the arrival of departure 0, a_last that of the last departure. *geometric* is its Algorithm 1.
"""

THREADS = """Threads, for tables of the guarantee *arrival* at 0.3 %. Efficiency is the speed-up by the number of threads; rows and bytes are the same for any number.
"""

ENVELOPE = """## Pieces of the arrival

How many pieces *F* the earliest arrival has as a function of the departure, found by `tdsp envelope`. The paper claims Omega(n^2). *nsquared*, *N* gaps and a chain of *N* discs, all discs of one rate, has
*N^2* at least ([derivation](math/pieces.md)). *columns*, a chain and two columns of gaps of one rate, is what comes to mind first; only the gaps add to it. *narrowest* is
the shortest piece of *nsquared*, where departures are told apart to 1e-4.
"""

LOOKUP = """## Look-up

Nanoseconds for one look-up in a table of so many rows. *independent*: the next question is known before the answer; *dependent*: it waits for it;
*batch*: one call for many. What else one could search a sorted array with is timed in the same run.
"""

PEERS = """## Beside what one would use instead

Exact baselines of our own ([tests/bench/tangents.c](../tests/bench/tangents.c)), and programs of others where they are at hand. *error* is of the travel time, against the library's exact
one; *slower* is by how much the peer's time exceeds the library's for one question, the scene being prepared (a peer's set-up is left out likewise).
"""

MEMORY = """## Memory

*index*: bytes a disc of a prepared scene, and the most that was held while it was prepared. *query*: what a solver holds after one forward question;
a scene is shared by all solvers. Medians over seeds, worlds of the kind *random*.
"""

REAL = """## Real scenes

*arrive* is *forward* of above: the first question to a new solver, at departure 0; the others are as above.
"""

TABLES = """### Tables at 1 %

The adaptive tables promise travel time or arrival time, the geometric one, which is Algorithm 1 of the paper, arrival time, the only promise that it can make.
*calls* are the sampler's forward and reverse searches; *seconds* are those of `tdsp build` on all processors, in parentheses on one thread. The last columns belong to the first
table: nanoseconds for one arrival, and for one position on the way, at departures in no order.
"""


def significant(value, digits=3):
    if value in ("", None):
        return ""
    text = f"{float(value):.{digits}g}"
    return f"{float(text):.0f}" if "e" in text and abs(float(text)) >= 1 and abs(float(text)) < 1e7 else text


def grid(head, rows, left=1):
    """A Markdown table; the first `left` columns are text."""
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join("---" if i < left else "--:" for i in range(len(head))) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


class Page:
    def __init__(self, docs):
        self.docs = docs
        self.data = docs / "results"
        self.pictures = docs / "pictures"
        self.pictures.mkdir(parents=True, exist_ok=True)
        self.machines = {row["section"]: row for row in read_csv(self.data / "machine.csv")}
        self.text = [TOP]

    def rows(self, table):
        return read_csv(self.data / f"{table}.csv")

    def section(self, name, text):
        measured = self.machines.get(name)
        self.text.append(text)
        if measured:
            self.text.append(f"Machine: {measured['machine']}; {measured['date']}.\n")

    def picture(self, name, alt, panels, columns, **style):
        if chart.draw(self.pictures / f"{name}.png", panels, columns, **style):
            self.text.append(f"![{alt}](pictures/{name}.png)\n")

    def write(self):
        (self.docs / "results.md").write_text("\n".join(self.text).rstrip() + "\n", encoding="utf-8")


def by_size(rows, column="ms"):
    """Points (discs, median, lowest, highest) over the seeds."""
    sizes = {}
    for row in rows:
        sizes.setdefault(int(row["wanted"]), []).append(float(row[column]))
    return [(size, statistics.median(values), min(values), max(values)) for size, values in sorted(sizes.items())]


def select(rows, **columns):
    return [row for row in rows if all(row[name] == value for name, value in columns.items())]


def fit(points):
    return chart.exponent([point for point in points if point[0] >= FIT_FROM])


def labelled(name, points):
    b = fit(points)
    return name if b is None else f"{name}  n^{{{b:.2f}}}"


def scaling_panel(rows, span, operation, title, kinds):
    series = []
    for kind in kinds:
        points = by_size(select(rows, world=kind, span=span, operation=operation))
        series.append(chart.Series(labelled(kind, points), points, KINDS.index(kind)))
    return chart.Panel(title, "discs", "milliseconds", series)


def query_panel(rows, span):
    series = []
    for kind in KINDS:
        points = [(size, *(value / 1024 for value in values)) for size, *values in
                  by_size(select(rows, world=kind, span=span, operation="forward"), "bytes")]
        series.append(chart.Series(labelled(kind, points), points, KINDS.index(kind)))
    return chart.Panel("memory of a query", "discs", "KiB", series)


def scaling_panels(rows, span):
    with_path = [kind for kind in KINDS if kind not in WITHOUT_PATH]
    return [scaling_panel(rows, span, "prepare", "index", KINDS),
            scaling_panel(rows, span, "forward", "forward", with_path),
            scaling_panel(rows, span, "within", "forward, within 1 %", with_path),
            scaling_panel(rows, span, "neighbour", "neighbour", with_path),
            scaling_panel(rows, span, "reverse", "reverse", with_path),
            scaling_panel(rows, span, "forward", "no path", WITHOUT_PATH),
            query_panel(rows, span)]


OPERATIONS = (("prepare", "index"), ("forward", "forward"), ("within", "within 1 %"), ("neighbour", "neighbour"), ("reverse", "reverse"))


def scaling_lines(rows, span, kind):
    """(title, {discs: milliseconds}, exponent) of each operation, and how much faster than a first question a neighbouring one is."""
    medians = {}
    for operation, name in OPERATIONS:
        points = by_size(select(rows, world=kind, span=span, operation=operation))
        if not points or (operation == "prepare" and kind != "random") or (operation == "within" and kind in WITHOUT_PATH):
            continue
        medians[operation] = {point[0]: point[1] for point in points}
        title = "no path" if kind in WITHOUT_PATH and operation == "forward" else name
        yield title, medians[operation], fit(points)
        if operation == "neighbour":
            first, next_one = medians["forward"], medians["neighbour"]
            yield "forward / neighbour", {size: first[size] / next_one[size] for size in next_one if size in first}, None


def scaling_table(rows, span):
    """Milliseconds at powers of ten, and the exponents."""
    sizes = sorted({int(row["wanted"]) for row in rows if row["span"] == span and row["wanted"].strip("0") == "1"})
    lines = [[kind, title, *(significant(values.get(size)) for size in sizes), "" if b is None else f"{b:.2f}"]
             for kind in KINDS for title, values, b in scaling_lines(rows, span, kind)]
    return grid(["ms", "", *(f"n = {size:,}" for size in sizes), "exponent"], lines, 2)


def write_scaling(page):
    rows = page.rows("scaling")
    if not rows:
        return
    page.section("scaling", SCALING)
    page.text.append("### Across the whole scene\n")
    page.picture("scaling-far", "Time over the number of discs, across the whole scene", scaling_panels(rows, "far"), 4)
    page.text.append(scaling_table(rows, "far"))
    if select(rows, span="near"):
        page.text.append("### Ends twenty spacings apart\n")
        page.picture("scaling-near", "Time over the number of discs, ends twenty spacings apart", scaling_panels(rows, "near"), 4)
        page.text.append(scaling_table(rows, "near"))


METHOD_NAMES = {("travel", "adaptive"): "adaptive, travel", ("arrival", "adaptive"): "adaptive, arrival",
                ("arrival", "geometric"): "geometric, arrival"}


def epsilon_points(rows, value):
    return [(float(row["epsilon"]), value(row)) for row in rows if not row["failed"]]


def calls(row):
    return int(row["forward_calls"]) + int(row["reverse_calls"])


def epsilon_panel(rows, scene, title, value, paper):
    mine = select(rows, scene=scene)
    series = [chart.Series(name, epsilon_points(select(mine, guarantee=how[0], sampling=how[1]), value), i)
              for i, (how, name) in enumerate(METHOD_NAMES.items())]
    if paper:
        bound = epsilon_points(select(mine, guarantee="travel"), lambda row: float(row["paper_calls"]))
        series.append(chart.Series("bound of the paper", bound, 6, dashed=True, bare=True))
    return chart.Panel(f"{scene}: {title}", "epsilon", title, series)


def epsilon_table(rows):
    lines = []
    for row in rows:
        name = METHOD_NAMES[row["guarantee"], row["sampling"]]
        if row["failed"]:
            lines.append([row["scene"], name, row["epsilon"], row["failed"], "", "", "", ""])
            continue
        lines.append([row["scene"], name, row["epsilon"], row["rows"], f"{row['forward_calls']} + {row['reverse_calls']}",
                      f"{calls(row) / int(row['rows']):.2f}", significant(row["paper_calls"], 4), significant(row["seconds"])])
    return grid(["scene", "rows placed, guarantee", "epsilon", "rows", "calls", "calls a row", "paper's bound", "seconds"], lines, 2)


def threads_table(rows):
    lines = []
    for row in rows:
        single = select(rows, scene=row["scene"], sampling=row["sampling"], threads="1")
        speed_up = float(single[0]["seconds"]) / float(row["seconds"])
        lines.append([row["scene"], row["sampling"], row["rows"], row["threads"], significant(row["seconds"]),
                      f"{significant(row['seconds_low'])} to {significant(row['seconds_high'])}", f"{speed_up / int(row['threads']):.2f}"])
    return grid(["scene", "rows placed", "rows", "threads", "seconds", "lowest to highest", "efficiency"], lines, 2)


def write_epsilon(page):
    rows = page.rows("epsilon")
    if not rows:
        return
    page.section("epsilon", EPSILON)
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    panels = [epsilon_panel(rows, scene, title, value, paper) for scene in scenes
              for title, value, paper in (("rows", lambda row: int(row["rows"]), False), ("oracle calls", calls, True))]
    page.picture("epsilon", "Rows and oracle calls over epsilon", panels, 2, key="top right", xformat="%g")
    page.text += [epsilon_table(rows), THREADS, threads_table(page.rows("threads"))]


def envelope_points(rows, kind):
    return [(int(row["gaps"]), int(row["pieces"])) for row in select(rows, kind=kind)]


def envelope_fit(points):
    """F ~ a N^b, by least squares of the logarithms."""
    b = chart.exponent(points)
    if b is None:
        return None
    return math.exp(statistics.fmean(math.log(pieces) - b * math.log(gaps) for gaps, pieces in points)), b


def write_envelope(page):
    rows = page.rows("envelope")
    if not rows:
        return
    page.section("envelope", ENVELOPE)
    series, fits = [], []
    for i, kind in enumerate(dict.fromkeys(row["kind"] for row in rows)):
        points = envelope_points(rows, kind)
        series.append(chart.Series(kind, points, i))
        for least in (2, 5):
            found = envelope_fit([point for point in points if point[0] >= least])
            if found:
                fits.append(f"*{kind}* from N = {least} on {found[0]:.2f} N^{found[1]:.2f}")
    gaps = [point[0] for point in envelope_points(rows, "nsquared")]
    series.append(chart.Series("N^2", [(n, n * n) for n in gaps], 6, dashed=True, bare=True))
    page.picture("envelope", "Pieces of the arrival over the number of gaps", [chart.Panel("pieces", "gaps N", "F", series)], 1, xformat="%g")
    lines = []
    for n in gaps:
        ours, columns = select(rows, kind="nsquared", gaps=str(n))[0], select(rows, kind="columns", gaps=str(n))[0]
        lines.append([n, ours["discs"], n * n, ours["pieces"], f"{int(ours['pieces']) / n**2:.2f}", ours["jumps"], ours["narrowest"], columns["discs"], columns["pieces"]])
    page.text.append(grid(["N", "discs", "N^2", "F", "F / N^2", "jumps", "narrowest", "columns: discs", "F"], lines, 0))
    page.text.append(f"Least squares of the logarithms: {'; '.join(fits)}.\n")


def lookup_panel(rows, queries, kinds):
    series = []
    for ours in (True, False):
        mine = [kind for kind in kinds if kind.startswith("tdsp") == ours]
        for i, kind in enumerate(mine):
            points = [tuple(float(row[column]) for column in ("rows", "ns_median", "ns_low", "ns_high"))
                      for row in select(rows, kind=kind, queries=queries)]
            series.append(chart.Series(kind, points, i, heavy=ours))
    return chart.Panel(queries, "rows", "nanoseconds a look-up", series)


def write_lookup(page):
    rows = page.rows("lookup")
    if not rows:
        return
    page.section("lookup", LOOKUP)
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    panels = [lookup_panel(rows, queries, kinds) for queries in dict.fromkeys(row["queries"] for row in rows)]
    page.picture("look-up", "Time of a look-up over the rows of the table", panels, 2, key="outside")
    sizes = list(dict.fromkeys(row["rows"] for row in rows))
    lines = []
    for kind in kinds:
        for queries in dict.fromkeys(row["queries"] for row in select(rows, kind=kind)):
            found = {row["rows"]: row["ns_median"] for row in select(rows, kind=kind, queries=queries)}
            lines.append([kind, queries, *(significant(found.get(size)) for size in sizes)])
    page.text.append(grid(["ns", "queries", *(f"{int(size):,} rows" for size in sizes)], lines, 2))


def write_peers(page):
    rows = page.rows("peers")
    if not rows:
        return
    page.section("peers", PEERS)
    lines = []
    for row in rows:
        who = row["peer"] + (", theirs" if row["source"] == "peers" and "tangent" in row["peer"] else "")
        if row["failed"]:
            lines.append([row["scene"], who, row["setting"], row["failed"], "", "", "", ""])
            continue
        ours = float(next(one["seconds"] for one in rows if one["scene"] == row["scene"]))
        spread = f"{significant(1e3 * float(row['seconds_low']))} to {significant(1e3 * float(row['seconds_high']))}" if row["seconds_low"] else ""
        slower = "" if row is next(one for one in rows if one["scene"] == row["scene"]) else f"{significant(float(row['seconds']) / ours)} x"
        setup = significant(1e3 * float(row["setup_seconds"])) if row["setup_seconds"] else ""
        lines.append([row["scene"], who, row["setting"], significant(1e3 * float(row["seconds"])), spread, setup, row["travel_error"], slower])
    page.text.append(grid(["world", "peer", "setting", "ms", "spread", "set-up ms", "error", "slower"], lines, 3))
    if not any(row["source"] == "peers" for row in rows):
        page.text.append("Programs of others were not at hand when this was measured: fast marching, any-angle grid search and OMPL are missing.\n")


def write_memory(page):
    rows = select(page.rows("scaling"), world="random")
    if not rows:
        return
    page.section("scaling", MEMORY)
    lines = []
    for size in sorted({int(row["wanted"]) for row in rows}):
        here = [row for row in rows if int(row["wanted"]) == size]
        cells = [f"{size:,}"]
        for span, operation, column, per in (("far", "prepare", "bytes", size), ("far", "prepare", "peak_bytes", size),
                                             ("far", "workspace", "bytes", 1024), ("near", "forward", "bytes", 1024), ("far", "forward", "bytes", 1024)):
            values = [int(row[column]) / per for row in select(here, span=span, operation=operation)]
            cells.append(significant(statistics.median(values)) if values else "")
        lines.append(cells)
    page.text.append(grid(["discs", "index: bytes a disc", "at most", "new solver [KiB]", "query, near [KiB]", "query, far [KiB]"], lines, 0))
    tables = [row for row in page.rows("tables") if not row["failed"]]
    if tables:
        shares = sorted(int(row["bytes"]) / int(row["rows"]) for row in tables)
        page.text.append(f"Tables of the real scenes below take {shares[0]:.0f} to {shares[-1]:.0f} bytes a row with its path, {statistics.median(shares):.0f} in the median.\n")


def real_scenes(rows):
    lines = []
    for name in dict.fromkeys(row["world"] for row in rows):
        mine = {row["operation"]: row for row in select(rows, world=name)}
        if "" in mine or "forward" not in mine:
            lines.append([name, "", next(iter(mine.values()))["failed"], "", "", "", "", "", ""])
            continue
        asked = mine["forward"]
        cells = [significant(mine[operation]["ms"]) if operation in mine else "" for operation in ("prepare", "forward", "within", "neighbour", "reverse")]
        arrival = significant(asked["answer"], 6) if asked["status"] == "ok" else asked["status"]
        lines.append([name, asked["discs"], *cells, arrival, significant(int(asked["bytes"]) / 1024)])
    return grid(["scene", "discs", "prepare [ms]", "arrive [ms]", "within 1 % [ms]", "neighbour [ms]", "reverse [ms]", "T(0)", "query [KiB]"], lines)


def table_cells(row, single=None):
    if row["failed"]:
        return [row["failed"], "", "", ""]
    seconds = significant(row["seconds"]) + (f" ({significant(single['seconds'])})" if single and single["seconds"] else "")
    return [row["rows"], f"{row['forward_calls']} + {row['reverse_calls']}", row["bytes"], seconds]


def real_tables(rows):
    lines = []
    for name in dict.fromkeys(row["scene"] for row in rows):
        mine = {(row["guarantee"], row["sampling"], row["threads"]): row for row in select(rows, scene=name)}
        single = mine["travel", "adaptive", "1"]
        end = "" if single["failed"] else f"{significant(single['last_departure'], 6)} {'horizon given' if single['horizon'] else single['last_reason']}"
        lines.append([name, end, *table_cells(mine["travel", "adaptive", "all"], single), *table_cells(mine["arrival", "adaptive", "all"]),
                      *table_cells(mine["arrival", "geometric", "all"]), single["arrival_ns"], single["position_ns"]])
    head = ["scene", "last departure, and then"]
    for method in ("adaptive, travel", "adaptive, arrival", "geometric, arrival"):
        head += [f"{method}: rows", "calls", "bytes", "seconds"]
    return grid(head + ["arrival [ns]", "position [ns]"], lines, 2)


def sampler_sums(rows):
    """Calls a row over all tables, and how adaptive rows compare with Algorithm 1's."""
    done = [row for row in rows if not row["failed"] and row["threads"] == "all"]
    sentences = []
    for (guarantee, sampling), name in METHOD_NAMES.items():
        mine = select(done, guarantee=guarantee, sampling=sampling)
        if mine:
            shares = [calls(row) / int(row["rows"]) for row in mine]
            sentences.append(f"{name} {statistics.fmean(shares):.2f} in the mean of the tables, {sum(map(calls, mine)) / sum(int(row['rows']) for row in mine):.2f} over all rows")
    geometric = {row["scene"]: int(row["rows"]) for row in select(done, sampling="geometric")}
    adaptive = {row["scene"]: int(row["rows"]) for row in select(done, guarantee="arrival", sampling="adaptive")}
    both = [scene for scene in adaptive if scene in geometric]
    more = [scene for scene in both if adaptive[scene] > geometric[scene]]
    return (f"Calls a row: {'; '.join(sentences)}. For the guarantee *arrival*, adaptive tables have more rows than Algorithm 1 in {len(more)} of {len(both)} "
            f"scenes{': ' + ', '.join(more) if more else ''}, and {significant(sum(adaptive[scene] for scene in both) / max(1, sum(geometric[scene] for scene in both)))} "
            "times as many in all.\n")


def write_real(page):
    rows = page.rows("scenes")
    if not rows:
        return
    page.section("real", REAL)
    tables = page.rows("tables")
    page.text += [real_scenes(rows), TABLES, real_tables(tables), sampler_sums(tables)]


def write(docs):
    page = Page(docs)
    for part in (write_peers, write_scaling, write_memory, write_epsilon, write_envelope, write_lookup, write_real):
        part(page)
    page.write()
