// What ui/page/page_data.cpp has packed: the description, and the paths from their columns.

const low = 0x7f;

/** Zigzag numbers of seven bits a byte, the lowest first. */
function numbersOf(bytes, count) {
  const numbers = new Float64Array(count);
  let at = 0;
  for (let i = 0; i < count; ++i) {
    let number = 0;
    let factor = 1;
    for (;;) {
      const byte = bytes[at++];
      number += (byte & low) * factor;
      if (byte <= low) break;
      factor *= 128;
    }
    numbers[i] = number % 2 === 1 ? -(number + 1) / 2 : number / 2;
  }
  return numbers;
}

function summed(numbers) {
  for (let i = 1; i < numbers.length; ++i) numbers[i] += numbers[i - 1];
  return numbers;
}

function scaled(numbers, step) {
  for (let i = 0; i < numbers.length; ++i) numbers[i] *= step;
  return numbers;
}

export const kinds = { cut: 0, rapid: 1, pause: 2, gap: 3, arc: 4 };

/** Index of the last of the rising `values` that is at most `value`; 0 if there is none. */
export function lastAtMost(values, value) {
  let from = 0;
  let to = values.length;
  while (to - from > 1) {
    const middle = (from + to) >> 1;
    if (values[middle] <= value) from = middle;
    else to = middle;
  }
  return from;
}

/** Index of the first of the rising `values` that is at least `value`; the last one if there is none. */
export function firstAtLeast(values, value) {
  let from = 0;
  let to = values.length - 1;
  while (from < to) {
    const middle = (from + to) >> 1;
    if (values[middle] < value) from = middle + 1;
    else to = middle;
  }
  return from;
}

/** The programmed path: points with the way to each of them, lengths in mm. */
export class Programmed {
  constructor({ count, columns }, column, steps) {
    const read = (name) => summed(column(columns[name], count));
    this.count = count;
    this.placeSteps = read('place');
    this.positionSteps = [read('x'), read('y'), read('z')];
    this.line = read('line');
    this.kind = read('kind');
    this.place = this.placeSteps.map((value) => value * steps.length);
    this.positions = this.positionSteps.map((axis) => axis.map((value) => value * steps.position));
  }

  point(i) {
    return this.positions.map((axis) => axis[i]);
  }

  /** The programmed point at a place. */
  at(place) {
    const next = Math.max(1, firstAtLeast(this.place, place));
    const length = this.place[next] - this.place[next - 1];
    const share = length > 0 ? Math.min(1, Math.max(0, (place - this.place[next - 1]) / length)) : 0;
    return this.positions.map((axis) => axis[next - 1] + (axis[next] - axis[next - 1]) * share);
  }
}

/** Positions of nodes whose places do not fall, as ProgrammedSteps of page_data.cpp. */
function positionsOf(places, rests, programmed) {
  const known = programmed.placeSteps;
  let next = 0;
  for (let i = 0; i < places.length; ++i) {
    while (next + 1 < known.length && known[next] < places[i]) ++next;
    const before = next > 0 ? next - 1 : 0;
    const length = known[next] - known[before];
    const share = length > 0 ? (places[i] - known[before]) / length : 0;
    programmed.positionSteps.forEach((axis, k) => {
      rests[k][i] += Math.floor(axis[before] + (axis[next] - axis[before]) * share + 0.5);
    });
  }
  return rests;
}

/** Velocity, acceleration or jerk of a rotary axis over time; straight between its points. */
class RotaryCurve {
  constructor(description, column, steps) {
    Object.assign(this, description);
    const read = (name) => summed(column(description.columns[name], description.count));
    this.time = scaled(read('time'), steps.time);
    this.value = scaled(read('value'), description.step);
  }

  at(time) {
    const next = Math.max(1, firstAtLeast(this.time, time));
    const width = this.time[next] - this.time[next - 1];
    const share = width > 0 ? Math.min(1, Math.max(0, (time - this.time[next - 1]) / width)) : 0;
    return this.value[next - 1] + (this.value[next] - this.value[next - 1]) * share;
  }

  /** Places of the program at its points, which `run` knows. */
  placesIn(run) {
    this.places ??= this.time.map((time) => run.at(time).place);
    return this.places;
  }
}

/** A run: nodes with what holds from each to the next. Inside units: mm, s. */
export class Run {
  constructor(description, programmed, column, steps) {
    Object.assign(this, description);
    this.programmedPath = programmed;
    this.rotary = (description.rotary ?? []).map((curve) => new RotaryCurve(curve, column, steps));
    if (!description.nodes) {
      this.count = 0;
      return;
    }
    const { count, columns, speed_step, acceleration_step, jerk_step } = description.nodes;
    const raw = (name) => column(columns[name], count);
    const read = (name) => summed(raw(name));
    this.count = count;
    const time = read('time');
    const speed = read('speed');
    const middle = raw('middle');
    const length = raw('length');
    const acceleration = read('acceleration');
    const after = raw('after');
    const simpson = (speed_step * steps.time) / (6 * steps.length);
    const last = count - 1;
    for (let i = 0; i < count; ++i) {
      const next = Math.min(i + 1, last);
      const end = speed[next];
      middle[i] += Math.trunc((speed[i] + end) / 2);
      if (i < last) {
        const driven = (speed[i] + 4 * middle[i] + end) * (time[next] - time[i]) * simpson;
        length[i + 1] += length[i] + Math.floor(driven + 0.5);
      }
      after[i] += acceleration[next];
    }
    const places = read('ahead');
    for (let i = 0; i < count; ++i) places[i] += length[i];
    const rests = ['x', 'y', 'z'].map(raw);
    this.positions = positionsOf(places, rests, programmed).map((axis) => scaled(axis, steps.position));
    this.time = scaled(time, steps.time);
    this.length = scaled(length, steps.length);
    this.place = scaled(places, steps.length);
    this.speed = scaled(speed, speed_step);
    this.middle = scaled(middle, speed_step);
    this.acceleration = scaled(acceleration, acceleration_step);
    this.after = scaled(after, acceleration_step);
    this.jerk = scaled(read('jerk'), jerk_step);
    this.error = scaled(read('error'), steps.length);
    this.feed = scaled(read('feed'), steps.feed);
    this.line = read('line');
    this.cause = read('cause');
    this.kind = read('kind');
    this.duration = this.time[last];
  }

  get moves() {
    return this.count > 1;
  }

  nodeAt(time) {
    return Math.min(lastAtMost(this.time, time), this.count - 2);
  }

  /** Everything at a time, clamped to the run. */
  at(time) {
    const i = this.nodeAt(Math.min(Math.max(time, 0), this.duration));
    const duration = this.time[i + 1] - this.time[i];
    const u = duration > 0 ? Math.min(1, Math.max(0, (time - this.time[i]) / duration)) : 0;
    const [start, middle, end] = [this.speed[i], this.middle[i], this.speed[i + 1]];
    const driven = duration * u * (start + u * ((4 * middle - 3 * start - end) / 2 + (u * 2 * (start + end - 2 * middle)) / 3));
    const whole = (duration * (start + 4 * middle + end)) / 6;
    const share = whole > 0 ? driven / whole : u;
    const between = (values) => values[i] + (values[i + 1] - values[i]) * share;
    return {
      node: i,
      time: this.time[i] + duration * u,
      length: between(this.length),
      place: between(this.place),
      position: this.positions.map(between),
      speed: Math.max(0, start + u * (4 * middle - 3 * start - end) + u * u * 2 * (start + end - 2 * middle)),
      acceleration: this.acceleration[i] + (this.after[i] - this.acceleration[i]) * u,
      jerk: this.jerk[i],
      error: between(this.error),
      feed: this.feed[i],
      line: this.line[i],
      cause: this.cause[i],
      kind: this.kind[i],
    };
  }

  /** Time at a share of the way from node `i` to the next. */
  timeWithin(i, share) {
    let from = 0;
    let to = 1;
    const target = this.length[i] + share * (this.length[i + 1] - this.length[i]);
    for (let k = 0; k < 24; ++k) {
      const middle = (from + to) / 2;
      const time = this.time[i] + middle * (this.time[i + 1] - this.time[i]);
      if (this.at(time).length < target) from = middle;
      else to = middle;
    }
    return this.time[i] + to * (this.time[i + 1] - this.time[i]);
  }

  /**
   * When the run is at a place of the program [s]. Where it stands there for a while, `share` of that time has
   * passed.
   */
  timeAtPlace(place, share = 0) {
    const i = firstAtLeast(this.place, place);
    if (i === 0) return this.time[0];
    if (this.place[i] <= place) {
      const end = lastAtMost(this.place, place);
      return this.time[i] + share * (this.time[end] - this.time[i]);
    }
    const length = this.place[i] - this.place[i - 1];
    return this.timeWithin(i - 1, length > 0 ? (place - this.place[i - 1]) / length : 0);
  }

  /** Place at a time, and what share of the stay there has passed. */
  whereAt(time) {
    const { place, node } = this.at(time);
    if (this.place[node + 1] > this.place[node]) return { place, share: 0 };
    const first = firstAtLeast(this.place, place);
    const last = lastAtMost(this.place, place);
    const stay = this.time[last] - this.time[first];
    return { place, share: stay > 0 ? (time - this.time[first]) / stay : 0 };
  }

  /** The time at which `line`, or the nearest later line that moves, is under way. */
  timeOfLine(line) {
    const found = this.line.findIndex((one) => one >= line);
    return this.time[found < 0 ? this.count - 1 : found];
  }

  /** Time spent on each line beyond that of its programmed feed [s], by line. */
  lostByLine() {
    const lost = new Map();
    for (let i = 0; i + 1 < this.count; ++i) {
      if (this.kind[i] > kinds.rapid || !(this.feed[i] > 0)) continue;
      const asked = (this.length[i + 1] - this.length[i]) / this.feed[i];
      const more = this.time[i + 1] - this.time[i] - asked;
      lost.set(this.line[i], (lost.get(this.line[i]) ?? 0) + more);
    }
    return lost;
  }

  /** Time to each node less that of `other` at the same place [s]. */
  lostAgainst(other) {
    const lost = new Float64Array(this.count);
    let k = 0;
    for (let i = 0; i < this.count; ++i) {
      const place = this.place[i];
      while (k + 1 < other.count && other.place[k + 1] < place) ++k;
      const plateau = other.place[k + 1] === place || k + 1 >= other.count;
      const length = plateau ? 0 : other.place[k + 1] - other.place[k];
      const share = length > 0 ? (place - other.place[k]) / length : 0;
      const there = plateau
        ? other.timeAtPlace(place, this.whereAt(this.time[i]).share)
        : other.timeOfShare(k, share);
      lost[i] = this.time[i] - there;
    }
    return lost;
  }

  /** As timeWithin(), in closed form where the speed is nearly constant. */
  timeOfShare(i, share) {
    const flat = Math.abs(this.speed[i + 1] - this.speed[i]) < 0.02 * this.speed[i];
    const duration = this.time[i + 1] - this.time[i];
    return flat ? this.time[i] + share * duration : this.timeWithin(i, share);
  }
}

/** `bytes`: PageData::packed(), inflated. */
export function readPage(bytes) {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const description = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const columns = bytes.subarray(4 + length);
  const column = (place, count) =>
    numbersOf(columns.subarray(place.from, place.from + place.bytes), count);
  const programmed = description.programmed.map(
    (path) => new Programmed(path, column, description.steps),
  );
  const runs = description.runs.map(
    (run) => new Run(run, programmed[run.programmed], column, description.steps),
  );
  return { ...description, programmed, runs };
}
