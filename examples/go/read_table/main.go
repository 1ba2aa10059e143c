// SPDX-License-Identifier: MIT

// Read a table, then make one: the lines of examples/c/read_table.c, to the bit.
//
//	read_table TABLE [NEW]    NEW receives the table that is made
package main

import (
	"fmt"
	"math"
	"os"

	"tdsp.example/tdsp"
)

func number(value float64) string {
	return fmt.Sprintf("%.6f[%016x]", value, math.Float64bits(value))
}

func place(p tdsp.Point) string { return fmt.Sprintf("(%s, %s)", number(p.X), number(p.Y)) }

func printInfo(table *tdsp.Table) error {
	info, err := table.Info()
	if err != nil {
		return err
	}
	fmt.Printf("%d rows, %d legs, %d bytes, in %s and %s\n", info.Rows, info.Legs, info.Length, info.LengthUnit, info.TimeUnit)
	fmt.Printf("departures up to %s, then %s\n", number(info.LastDeparture), info.LastReason.Name())
	return nil
}

func printArrival(table *tdsp.Table, departure float64) {
	found, err := table.Arrival(departure)
	if err != nil {
		fmt.Printf("leave at %s: %v\n", number(departure), err)
		return
	}
	fmt.Printf("leave at %s: arrive from %s to %s\n", number(departure), number(found.Lower), number(found.Upper))
}

func printDeparture(table *tdsp.Table, arrival float64) {
	found, err := table.Departure(arrival)
	if err != nil {
		fmt.Printf("arrive by %s: %v\n", number(arrival), err)
		return
	}
	fmt.Printf("arrive by %s: leave by %s, none after %s\n", number(arrival), number(found.Safe), number(found.NoneAfter))
}

func printPath(table *tdsp.Table, departure float64) error {
	legs, err := table.Path(departure)
	if err != nil {
		return err
	}
	fmt.Printf("path for %s: %d legs\n", number(departure), len(legs))
	for _, leg := range legs {
		kind := "ride"
		if leg.Kind == tdsp.LegLine {
			kind = "line"
		}
		fmt.Printf("  %s from %s at %s to %s at %s\n", kind, number(leg.StartTime), place(leg.From), number(leg.EndTime), place(leg.To))
		if leg.Kind != tdsp.LegLine {
			fmt.Printf("    on disc %d, turn %d, from angle %s by %s, radius %s to %s\n", leg.Disc, leg.Turn, number(leg.AngleFrom),
				number(leg.Sweep), number(leg.RadiusFrom), number(leg.RadiusTo))
		}
	}
	return nil
}

func printPositions(table *tdsp.Table, departure float64) error {
	for i := 0; i < 6; i++ {
		time := departure + float64(5*i)
		where, err := table.Position(departure, time)
		if err != nil {
			return err
		}
		fmt.Printf("at %s: %s\n", number(time), place(where))
	}
	return nil
}

func printBatch(table *tdsp.Table) error {
	departures := []float64{0, 10, 20, 30, 40, 50, 60, 70}
	lower, upper := make([]float64, len(departures)), make([]float64, len(departures))
	statuses := make([]tdsp.Status, len(departures))
	if err := table.Arrivals(departures, lower, upper, statuses); err != nil {
		return err
	}
	for i, status := range statuses {
		fmt.Printf("batch %d: %s", i, status.Name())
		if status == tdsp.OK {
			fmt.Printf(" %s %s", number(lower[i]), number(upper[i]))
		}
		fmt.Println()
	}
	return nil
}

func printJumps(table *tdsp.Table) error {
	jumps, err := table.Jumps()
	for _, jump := range jumps {
		fmt.Printf("after %s: jump from %s to %s\n", number(jump.Departure), number(jump.Before), number(jump.After))
		if gap := jump.Gap; gap.First != tdsp.NoDisc {
			fmt.Printf("  discs %d and %d close at %s, at %s\n", gap.First, gap.Second, number(gap.Time), place(gap.Place))
		}
	}
	return err
}

func printTable(table *tdsp.Table) error {
	if err := printInfo(table); err != nil {
		return err
	}
	for _, departure := range []float64{0, 5, 40, 61} {
		printArrival(table, departure)
	}
	for _, arrival := range []float64{10, 30, 1000} {
		printDeparture(table, arrival)
	}
	if err := printPath(table, 12); err != nil {
		return err
	}
	if err := printPositions(table, 12); err != nil {
		return err
	}
	if err := printBatch(table); err != nil {
		return err
	}
	return printJumps(table)
}

func makeTable() (*tdsp.Table, error) {
	journey := tdsp.Journey{Speed: 1, Source: tdsp.Point{X: -10}, Destination: tdsp.Point{X: 10}}
	discs := []tdsp.Disc{{Center: tdsp.Point{Y: 3}, Radius: 1, Growth: 0.1}, {Center: tdsp.Point{Y: -3}, Radius: 1, Growth: 0.1}}
	scene, err := tdsp.NewScene(journey, discs)
	if err != nil {
		return nil, err
	}
	defer scene.Close()
	solver, err := tdsp.NewSolver(scene)
	if err != nil {
		return nil, err
	}
	defer solver.Close()
	arrival, err := solver.EarliestArrival(9)
	if err != nil {
		return nil, err
	}
	departure, err := solver.LatestDeparture(33)
	if err != nil {
		return nil, err
	}
	fmt.Printf("made: from 9 to %s; to 33 from %s\n", number(arrival), number(departure))
	options := tdsp.DefaultOptions()
	options.Guarantee = tdsp.Travel(0.05)
	options.LengthUnit, options.TimeUnit = "m", "s"
	return tdsp.BuildScene(scene, options)
}

func write(table *tdsp.Table, name string) error {
	file, err := os.Create(name)
	if err != nil {
		return err
	}
	if _, err := table.WriteTo(file); err != nil {
		return err
	}
	return file.Close()
}

func run(arguments []string) error {
	table, err := tdsp.Open(arguments[0])
	if err != nil {
		return err
	}
	defer table.Close()
	if err := printTable(table); err != nil {
		return err
	}
	made, err := makeTable()
	if err != nil {
		return err
	}
	defer made.Close()
	if err := printTable(made); err != nil || len(arguments) < 2 {
		return err
	}
	return write(made, arguments[1])
}

func main() {
	if len(os.Args) < 2 {
		fmt.Fprintln(os.Stderr, "usage: read_table TABLE [NEW]")
		os.Exit(2)
	}
	if err := run(os.Args[1:]); err != nil {
		fmt.Fprintln(os.Stderr, "read_table:", err)
		os.Exit(1)
	}
}
