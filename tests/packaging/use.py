# SPDX-License-Identifier: MIT
"""What a user's first script does: needs the installed Python package only."""
import tdsp

scene = tdsp.Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
assert scene.solver().arrival(0.0) == 20.0
lower, upper = scene.build(epsilon=0.01).arrival(9.9)
assert lower <= scene.solver().arrival(9.9) <= upper <= 1.01 * lower
print(tdsp.__name__, upper)
