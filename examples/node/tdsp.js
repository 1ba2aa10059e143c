// SPDX-License-Identifier: MIT
'use strict';
/*
 * libtdsp in JavaScript, over koffi: tables, scenes, exact answers.
 *
 * The library keeps pointers into the bytes of a table: they are in a Buffer, whose memory does not move, and the table holds on to it. What the library
 * allocates is given back by close(), or after the garbage collector found that it was forgotten. What goes wrong, and a question that has no answer, is thrown
 * as a TdspError with the library's words; its `code` is the status's name, e.g. 'cut_off'.
 *
 * The library is found as the system finds libraries, or where the environment variable TDSP_LIBRARY says.
 */
const fs = require('fs');
const koffi = require('koffi');

const library = koffi.load(process.env.TDSP_LIBRARY || 'libtdsp.so.0');

const OK = 0;
const BUFFER_TOO_SMALL = 17;
const NO_ANSWER = 18;
const BAD_SCENE = 32;
const NO_DISC = 0xffffffff;
/** sizeof(tdsp_table), whose members are private, and sizeof(tdsp_oracle), of which none is used here. */
const TABLE_SIZE = 264;
const ORACLE_SIZE = 96;

// The structures of include/tdsp/*.h, laid out by koffi as C does.
const Point = koffi.struct({ x: 'double', y: 'double' });
const Disc = koffi.struct({ center: Point, radius: 'double', growth: 'double' });
const Journey = koffi.struct({ speed: 'double', radius: 'double', source: Point, destination: Point });
const Leg = koffi.struct({
  kind: 'uint32', disc: 'uint32', turn: 'int32', reserved: 'uint32', startTime: 'double', endTime: 'double', from: Point, to: Point, center: Point,
  radiusFrom: 'double', radiusTo: 'double', angleFrom: 'double', sweep: 'double', rateFrom: 'double', rateTo: 'double', bendFrom: 'double',
  bendTo: 'double', speed: 'double',
});
const Gap = koffi.struct({ first: 'uint32', second: 'uint32', time: 'double', place: Point });
const Jump = koffi.struct({ row: 'uint64', departure: 'double', before: 'double', after: 'double', gap: Gap });
const Row = koffi.struct({ departure: 'double', left: 'double', right: 'double', legs: 'uint64' });
const Info = koffi.struct({
  versionMajor: 'uint16', versionMinor: 'uint16', monotone: 'uint32', guarantee: 'uint32', sampling: 'uint32', rows: 'uint64', legs: 'uint64',
  length: 'uint64', sceneHash: 'uint64', epsilon: 'double', delta: 'double', error: 'double', timeScale: 'double', speed: 'double', source: Point,
  destination: Point, firstLower: 'double', firstDeparture: 'double', lastDeparture: 'double', lastReason: 'int32',
  lengthUnit: koffi.array('char', 16), timeUnit: koffi.array('char', 16), guideLength: 'uint64', curves: 'uint64', gaps: 'uint64',
});
const World = koffi.struct({ sceneHash: 'uint64', speed: 'double', source: Point, destination: Point, lengthUnit: 'str', timeUnit: 'str' });
const Options = koffi.struct({
  size: 'size_t', guarantee: 'int', sampling: 'int', epsilon: 'double', delta: 'double', horizon: 'double', maxRows: 'uint32', world: World,
  progress: 'void *', progressCtx: 'void *', runTasks: 'void *', runTasksCtx: 'void *', workers: 'void *', workerCount: 'size_t', oracleShare: 'double',
});

// Types that were not named are given to koffi as they are; `out` and `inout` say who writes.
const to = (type) => koffi.pointer(type);
const out = (type) => koffi.out(koffi.pointer(type));
const bind = (name, result, ...parameters) => library.func(name, result, parameters);
const c = {
  version: bind('tdsp_version', 'str'),
  statusIsAnswer: bind('tdsp_status_is_answer', 'int', 'int'),
  statusName: bind('tdsp_status_name', 'str', 'int'),
  statusText: bind('tdsp_status_text', 'str', 'int'),
  tableOpen: bind('tdsp_table_open', 'int', 'void *', 'void *', 'size_t'),
  tableInfo: bind('tdsp_table_get_info', 'int', 'void *', out(Info)),
  tableRow: bind('tdsp_table_row', 'int', 'void *', 'uint64', out(Row)),
  tableArrival: bind('tdsp_table_arrival', 'int', 'void *', 'double', 'void *', 'void *'),
  tableDeparture: bind('tdsp_table_departure', 'int', 'void *', 'double', 'void *', 'void *'),
  tableArrivals: bind('tdsp_table_arrivals', 'int', 'void *', 'void *', 'size_t', 'void *', 'void *', 'void *'),
  tablePath: bind('tdsp_table_path', 'int', 'void *', 'double', 'void *', 'size_t', out('size_t')),
  tablePosition: bind('tdsp_table_position', 'int', 'void *', 'double', 'double', out(Point)),
  tableNextJump: bind('tdsp_table_next_jump', 'int', 'void *', 'double', out(Jump)),
  journeyCheck: bind('tdsp_journey_check', 'str', to(Journey)),
  discCheck: bind('tdsp_disc_check', 'str', to(Disc)),
  sceneCreate: bind('tdsp_scene_create', 'int', to(Journey), to(Disc), 'size_t', 'void *', out('void *')),
  sceneFree: bind('tdsp_scene_free', 'void', 'void *'),
  sceneHash: bind('tdsp_scene_hash', 'uint64', 'void *'),
  solverCreate: bind('tdsp_solver_create', 'int', 'void *', out('void *')),
  solverFree: bind('tdsp_solver_free', 'void', 'void *'),
  earliestArrival: bind('tdsp_earliest_arrival', 'int', 'void *', 'double', out('double')),
  latestDeparture: bind('tdsp_latest_departure', 'int', 'void *', 'double', out('double'), 'void *'),
  solverPath: bind('tdsp_solver_path', 'int', 'void *', 'void *', 'size_t', out('size_t')),
  solverOracle: bind('tdsp_solver_oracle', 'int', 'void *', 'void *'),
  optionsInit: bind('tdsp_build_options_init', 'void', out(Options)),
  build: bind('tdsp_build', 'int', 'void *', to(Options), 'void *', out('void *'), out('size_t'), 'void *'),
  bytesFree: bind('tdsp_bytes_free', 'void', 'void *', 'void *', 'size_t'),
};

class TdspError extends Error {
  constructor(status, words = c.statusText(status)) {
    super(words);
    this.name = 'TdspError';
    this.status = status;
    this.code = c.statusName(status);
  }

  /** Was the question understood, and this is why there is no number? */
  get isAnswer() {
    return c.statusIsAnswer(this.status) !== 0;
  }
}

function check(status) {
  if (status !== OK) throw new TdspError(status);
}

function about(what, ask) {
  try {
    return ask();
  } catch (problem) {
    if (problem instanceof TdspError) problem.message = `${what}: ${problem.message}`;
    throw problem;
  }
}

/** Calls the function that an object left behind, which must not hold the object. */
const forgotten = new FinalizationRegistry((free) => free());

/** What the library allocated: freed once, by close() or after it was forgotten. */
class Owned {
  #raw;
  #free;

  constructor(raw, free) {
    this.#raw = raw;
    this.#free = free;
    forgotten.register(this, free, this);
  }

  get raw() {
    if (this.#raw === null) throw new Error(`${this.constructor.name} is closed`);
    return this.#raw;
  }

  close() {
    if (this.#raw === null) return;
    forgotten.unregister(this);
    this.#raw = null;
    this.#free();
  }
}

/** Asks twice, as the library does with arrays whose length is not known: how many, then for them. */
function legsOf(ask) {
  const count = [0];
  const status = ask(null, 0, count);
  if (status !== BUFFER_TOO_SMALL) check(status);
  if (count[0] === 0) return [];
  const legs = Buffer.alloc(count[0] * koffi.sizeof(Leg));
  check(ask(legs, count[0], count));
  return koffi.decode(legs, koffi.array(Leg, count[0]));
}

const text = (chars) => (typeof chars === 'string' ? chars : String.fromCharCode(...chars)).replace(/\0.*/s, '');

/** An opened table. Asking changes nothing. */
class Table extends Owned {
  #size;
  #bytes;
  #answer = new Float64Array(2);

  /** Reads a file and checks it whole; a refusal begins with the file's name. */
  static open(file) {
    const bytes = fs.readFileSync(file);
    return about(file, () => new Table(bytes));
  }

  /** A table over a Buffer or Uint8Array, which is not copied and must stay as it is. `free` gives memory back that the library allocated. */
  constructor(bytes, size = bytes.length, free = () => {}) {
    const view = Buffer.alloc(TABLE_SIZE);
    try {
      // An empty Buffer has no address, and null is no table but a mistake.
      check(c.tableOpen(view, size === 0 ? view : bytes, size));
    } catch (refused) {
      free();
      throw refused;
    }
    super(view, free);
    this.#bytes = bytes;
    this.#size = size;
  }

  /** A copy of the bytes, as they are in a file. */
  bytes() {
    this.raw; // open?
    return Buffer.from(this.#bytes instanceof Uint8Array ? this.#bytes : koffi.decode(this.#bytes, koffi.array('uint8_t', this.#size)));
  }

  info() {
    const info = {};
    check(c.tableInfo(this.raw, info));
    return { ...info, lastReason: c.statusName(info.lastReason), lengthUnit: text(info.lengthUnit), timeUnit: text(info.timeUnit) };
  }

  /** Two numbers, each written in place. */
  #two(ask) {
    check(ask(this.#answer, this.#answer.subarray(1)));
    return this.#answer;
  }

  /** The earliest arrival is not before lower; a path is known that arrives at upper or before. */
  arrival(departure) {
    const [lower, upper] = this.#two((first, second) => c.tableArrival(this.raw, departure, first, second));
    return { lower, upper };
  }

  /** Leaving at safe is in time for certain; leaving after noneAfter is not. */
  departure(arrival) {
    const [safe, noneAfter] = this.#two((first, second) => c.tableDeparture(this.raw, arrival, first, second));
    return { safe, noneAfter };
  }

  path(departure) {
    return legsOf((legs, capacity, count) => c.tablePath(this.raw, departure, legs, capacity, count));
  }

  /** Where a robot that left at `departure` is at `time`, clamped to its path. */
  position(departure, time) {
    const place = {};
    check(c.tablePosition(this.raw, departure, time, place));
    return place;
  }

  /** Looks up a Float64Array of departures, without copying; where a status is not 0 both ends are infinite. */
  arrivals(departures) {
    const count = departures.length;
    const answers = { lower: new Float64Array(count), upper: new Float64Array(count), statuses: new Int32Array(count) };
    if (!(departures instanceof Float64Array)) throw new TypeError('departures are a Float64Array');
    if (count > 0) check(c.tableArrivals(this.raw, departures, count, answers.lower, answers.upper, answers.statuses));
    return answers;
  }

  /** The jumps of the travel time, in order; `gap` is null where it is not known what closes. */
  *jumps() {
    const jump = {};
    const next = { departure: 0 };
    for (;;) {
      const status = c.tableNextJump(this.raw, next.departure, jump);
      if (status === NO_ANSWER) return;
      check(status);
      yield { ...jump, gap: jump.gap.first === NO_DISC ? null : jump.gap };
      // A jump is at a row and never at the last, so there is a row after it.
      check(c.tableRow(this.raw, Number(jump.row) + 1, next));
    }
  }
}

function inRange(what, wrong) {
  if (wrong !== null) throw new TdspError(BAD_SCENE, `${what}: ${wrong}`);
}

/** Discs around a journey, prepared: { speed, radius, source, destination } and [{ center, radius, growth }]. Close its solvers before it. */
class Scene extends Owned {
  constructor(journey, discs) {
    inRange('journey', c.journeyCheck(journey));
    discs.forEach((disc, i) => inRange(`disc ${i}`, c.discCheck(disc)));
    const made = [null];
    check(c.sceneCreate(journey, discs, discs.length, null, made));
    super(made[0], () => c.sceneFree(made[0]));
    this.journey = journey;
  }

  /** The table of this scene, which its header describes. `guarantee`: 0 travel, 1 arrival, 2 absolute, each with its bound. */
  build({ guarantee = 0, bound = 0.01, horizon = Infinity, lengthUnit = '', timeUnit = '' } = {}) {
    const solver = new Solver(this);
    try {
      const oracle = Buffer.alloc(ORACLE_SIZE);
      check(c.solverOracle(solver.raw, oracle));
      const options = {};
      c.optionsInit(options);
      const { speed, source, destination } = this.journey;
      Object.assign(options, { guarantee, epsilon: bound, delta: bound, horizon });
      options.world = { sceneHash: c.sceneHash(this.raw), speed, source, destination, lengthUnit, timeUnit };
      const bytes = [null];
      const size = [0];
      check(c.build(oracle, options, null, bytes, size, null));
      return new Table(bytes[0], size[0], () => c.bytesFree(null, bytes[0], size[0]));
    } finally {
      solver.close();
    }
  }
}

/** A workspace for exact questions to one scene, which it keeps. */
class Solver extends Owned {
  constructor(scene) {
    const made = [null];
    check(c.solverCreate(scene.raw, made));
    // Holding the scene here lets it be freed after the solver only.
    super(made[0], () => scene && c.solverFree(made[0]));
    this.scene = scene;
  }

  get raw() {
    return this.scene.raw && super.raw;
  }

  earliestArrival(departure) {
    const arrival = [0];
    check(c.earliestArrival(this.raw, departure, arrival));
    return arrival[0];
  }

  latestDeparture(arrival) {
    const departure = [0];
    check(c.latestDeparture(this.raw, arrival, departure, null));
    return departure[0];
  }

  /** Of the last answer. */
  path() {
    return legsOf((legs, capacity, count) => c.solverPath(this.raw, legs, capacity, count));
  }
}

module.exports = { Table, Scene, Solver, TdspError, LEG_LINE: 0, LEG_ARC: 1, LEG_CURVE: 2, statusName: c.statusName, version: c.version };
