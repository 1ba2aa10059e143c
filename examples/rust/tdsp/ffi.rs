// SPDX-License-Identifier: MIT
//! The C interface, as far as this crate uses it: the layouts are those of `include/tdsp/*.h`, listed in docs/ffi.md.
use std::os::raw::{c_char, c_int, c_void};

pub type Status = c_int;
pub const OK: Status = 0;
pub const UNREACHABLE: Status = 7;
pub const INVALID_ARGUMENT: Status = 16;
pub const BUFFER_TOO_SMALL: Status = 17;
pub const BAD_SCENE: Status = 32;
pub const FAILED: Status = 66;

/// Private members: only their size and alignment matter here.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Table {
    members: [u64; 33],
}

#[repr(C)]
pub struct TableInfo {
    pub version_major: u16,
    pub version_minor: u16,
    pub monotone: u32,
    pub guarantee: u32,
    pub sampling: u32,
    pub rows: u64,
    pub legs: u64,
    pub length: u64,
    pub scene_hash: u64,
    pub epsilon: f64,
    pub delta: f64,
    pub error: f64,
    pub time_scale: f64,
    pub speed: f64,
    pub source: crate::Point,
    pub destination: crate::Point,
    pub first_lower: f64,
    pub first_departure: f64,
    pub last_departure: f64,
    pub last_reason: Status,
    pub length_unit: [c_char; 16],
    pub time_unit: [c_char; 16],
    pub guide_length: u64,
    pub curves: u64,
    pub gaps: u64,
}

#[repr(C)]
pub struct Row {
    pub departure: f64,
    pub left: f64,
    pub right: f64,
    pub legs: u64,
}

#[repr(C)]
pub struct World {
    pub scene_hash: u64,
    pub speed: f64,
    pub source: crate::Point,
    pub destination: crate::Point,
    pub length_unit: *const c_char,
    pub time_unit: *const c_char,
}

#[repr(C)]
pub struct BuildOptions {
    pub size: usize,
    pub guarantee: c_int,
    pub sampling: c_int,
    pub epsilon: f64,
    pub delta: f64,
    pub horizon: f64,
    pub max_rows: u32,
    pub world: World,
    pub progress: *const c_void,
    pub progress_ctx: *mut c_void,
    pub run_tasks: *const c_void,
    pub run_tasks_ctx: *mut c_void,
    pub workers: *const Oracle,
    pub worker_count: usize,
    pub oracle_share: f64,
}

#[repr(C)]
pub struct OraclePath {
    pub legs: *const crate::Leg,
    pub leg_count: usize,
    pub bytes: *const c_void,
    pub byte_count: usize,
}

pub type Search = unsafe extern "C" fn(*mut c_void, f64, *mut f64) -> Status;
pub type GivePath = unsafe extern "C" fn(*mut c_void, *mut OraclePath) -> Status;

#[repr(C)]
pub struct Oracle {
    pub size: usize,
    pub ctx: *mut c_void,
    pub monotone: c_int,
    pub error: f64,
    pub time_scale: f64,
    pub earliest_arrival: Option<Search>,
    pub latest_departure: Option<Search>,
    pub path: Option<GivePath>,
    pub last_reason: *const c_void,
    pub earliest_arrival_within: *const c_void,
    pub latest_departure_between: *const c_void,
    pub jump_gap: *const c_void,
}

#[repr(C)]
pub struct Scene {
    opaque: [u8; 0],
}

#[repr(C)]
pub struct Solver {
    opaque: [u8; 0],
}

#[link(name = "tdsp")]
extern "C" {
    pub fn tdsp_version() -> *const c_char;
    pub fn tdsp_status_is_answer(status: Status) -> c_int;
    pub fn tdsp_status_name(status: Status) -> *const c_char;
    pub fn tdsp_status_text(status: Status) -> *const c_char;

    pub fn tdsp_table_open(table: *mut Table, bytes: *const c_void, length: usize) -> Status;
    pub fn tdsp_table_get_info(table: *const Table, out: *mut TableInfo) -> Status;
    pub fn tdsp_table_row(table: *const Table, row: u64, out: *mut Row) -> Status;
    pub fn tdsp_table_find(table: *const Table, departure: f64, row: *mut u64) -> Status;
    pub fn tdsp_table_row_bytes(table: *const Table, row: u64, bytes: *mut *const c_void, length: *mut usize) -> Status;
    pub fn tdsp_table_arrival(table: *const Table, departure: f64, lower: *mut f64, upper: *mut f64) -> Status;
    pub fn tdsp_table_departure(table: *const Table, arrival: f64, departure: *mut f64, departure_upper: *mut f64) -> Status;
    pub fn tdsp_table_arrivals(table: *const Table, departures: *const f64, count: usize, lower: *mut f64, upper: *mut f64, statuses: *mut Status) -> Status;
    pub fn tdsp_table_path(table: *const Table, departure: f64, legs: *mut crate::Leg, capacity: usize, count: *mut usize) -> Status;
    pub fn tdsp_table_position(table: *const Table, departure: f64, time: f64, out: *mut crate::Point) -> Status;
    pub fn tdsp_table_next_jump(table: *const Table, departure: f64, out: *mut crate::Jump) -> Status;

    pub fn tdsp_journey_check(journey: *const crate::Journey) -> *const c_char;
    pub fn tdsp_disc_check(disc: *const crate::Disc) -> *const c_char;
    pub fn tdsp_scene_create(
        journey: *const crate::Journey,
        discs: *const crate::Disc,
        count: usize,
        allocator: *const c_void,
        out: *mut *mut Scene,
    ) -> Status;
    pub fn tdsp_scene_free(scene: *mut Scene);
    pub fn tdsp_scene_hash(scene: *const Scene) -> u64;
    pub fn tdsp_scene_journey(scene: *const Scene) -> *const crate::Journey;

    pub fn tdsp_solver_create(scene: *const Scene, out: *mut *mut Solver) -> Status;
    pub fn tdsp_solver_free(solver: *mut Solver);
    pub fn tdsp_earliest_arrival(solver: *mut Solver, departure: f64, arrival: *mut f64) -> Status;
    pub fn tdsp_latest_departure(solver: *mut Solver, arrival: f64, departure: *mut f64, arrives: *mut f64) -> Status;
    pub fn tdsp_solver_path(solver: *const Solver, legs: *mut crate::Leg, capacity: usize, count: *mut usize) -> Status;
    pub fn tdsp_solver_oracle(solver: *mut Solver, out: *mut Oracle) -> Status;

    pub fn tdsp_oracle_init(oracle: *mut Oracle);
    pub fn tdsp_build_options_init(options: *mut BuildOptions);
    pub fn tdsp_build(
        oracle: *const Oracle,
        options: *const BuildOptions,
        allocator: *const c_void,
        bytes: *mut *mut c_void,
        length: *mut usize,
        report: *mut c_void,
    ) -> Status;
    pub fn tdsp_bytes_free(allocator: *const c_void, bytes: *mut c_void, length: usize);
}
