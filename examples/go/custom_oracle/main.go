// SPDX-License-Identifier: MIT

// A table over a world of one's own, sampled by the library through callbacks: the ferries of examples/c/custom_oracle.c, and the same table to the bit.
//
//	custom_oracle [NEW]    NEW receives the table that is made
package main

import (
	"encoding/binary"
	"fmt"
	"os"

	"tdsp.example/tdsp"
)

const minutesBetween = 30.0

// Minutes of each crossing. A later ferry never arrives before an earlier one.
var crossing = []float64{20, 20, 22, 25, 30, 32, 30, 26, 21}

// ferries holds the number of the ferry that was taken last: a row's path.
type ferries struct{ lastTaken uint32 }

func (*ferries) Monotone() tdsp.Monotone { return tdsp.MonotoneArrival }

func (f *ferries) EarliestArrival(departure float64) (float64, error) {
	for i, minutes := range crossing {
		if leaves := float64(i) * minutesBetween; leaves >= departure {
			f.lastTaken = uint32(i)
			return leaves + minutes, nil
		}
	}
	return 0, tdsp.Unreachable
}

func (f *ferries) Path() []byte { return binary.LittleEndian.AppendUint32(nil, f.lastTaken) }

func printAnswer(table *tdsp.Table, departure float64) error {
	fmt.Printf("at the quay at minute %.0f: ", departure)
	found, err := table.Arrival(departure)
	if err != nil {
		fmt.Println(err)
		return nil
	}
	path, err := table.RowBytes(departure)
	if err != nil {
		return err
	}
	fmt.Printf("take ferry %d, arrive at minute %.0f\n", binary.LittleEndian.Uint32(path), found.Upper)
	return nil
}

func run(arguments []string) error {
	options := tdsp.DefaultOptions()
	options.Guarantee = tdsp.Absolute(1)
	table, err := tdsp.Build(&ferries{}, options)
	if err != nil {
		return err
	}
	defer table.Close()
	for _, departure := range []float64{0, 31, 89, 90, 239, 241} {
		if err := printAnswer(table, departure); err != nil {
			return err
		}
	}
	if len(arguments) == 0 {
		return nil
	}
	file, err := os.Create(arguments[0])
	if err != nil {
		return err
	}
	if _, err := table.WriteTo(file); err != nil {
		return err
	}
	return file.Close()
}

func main() {
	if err := run(os.Args[1:]); err != nil {
		fmt.Fprintln(os.Stderr, "custom_oracle:", err)
		os.Exit(1)
	}
}
