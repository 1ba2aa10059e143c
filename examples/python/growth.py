# SPDX-License-Identifier: MIT
"""Discs that grow otherwise than at one rate: polynomials, rates that change, and any function of time."""
import math

import tdsp

fire = tdsp.Rates(times=[0, 30, 60], rates=[0.05, 0.3, 0.1])  # the wind rises, and falls
spill = tdsp.Polynomial([0.3, -0.001])  # R(t) = radius + 0.3 t - 0.001 t^2: it shrinks from 150 on
smoke = tdsp.Law(lambda t: (2 + 3 * math.log1p(t / 10), 3 / (10 + t)), until=200.0)  # ever more slowly

scene = tdsp.Scene(1.0, source=(-40, 0), destination=(40, 0), centers=[(-15, 2), (5, -3), (20, 4)], radii=[1, 1, 2], growth=[fire, spill, smoke])
solver = scene.solver()
print(f"method {solver.method}; no radius shrinks before {scene.valid_until().time:g}")
for time in (0.0, 50.0, 100.0):
    print(f"at {time:3.0f}:", ", ".join(f"radius {scene.disc_at(i, time).radius:.3f}" for i in range(len(scene))))
arrivals, status = solver.arrivals([0.0, 10.0, 20.0])
for departure, arrival in zip((0, 10, 20), arrivals):
    discs = solver.path(departure).legs["disc"]
    ridden = dict.fromkeys(int(disc) for disc in discs[discs != tdsp.NO_DISC])
    print(f"leave at {departure:2}: arrive at {arrival:.4f}, along the edges of discs {', '.join(map(str, ridden))}")
margin = scene.departure_margin(0.0, deadline=110.0)
print(f"to arrive by 110 all may grow {margin.most:.3f} times as fast; then {margin.witness.limit.name.lower()}")
