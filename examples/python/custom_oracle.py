# SPDX-License-Identifier: MIT
"""A world of one's own: roads with a rush hour and a ferry that leaves every half hour, as an oracle in Python.

The library's search finds the fastest way, the conformance kit finds out whether the oracle keeps its promises, and the library's sampler makes a
table whose rows hold the route. Times are minutes after six.
"""
import math
from typing import Callable, Optional

import tdsp

PLACES = ["home", "bridge", "quay", "office"]
HOME, BRIDGE, QUAY, OFFICE = range(4)


def rush(minutes: float) -> Callable[[float], float]:
    """A road that takes twice as long from 90 to 150. Who enters later never leaves it earlier: the change takes as long as the road gets longer."""
    def arrival(time: float) -> float:
        late = min(max((time - 90) / (2 * minutes), 0.0), 1.0) - min(max((time - 150) / (2 * minutes), 0.0), 1.0)
        return time + minutes * (1 + late)
    return arrival


def road(minutes: float) -> Callable[[float], float]:
    return lambda time: time + minutes


def ferry(minutes: float) -> Callable[[float], float]:
    """Leaves every 30 minutes until 270; then there is none."""
    return lambda time: 30.0 * math.ceil(time / 30) + minutes if time <= 270 else math.inf


ROADS = {HOME: [(BRIDGE, rush(15)), (QUAY, road(10))], BRIDGE: [(OFFICE, rush(20))], QUAY: [(OFFICE, ferry(12))], OFFICE: []}


class Commute(tdsp.Oracle):
    """When does one arrive at the office who leaves home at `t`?"""

    monotone = "arrival"  # who is early waits

    def __init__(self) -> None:
        self.route: list[int] = []

    def earliest_arrival(self, departure: float) -> float:
        if departure > 300:
            raise tdsp.Unreachable  # nobody goes to work after eleven
        reached: dict[int, float] = {}
        before: dict[int, Optional[int]] = {}

        def expand(label: tdsp.Label, open: tdsp.Open) -> bool:
            if label.id not in reached:
                reached[label.id], before[label.id] = label.time, label.kind or None
                for to, arrival in ROADS[label.id]:
                    when = arrival(label.time)
                    if when < math.inf:
                        open.push(tdsp.Label(when, to, label.id + 1))
            return label.id == OFFICE

        tdsp.search([tdsp.Label(departure, HOME)], expand)
        self.route, place = [OFFICE], before[OFFICE]
        while place:
            self.route.insert(0, place - 1)
            place = before[place - 1]
        return reached[OFFICE]

    def path(self) -> bytes:
        return bytes(self.route)


oracle = Commute()
findings = tdsp.check_oracle(oracle)
print("the oracle keeps its promises:", bool(findings), f"({len(findings.looked_at)} rules looked at)")

table = tdsp.build(oracle, guarantee="absolute", delta=1.0, about=tdsp.About(time_unit="min"))
print(table.info.rows > 20, table.info.last_departure, table.info.last_reason.name)
for departure in (0.0, 40.0, 100.0, 119.0, 295.0):
    lower, upper = table.arrival(departure)
    route = " - ".join(PLACES[place] for place in table.row_bytes(table.row_at(departure)))
    print(f"leave at {departure:3.0f}: arrive between {lower:.1f} and {upper:.1f} by {route}")
print(f"to be there by 150, leave by {table.departure(150.0).departure:.1f}")
