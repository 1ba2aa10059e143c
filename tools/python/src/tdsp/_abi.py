# SPDX-License-Identifier: MIT
# Written by abi.py from include/tdsp/*.h. Do not edit: `make python-abi` writes it anew.
"""The C interface as ctypes sees it. Private: the package's other modules are what users see.

Pointers to data are `c_void_p`, so that addresses of NumPy arrays, `byref()` and None are all welcome. An enumeration's values travel as `c_uint`.
"""
from __future__ import annotations

import ctypes
from enum import IntEnum
from typing import Any, Optional

GROWTH_DEGREE = 8
LEG_ARC = 1
LEG_CURVE = 2
LEG_LINE = 0
MARGIN_CAP = (1.0 - 1.0 / 1048576.0)
MAX_ROWS = 16777216
NO_DISC = 0xffffffff
ORACLE_EXAMPLES = 3
ORACLE_FINDINGS = 64
ORACLE_RULES = 21
PROBLEM_CLEARANCE = 16
PROBLEM_END = 2
PROBLEM_JOIN = 4
PROBLEM_LEG = 32
PROBLEM_SPEED = 8
PROBLEM_START = 1
SOLVER_ERROR = 1e-11
VERIFY_ROUNDING = 1e-13
VERIFY_TOLERANCE = 1e-9
VERSION_MAJOR = 0
VERSION_MINOR = 1
VERSION_PATCH = 0


class Status(IntEnum):
    """Values of tdsp_status."""

    OK = 0
    SOURCE_COVERED = 1
    DESTINATION_COVERED = 2
    CUT_OFF = 3
    ARRIVAL_TOO_EARLY = 4
    HORIZON = 5
    OUTSIDE_TABLE = 6
    UNREACHABLE = 7
    INVALID_ARGUMENT = 16
    BUFFER_TOO_SMALL = 17
    NO_ANSWER = 18
    NOT_SUPPORTED = 19
    NEEDS_HORIZON = 20
    TOO_MANY_ROWS = 21
    BAD_SCENE = 32
    BAD_MAGIC = 33
    BAD_VERSION = 34
    BAD_LENGTH = 35
    BAD_CHECKSUM = 36
    BAD_TABLE = 37
    BAD_PATH = 38
    STALE_TABLE = 39
    BAD_ORACLE = 40
    SHRINKS = 41
    NO_MEMORY = 64
    CANCELLED = 65
    FAILED = 66


class Monotone(IntEnum):
    """Values of tdsp_monotone."""

    TRAVEL = 0
    ARRIVAL = 1


class Guarantee(IntEnum):
    """Values of tdsp_guarantee."""

    TRAVEL = 0
    ARRIVAL = 1
    ABSOLUTE = 2


class Sampling(IntEnum):
    """Values of tdsp_sampling."""

    ADAPTIVE = 0
    GEOMETRIC = 1


class GrowthKind(IntEnum):
    """Values of tdsp_growth_kind."""

    RATE = 0
    POLYNOMIAL = 1
    RATES = 2
    LAW = 3


class Method(IntEnum):
    """Values of tdsp_method."""

    AUTO = 0
    SAME_SPEED = 1
    DIFFERENT_SPEEDS = 2
    GENERAL = 3


class Limit(IntEnum):
    """Values of tdsp_limit."""

    NONE = 0
    DEADLINE = 1
    GAP = 2
    JUMP = 3
    SOURCE_COVERED = 4
    DESTINATION_COVERED = 5
    CUT_OFF = 6
    TOUCH = 7


class Raise(IntEnum):
    """Values of tdsp_raise."""

    FACTOR = 0
    ADDED = 1


class OracleRule(IntEnum):
    """Values of tdsp_oracle_rule."""

    DECLARED = 0
    ERROR = 1
    STATUS = 2
    ARRIVAL = 3
    REPEATABLE = 4
    ORDER = 5
    NO_WAY = 6
    PATH_FORM = 7
    PATH_JOINS = 8
    PATH_ENDS = 9
    PATH_REPEATABLE = 10
    DEPARTURE = 11
    TOO_EARLY = 12
    BOTH_WAYS = 13
    LATE = 14
    EARLY = 15
    ARRIVES = 16
    WITHIN = 17
    BOUNDS = 18
    REASON = 19
    SLOW = 20


class OracleCallback(IntEnum):
    """Values of tdsp_oracle_callback."""

    MEMBERS = 0
    EARLIEST_ARRIVAL = 1
    LATEST_DEPARTURE = 2
    PATH = 3
    LAST_REASON = 4
    EARLIEST_ARRIVAL_WITHIN = 5
    LATEST_DEPARTURE_BETWEEN = 6


class Change(IntEnum):
    """Values of tdsp_change."""

    END = 0
    JUMP = 1
    TOUCH = 2
    SWITCH = 3


class tdsp_point(ctypes.Structure):
    _fields_ = [
        ("x", ctypes.c_double),
        ("y", ctypes.c_double),
    ]
    x: float
    y: float


class tdsp_disc(ctypes.Structure):
    _fields_ = [
        ("center", tdsp_point),
        ("radius", ctypes.c_double),
        ("growth", ctypes.c_double),
    ]
    center: tdsp_point
    radius: float
    growth: float


class tdsp_leg(ctypes.Structure):
    _fields_ = [
        ("kind", ctypes.c_uint32),
        ("disc", ctypes.c_uint32),
        ("turn", ctypes.c_int32),
        ("reserved", ctypes.c_uint32),
        ("start_time", ctypes.c_double),
        ("end_time", ctypes.c_double),
        ("from", tdsp_point),
        ("to", tdsp_point),
        ("center", tdsp_point),
        ("radius_from", ctypes.c_double),
        ("radius_to", ctypes.c_double),
        ("angle_from", ctypes.c_double),
        ("sweep", ctypes.c_double),
        ("rate_from", ctypes.c_double),
        ("rate_to", ctypes.c_double),
        ("bend_from", ctypes.c_double),
        ("bend_to", ctypes.c_double),
        ("speed", ctypes.c_double),
    ]
    kind: int
    disc: int
    turn: int
    reserved: int
    start_time: float
    end_time: float
    to: tdsp_point
    center: tdsp_point
    radius_from: float
    radius_to: float
    angle_from: float
    sweep: float
    rate_from: float
    rate_to: float
    bend_from: float
    bend_to: float
    speed: float


class tdsp_gap(ctypes.Structure):
    _fields_ = [
        ("first", ctypes.c_uint32),
        ("second", ctypes.c_uint32),
        ("time", ctypes.c_double),
        ("place", tdsp_point),
    ]
    first: int
    second: int
    time: float
    place: tdsp_point


class tdsp_allocator(ctypes.Structure):
    _fields_ = [
        ("ctx", ctypes.c_void_p),
        ("resize", ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)),
    ]
    ctx: Optional[int]
    resize: Any


class tdsp_guide(ctypes.Structure):
    _fields_ = [
        ("bases", ctypes.c_uint64),
        ("counts", ctypes.c_uint64),
        ("cells", ctypes.c_uint64),
        ("scale", ctypes.c_double),
        ("first", ctypes.c_double),
        ("last", ctypes.c_double),
    ]
    bases: int
    counts: int
    cells: int
    scale: float
    first: float
    last: float


class tdsp_table(ctypes.Structure):
    _fields_ = [
        ("bytes", ctypes.c_void_p),
        ("length", ctypes.c_uint64),
        ("rows", ctypes.c_uint64),
        ("waypoint_count", ctypes.c_uint64),
        ("arc_count", ctypes.c_uint64),
        ("departures", ctypes.c_uint64),
        ("left", ctypes.c_uint64),
        ("right", ctypes.c_uint64),
        ("first_waypoint", ctypes.c_uint64),
        ("waypoints", ctypes.c_uint64),
        ("arcs", ctypes.c_uint64),
        ("first_byte", ctypes.c_uint64),
        ("opaque", ctypes.c_uint64),
        ("opaque_length", ctypes.c_uint64),
        ("monotone", ctypes.c_uint32),
        ("joint", ctypes.c_uint32),
        ("last", ctypes.c_uint64),
        ("by_departure", tdsp_guide),
        ("by_arrival", tdsp_guide),
        ("curve_count", ctypes.c_uint64),
        ("curves", ctypes.c_uint64),
        ("gap_count", ctypes.c_uint64),
        ("gaps", ctypes.c_uint64),
        ("last_word", ctypes.c_uint64),
    ]
    bytes: Optional[int]
    length: int
    rows: int
    waypoint_count: int
    arc_count: int
    departures: int
    left: int
    right: int
    first_waypoint: int
    waypoints: int
    arcs: int
    first_byte: int
    opaque: int
    opaque_length: int
    monotone: int
    joint: int
    last: int
    by_departure: tdsp_guide
    by_arrival: tdsp_guide
    curve_count: int
    curves: int
    gap_count: int
    gaps: int
    last_word: int


class tdsp_table_info(ctypes.Structure):
    _fields_ = [
        ("version_major", ctypes.c_uint16),
        ("version_minor", ctypes.c_uint16),
        ("monotone", ctypes.c_uint32),
        ("guarantee", ctypes.c_uint32),
        ("sampling", ctypes.c_uint32),
        ("rows", ctypes.c_uint64),
        ("legs", ctypes.c_uint64),
        ("length", ctypes.c_uint64),
        ("scene_hash", ctypes.c_uint64),
        ("epsilon", ctypes.c_double),
        ("delta", ctypes.c_double),
        ("error", ctypes.c_double),
        ("time_scale", ctypes.c_double),
        ("speed", ctypes.c_double),
        ("source", tdsp_point),
        ("destination", tdsp_point),
        ("first_lower", ctypes.c_double),
        ("first_departure", ctypes.c_double),
        ("last_departure", ctypes.c_double),
        ("last_reason", ctypes.c_uint),
        ("length_unit", ctypes.c_char * 16),
        ("time_unit", ctypes.c_char * 16),
        ("guide_length", ctypes.c_uint64),
        ("curves", ctypes.c_uint64),
        ("gaps", ctypes.c_uint64),
    ]
    version_major: int
    version_minor: int
    monotone: int
    guarantee: int
    sampling: int
    rows: int
    legs: int
    length: int
    scene_hash: int
    epsilon: float
    delta: float
    error: float
    time_scale: float
    speed: float
    source: tdsp_point
    destination: tdsp_point
    first_lower: float
    first_departure: float
    last_departure: float
    last_reason: int
    length_unit: Any
    time_unit: Any
    guide_length: int
    curves: int
    gaps: int


class tdsp_row(ctypes.Structure):
    _fields_ = [
        ("departure", ctypes.c_double),
        ("left", ctypes.c_double),
        ("right", ctypes.c_double),
        ("legs", ctypes.c_uint64),
    ]
    departure: float
    left: float
    right: float
    legs: int


class tdsp_jump(ctypes.Structure):
    _fields_ = [
        ("row", ctypes.c_uint64),
        ("departure", ctypes.c_double),
        ("before", ctypes.c_double),
        ("after", ctypes.c_double),
        ("gap", tdsp_gap),
    ]
    row: int
    departure: float
    before: float
    after: float
    gap: tdsp_gap


class tdsp_matrix(ctypes.Structure):
    _fields_ = [
        ("bytes", ctypes.c_void_p),
        ("length", ctypes.c_uint64),
        ("sources", ctypes.c_uint64),
        ("destinations", ctypes.c_uint64),
        ("points", ctypes.c_uint64),
        ("name_ends", ctypes.c_uint64),
        ("names", ctypes.c_uint64),
        ("pairs", ctypes.c_uint64),
        ("reserved", ctypes.c_uint64 * 4),
    ]
    bytes: Optional[int]
    length: int
    sources: int
    destinations: int
    points: int
    name_ends: int
    names: int
    pairs: int
    reserved: Any


class tdsp_matrix_end(ctypes.Structure):
    _fields_ = [
        ("place", tdsp_point),
        ("name", ctypes.c_void_p),
        ("name_length", ctypes.c_size_t),
    ]
    place: tdsp_point
    name: Optional[int]
    name_length: int


class tdsp_oracle_path(ctypes.Structure):
    _fields_ = [
        ("legs", ctypes.c_void_p),
        ("leg_count", ctypes.c_size_t),
        ("bytes", ctypes.c_void_p),
        ("byte_count", ctypes.c_size_t),
    ]
    legs: Optional[int]
    leg_count: int
    bytes: Optional[int]
    byte_count: int


class tdsp_oracle(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("ctx", ctypes.c_void_p),
        ("monotone", ctypes.c_uint),
        ("error", ctypes.c_double),
        ("time_scale", ctypes.c_double),
        ("earliest_arrival", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p)),
        ("latest_departure", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p)),
        ("path", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_void_p)),
        ("last_reason", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p)),
        ("earliest_arrival_within", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p)),
        ("latest_departure_between", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p)),
        ("jump_gap", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_double, ctypes.c_void_p)),
    ]
    size: int
    ctx: Optional[int]
    monotone: int
    error: float
    time_scale: float
    earliest_arrival: Any
    latest_departure: Any
    path: Any
    last_reason: Any
    earliest_arrival_within: Any
    latest_departure_between: Any
    jump_gap: Any


class tdsp_build_world(ctypes.Structure):
    _fields_ = [
        ("scene_hash", ctypes.c_uint64),
        ("speed", ctypes.c_double),
        ("source", tdsp_point),
        ("destination", tdsp_point),
        ("length_unit", ctypes.c_void_p),
        ("time_unit", ctypes.c_void_p),
    ]
    scene_hash: int
    speed: float
    source: tdsp_point
    destination: tdsp_point
    length_unit: Optional[int]
    time_unit: Optional[int]


tdsp_progress = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double)


tdsp_task = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)


tdsp_run_tasks = ctypes.CFUNCTYPE(None, ctypes.c_void_p, tdsp_task, ctypes.c_void_p, ctypes.c_size_t)


class tdsp_build_options(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("guarantee", ctypes.c_uint),
        ("sampling", ctypes.c_uint),
        ("epsilon", ctypes.c_double),
        ("delta", ctypes.c_double),
        ("horizon", ctypes.c_double),
        ("max_rows", ctypes.c_uint32),
        ("world", tdsp_build_world),
        ("progress", tdsp_progress),
        ("progress_ctx", ctypes.c_void_p),
        ("run_tasks", tdsp_run_tasks),
        ("run_tasks_ctx", ctypes.c_void_p),
        ("workers", ctypes.c_void_p),
        ("worker_count", ctypes.c_size_t),
        ("oracle_share", ctypes.c_double),
    ]
    size: int
    guarantee: int
    sampling: int
    epsilon: float
    delta: float
    horizon: float
    max_rows: int
    world: tdsp_build_world
    progress: Any
    progress_ctx: Optional[int]
    run_tasks: Any
    run_tasks_ctx: Optional[int]
    workers: Optional[int]
    worker_count: int
    oracle_share: float


class tdsp_build_report(ctypes.Structure):
    _fields_ = [
        ("rows", ctypes.c_uint64),
        ("bytes", ctypes.c_uint64),
        ("forward_calls", ctypes.c_uint64),
        ("reverse_calls", ctypes.c_uint64),
        ("last_departure", ctypes.c_double),
        ("last_reason", ctypes.c_uint),
        ("oracle_delta", ctypes.c_double),
        ("rough_calls", ctypes.c_uint64),
        ("gaps", ctypes.c_uint64),
    ]
    rows: int
    bytes: int
    forward_calls: int
    reverse_calls: int
    last_departure: float
    last_reason: int
    oracle_delta: float
    rough_calls: int
    gaps: int


tdsp_pair_oracle = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p)


class tdsp_matrix_plan(ctypes.Structure):
    _fields_ = [
        ("sources", ctypes.c_void_p),
        ("source_count", ctypes.c_size_t),
        ("destinations", ctypes.c_void_p),
        ("destination_count", ctypes.c_size_t),
        ("oracle_for", tdsp_pair_oracle),
        ("ctx", ctypes.c_void_p),
    ]
    sources: Optional[int]
    source_count: int
    destinations: Optional[int]
    destination_count: int
    oracle_for: Any
    ctx: Optional[int]


class tdsp_matrix_report(ctypes.Structure):
    _fields_ = [
        ("tables", ctypes.c_uint64),
        ("rows", ctypes.c_uint64),
        ("bytes", ctypes.c_uint64),
        ("forward_calls", ctypes.c_uint64),
        ("reverse_calls", ctypes.c_uint64),
        ("source", ctypes.c_size_t),
        ("destination", ctypes.c_size_t),
    ]
    tables: int
    rows: int
    bytes: int
    forward_calls: int
    reverse_calls: int
    source: int
    destination: int


class tdsp_journey(ctypes.Structure):
    _fields_ = [
        ("speed", ctypes.c_double),
        ("radius", ctypes.c_double),
        ("source", tdsp_point),
        ("destination", tdsp_point),
    ]
    speed: float
    radius: float
    source: tdsp_point
    destination: tdsp_point


class tdsp_ends(ctypes.Structure):
    _fields_ = [
        ("source", tdsp_point),
        ("destination", tdsp_point),
    ]
    source: tdsp_point
    destination: tdsp_point


tdsp_growth_law = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p)


class tdsp_growth(ctypes.Structure):
    _fields_ = [
        ("kind", ctypes.c_uint),
        ("rate", ctypes.c_double),
        ("count", ctypes.c_size_t),
        ("values", ctypes.c_void_p),
        ("times", ctypes.c_void_p),
        ("law", tdsp_growth_law),
        ("ctx", ctypes.c_void_p),
        ("until", ctypes.c_double),
    ]
    kind: int
    rate: float
    count: int
    values: Optional[int]
    times: Optional[int]
    law: Any
    ctx: Optional[int]
    until: float


class tdsp_growing_disc(ctypes.Structure):
    _fields_ = [
        ("center", tdsp_point),
        ("radius", ctypes.c_double),
        ("growth", tdsp_growth),
    ]
    center: tdsp_point
    radius: float
    growth: tdsp_growth


class tdsp_last_departure(ctypes.Structure):
    _fields_ = [
        ("departure", ctypes.c_double),
        ("arrival", ctypes.c_double),
        ("reason", ctypes.c_uint),
        ("disc", ctypes.c_uint32),
        ("other", ctypes.c_uint32),
        ("time", ctypes.c_double),
        ("place", tdsp_point),
    ]
    departure: float
    arrival: float
    reason: int
    disc: int
    other: int
    time: float
    place: tdsp_point


class tdsp_solver_work(ctypes.Structure):
    _fields_ = [
        ("forward_searches", ctypes.c_uint64),
        ("reverse_searches", ctypes.c_uint64),
        ("rounds", ctypes.c_uint64),
        ("labels", ctypes.c_uint64),
        ("legs_tested", ctypes.c_uint64),
        ("bytes", ctypes.c_uint64),
    ]
    forward_searches: int
    reverse_searches: int
    rounds: int
    labels: int
    legs_tested: int
    bytes: int


class tdsp_witness(ctypes.Structure):
    _fields_ = [
        ("limit", ctypes.c_uint),
        ("disc", ctypes.c_uint32),
        ("other", ctypes.c_uint32),
        ("time", ctypes.c_double),
        ("place", tdsp_point),
    ]
    limit: int
    disc: int
    other: int
    time: float
    place: tdsp_point


class tdsp_deadline_answer(ctypes.Structure):
    _fields_ = [
        ("departure", ctypes.c_double),
        ("arrival", ctypes.c_double),
        ("witness", tdsp_witness),
        ("after", ctypes.c_uint),
        ("after_arrival", ctypes.c_double),
    ]
    departure: float
    arrival: float
    witness: tdsp_witness
    after: int
    after_arrival: float


class tdsp_slack(ctypes.Structure):
    _fields_ = [
        ("status", ctypes.c_uint),
        ("arrival", ctypes.c_double),
        ("early", ctypes.c_double),
        ("later", ctypes.c_double),
        ("latest_status", ctypes.c_uint),
        ("latest", tdsp_deadline_answer),
    ]
    status: int
    arrival: float
    early: float
    later: float
    latest_status: int
    latest: tdsp_deadline_answer


class tdsp_margin(ctypes.Structure):
    _fields_ = [
        ("most", ctypes.c_double),
        ("status", ctypes.c_uint),
        ("arrival", ctypes.c_double),
        ("witness", tdsp_witness),
        ("scenes", ctypes.c_uint32),
    ]
    most: float
    status: int
    arrival: float
    witness: tdsp_witness
    scenes: int


class tdsp_oracle_finding(ctypes.Structure):
    _fields_ = [
        ("rule", ctypes.c_uint),
        ("callback", ctypes.c_uint),
        ("status", ctypes.c_uint),
        ("asked", ctypes.c_double),
        ("answered", ctypes.c_double),
        ("other", ctypes.c_double),
        ("seen", ctypes.c_double),
        ("expected", ctypes.c_double),
    ]
    rule: int
    callback: int
    status: int
    asked: float
    answered: float
    other: float
    seen: float
    expected: float


class tdsp_oracle_findings(ctypes.Structure):
    _fields_ = [
        ("looked_at", ctypes.c_uint64),
        ("broken", ctypes.c_uint64),
        ("times", ctypes.c_uint64 * 21),
        ("count", ctypes.c_size_t),
        ("found", tdsp_oracle_finding * 64),
        ("calls", ctypes.c_uint64),
        ("last_departure", ctypes.c_double),
        ("slowest", ctypes.c_double),
        ("complete", ctypes.c_int),
    ]
    looked_at: int
    broken: int
    times: Any
    count: int
    found: Any
    calls: int
    last_departure: float
    slowest: float
    complete: int


class tdsp_oracle_check_options(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("horizon", ctypes.c_double),
        ("departures", ctypes.c_uint32),
        ("calls", ctypes.c_uint64),
        ("seed", ctypes.c_uint64),
        ("clock", ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p)),
        ("clock_ctx", ctypes.c_void_p),
        ("seconds", ctypes.c_double),
    ]
    size: int
    horizon: float
    departures: int
    calls: int
    seed: int
    clock: Any
    clock_ctx: Optional[int]
    seconds: float


class tdsp_label(ctypes.Structure):
    _fields_ = [
        ("time", ctypes.c_double),
        ("id", ctypes.c_uint32),
        ("kind", ctypes.c_uint32),
    ]
    time: float
    id: int
    kind: int


class tdsp_search_problem(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("ctx", ctypes.c_void_p),
        ("bound", ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p)),
        ("expand", ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)),
    ]
    size: int
    ctx: Optional[int]
    bound: Any
    expand: Any


class tdsp_shape_options(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("from", ctypes.c_double),
        ("until", ctypes.c_double),
        ("least", ctypes.c_double),
        ("resolution", ctypes.c_double),
        ("progress", tdsp_progress),
        ("progress_ctx", ctypes.c_void_p),
    ]
    size: int
    until: float
    least: float
    resolution: float
    progress: Any
    progress_ctx: Optional[int]


class tdsp_arrival_jump(ctypes.Structure):
    _fields_ = [
        ("departure", ctypes.c_double),
        ("travel_before", ctypes.c_double),
        ("travel_after", ctypes.c_double),
        ("size", ctypes.c_double),
        ("gap", tdsp_gap),
    ]
    departure: float
    travel_before: float
    travel_after: float
    size: float
    gap: tdsp_gap


class tdsp_ride(ctypes.Structure):
    _fields_ = [
        ("disc", ctypes.c_uint32),
        ("turn", ctypes.c_int32),
    ]
    disc: int
    turn: int


class tdsp_piece(ctypes.Structure):
    _fields_ = [
        ("from", ctypes.c_double),
        ("until", ctypes.c_double),
        ("travel_from", ctypes.c_double),
        ("travel_until", ctypes.c_double),
        ("rides", ctypes.c_void_p),
        ("ride_count", ctypes.c_size_t),
        ("form", ctypes.c_size_t),
        ("change", ctypes.c_uint),
        ("gap", tdsp_gap),
    ]
    until: float
    travel_from: float
    travel_until: float
    rides: Optional[int]
    ride_count: int
    form: int
    change: int
    gap: tdsp_gap


class tdsp_verdict(ctypes.Structure):
    _fields_ = [
        ("problems", ctypes.c_uint32),
        ("min_clearance", ctypes.c_double),
        ("time", ctypes.c_double),
        ("disc", ctypes.c_uint32),
        ("leg", ctypes.c_size_t),
        ("tolerance", ctypes.c_double),
    ]
    problems: int
    min_clearance: float
    time: float
    disc: int
    leg: int
    tolerance: float


class tdsp_table_verdict(ctypes.Structure):
    _fields_ = [
        ("ok", ctypes.c_int),
        ("stale", ctypes.c_int),
        ("bad_order", ctypes.c_uint64),
        ("bad_ratio", ctypes.c_uint64),
        ("bad_paths", ctypes.c_uint64),
        ("first_bad_row", ctypes.c_uint64),
        ("worst", tdsp_verdict),
    ]
    ok: int
    stale: int
    bad_order: int
    bad_ratio: int
    bad_paths: int
    first_bad_row: int
    worst: tdsp_verdict


# Result and parameters of each function.
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "tdsp_build": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_build_options_init": (None, [ctypes.c_void_p]),
    "tdsp_bytes_free": (None, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t]),
    "tdsp_departure_margin": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_disc_check": (ctypes.c_char_p, [ctypes.c_void_p]),
    "tdsp_earliest_arrival": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_earliest_arrival_for": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_earliest_arrival_within": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_earliest_arrivals": (ctypes.c_uint, [ctypes.c_void_p, tdsp_point, ctypes.c_double, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_envelope_find": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_envelope_forms": (ctypes.c_size_t, [ctypes.c_void_p]),
    "tdsp_envelope_free": (None, [ctypes.c_void_p]),
    "tdsp_envelope_piece": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]),
    "tdsp_envelope_pieces": (ctypes.c_size_t, [ctypes.c_void_p]),
    "tdsp_envelope_resolution": (ctypes.c_double, [ctypes.c_void_p]),
    "tdsp_growing_disc_check": (ctypes.c_char_p, [ctypes.c_void_p]),
    "tdsp_journey_check": (ctypes.c_char_p, [ctypes.c_void_p]),
    "tdsp_jumps_count": (ctypes.c_size_t, [ctypes.c_void_p]),
    "tdsp_jumps_find": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_jumps_free": (None, [ctypes.c_void_p]),
    "tdsp_jumps_get": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]),
    "tdsp_latest_departure": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_latest_departure_for": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_latest_departures": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, tdsp_point, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_leg_position": (tdsp_point, [ctypes.c_void_p, ctypes.c_double]),
    "tdsp_leg_shifted": (tdsp_leg, [ctypes.c_void_p, ctypes.c_double]),
    "tdsp_limit_name": (ctypes.c_char_p, [ctypes.c_uint]),
    "tdsp_matrix_build": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_matrix_destination": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p]),
    "tdsp_matrix_open": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t]),
    "tdsp_matrix_size": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_matrix_source": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p]),
    "tdsp_matrix_table": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64, ctypes.c_void_p]),
    "tdsp_method_name": (ctypes.c_char_p, [ctypes.c_uint]),
    "tdsp_oracle_callback_name": (ctypes.c_char_p, [ctypes.c_uint]),
    "tdsp_oracle_check": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_oracle_check_options_init": (None, [ctypes.c_void_p]),
    "tdsp_oracle_finding_text": (ctypes.c_char_p, [ctypes.c_void_p]),
    "tdsp_oracle_init": (None, [ctypes.c_void_p]),
    "tdsp_oracle_rule_name": (ctypes.c_char_p, [ctypes.c_uint]),
    "tdsp_path_margin": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_path_position": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_scene_create": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_create_growing": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_destination_free_until": (ctypes.c_double, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_disc_at": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint32, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_discs": (ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_free": (None, [ctypes.c_void_p]),
    "tdsp_scene_free_until": (ctypes.c_double, [ctypes.c_void_p, tdsp_point, ctypes.c_void_p]),
    "tdsp_scene_has_rates_only": (ctypes.c_int, [ctypes.c_void_p]),
    "tdsp_scene_hash": (ctypes.c_uint64, [ctypes.c_void_p]),
    "tdsp_scene_hash_for": (ctypes.c_uint64, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_journey": (ctypes.c_void_p, [ctypes.c_void_p]),
    "tdsp_scene_raise": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_scene_source_free_until": (ctypes.c_double, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_scene_valid_until": (ctypes.c_double, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_search_create": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_search_free": (None, [ctypes.c_void_p]),
    "tdsp_search_limit": (None, [ctypes.c_void_p, ctypes.c_double]),
    "tdsp_search_push": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_search_run": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]),
    "tdsp_shape_options_init": (None, [ctypes.c_void_p]),
    "tdsp_solver_create": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_solver_create_for": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint, ctypes.c_void_p]),
    "tdsp_solver_deadline": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_solver_ends": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_solver_free": (None, [ctypes.c_void_p]),
    "tdsp_solver_gap": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_solver_last_departure": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_solver_method": (ctypes.c_uint, [ctypes.c_void_p]),
    "tdsp_solver_oracle": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_solver_path": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]),
    "tdsp_solver_scene": (ctypes.c_void_p, [ctypes.c_void_p]),
    "tdsp_solver_set_ends": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_solver_slack": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_solver_work_done": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_status_is_answer": (ctypes.c_int, [ctypes.c_uint]),
    "tdsp_status_name": (ctypes.c_char_p, [ctypes.c_uint]),
    "tdsp_status_text": (ctypes.c_char_p, [ctypes.c_uint]),
    "tdsp_table_arrival": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_arrival_float": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_float, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_arrivals": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_departure": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_departures": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_find": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_table_get_info": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_leg": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_uint64, ctypes.c_void_p]),
    "tdsp_table_next_jump": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_table_open": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t]),
    "tdsp_table_path": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]),
    "tdsp_table_position": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_table_previous_jump": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_table_reopen": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t]),
    "tdsp_table_row": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p]),
    "tdsp_table_row_bytes": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_table_row_leg": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64, ctypes.c_void_p]),
    "tdsp_table_rows": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_verify_path": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_verify_path_for": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]),
    "tdsp_verify_table": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_verify_table_for": (ctypes.c_uint, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
    "tdsp_version": (ctypes.c_char_p, []),
}
