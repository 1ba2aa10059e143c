// SPDX-License-Identifier: MIT
//! libtdsp in Rust, without crates: tables, scenes, exact answers, and oracles of one's own.
//!
//! Owners free what they own when they are dropped; what borrows says so by its lifetime. What goes wrong, and a question that has no answer, is an
//! [`Error`] with the library's words.
use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_char;

pub mod ffi;
mod oracle;
mod scene;
mod table;

pub use oracle::{build, Monotone, Oracle, Path};
pub use scene::{Scene, Solver};
pub use table::{Departure, Info, Interval, Intervals, Jumps, Table};

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    pub x: f64,
    pub y: f64,
}

/// A disc that covers, at time t, everything closer to its centre than `radius + growth t`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Disc {
    pub center: Point,
    pub radius: f64,
    pub growth: f64,
}

/// The robot and the ends of its journey.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Journey {
    pub speed: f64,
    pub radius: f64,
    pub source: Point,
    pub destination: Point,
}

pub const LEG_LINE: u32 = 0;
pub const NO_DISC: u32 = 0xffff_ffff;

/// One leg of a path; `tdsp_leg` in include/tdsp/types.h says what each member means.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leg {
    pub kind: u32,
    pub disc: u32,
    pub turn: i32,
    pub reserved: u32,
    pub start_time: f64,
    pub end_time: f64,
    pub from: Point,
    pub to: Point,
    pub center: Point,
    pub radius_from: f64,
    pub radius_to: f64,
    pub angle_from: f64,
    pub sweep: f64,
    pub rate_from: f64,
    pub rate_to: f64,
    pub bend_from: f64,
    pub bend_to: f64,
    pub speed: f64,
}

/// A gap that closes; `first` is [`NO_DISC`] where it is not known.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gap {
    pub first: u32,
    pub second: u32,
    pub time: f64,
    pub place: Point,
}

/// The travel time jumps after `departure`, from `before` to `after`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jump {
    pub row: u64,
    pub departure: f64,
    pub before: f64,
    pub after: f64,
    pub gap: Gap,
}

/// A status of the library other than "ok": why there is no answer, or what is wrong.
#[repr(transparent)]
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Status(pub ffi::Status);

impl Status {
    pub const OK: Status = Status(ffi::OK);
    /// For an oracle: there is no way, now or later.
    pub const UNREACHABLE: Status = Status(ffi::UNREACHABLE);
    /// For an oracle that fails.
    pub const FAILED: Status = Status(ffi::FAILED);

    /// Was the question understood, and this is why there is no number?
    pub fn is_answer(self) -> bool {
        unsafe { ffi::tdsp_status_is_answer(self.0) != 0 }
    }

    /// The stable name, e.g. `cut_off`.
    pub fn name(self) -> &'static str {
        words(unsafe { ffi::tdsp_status_name(self.0) })
    }

    /// The library's sentence.
    pub fn text(self) -> &'static str {
        words(unsafe { ffi::tdsp_status_text(self.0) })
    }
}

impl fmt::Debug for Status {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.name())
    }
}

/// What stands in the way of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    status: Status,
    words: String,
}

impl Error {
    /// An error of one's own, for an [`Oracle`]: it comes out of [`build`] as it is.
    pub fn new(status: Status, words: &str) -> Error {
        Error { status, words: words.to_string() }
    }

    pub fn status(&self) -> Status {
        self.status
    }

    fn about(self, what: &str) -> Error {
        Error { words: format!("{}: {}", what, self.words), ..self }
    }
}

impl From<Status> for Error {
    fn from(status: Status) -> Error {
        Error::new(status, status.text())
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.words)
    }
}

impl std::error::Error for Error {}

/// The version of the linked library.
pub fn version() -> &'static str {
    words(unsafe { ffi::tdsp_version() })
}

fn check(status: ffi::Status) -> Result<(), Error> {
    match status {
        ffi::OK => Ok(()),
        wrong => Err(Status(wrong).into()),
    }
}

/// The library's sentences are static, ASCII, and never null.
fn words(text: *const c_char) -> &'static str {
    unsafe { CStr::from_ptr(text) }.to_str().unwrap_or("")
}

/// Ask twice, as the library does with arrays whose length is not known: how many, then for them.
fn legs_of(mut ask: impl FnMut(*mut Leg, usize, &mut usize) -> ffi::Status) -> Result<Vec<Leg>, Error> {
    let mut count = 0;
    match ask(std::ptr::null_mut(), 0, &mut count) {
        ffi::OK | ffi::BUFFER_TOO_SMALL => {}
        wrong => return Err(Status(wrong).into()),
    }
    let mut legs = vec![Leg::default(); count];
    if count > 0 {
        check(ask(legs.as_mut_ptr(), count, &mut count))?;
    }
    Ok(legs)
}
