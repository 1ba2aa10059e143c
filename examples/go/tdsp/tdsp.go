// SPDX-License-Identifier: MIT

// Package tdsp is libtdsp in Go: tables, scenes, exact answers, and oracles of one's own.
//
// It needs cgo, the library's headers and the library: CGO_CFLAGS=-I.../include CGO_LDFLAGS=-L.../lib where they are not installed.
//
// What is opened or made is closed with Close; what is forgotten is freed when the garbage collector finds it. What goes wrong, and a question that has
// no answer, is an error that wraps a Status with the library's words: errors.Is(err, tdsp.CutOff).
package tdsp

/*
#cgo CFLAGS: -std=c99
#cgo LDFLAGS: -ltdsp -lm
#include "tdsp/path.h"
#include "tdsp/status.h"
#include "tdsp/types.h"
*/
import "C"

import "unsafe"

// Status says why there is no answer, or what is wrong. It is an error.
type Status int32

// The statuses that this package's own documentation speaks of; tdsp/status.h has them all.
const (
	OK                 Status = C.TDSP_OK
	SourceCovered      Status = C.TDSP_SOURCE_COVERED
	DestinationCovered Status = C.TDSP_DESTINATION_COVERED
	CutOff             Status = C.TDSP_CUT_OFF
	ArrivalTooEarly    Status = C.TDSP_ARRIVAL_TOO_EARLY
	Unreachable        Status = C.TDSP_UNREACHABLE
	InvalidArgument    Status = C.TDSP_INVALID_ARGUMENT
	BadScene           Status = C.TDSP_BAD_SCENE
	BadMagic           Status = C.TDSP_BAD_MAGIC
	NoMemory           Status = C.TDSP_NO_MEMORY
	Failed             Status = C.TDSP_FAILED
)

// Error is the library's sentence.
func (s Status) Error() string { return C.GoString(C.tdsp_status_text(C.tdsp_status(s))) }

// Name is the stable name, e.g. "cut_off".
func (s Status) Name() string { return C.GoString(C.tdsp_status_name(C.tdsp_status(s))) }

// IsAnswer tells whether the question was understood, and this is why there is no number.
func (s Status) IsAnswer() bool { return C.tdsp_status_is_answer(C.tdsp_status(s)) != 0 }

// Version of the linked library.
func Version() string { return C.GoString(C.tdsp_version()) }

func check(status C.tdsp_status) error {
	if status == C.TDSP_OK {
		return nil
	}
	return Status(status)
}

// Point is a place, in the unit of length.
type Point struct{ X, Y float64 }

// NoDisc is the disc of a leg that rides on none, and of a gap that is not known.
const NoDisc = C.TDSP_NO_DISC

// Kinds of legs.
const (
	LegLine  = C.TDSP_LEG_LINE
	LegArc   = C.TDSP_LEG_ARC
	LegCurve = C.TDSP_LEG_CURVE
)

// Leg is one leg of a path, laid out as tdsp_leg, which says what each member means.
type Leg struct {
	Kind                               uint32
	Disc                               uint32
	Turn                               int32
	_                                  uint32
	StartTime, EndTime                 float64
	From, To, Center                   Point
	RadiusFrom, RadiusTo               float64
	AngleFrom, Sweep                   float64
	RateFrom, RateTo, BendFrom, BendTo float64
	Speed                              float64
}

// Does not compile where the layouts differ.
var _ = [1]byte{}[unsafe.Sizeof(Leg{})-unsafe.Sizeof(C.tdsp_leg{})]

// Gap is what closes at a jump; First is NoDisc where it is not known.
type Gap struct {
	First, Second uint32
	Time          float64
	Place         Point
}

func point(p C.tdsp_point) Point { return Point{float64(p.x), float64(p.y)} }

// legsOf asks twice, as the library does with arrays whose length is not known: how many, then for them. Legs are written where they stay.
func legsOf(ask func(legs *C.tdsp_leg, capacity C.size_t, count *C.size_t) C.tdsp_status) ([]Leg, error) {
	var count C.size_t
	if status := ask(nil, 0, &count); status != C.TDSP_OK && status != C.TDSP_BUFFER_TOO_SMALL {
		return nil, Status(status)
	}
	legs := make([]Leg, count)
	if count == 0 {
		return legs, nil
	}
	return legs, check(ask((*C.tdsp_leg)(unsafe.Pointer(&legs[0])), count, &count))
}
