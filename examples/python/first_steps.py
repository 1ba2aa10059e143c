# SPDX-License-Identifier: MIT
"""From a scene to a table and back: exact answers, certified ones, a path, and who says that it is safe."""
import pathlib
import tempfile

import numpy as np
import tdsp

# Two wells leak: what they cover grows by 0.1 m/s, and the straight way leads between them.
scene = tdsp.Scene(speed=1.0, source=(-10, 0), destination=(10, 0), centers=[[0, 3], [0, -3]], radii=1.0, growth=0.1,
                   length_unit="m", time_unit="s")

solver = scene.solver()
print(f"leave at 0, arrive at {solver.arrival(0.0):.4f}")
latest = solver.latest_departure(33.0)
gap = solver.gap(latest)
print(f"to arrive by 33, leave by {latest:.4f}: then the gap between discs {gap.first} and {gap.second} closes")

# A table answers for every departure; many at once in one call.
table = scene.build(epsilon=0.01)
departures = np.array([0.0, 5.0, 9.8, 9.9, 100.0])
lower, upper, status = table.arrivals(departures)
for departure, low, high, why in zip(departures, lower, upper, tdsp.named(status)):
    print(f"leave at {departure:5.1f}: arrive between {low:.3f} and {high:.3f} ({why})")

# A file is read in place, and its paths are safe whoever checks them.
with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "gate.tdsp"
    table.save(file)
    with tdsp.Table.open(file) as opened:
        path = opened.path(12.0)
        print(f"leave at 12 along {len(path)} legs; at 20 the robot is at ({path.position(20.0).x:.3f}, {path.position(20.0).y:.3f})")
        print("the path is clear:", bool(path.verify(scene)), "- the table is sound:", bool(opened.verify(scene)))

# Where there is no way, the class of the exception says why.
try:
    table.arrival(100.0)
except tdsp.DestinationCovered as no:
    print(no)
