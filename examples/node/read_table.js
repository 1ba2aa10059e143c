// SPDX-License-Identifier: MIT
'use strict';
/*
 * Read a table, then make one: the lines of examples/c/read_table.c, to the bit.
 *
 *   node read_table.js TABLE [NEW]    NEW receives the table that is made
 */
const fs = require('fs');
const { LEG_LINE, Scene, Solver, Table, TdspError, statusName } = require('./tdsp.js');

function number(value) {
  const bits = Buffer.alloc(8);
  bits.writeDoubleBE(value);
  return `${value.toFixed(6)}[${bits.toString('hex')}]`;
}

const place = ({ x, y }) => `(${number(x)}, ${number(y)})`;
const print = (line) => process.stdout.write(`${line}\n`);

function printInfo(table) {
  const info = table.info();
  print(`${info.rows} rows, ${info.legs} legs, ${info.length} bytes, in ${info.lengthUnit} and ${info.timeUnit}`);
  print(`departures up to ${number(info.lastDeparture)}, then ${info.lastReason}`);
}

/** An answer, or why there is none. */
function answer(ask) {
  try {
    return ask();
  } catch (none) {
    if (none instanceof TdspError && none.isAnswer) return none.message;
    throw none;
  }
}

function printArrival(table, departure) {
  const found = answer(() => {
    const { lower, upper } = table.arrival(departure);
    return `arrive from ${number(lower)} to ${number(upper)}`;
  });
  print(`leave at ${number(departure)}: ${found}`);
}

function printDeparture(table, arrival) {
  const found = answer(() => {
    const { safe, noneAfter } = table.departure(arrival);
    return `leave by ${number(safe)}, none after ${number(noneAfter)}`;
  });
  print(`arrive by ${number(arrival)}: ${found}`);
}

function printPath(table, departure) {
  const path = table.path(departure);
  print(`path for ${number(departure)}: ${path.length} legs`);
  for (const leg of path) {
    const kind = leg.kind === LEG_LINE ? 'line' : 'ride';
    print(`  ${kind} from ${number(leg.startTime)} at ${place(leg.from)} to ${number(leg.endTime)} at ${place(leg.to)}`);
    if (leg.kind !== LEG_LINE) {
      print(`    on disc ${leg.disc}, turn ${leg.turn}, from angle ${number(leg.angleFrom)} by ${number(leg.sweep)}, ` +
        `radius ${number(leg.radiusFrom)} to ${number(leg.radiusTo)}`);
    }
  }
}

function printBatch(table) {
  const departures = Float64Array.from({ length: 8 }, (_, i) => 10 * i);
  const { lower, upper, statuses } = table.arrivals(departures);
  statuses.forEach((status, i) => {
    print(`batch ${i}: ${statusName(status)}${status === 0 ? ` ${number(lower[i])} ${number(upper[i])}` : ''}`);
  });
}

function printJumps(table) {
  for (const { departure, before, after, gap } of table.jumps()) {
    print(`after ${number(departure)}: jump from ${number(before)} to ${number(after)}`);
    if (gap) print(`  discs ${gap.first} and ${gap.second} close at ${number(gap.time)}, at ${place(gap.place)}`);
  }
}

function printTable(table) {
  printInfo(table);
  for (const departure of [0, 5, 40, 61]) printArrival(table, departure);
  for (const arrival of [10, 30, 1000]) printDeparture(table, arrival);
  printPath(table, 12);
  for (const time of [12, 17, 22, 27, 32, 37]) print(`at ${number(time)}: ${place(table.position(12, time))}`);
  printBatch(table);
  printJumps(table);
}

function makeTable() {
  const journey = { speed: 1, radius: 0, source: { x: -10, y: 0 }, destination: { x: 10, y: 0 } };
  const scene = new Scene(journey, [3, -3].map((y) => ({ center: { x: 0, y }, radius: 1, growth: 0.1 })));
  const solver = new Solver(scene);
  try {
    print(`made: from 9 to ${number(solver.earliestArrival(9))}; to 33 from ${number(solver.latestDeparture(33))}`);
    return scene.build({ bound: 0.05, lengthUnit: 'm', timeUnit: 's' });
  } finally {
    solver.close();
    scene.close();
  }
}

function main([name, made]) {
  if (name === undefined) {
    process.stderr.write('usage: node read_table.js TABLE [NEW]\n');
    return 2;
  }
  try {
    const table = Table.open(name);
    printTable(table);
    table.close();
    const fresh = makeTable();
    printTable(fresh);
    if (made !== undefined) fs.writeFileSync(made, fresh.bytes());
    fresh.close();
    return 0;
  } catch (problem) {
    process.stderr.write(`read_table: ${problem.message}\n`);
    return 1;
  }
}

process.exitCode = main(process.argv.slice(2));
