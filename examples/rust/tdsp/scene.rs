// SPDX-License-Identifier: MIT
//! Scenes of growing discs, and exact questions to them.
use crate::{check, ffi, legs_of, words, Disc, Error, Journey, Leg, Status};
use std::marker::PhantomData;
use std::os::raw::c_char;
use std::ptr;

/// Discs around a journey, prepared. Never changes: share it among threads, each with a [`Solver`] of its own.
pub struct Scene {
    raw: *mut ffi::Scene,
}

unsafe impl Send for Scene {}
unsafe impl Sync for Scene {}

impl Scene {
    /// An error says which number is out of its range.
    pub fn new(journey: &Journey, discs: &[Disc]) -> Result<Scene, Error> {
        in_range("journey", unsafe { ffi::tdsp_journey_check(journey) })?;
        for (i, disc) in discs.iter().enumerate() {
            in_range(&format!("disc {}", i), unsafe { ffi::tdsp_disc_check(disc) })?;
        }
        let mut raw = ptr::null_mut();
        check(unsafe { ffi::tdsp_scene_create(journey, discs.as_ptr(), discs.len(), ptr::null(), &mut raw) })?;
        Ok(Scene { raw })
    }

    pub fn hash(&self) -> u64 {
        unsafe { ffi::tdsp_scene_hash(self.raw) }
    }

    pub fn journey(&self) -> &Journey {
        unsafe { &*ffi::tdsp_scene_journey(self.raw) }
    }
}

fn in_range(what: &str, wrong: *const c_char) -> Result<(), Error> {
    if wrong.is_null() {
        return Ok(());
    }
    Err(Error::new(Status(ffi::BAD_SCENE), words(wrong)).about(what))
}

impl Drop for Scene {
    fn drop(&mut self) {
        unsafe { ffi::tdsp_scene_free(self.raw) }
    }
}

/// A workspace for questions to one scene, which it borrows. One thread at a time: `&mut self` sees to that.
pub struct Solver<'s> {
    pub(crate) raw: *mut ffi::Solver,
    scene: PhantomData<&'s Scene>,
}

unsafe impl Send for Solver<'_> {}

impl<'s> Solver<'s> {
    pub fn new(scene: &'s Scene) -> Result<Solver<'s>, Error> {
        let mut raw = ptr::null_mut();
        check(unsafe { ffi::tdsp_solver_create(scene.raw, &mut raw) })?;
        Ok(Solver { raw, scene: PhantomData })
    }

    pub fn earliest_arrival(&mut self, departure: f64) -> Result<f64, Error> {
        let mut arrival = 0.0;
        check(unsafe { ffi::tdsp_earliest_arrival(self.raw, departure, &mut arrival) })?;
        Ok(arrival)
    }

    pub fn latest_departure(&mut self, arrival: f64) -> Result<f64, Error> {
        let mut departure = 0.0;
        check(unsafe { ffi::tdsp_latest_departure(self.raw, arrival, &mut departure, ptr::null_mut()) })?;
        Ok(departure)
    }

    /// Of the last answer.
    pub fn path(&self) -> Result<Vec<Leg>, Error> {
        legs_of(|legs, capacity, count| unsafe { ffi::tdsp_solver_path(self.raw, legs, capacity, count) })
    }
}

impl Drop for Solver<'_> {
    fn drop(&mut self) {
        unsafe { ffi::tdsp_solver_free(self.raw) }
    }
}
