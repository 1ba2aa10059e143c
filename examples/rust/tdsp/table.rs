// SPDX-License-Identifier: MIT
//! Tables: a view of bytes that were checked whole when it was made.
//!
//! `Table::raw` points into `Table::bytes`, which do not move when the table does: they are on a heap, or borrowed for the table's lifetime.
use crate::{check, ffi, legs_of, words, Error, Jump, Leg, Point, Status};
use std::mem::MaybeUninit;
use std::os::raw::{c_char, c_void};
use std::ptr;

enum Bytes<'a> {
    Owned(Vec<u8>),
    Borrowed(&'a [u8]),
    /// Made by tdsp_build().
    Made(*mut c_void, usize),
}

/// An opened table. Any number of threads may ask it.
pub struct Table<'a> {
    raw: ffi::Table,
    bytes: Bytes<'a>,
}

// Nothing is ever written, and nothing else points to what Made owns.
unsafe impl Send for Table<'_> {}
unsafe impl Sync for Table<'_> {}

impl Drop for Bytes<'_> {
    fn drop(&mut self) {
        if let Bytes::Made(start, length) = *self {
            unsafe { ffi::tdsp_bytes_free(ptr::null(), start, length) }
        }
    }
}

impl Bytes<'_> {
    fn get(&self) -> &[u8] {
        match self {
            Bytes::Owned(bytes) => bytes,
            Bytes::Borrowed(bytes) => bytes,
            Bytes::Made(start, length) => unsafe { std::slice::from_raw_parts(*start as *const u8, *length) },
        }
    }
}

/// The earliest arrival is not before `lower`; a path is known that arrives at `upper` or before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub lower: f64,
    pub upper: f64,
}

/// Leaving at `safe` is in time for certain; leaving after `none_after` is not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    pub safe: f64,
    pub none_after: f64,
}

/// Answers to many departures; where a status is not [`Status::OK`] both ends are infinite.
#[derive(Clone, Debug, Default)]
pub struct Intervals {
    pub lower: Vec<f64>,
    pub upper: Vec<f64>,
    pub statuses: Vec<Status>,
}

/// What the header says.
#[derive(Clone, Debug)]
pub struct Info {
    pub rows: u64,
    pub legs: u64,
    pub length: u64,
    pub scene_hash: u64,
    pub epsilon: f64,
    pub delta: f64,
    pub speed: f64,
    pub source: Point,
    pub destination: Point,
    pub last_departure: f64,
    pub last_reason: Status,
    pub length_unit: String,
    pub time_unit: String,
}

impl Table<'static> {
    /// Read a file and check it whole; an error begins with its name.
    pub fn open(name: &str) -> Result<Table<'static>, Error> {
        match std::fs::read(name) {
            Ok(bytes) => Table::from_vec(bytes).map_err(|wrong| wrong.about(name)),
            Err(wrong) => Err(Error::new(Status::FAILED, &wrong.to_string()).about(name)),
        }
    }

    /// Bytes that the table takes over.
    pub fn from_vec(bytes: Vec<u8>) -> Result<Table<'static>, Error> {
        Table::over(Bytes::Owned(bytes))
    }

    /// `start` and `length` are as tdsp_build() gave them, and nobody else's.
    pub(crate) unsafe fn made(start: *mut c_void, length: usize) -> Result<Table<'static>, Error> {
        Table::over(Bytes::Made(start, length))
    }
}

impl<'a> Table<'a> {
    /// A view of bytes that stay the caller's.
    pub fn view(bytes: &'a [u8]) -> Result<Table<'a>, Error> {
        Table::over(Bytes::Borrowed(bytes))
    }

    fn over(bytes: Bytes<'a>) -> Result<Table<'a>, Error> {
        let mut raw = MaybeUninit::uninit();
        let content = bytes.get();
        check(unsafe { ffi::tdsp_table_open(raw.as_mut_ptr(), content.as_ptr() as *const c_void, content.len()) })?;
        Ok(Table { raw: unsafe { raw.assume_init() }, bytes })
    }

    /// The bytes, as they are in a file.
    pub fn as_bytes(&self) -> &[u8] {
        self.bytes.get()
    }

    pub fn info(&self) -> Info {
        let mut out = MaybeUninit::<ffi::TableInfo>::uninit();
        // Only null pointers could be refused.
        let out = unsafe {
            ffi::tdsp_table_get_info(&self.raw, out.as_mut_ptr());
            out.assume_init()
        };
        Info {
            rows: out.rows,
            legs: out.legs,
            length: out.length,
            scene_hash: out.scene_hash,
            epsilon: out.epsilon,
            delta: out.delta,
            speed: out.speed,
            source: out.source,
            destination: out.destination,
            last_departure: out.last_departure,
            last_reason: Status(out.last_reason),
            length_unit: unit(&out.length_unit),
            time_unit: unit(&out.time_unit),
        }
    }

    pub fn arrival(&self, departure: f64) -> Result<Interval, Error> {
        let (mut lower, mut upper) = (0.0, 0.0);
        check(unsafe { ffi::tdsp_table_arrival(&self.raw, departure, &mut lower, &mut upper) })?;
        Ok(Interval { lower, upper })
    }

    pub fn departure(&self, arrival: f64) -> Result<Departure, Error> {
        let (mut safe, mut none_after) = (0.0, 0.0);
        check(unsafe { ffi::tdsp_table_departure(&self.raw, arrival, &mut safe, &mut none_after) })?;
        Ok(Departure { safe, none_after })
    }

    pub fn path(&self, departure: f64) -> Result<Vec<Leg>, Error> {
        legs_of(|legs, capacity, count| unsafe { ffi::tdsp_table_path(&self.raw, departure, legs, capacity, count) })
    }

    /// Where a robot that left at `departure` is at `time`, clamped to its path.
    pub fn position(&self, departure: f64, time: f64) -> Result<Point, Error> {
        let mut out = Point::default();
        check(unsafe { ffi::tdsp_table_position(&self.raw, departure, time, &mut out) })?;
        Ok(out)
    }

    /// Look up many departures at once.
    pub fn arrivals(&self, departures: &[f64]) -> Intervals {
        let count = departures.len();
        let mut out = Intervals { lower: vec![0.0; count], upper: vec![0.0; count], statuses: vec![Status::OK; count] };
        // Only null pointers could be refused; a Status is a C int.
        unsafe {
            let statuses = out.statuses.as_mut_ptr() as *mut ffi::Status;
            ffi::tdsp_table_arrivals(&self.raw, departures.as_ptr(), count, out.lower.as_mut_ptr(), out.upper.as_mut_ptr(), statuses);
        }
        out
    }

    /// The jumps of the travel time, in order.
    pub fn jumps(&self) -> Jumps<'_> {
        Jumps { raw: &self.raw, next: 0.0 }
    }

    /// The bytes that an oracle gave as the path of the row that answers `departure`.
    pub fn row_bytes(&self, departure: f64) -> Result<&[u8], Error> {
        let (mut row, mut start, mut length) = (0, ptr::null(), 0);
        check(unsafe { ffi::tdsp_table_find(&self.raw, departure, &mut row) })?;
        check(unsafe { ffi::tdsp_table_row_bytes(&self.raw, row, &mut start, &mut length) })?;
        if length == 0 {
            return Ok(&[]);
        }
        Ok(unsafe { std::slice::from_raw_parts(start as *const u8, length) })
    }
}

/// See [`Table::jumps`].
pub struct Jumps<'t> {
    raw: &'t ffi::Table,
    next: f64,
}

impl Iterator for Jumps<'_> {
    type Item = Jump;

    fn next(&mut self) -> Option<Jump> {
        let mut jump = Jump::default();
        let mut row = ffi::Row { departure: 0.0, left: 0.0, right: 0.0, legs: 0 };
        if unsafe { ffi::tdsp_table_next_jump(self.raw, self.next, &mut jump) } != ffi::OK {
            return None;
        }
        // A jump is at a row and never at the last, so there is a row after it.
        unsafe { ffi::tdsp_table_row(self.raw, jump.row + 1, &mut row) };
        self.next = row.departure;
        Some(jump)
    }
}

/// Sixteen bytes that end with a zero byte.
fn unit(text: &[c_char; 16]) -> String {
    words(text.as_ptr()).to_string()
}
