// SPDX-License-Identifier: MIT

package tdsp

/*
#include <stdlib.h>
#include "oracle.h"
#include "tdsp/solver.h"
*/
import "C"

import (
	"errors"
	"math"
	"runtime"
	"runtime/cgo"
	"unsafe"
)

// Monotone is what an oracle promises; docs/oracles.md.
type Monotone int

const (
	// MonotoneTravel: the travel time never decreases, and a path serves earlier departures too.
	MonotoneTravel Monotone = C.TDSP_MONOTONE_TRAVEL
	// MonotoneArrival: the arrival never decreases; who is early waits.
	MonotoneArrival Monotone = C.TDSP_MONOTONE_ARRIVAL
)

// Oracle is a world of one's own. It is called in the goroutine that builds, one call at a time.
type Oracle interface {
	Monotone() Monotone
	// EarliestArrival is A(departure). An error that wraps an answer (Status.IsAnswer) says why there is no way; any other ends the building and comes out of it.
	EarliestArrival(departure float64) (float64, error)
	// Path is the path of the last answer as bytes that only the oracle understands; nil for none.
	Path() []byte
}

// Options are those of the library; DefaultOptions are its defaults.
type Options struct {
	Guarantee            Guarantee
	Horizon              float64
	LengthUnit, TimeUnit string
}

// Guarantee is what holds between the lower and the upper end of every answer.
type Guarantee struct {
	kind  C.tdsp_guarantee
	bound float64
}

// Travel promises Upper - t <= (1 + epsilon) (Lower - t).
func Travel(epsilon float64) Guarantee { return Guarantee{C.TDSP_GUARANTEE_TRAVEL, epsilon} }

// Arrival promises Upper <= (1 + epsilon) Lower.
func Arrival(epsilon float64) Guarantee { return Guarantee{C.TDSP_GUARANTEE_ARRIVAL, epsilon} }

// Absolute promises Upper - Lower <= delta.
func Absolute(delta float64) Guarantee { return Guarantee{C.TDSP_GUARANTEE_ABSOLUTE, delta} }

// DefaultOptions promise a hundredth of the travel time.
func DefaultOptions() Options { return Options{Guarantee: Travel(0.01), Horizon: math.Inf(1)} }

// Build makes the table of any world. A panic of the oracle goes on when the sampler has returned.
func Build(oracle Oracle, options Options) (*Table, error) {
	seat := &seat{oracle: oracle}
	handle := cgo.NewHandle(seat)
	defer handle.Delete()
	defer func() { C.free(seat.path) }()
	raw := (*C.tdsp_oracle)(C.malloc(C.sizeof_tdsp_oracle))
	defer C.free(unsafe.Pointer(raw))
	C.go_oracle_init(raw, C.uintptr_t(handle))
	raw.monotone = C.tdsp_monotone(oracle.Monotone())

	table, err := sample(raw, options, C.tdsp_build_world{})
	if seat.panicked != nil {
		panic(seat.panicked)
	}
	if err != nil && seat.err != nil {
		return nil, seat.err
	}
	return table, err
}

// BuildScene makes the table of a scene, which its header describes.
func BuildScene(scene *Scene, options Options) (*Table, error) {
	solver, err := NewSolver(scene)
	if err != nil {
		return nil, err
	}
	defer solver.Close()
	raw := (*C.tdsp_oracle)(C.malloc(C.sizeof_tdsp_oracle))
	defer C.free(unsafe.Pointer(raw))
	if err := check(C.tdsp_solver_oracle(solver.raw, raw)); err != nil {
		return nil, err
	}
	journey := C.tdsp_scene_journey(scene.raw)
	world := C.tdsp_build_world{
		scene_hash: C.tdsp_scene_hash(scene.raw), speed: journey.speed, source: journey.source, destination: journey.destination,
	}
	defer runtime.KeepAlive(scene)
	return sample(raw, options, world)
}

func sample(oracle *C.tdsp_oracle, options Options, world C.tdsp_build_world) (*Table, error) {
	world.length_unit, world.time_unit = C.CString(options.LengthUnit), C.CString(options.TimeUnit)
	defer C.free(unsafe.Pointer(world.length_unit))
	defer C.free(unsafe.Pointer(world.time_unit))
	var raw C.tdsp_build_options
	C.tdsp_build_options_init(&raw)
	raw.guarantee = options.Guarantee.kind
	raw.epsilon, raw.delta = C.double(options.Guarantee.bound), C.double(options.Guarantee.bound)
	raw.horizon = C.double(options.Horizon)
	raw.world = world
	var bytes unsafe.Pointer
	var length C.size_t
	if err := check(C.tdsp_build(oracle, &raw, nil, &bytes, &length, nil)); err != nil {
		return nil, err
	}
	return over(bytes, length, func(bytes unsafe.Pointer, size C.size_t) { C.tdsp_bytes_free(nil, bytes, size) })
}

// seat is what the callbacks find by their handle: the oracle, and what went wrong in it.
type seat struct {
	oracle   Oracle
	err      error
	panicked any
	path     unsafe.Pointer // C's copy of the last path, which the library reads after the callback has returned
}

// guard calls into Go so that nothing but a status comes out: a panic must not unwind C's frames.
func (s *seat) guard(call func() error) (status C.int) {
	returned := false
	defer func() {
		if returned {
			return
		}
		if s.panicked = recover(); s.panicked == nil {
			s.panicked = "tdsp: an oracle panicked with nil"
		}
		status = C.TDSP_FAILED
	}()
	err := call()
	returned = true
	if err == nil {
		return C.TDSP_OK
	}
	var known Status
	if !errors.As(err, &known) || known == OK {
		known = Failed
	}
	if !known.IsAnswer() {
		s.err = err
	}
	return C.int(known)
}

//export goEarliestArrival
func goEarliestArrival(handle C.uintptr_t, departure C.double, arrival *C.double) C.int {
	s := cgo.Handle(handle).Value().(*seat)
	return s.guard(func() error {
		answer, err := s.oracle.EarliestArrival(float64(departure))
		*arrival = C.double(answer)
		return err
	})
}

//export goPath
func goPath(handle C.uintptr_t, out *C.tdsp_oracle_path) C.int {
	s := cgo.Handle(handle).Value().(*seat)
	return s.guard(func() error {
		path := s.oracle.Path()
		C.free(s.path)
		s.path = C.CBytes(path)
		*out = C.tdsp_oracle_path{bytes: s.path, byte_count: C.size_t(len(path))}
		return nil
	})
}
