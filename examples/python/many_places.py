# SPDX-License-Identifier: MIT
"""Which places can still be reached, and when? One search from one source to a grid of destinations, among fires that spread."""
import pathlib

import numpy as np
import tdsp

SCENES = pathlib.Path(__file__).resolve().parents[1] / "scenes"
scene = tdsp.Scene.load(SCENES / "fire-oregon-c.json")
solver = scene.solver()

# A grid over the fires: an array of places of the shape (n, 2), read where it lies.
low, high = scene.discs["center"].min(axis=0), scene.discs["center"].max(axis=0)
x, y = np.meshgrid(np.linspace(low[0], high[0], 12), np.linspace(high[1], low[1], 8))
places = np.column_stack([x.ravel(), y.ravel()])

for departure in (0.0, 3000.0):
    arrivals, status = solver.arrivals_to(places, departure)
    minutes = ((arrivals - departure) / 60).reshape(x.shape)
    print(f"leaving {departure:.0f} {scene.time_unit} from now, minutes to each place (-: no way)")
    for row in minutes:
        print(" ".join("   -" if np.isinf(m) else f"{m:4.0f}" for m in row))

reached, fires = np.isfinite(arrivals).sum(), len(scene)
print(f"{reached} of {len(places)} places, among {fires} fires")
