// SPDX-License-Identifier: MIT
//! What the Rust wrapper says when it is used wrongly, and what becomes of errors and panics in a callback.
use std::panic::{catch_unwind, AssertUnwindSafe};
use tdsp::{build, Disc, Error, Journey, Monotone, Oracle, Point, Scene, Solver, Status, Table};

fn golden() -> Table<'static> {
    Table::open(&std::env::var("TDSP_GOLDEN").unwrap()).unwrap()
}

fn journey() -> Journey {
    Journey { speed: 1.0, radius: 0.0, source: Point { x: -10.0, y: 0.0 }, destination: Point { x: 10.0, y: 0.0 } }
}

/// Takes ten minutes, and does something else from a departure on.
struct After<F>(f64, F);

impl<F: FnMut() -> Result<f64, Error>> Oracle for After<F> {
    const MONOTONE: Monotone = Monotone::Travel;

    fn earliest_arrival(&mut self, departure: f64) -> Result<f64, Error> {
        if departure >= self.0 {
            return (self.1)();
        }
        Ok(departure + 10.0)
    }
}

fn options() -> build::Options {
    build::Options { horizon: 100.0, ..build::Options::default() }
}

#[test]
fn a_question_without_an_answer_is_told_apart_from_a_mistake() {
    let table = golden();
    let none = table.arrival(61.0).unwrap_err();
    assert!(none.status().is_answer());
    assert_eq!(none.status().name(), "destination_covered");
    let mistake = table.arrival(-1.0).unwrap_err();
    assert!(!mistake.status().is_answer());
    assert_eq!(mistake.to_string(), "An argument is missing, not a number or out of its range");
    assert!(table.path(61.0).is_err());
    assert!(table.arrivals(&[]).statuses.is_empty());
}

#[test]
fn bytes_that_are_no_table_are_refused() {
    assert_eq!(Table::view(b"no table").err().unwrap().status().name(), "bad_magic");
    assert_eq!(Table::view(&[]).err().unwrap().status().name(), "bad_magic");
    let mut bytes = golden().as_bytes().to_vec();
    *bytes.last_mut().unwrap() ^= 1;
    assert_eq!(Table::from_vec(bytes).err().unwrap().status().name(), "bad_checksum");
}

#[test]
fn a_table_moves_to_threads_and_is_shared_there() {
    let table = golden();
    let here = table.arrival(5.0).unwrap();
    std::thread::scope(|threads| {
        for _ in 0..4 {
            threads.spawn(|| assert_eq!(table.arrival(5.0).unwrap(), here));
        }
    });
    assert_eq!(std::thread::spawn(move || table.arrival(5.0).unwrap()).join().unwrap(), here);
}

#[test]
fn a_scene_names_what_is_out_of_range() {
    let good = Disc { center: Point { x: 0.0, y: 3.0 }, radius: 1.0, growth: 0.1 };
    let wrong = Scene::new(&journey(), &[good, Disc { growth: f64::NAN, ..good }]).err().unwrap();
    assert!(wrong.to_string().starts_with("disc 1: "), "{}", wrong);
    assert!(Scene::new(&Journey::default(), &[]).err().unwrap().to_string().starts_with("journey: "));
}

#[test]
fn departures_without_an_end_need_a_horizon() {
    let scene = Scene::new(&journey(), &[]).unwrap();
    assert_eq!(build::scene(&scene, &build::Options::default()).err().unwrap().status().name(), "needs_horizon");
    assert!(build::scene(&scene, &options()).is_ok());
    let mut solver = Solver::new(&scene).unwrap();
    assert!(solver.path().is_err());
    assert_eq!(solver.earliest_arrival(1.0).unwrap(), 21.0);
    assert_eq!(solver.path().unwrap().len(), 1);
}

#[test]
fn an_error_of_an_oracle_comes_out_as_it_is() {
    let own = Error::new(Status::FAILED, "the timetable is missing");
    let wrong = build::oracle(&mut After(0.0, || Err(own.clone())), &options()).err().unwrap();
    assert_eq!(wrong, own);
    assert_eq!(build::oracle(&mut After(50.0, || Err(own.clone())), &options()).err().unwrap(), own);
}

#[test]
fn an_answer_of_an_oracle_ends_the_table() {
    let table = build::oracle(&mut After(50.0, || Err(Status::UNREACHABLE.into())), &options()).unwrap();
    assert_eq!(table.info().last_reason, Status::UNREACHABLE);
    assert_eq!(table.arrival(60.0).unwrap_err().status(), Status::UNREACHABLE);
    let none = build::oracle(&mut After(0.0, || Err(Status::UNREACHABLE.into())), &options()).err().unwrap();
    assert_eq!(none.status(), Status::UNREACHABLE);
}

#[test]
fn a_panic_in_an_oracle_goes_on_when_the_sampler_has_returned() {
    let mut oracle = After(50.0, || -> Result<f64, Error> { panic!("the clock stopped") });
    let caught = catch_unwind(AssertUnwindSafe(|| build::oracle(&mut oracle, &options()).is_ok()));
    assert_eq!(*caught.err().unwrap().downcast::<&str>().unwrap(), "the clock stopped");
}

#[test]
fn an_oracle_that_breaks_its_promise_is_refused() {
    assert_eq!(build::oracle(&mut After(50.0, || Ok(1.0)), &options()).err().unwrap().status().name(), "bad_oracle");
    assert_eq!(build::oracle(&mut After(50.0, || Ok(f64::NAN)), &options()).err().unwrap().status().name(), "bad_oracle");
}

#[test]
fn a_unit_with_a_zero_byte_is_refused() {
    let options = build::Options { time_unit: "s\0".to_string(), ..options() };
    assert_eq!(build::oracle(&mut After(99.0, || Ok(110.0)), &options).err().unwrap().status().name(), "invalid_argument");
}
