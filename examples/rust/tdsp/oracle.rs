// SPDX-License-Identifier: MIT
//! Building tables, over scenes or over any world that implements [`Oracle`].
//!
//! The sampler calls back through `extern "C"` functions, in the thread that called it. Unwinding must not cross it, so a panic is caught there, the
//! sampler told that it failed, and the panic goes on when the sampler has returned. An error is carried around in the same way.
use crate::{check, ffi, Error, Leg, Point, Scene, Solver, Status, Table};
use std::any::Any;
use std::ffi::CString;
use std::mem::MaybeUninit;
use std::os::raw::{c_int, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr;

/// What an oracle promises; docs/oracles.md.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Monotone {
    /// The travel time never decreases, and a path serves earlier departures too.
    Travel = 0,
    /// The arrival never decreases; who is early waits.
    Arrival = 1,
}

/// The path of an oracle's last answer.
pub enum Path<'o> {
    None,
    Legs(&'o [Leg]),
    Bytes(&'o [u8]),
}

/// A world of one's own.
pub trait Oracle {
    const MONOTONE: Monotone;

    /// A(t). `Err` with an answer ([`Status::is_answer`]) says why there is no way; any other error ends the building and comes out of it.
    fn earliest_arrival(&mut self, departure: f64) -> Result<f64, Error>;

    /// The path of the last answer.
    fn path(&self) -> Path<'_> {
        Path::None
    }

    /// The stated error: relative to the travel time plus [`Oracle::time_scale`].
    fn error(&self) -> f64 {
        0.0
    }

    fn time_scale(&self) -> f64 {
        0.0
    }
}

/// How a table is built. `build::Options::default()` is the library's.
pub mod build {
    /// What holds between the lower and the upper end of every answer.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum Guarantee {
        Travel(f64),
        Arrival(f64),
        Absolute(f64),
    }

    #[derive(Clone, Debug)]
    pub struct Options {
        pub guarantee: Guarantee,
        pub horizon: f64,
        pub length_unit: String,
        pub time_unit: String,
    }

    impl Default for Options {
        fn default() -> Options {
            Options { guarantee: Guarantee::Travel(0.01), horizon: f64::INFINITY, length_unit: String::new(), time_unit: String::new() }
        }
    }

    pub use super::{oracle, scene};
}

use build::{Guarantee, Options};

/// The table of a scene, which its header describes.
pub fn scene(scene: &Scene, options: &Options) -> Result<Table<'static>, Error> {
    let solver = Solver::new(scene)?;
    let mut raw = MaybeUninit::uninit();
    check(unsafe { ffi::tdsp_solver_oracle(solver.raw, raw.as_mut_ptr()) })?;
    let journey = scene.journey();
    let world = World { hash: scene.hash(), speed: journey.speed, source: journey.source, destination: journey.destination };
    // `solver` is borrowed by the oracle until here.
    unsafe { sample(raw.as_ptr(), options, &world) }
}

/// The table of any world.
pub fn oracle<O: Oracle>(oracle: &mut O, options: &Options) -> Result<Table<'static>, Error> {
    let mut seat = Seat { oracle, error: None, panic: None };
    let mut raw = MaybeUninit::uninit();
    let raw: ffi::Oracle = unsafe {
        ffi::tdsp_oracle_init(raw.as_mut_ptr());
        raw.assume_init()
    };
    let raw = ffi::Oracle {
        ctx: &mut seat as *mut Seat<'_, O> as *mut c_void,
        monotone: O::MONOTONE as c_int,
        error: seat.oracle.error(),
        time_scale: seat.oracle.time_scale(),
        earliest_arrival: Some(on_earliest_arrival::<O>),
        path: Some(on_path::<O>),
        ..raw
    };
    let made = unsafe { sample(&raw, options, &World::default()) };
    if let Some(payload) = seat.panic {
        resume_unwind(payload);
    }
    match seat.error {
        Some(error) if made.is_err() => Err(error),
        _ => made,
    }
}

/// What the callbacks are handed: the oracle, and what went wrong in it.
struct Seat<'o, O> {
    oracle: &'o mut O,
    error: Option<Error>,
    panic: Option<Box<dyn Any + Send>>,
}

impl<O: Oracle> Seat<'_, O> {
    /// Call into Rust so that nothing but a status comes out.
    fn guard(&mut self, call: impl FnOnce(&mut O) -> Result<(), Error>) -> ffi::Status {
        match catch_unwind(AssertUnwindSafe(|| call(self.oracle))) {
            Ok(Ok(())) => ffi::OK,
            Ok(Err(error)) => {
                let status = error.status();
                self.error = if status.is_answer() { None } else { Some(error) };
                status.0
            }
            Err(payload) => {
                self.panic = Some(payload);
                ffi::FAILED
            }
        }
    }
}

unsafe extern "C" fn on_earliest_arrival<O: Oracle>(ctx: *mut c_void, departure: f64, arrival: *mut f64) -> ffi::Status {
    let seat = &mut *(ctx as *mut Seat<'_, O>);
    seat.guard(|oracle| {
        *arrival = oracle.earliest_arrival(departure)?;
        Ok(())
    })
}

unsafe extern "C" fn on_path<O: Oracle>(ctx: *mut c_void, out: *mut ffi::OraclePath) -> ffi::Status {
    let seat = &mut *(ctx as *mut Seat<'_, O>);
    seat.guard(|oracle| {
        let mut path = ffi::OraclePath { legs: ptr::null(), leg_count: 0, bytes: ptr::null(), byte_count: 0 };
        match oracle.path() {
            Path::None => {}
            Path::Legs(legs) => {
                path.legs = legs.as_ptr();
                path.leg_count = legs.len();
            }
            Path::Bytes(bytes) => {
                path.bytes = bytes.as_ptr() as *const c_void;
                path.byte_count = bytes.len();
            }
        }
        *out = path;
        Ok(())
    })
}

/// What the header says of the world.
#[derive(Default)]
struct World {
    hash: u64,
    speed: f64,
    source: Point,
    destination: Point,
}

/// `oracle` and all that it points to must stay for the call.
unsafe fn sample(oracle: *const ffi::Oracle, options: &Options, world: &World) -> Result<Table<'static>, Error> {
    let length_unit = c_string(&options.length_unit)?;
    let time_unit = c_string(&options.time_unit)?;
    let mut raw = MaybeUninit::<ffi::BuildOptions>::uninit();
    ffi::tdsp_build_options_init(raw.as_mut_ptr());
    let mut raw = raw.assume_init();
    match options.guarantee {
        Guarantee::Travel(epsilon) => raw.epsilon = epsilon,
        Guarantee::Arrival(epsilon) => {
            raw.guarantee = 1;
            raw.epsilon = epsilon;
        }
        Guarantee::Absolute(delta) => {
            raw.guarantee = 2;
            raw.delta = delta;
        }
    }
    raw.horizon = options.horizon;
    raw.world = ffi::World {
        scene_hash: world.hash,
        speed: world.speed,
        source: world.source,
        destination: world.destination,
        length_unit: length_unit.as_ptr(),
        time_unit: time_unit.as_ptr(),
    };
    let (mut bytes, mut length) = (ptr::null_mut(), 0);
    check(ffi::tdsp_build(oracle, &raw, ptr::null(), &mut bytes, &mut length, ptr::null_mut()))?;
    Table::made(bytes, length)
}

fn c_string(text: &str) -> Result<CString, Error> {
    CString::new(text).map_err(|_| Error::from(Status(ffi::INVALID_ARGUMENT)))
}
