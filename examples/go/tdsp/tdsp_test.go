// SPDX-License-Identifier: MIT

package tdsp

import (
	"bytes"
	"errors"
	"math"
	"os"
	"runtime"
	"strings"
	"sync"
	"testing"
)

// What the wrapper says when it is used wrongly, and what becomes of errors and panics in a callback.

func golden(t *testing.T) *Table {
	t.Helper()
	table, err := Open(os.Getenv("TDSP_GOLDEN"))
	if err != nil {
		t.Fatal(err)
	}
	t.Cleanup(func() { table.Close() })
	return table
}

func expect(t *testing.T, err error, want Status) {
	t.Helper()
	if !errors.Is(err, want) {
		t.Errorf("got %v, not %q", err, want.Name())
	}
}

var journey = Journey{Speed: 1, Source: Point{X: -10}, Destination: Point{X: 10}}

// after takes ten minutes, and does something else from a departure on.
type after struct {
	from float64
	then func() (float64, error)
}

func (after) Monotone() Monotone { return MonotoneTravel }
func (after) Path() []byte       { return nil }
func (a after) EarliestArrival(departure float64) (float64, error) {
	if departure >= a.from {
		return a.then()
	}
	return departure + 10, nil
}

func untilHundred() Options {
	options := DefaultOptions()
	options.Horizon = 100
	return options
}

func TestAnAnswerThatThereIsNoneIsToldApartFromAMistake(t *testing.T) {
	table := golden(t)
	_, err := table.Arrival(61)
	expect(t, err, DestinationCovered)
	_, err = table.Path(61)
	expect(t, err, DestinationCovered)
	_, err = table.Arrival(-1)
	expect(t, err, InvalidArgument)
	if !DestinationCovered.IsAnswer() || InvalidArgument.IsAnswer() {
		t.Error("answers and mistakes are mixed up")
	}
}

func TestBytesThatAreNoTableAreRefused(t *testing.T) {
	for _, wrong := range [][]byte{nil, {}, []byte("no table")} {
		_, err := FromBytes(wrong)
		expect(t, err, BadMagic)
	}
}

func TestATableIsWrittenAsItWasRead(t *testing.T) {
	table := golden(t)
	var written bytes.Buffer
	if _, err := table.WriteTo(&written); err != nil {
		t.Fatal(err)
	}
	again, err := FromBytes(written.Bytes())
	if err != nil {
		t.Fatal(err)
	}
	first, _ := table.Arrival(5)
	second, _ := again.Arrival(5)
	if first != second {
		t.Error(first, second)
	}
}

func TestUseAfterCloseIsAnError(t *testing.T) {
	table := golden(t)
	table.Close()
	table.Close()
	if _, err := table.Arrival(5); !errors.Is(err, ErrClosed) {
		t.Error(err)
	}
	if _, err := table.Path(5); !errors.Is(err, ErrClosed) {
		t.Error(err)
	}
	scene, err := NewScene(journey, nil)
	if err != nil {
		t.Fatal(err)
	}
	solver, err := NewSolver(scene)
	if err != nil {
		t.Fatal(err)
	}
	solver.Close()
	scene.Close()
	if _, err := solver.EarliestArrival(0); !errors.Is(err, ErrClosed) {
		t.Error(err)
	}
	if _, err := BuildScene(scene, DefaultOptions()); !errors.Is(err, ErrClosed) {
		t.Error(err)
	}
}

func TestSlicesOfOtherLengthsAreRefused(t *testing.T) {
	table := golden(t)
	expect(t, table.Arrivals(make([]float64, 3), make([]float64, 3), make([]float64, 2), make([]Status, 3)), InvalidArgument)
	if err := table.Arrivals(nil, nil, nil, nil); err != nil {
		t.Error(err)
	}
}

func TestAForgottenTableLeavesTheOthersAlone(t *testing.T) {
	table := golden(t)
	want, _ := table.Arrival(5)
	var waiting sync.WaitGroup
	for i := 0; i < 4; i++ {
		waiting.Add(1)
		go func() {
			defer waiting.Done()
			for j := 0; j < 50; j++ {
				forgotten, err := Open(os.Getenv("TDSP_GOLDEN"))
				if err != nil {
					t.Error(err)
					return
				}
				if got, err := forgotten.Arrival(5); got != want || err != nil {
					t.Error(got, err)
				}
				if j%10 == 0 {
					runtime.GC()
				}
			}
		}()
	}
	waiting.Wait()
}

func TestASceneNamesWhatIsOutOfRange(t *testing.T) {
	_, err := NewScene(journey, []Disc{{Radius: 1}, {Radius: math.NaN()}})
	expect(t, err, BadScene)
	if err == nil || !strings.HasPrefix(err.Error(), "disc 1: ") {
		t.Error(err)
	}
	_, err = NewScene(Journey{}, nil)
	expect(t, err, BadScene)
}

func TestAnErrorOfAnOracleComesOutAsItIs(t *testing.T) {
	own := errors.New("the timetable is missing")
	for _, from := range []float64{0, 50} {
		_, err := Build(after{from, func() (float64, error) { return 0, own }}, untilHundred())
		if !errors.Is(err, own) {
			t.Error(err)
		}
	}
}

func TestAnAnswerOfAnOracleEndsTheTable(t *testing.T) {
	table, err := Build(after{50, func() (float64, error) { return 0, Unreachable }}, untilHundred())
	if err != nil {
		t.Fatal(err)
	}
	_, err = table.Arrival(60)
	expect(t, err, Unreachable)
	_, err = Build(after{0, func() (float64, error) { return 0, Unreachable }}, untilHundred())
	expect(t, err, Unreachable)
}

// thrown is what building with an oracle that panics with a value throws.
func thrown(value any) (caught any) {
	defer func() { caught = recover() }()
	Build(after{50, func() (float64, error) { panic(value) }}, untilHundred())
	return "nothing"
}

func TestAPanicOfAnOracleGoesOnWhenTheSamplerHasReturned(t *testing.T) {
	if caught := thrown("the clock stopped"); caught != "the clock stopped" {
		t.Error(caught)
	}
	// In Go 1.19 nobody can tell from recover() that there was one.
	if caught := thrown(nil); caught == "nothing" || caught == nil {
		t.Error(caught)
	}
}

func TestAnOracleThatBreaksItsPromiseIsRefused(t *testing.T) {
	for _, wrong := range []float64{1, math.NaN()} {
		_, err := Build(after{50, func() (float64, error) { return wrong, nil }}, untilHundred())
		if err == nil || !strings.Contains(err.Error(), "oracle") {
			t.Error(err)
		}
	}
}
