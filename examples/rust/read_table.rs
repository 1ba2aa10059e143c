// SPDX-License-Identifier: MIT
//! Read a table, then make one: the lines of examples/c/read_table.c, to the bit.
//!
//!     read_table TABLE [NEW]    NEW receives the table that is made
use std::error::Error;
use std::process::exit;
use tdsp::{build, Disc, Journey, Point, Scene, Solver, Table, LEG_LINE, NO_DISC};

fn number(value: f64) -> String {
    format!("{:.6}[{:016x}]", value, value.to_bits())
}

fn place(point: Point) -> String {
    format!("({}, {})", number(point.x), number(point.y))
}

fn print_info(table: &Table) {
    let info = table.info();
    println!("{} rows, {} legs, {} bytes, in {} and {}", info.rows, info.legs, info.length, info.length_unit, info.time_unit);
    println!("departures up to {}, then {}", number(info.last_departure), info.last_reason.name());
}

fn print_arrival(table: &Table, departure: f64) {
    print!("leave at {}: ", number(departure));
    match table.arrival(departure) {
        Ok(found) => println!("arrive from {} to {}", number(found.lower), number(found.upper)),
        Err(none) => println!("{}", none),
    }
}

fn print_departure(table: &Table, arrival: f64) {
    print!("arrive by {}: ", number(arrival));
    match table.departure(arrival) {
        Ok(found) => println!("leave by {}, none after {}", number(found.safe), number(found.none_after)),
        Err(none) => println!("{}", none),
    }
}

fn print_path(table: &Table, departure: f64) -> Result<(), tdsp::Error> {
    let legs = table.path(departure)?;
    println!("path for {}: {} legs", number(departure), legs.len());
    for leg in &legs {
        let kind = if leg.kind == LEG_LINE { "line" } else { "ride" };
        println!("  {} from {} at {} to {} at {}", kind, number(leg.start_time), place(leg.from), number(leg.end_time), place(leg.to));
        if leg.kind != LEG_LINE {
            print!("    on disc {}, turn {}, from angle {} by {}, ", leg.disc, leg.turn, number(leg.angle_from), number(leg.sweep));
            println!("radius {} to {}", number(leg.radius_from), number(leg.radius_to));
        }
    }
    Ok(())
}

fn print_batch(table: &Table) {
    let departures: Vec<f64> = (0..8).map(|i| 10.0 * f64::from(i)).collect();
    let answers = table.arrivals(&departures);
    for (i, status) in answers.statuses.iter().enumerate() {
        print!("batch {}: {}", i, status.name());
        if *status == tdsp::Status::OK {
            print!(" {} {}", number(answers.lower[i]), number(answers.upper[i]));
        }
        println!();
    }
}

fn print_jumps(table: &Table) {
    for jump in table.jumps() {
        println!("after {}: jump from {} to {}", number(jump.departure), number(jump.before), number(jump.after));
        let gap = jump.gap;
        if gap.first != NO_DISC {
            println!("  discs {} and {} close at {}, at {}", gap.first, gap.second, number(gap.time), place(gap.place));
        }
    }
}

fn print_table(table: &Table) -> Result<(), tdsp::Error> {
    print_info(table);
    for departure in [0.0, 5.0, 40.0, 61.0] {
        print_arrival(table, departure);
    }
    for arrival in [10.0, 30.0, 1000.0] {
        print_departure(table, arrival);
    }
    print_path(table, 12.0)?;
    for time in [12.0, 17.0, 22.0, 27.0, 32.0, 37.0] {
        println!("at {}: {}", number(time), place(table.position(12.0, time)?));
    }
    print_batch(table);
    print_jumps(table);
    Ok(())
}

fn make_table() -> Result<Table<'static>, tdsp::Error> {
    let journey = Journey { speed: 1.0, radius: 0.0, source: Point { x: -10.0, y: 0.0 }, destination: Point { x: 10.0, y: 0.0 } };
    let disc = |y| Disc { center: Point { x: 0.0, y }, radius: 1.0, growth: 0.1 };
    let scene = Scene::new(&journey, &[disc(3.0), disc(-3.0)])?;
    let mut solver = Solver::new(&scene)?;
    let arrival = solver.earliest_arrival(9.0)?;
    println!("made: from 9 to {}; to 33 from {}", number(arrival), number(solver.latest_departure(33.0)?));
    let options = build::Options {
        guarantee: build::Guarantee::Travel(0.05),
        length_unit: "m".to_string(),
        time_unit: "s".to_string(),
        ..build::Options::default()
    };
    build::scene(&scene, &options)
}

fn run(arguments: &[String]) -> Result<(), Box<dyn Error>> {
    print_table(&Table::open(&arguments[1])?)?;
    let made = make_table()?;
    print_table(&made)?;
    if let Some(name) = arguments.get(2) {
        std::fs::write(name, made.as_bytes())?;
    }
    Ok(())
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: read_table TABLE [NEW]");
        exit(2);
    }
    if let Err(problem) = run(&arguments) {
        eprintln!("read_table: {}", problem);
        exit(1);
    }
}
