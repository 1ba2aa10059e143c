# SPDX-License-Identifier: MIT
"""Time-dependent shortest paths among growing discs.

>>> import tdsp
>>> scene = tdsp.Scene(speed=1.0, source=(-10, 0), destination=(10, 0), centers=[[0, 3], [0, -3]], radii=1.0, growth=0.1)
>>> scene.solver().arrival(0.0)
20.0
>>> table = scene.build(epsilon=0.01)
>>> table
<tdsp.Table: 39 rows, 8592 bytes, travel epsilon 0.01, departures 0 to 60.30851, then destination_covered>
>>> lower, upper, status = table.arrivals([0.0, 5.0, 9.9])
>>> upper.round(3)
array([20.   , 25.   , 33.855])

A `Scene` is prepared once; a `Solver` answers exactly; a `Table` answers certified intervals in nanoseconds and is a few kilobytes of bytes; an
`Oracle` of your own brings any other world. docs/python.md has the whole story.

Lengths, times and speeds are in units of your own that agree with each other. Arrays are of doubles; times may have any shape, places have the shape (n, 2).
"""
from ._abi import LEG_ARC, LEG_CURVE, LEG_LINE, MAX_ROWS, NO_DISC, SOLVER_ERROR, Change, Limit, OracleCallback, OracleRule, Status
from ._arrays import DISC_DTYPE, LEG_DTYPE, ROW_DTYPE
from ._library import version
from .sampler import About, BuildReport, build
from .errors import (AfterHorizon, ArrivalTooEarly, BadChecksum, BadLength, BadMagic, BadOracle, BadPath, BadScene, BadTable, BadVersion,
                     BufferTooSmall, Cancelled, CutOff, DataError, DestinationCovered, Failed, InvalidArgument, NeedsHorizon, NoAnswer, NoMemory,
                     NotSupported, NoWay, OutsideTable, Shrinks, SourceCovered, StaleTable, SystemFailure, TdspError, TooManyRows, Unreachable,
                     UsageError, is_answer, status_name, status_text)
from .growth import Law, Polynomial, Rates
from .matrix import End, Matrix, MatrixReport, build_matrix
from .oracle import Finding, Findings, Oracle, SolverOracle, check_oracle
from .path import Path
from .scene import DiscAt, FreeUntil, Scene
from .labels import Label, Open, search
from .shape import ArrivalJump, Envelope, Piece, Ride
from .solver import Solver, Within
from .table import Table, TableInfo
from .values import (Arrivals, Deadline, Departure, Departures, Ends, Gap, Interval, Intervals, LastDeparture, LatestDepartures, Margin, Point, Row,
                     Slack, TableJump, Witness, Work, limit_name, named)
from .verify import TableVerdict, Verdict

__version__ = version()

__all__ = [
    "About", "AfterHorizon", "ArrivalJump", "Arrivals", "ArrivalTooEarly", "BadChecksum", "BadLength", "BadMagic", "BadOracle", "BadPath", "BadScene",
    "BadTable", "BadVersion", "BufferTooSmall", "build", "build_matrix", "BuildReport", "Cancelled", "Change", "check_oracle", "CutOff", "DataError",
    "Deadline", "Departure", "Departures", "DestinationCovered", "DISC_DTYPE", "DiscAt", "End", "Ends", "Envelope", "Failed", "Finding", "Findings",
    "FreeUntil", "Gap", "Interval", "Intervals", "InvalidArgument", "is_answer", "Label", "LastDeparture", "LatestDepartures", "Law", "LEG_ARC",
    "LEG_CURVE", "LEG_DTYPE", "LEG_LINE", "Limit", "limit_name", "Margin", "Matrix", "MatrixReport", "MAX_ROWS", "named", "NeedsHorizon", "NO_DISC",
    "NoAnswer", "NoMemory", "NotSupported", "NoWay", "Open", "Oracle", "OracleCallback", "OracleRule", "OutsideTable", "Path", "Piece", "Point",
    "Polynomial", "Rates", "Ride", "Row", "ROW_DTYPE", "Scene", "search", "Shrinks", "Slack", "Solver", "SOLVER_ERROR", "SolverOracle",
    "SourceCovered", "StaleTable", "Status", "status_name", "status_text", "SystemFailure", "Table", "TableInfo", "TableJump", "TableVerdict",
    "TdspError", "TooManyRows", "Unreachable", "UsageError", "Verdict", "version", "Within", "Witness", "Work",
]
