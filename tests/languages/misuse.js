// SPDX-License-Identifier: MIT
'use strict';
/* What the Node.js wrapper says when it is used wrongly, and what it holds on to. */
const fs = require('fs');
const { Scene, Solver, Table, TdspError } = require('../../examples/node/tdsp.js');

let failures = 0;

function test(name, passed) {
  process.stdout.write(`${passed ? 'ok' : 'not ok'} node ${name}\n`);
  if (!passed) failures += 1;
}

/** Does it throw an error with this code (of the library) or of this kind, whose message has these words? */
function refuses(expected, words, call) {
  try {
    call();
  } catch (wrong) {
    const right = typeof expected === 'string' ? wrong instanceof TdspError && wrong.code === expected : wrong instanceof expected;
    if (right && wrong.message.includes(words)) return true;
    process.stderr.write(`${wrong.stack}\n`);
  }
  return false;
}

const journey = { speed: 1, radius: 0, source: { x: -10, y: 0 }, destination: { x: 10, y: 0 } };
const discs = [3, -3].map((y) => ({ center: { x: 0, y }, radius: 1, growth: 0.1 }));

function isAnswer(table, departure) {
  try {
    table.arrival(departure);
    return false;
  } catch (none) {
    return none.isAnswer;
  }
}

function testQuestions(table) {
  test('an answer that there is none is told apart from a mistake', isAnswer(table, 61) && !isAnswer(table, -1));
  test('a departure before 0 is a mistake', refuses('invalid_argument', 'out of its range', () => table.arrival(-1)));
  test('a path that there is none of is refused', refuses('destination_covered', 'covered', () => table.path(61)));
  test('departures in a plain array are refused', refuses(TypeError, 'Float64Array', () => table.arrivals([1, 2])));
  test('no departures have no arrivals', table.arrivals(new Float64Array(0)).statuses.length === 0);
}

function testBytes(bytes) {
  test('bytes that are no table are refused', refuses('bad_magic', 'not a table', () => new Table(Buffer.from('no table'))));
  test('no bytes are no table', refuses('bad_magic', 'not a table', () => new Table(Buffer.alloc(0))));
  test('part of a larger buffer is read', new Table(Buffer.concat([Buffer.alloc(3), bytes]).subarray(3)).arrival(5).upper > 24);
}

function testScenes() {
  test('a scene names the disc that is out of range', refuses('bad_scene', 'disc 1: ', () => new Scene(journey, [discs[0], { ...discs[1], radius: -1 }])));
  test('a journey without speed is refused', refuses('bad_scene', 'journey: ', () => new Scene({ ...journey, speed: 0 }, [])));
  const empty = new Scene(journey, []);
  test('departures without an end need a horizon', refuses('needs_horizon', 'horizon', () => empty.build()));
  test('with one they have it', empty.build({ horizon: 10 }).arrival(10).upper >= 30);
  test('a guarantee out of its range is refused', refuses('invalid_argument', 'out of its range', () => empty.build({ bound: 2, horizon: 10 })));
}

function testClosing(table) {
  const scene = new Scene(journey, discs);
  const solver = new Solver(scene);
  solver.close();
  solver.close();
  scene.close();
  table.close();
  test('a closed table says so', refuses(Error, 'Table is closed', () => table.arrival(5)));
  test('a closed solver says so', refuses(Error, 'closed', () => solver.earliestArrival(5)));
  test('a closed scene says so', refuses(Error, 'Scene is closed', () => new Solver(scene)));
}

/** Forgets tables; `freed` counts those that were given back. */
function forget(bytes, freed) {
  for (let i = 0; i < 100; i += 1) {
    const table = new Table(bytes, bytes.length, () => { freed.count += 1; });
    if (i % 2) table.close();
    new Solver(new Scene(journey, discs)).earliestArrival(5);
  }
}

async function testForgetting(bytes) {
  const freed = { count: 0 };
  forget(bytes, freed);
  for (let i = 0; i < 50 && freed.count < 100; i += 1) {
    global.gc();
    await new Promise((resolve) => { setTimeout(resolve, 20); });
  }
  // The last may still be on the stack.
  test('what was forgotten is freed once', freed.count >= 99 && freed.count <= 100);
}

async function main(golden) {
  const bytes = fs.readFileSync(golden);
  const table = Table.open(golden);
  testQuestions(table);
  testBytes(bytes);
  testScenes();
  testClosing(table);
  await testForgetting(bytes);
  process.exitCode = failures > 0 ? 1 : 0;
}

main(process.argv[2]);
