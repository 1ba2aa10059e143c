// SPDX-License-Identifier: MIT
//! A table over a world of one's own, sampled by the library through callbacks: the ferries of examples/c/custom_oracle.c, and the same table to the bit.
//!
//!     custom_oracle [NEW]    NEW receives the table that is made
use std::process::exit;
use tdsp::{build, Error, Monotone, Oracle, Path, Status, Table};

const MINUTES_BETWEEN: f64 = 30.0;
/// Minutes of each crossing. A later ferry never arrives before an earlier one.
const CROSSING: [f64; 9] = [20.0, 20.0, 22.0, 25.0, 30.0, 32.0, 30.0, 26.0, 21.0];

/// The number of the ferry that was taken last, as bytes: a row's path.
#[derive(Default)]
struct Ferries {
    last_taken: [u8; 4],
}

impl Oracle for Ferries {
    const MONOTONE: Monotone = Monotone::Arrival;

    fn earliest_arrival(&mut self, departure: f64) -> Result<f64, Error> {
        for (i, minutes) in (0..).zip(CROSSING) {
            let leaves = f64::from(i) * MINUTES_BETWEEN;
            if leaves >= departure {
                self.last_taken = i32::to_ne_bytes(i);
                return Ok(leaves + minutes);
            }
        }
        Err(Status::UNREACHABLE.into())
    }

    fn path(&self) -> Path<'_> {
        Path::Bytes(&self.last_taken)
    }
}

fn print_answer(table: &Table, departure: f64) -> Result<(), Error> {
    print!("at the quay at minute {:.0}: ", departure);
    match table.arrival(departure) {
        Ok(found) => {
            let mut ferry = [0; 4];
            ferry.copy_from_slice(table.row_bytes(departure)?);
            println!("take ferry {}, arrive at minute {:.0}", i32::from_ne_bytes(ferry), found.upper);
        }
        Err(none) => println!("{}", none),
    }
    Ok(())
}

fn run() -> Result<(), Box<dyn std::error::Error>> {
    let options = build::Options { guarantee: build::Guarantee::Absolute(1.0), ..build::Options::default() };
    let table = build::oracle(&mut Ferries::default(), &options)?;
    for departure in [0.0, 31.0, 89.0, 90.0, 239.0, 241.0] {
        print_answer(&table, departure)?;
    }
    if let Some(name) = std::env::args().nth(1) {
        std::fs::write(name, table.as_bytes())?;
    }
    Ok(())
}

fn main() {
    if let Err(problem) = run() {
        eprintln!("custom_oracle: {}", problem);
        exit(1);
    }
}
