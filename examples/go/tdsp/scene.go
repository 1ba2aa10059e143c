// SPDX-License-Identifier: MIT

package tdsp

/*
#include "tdsp/scene.h"
#include "tdsp/solver.h"
*/
import "C"

import (
	"fmt"
	"runtime"
	"unsafe"
)

// Disc covers, at time t, everything closer to Center than Radius + Growth t. Laid out as tdsp_disc.
type Disc struct {
	Center         Point
	Radius, Growth float64
}

var _ = [1]byte{}[unsafe.Sizeof(Disc{})-unsafe.Sizeof(C.tdsp_disc{})]

// Journey is the robot and the ends of its journey. Laid out as tdsp_journey.
type Journey struct {
	Speed, Radius       float64
	Source, Destination Point
}

var _ = [1]byte{}[unsafe.Sizeof(Journey{})-unsafe.Sizeof(C.tdsp_journey{})]

// Scene is a prepared scene. It never changes: any number of goroutines may use it, each with a Solver of its own.
type Scene struct{ raw *C.tdsp_scene }

// NewScene prepares discs around a journey. The discs are copied. An error says which number is out of its range.
func NewScene(journey Journey, discs []Disc) (*Scene, error) {
	from := (*C.tdsp_journey)(unsafe.Pointer(&journey))
	if wrong := C.tdsp_journey_check(from); wrong != nil {
		return nil, fmt.Errorf("journey: %s: %w", C.GoString(wrong), BadScene)
	}
	var first *C.tdsp_disc
	for i := range discs {
		disc := (*C.tdsp_disc)(unsafe.Pointer(&discs[i]))
		if wrong := C.tdsp_disc_check(disc); wrong != nil {
			return nil, fmt.Errorf("disc %d: %s: %w", i, C.GoString(wrong), BadScene)
		}
		if i == 0 {
			first = disc
		}
	}
	s := &Scene{}
	if err := check(C.tdsp_scene_create(from, first, C.size_t(len(discs)), nil, &s.raw)); err != nil {
		return nil, err
	}
	runtime.SetFinalizer(s, (*Scene).Close)
	return s, nil
}

// Close frees the scene. Its solvers must be closed before it. Closing twice is allowed.
func (s *Scene) Close() error {
	runtime.SetFinalizer(s, nil)
	C.tdsp_scene_free(s.raw)
	s.raw = nil
	return nil
}

// Solver is a workspace for exact questions to one scene: one goroutine at a time. It keeps its scene.
type Solver struct {
	raw   *C.tdsp_solver
	scene *Scene
}

// NewSolver makes a solver for the scene.
func NewSolver(scene *Scene) (*Solver, error) {
	if scene.raw == nil {
		return nil, ErrClosed
	}
	s := &Solver{scene: scene}
	if err := check(C.tdsp_solver_create(scene.raw, &s.raw)); err != nil {
		return nil, err
	}
	runtime.SetFinalizer(s, (*Solver).Close)
	return s, nil
}

// Close frees the solver. Closing twice is allowed.
func (s *Solver) Close() error {
	runtime.SetFinalizer(s, nil)
	C.tdsp_solver_free(s.raw)
	s.raw = nil
	return nil
}

// ask calls f with the solver, which is not freed meanwhile.
func (s *Solver) ask(f func(raw *C.tdsp_solver) C.tdsp_status) error {
	if s.raw == nil || s.scene.raw == nil {
		return ErrClosed
	}
	defer runtime.KeepAlive(s)
	return check(f(s.raw))
}

// EarliestArrival is A(departure).
func (s *Solver) EarliestArrival(departure float64) (float64, error) {
	var arrival C.double
	err := s.ask(func(raw *C.tdsp_solver) C.tdsp_status {
		return C.tdsp_earliest_arrival(raw, C.double(departure), &arrival)
	})
	return float64(arrival), err
}

// LatestDeparture is the last departure that arrives by arrival.
func (s *Solver) LatestDeparture(arrival float64) (float64, error) {
	var departure C.double
	err := s.ask(func(raw *C.tdsp_solver) C.tdsp_status {
		return C.tdsp_latest_departure(raw, C.double(arrival), &departure, nil)
	})
	return float64(departure), err
}

// Path is the path of the last answer.
func (s *Solver) Path() ([]Leg, error) {
	if s.raw == nil {
		return nil, ErrClosed
	}
	defer runtime.KeepAlive(s)
	return legsOf(func(legs *C.tdsp_leg, capacity C.size_t, count *C.size_t) C.tdsp_status {
		return C.tdsp_solver_path(s.raw, legs, capacity, count)
	})
}
