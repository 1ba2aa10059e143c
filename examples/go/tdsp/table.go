// SPDX-License-Identifier: MIT

package tdsp

/*
#include <stdlib.h>
#include "tdsp/build.h"
#include "tdsp/table.h"
*/
import "C"

import (
	"errors"
	"fmt"
	"io"
	"math"
	"os"
	"runtime"
	"unsafe"
)

// ErrClosed is returned where a table, a scene or a solver is used after Close.
var ErrClosed = errors.New("tdsp: used after Close")

// Table is an opened table: any number of goroutines may ask it, as long as none closes it.
//
// The bytes and the view of them are in C's memory: C keeps a pointer from one to the other, which Go's memory must not hold.
type Table struct {
	raw   *C.tdsp_table
	bytes unsafe.Pointer
	size  C.size_t
	free  func(bytes unsafe.Pointer, size C.size_t)
}

// Interval holds the earliest arrival: not before Lower, and by a path that is known at Upper or before.
type Interval struct{ Lower, Upper float64 }

// Departure answers a deadline: leaving at Safe is in time for certain, leaving after NoneAfter is not.
type Departure struct{ Safe, NoneAfter float64 }

// Info is what the header says.
type Info struct {
	Rows, Legs, Length   uint64
	SceneHash            uint64
	Epsilon, Delta       float64
	Speed                float64
	Source, Destination  Point
	LastDeparture        float64
	LastReason           Status
	LengthUnit, TimeUnit string
}

// Jump is a jump of the travel time after Departure, from Before to After.
type Jump struct {
	Departure, Before, After float64
	Gap                      Gap
}

// Open reads a file and checks it whole. The error names the file.
func Open(name string) (*Table, error) {
	file, err := os.Open(name)
	if err != nil {
		return nil, err
	}
	defer file.Close()
	status, err := file.Stat()
	if err != nil {
		return nil, err
	}
	if status.Size() > math.MaxInt32 {
		return nil, fmt.Errorf("%s: larger than this program reads", name)
	}
	table, err := read(file, int(status.Size()))
	if err != nil {
		return nil, fmt.Errorf("%s: %w", name, err)
	}
	return table, nil
}

// FromBytes opens a copy of the bytes.
func FromBytes(bytes []byte) (*Table, error) {
	return over(C.CBytes(bytes), C.size_t(len(bytes)), freeCopy)
}

// read fills C's memory from the file, so that nothing is copied.
func read(file io.Reader, size int) (*Table, error) {
	bytes := C.malloc(C.size_t(size) + 1)
	if _, err := io.ReadFull(file, unsafe.Slice((*byte)(bytes), size)); err != nil {
		C.free(bytes)
		return nil, err
	}
	return over(bytes, C.size_t(size), freeCopy)
}

func freeCopy(bytes unsafe.Pointer, _ C.size_t) { C.free(bytes) }

// over takes the bytes over, also when they are refused.
func over(bytes unsafe.Pointer, size C.size_t, free func(unsafe.Pointer, C.size_t)) (*Table, error) {
	t := &Table{(*C.tdsp_table)(C.malloc(C.sizeof_tdsp_table)), bytes, size, free}
	if err := check(C.tdsp_table_open(t.raw, bytes, size)); err != nil {
		t.Close()
		return nil, err
	}
	runtime.SetFinalizer(t, (*Table).Close)
	return t, nil
}

// Close frees the table's memory. Closing twice is allowed.
func (t *Table) Close() error {
	if t.raw != nil {
		runtime.SetFinalizer(t, nil)
		t.free(t.bytes, t.size)
		C.free(unsafe.Pointer(t.raw))
		t.raw, t.bytes, t.size = nil, nil, 0
	}
	return nil
}

// ask calls f with the open table, which is not freed meanwhile.
func (t *Table) ask(f func(raw *C.tdsp_table) C.tdsp_status) error {
	if t.raw == nil {
		return ErrClosed
	}
	defer runtime.KeepAlive(t)
	return check(f(t.raw))
}

// WriteTo writes the bytes, as they are in a file.
func (t *Table) WriteTo(w io.Writer) (int64, error) {
	if t.raw == nil {
		return 0, ErrClosed
	}
	defer runtime.KeepAlive(t)
	n, err := w.Write(unsafe.Slice((*byte)(t.bytes), t.size))
	return int64(n), err
}

// Info is what the header says.
func (t *Table) Info() (Info, error) {
	var out C.tdsp_table_info
	err := t.ask(func(raw *C.tdsp_table) C.tdsp_status { return C.tdsp_table_get_info(raw, &out) })
	if err != nil {
		return Info{}, err
	}
	return Info{
		Rows: uint64(out.rows), Legs: uint64(out.legs), Length: uint64(out.length), SceneHash: uint64(out.scene_hash),
		Epsilon: float64(out.epsilon), Delta: float64(out.delta), Speed: float64(out.speed),
		Source: point(out.source), Destination: point(out.destination),
		LastDeparture: float64(out.last_departure), LastReason: Status(out.last_reason),
		LengthUnit: C.GoString(&out.length_unit[0]), TimeUnit: C.GoString(&out.time_unit[0]),
	}, nil
}

// Arrival is the interval of the earliest arrival of who leaves at departure.
func (t *Table) Arrival(departure float64) (Interval, error) {
	var lower, upper C.double
	err := t.ask(func(raw *C.tdsp_table) C.tdsp_status {
		return C.tdsp_table_arrival(raw, C.double(departure), &lower, &upper)
	})
	return Interval{float64(lower), float64(upper)}, err
}

// Departure says when to leave to arrive by arrival.
func (t *Table) Departure(arrival float64) (Departure, error) {
	var safe, noneAfter C.double
	err := t.ask(func(raw *C.tdsp_table) C.tdsp_status {
		return C.tdsp_table_departure(raw, C.double(arrival), &safe, &noneAfter)
	})
	return Departure{float64(safe), float64(noneAfter)}, err
}

// Path is the path of who leaves at departure.
func (t *Table) Path(departure float64) ([]Leg, error) {
	if t.raw == nil {
		return nil, ErrClosed
	}
	defer runtime.KeepAlive(t)
	return legsOf(func(legs *C.tdsp_leg, capacity C.size_t, count *C.size_t) C.tdsp_status {
		return C.tdsp_table_path(t.raw, C.double(departure), legs, capacity, count)
	})
}

// Position is where a robot that left at departure is at time, clamped to its path.
func (t *Table) Position(departure, time float64) (Point, error) {
	var out C.tdsp_point
	err := t.ask(func(raw *C.tdsp_table) C.tdsp_status {
		return C.tdsp_table_position(raw, C.double(departure), C.double(time), &out)
	})
	return point(out), err
}

// Arrivals looks up many departures at once and writes into slices of the same length, without copying; where a status is not OK both ends are
// infinite.
func (t *Table) Arrivals(departures, lower, upper []float64, statuses []Status) error {
	count := len(departures)
	if len(lower) != count || len(upper) != count || len(statuses) != count {
		return fmt.Errorf("tdsp: %d departures, but room for %d, %d and %d: %w", count, len(lower), len(upper), len(statuses), InvalidArgument)
	}
	if count == 0 {
		return nil
	}
	return t.ask(func(raw *C.tdsp_table) C.tdsp_status {
		return C.tdsp_table_arrivals(raw, (*C.double)(&departures[0]), C.size_t(count), (*C.double)(&lower[0]), (*C.double)(&upper[0]),
			(*C.tdsp_status)(unsafe.Pointer(&statuses[0])))
	})
}

// Jumps are all jumps of the travel time, in order.
func (t *Table) Jumps() ([]Jump, error) {
	var out []Jump
	var jump C.tdsp_jump
	var next C.tdsp_row
	for {
		err := t.ask(func(raw *C.tdsp_table) C.tdsp_status { return C.tdsp_table_next_jump(raw, next.departure, &jump) })
		if errors.Is(err, Status(C.TDSP_NO_ANSWER)) {
			return out, nil
		}
		if err != nil {
			return nil, err
		}
		gap := Gap{uint32(jump.gap.first), uint32(jump.gap.second), float64(jump.gap.time), point(jump.gap.place)}
		out = append(out, Jump{float64(jump.departure), float64(jump.before), float64(jump.after), gap})
		// A jump is at a row and never at the last, so there is a row after it.
		if err := t.ask(func(raw *C.tdsp_table) C.tdsp_status { return C.tdsp_table_row(raw, jump.row+1, &next) }); err != nil {
			return nil, err
		}
	}
}

// RowBytes is a copy of the bytes that an oracle gave as the path of the row that answers departure.
func (t *Table) RowBytes(departure float64) ([]byte, error) {
	var row C.uint64_t
	var bytes unsafe.Pointer
	var length C.size_t
	if err := t.ask(func(raw *C.tdsp_table) C.tdsp_status { return C.tdsp_table_find(raw, C.double(departure), &row) }); err != nil {
		return nil, err
	}
	defer runtime.KeepAlive(t)
	err := t.ask(func(raw *C.tdsp_table) C.tdsp_status { return C.tdsp_table_row_bytes(raw, row, &bytes, &length) })
	return C.GoBytes(bytes, C.int(length)), err
}
