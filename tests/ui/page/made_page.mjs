// A page's data as ui/page/page_data.cpp packs it, from plain numbers: what tests know in closed form.

const steps = { position: 2e-4, length: 1e-4, time: 1e-6, feed: 1e-3 };
const step = (value, quantum) => Math.floor(value / quantum + 0.5);

/** Zigzag, seven bits a byte, the lowest first. */
export function packedNumbers(numbers) {
  const bytes = [];
  for (const number of numbers) {
    let rest = number >= 0 ? 2 * number : -2 * number - 1;
    while (rest > 127) {
      bytes.push((rest % 128) + 128);
      rest = Math.floor(rest / 128);
    }
    bytes.push(rest);
  }
  return bytes;
}

const deltas = (numbers) => numbers.map((number, i) => number - (i > 0 ? numbers[i - 1] : 0));

class Columns {
  bytes = [];

  add(numbers) {
    const packed = packedNumbers(numbers);
    const place = { from: this.bytes.length, bytes: packed.length };
    this.bytes = this.bytes.concat(packed);
    return place;
  }
}

function programmedAt(points, place) {
  let next = 0;
  while (next + 1 < points.length && step(points[next].place, steps.length) < place) ++next;
  const before = Math.max(0, next - 1);
  const from = step(points[before].place, steps.length);
  const length = step(points[next].place, steps.length) - from;
  const share = length > 0 ? (place - from) / length : 0;
  return [0, 1, 2].map((k) => {
    const [a, b] = [before, next].map((i) => step(points[i].position[k], steps.position));
    return Math.floor(a + (b - a) * share + 0.5);
  });
}

function nodesOf(nodes, points, columns) {
  const speedStep = Math.max(...nodes.map((node) => Math.max(node.speed, node.middle))) / 8192 || 1;
  const peak = (name) => Math.max(...nodes.map((node) => node[name] ?? 0)) / 250 || 1;
  const [accelerationStep, jerkStep] = [peak('acceleration'), peak('jerk')];
  const next = (i) => nodes[Math.min(i + 1, nodes.length - 1)];
  const speeds = nodes.map((node) => step(node.speed, speedStep));
  const middles = nodes.map((node) => step(node.middle, speedStep));
  const times = nodes.map((node) => step(node.time, steps.time));
  const lengths = nodes.map((node) => step(node.length, steps.length));
  const places = nodes.map((node) => step(node.place ?? node.length, steps.length));
  const simpson = (speedStep * steps.time) / (6 * steps.length);
  const rests = lengths.map((length, i) => {
    if (i === 0) return length;
    const driven = (speeds[i - 1] + 4 * middles[i - 1] + speeds[i]) * (times[i] - times[i - 1]);
    return length - lengths[i - 1] - Math.floor(driven * simpson + 0.5);
  });
  const offsets = nodes.map((node, i) => {
    const on = programmedAt(points, places[i]);
    return node.position.map((value, k) => step(value, steps.position) - on[k]);
  });
  const accelerations = nodes.map((node) => step(node.acceleration ?? 0, accelerationStep));
  const of = (name, quantum) => deltas(nodes.map((node) => step(node[name] ?? 0, quantum)));
  return {
    count: nodes.length,
    speed_step: speedStep,
    acceleration_step: accelerationStep,
    jerk_step: jerkStep,
    columns: {
      time: columns.add(deltas(times)),
      length: columns.add(rests),
      ahead: columns.add(deltas(places.map((place, i) => place - lengths[i]))),
      x: columns.add(offsets.map((offset) => offset[0])),
      y: columns.add(offsets.map((offset) => offset[1])),
      z: columns.add(offsets.map((offset) => offset[2])),
      speed: columns.add(deltas(speeds)),
      middle: columns.add(middles.map((middle, i) => middle - Math.trunc((speeds[i] + step(next(i).speed, speedStep)) / 2))),
      acceleration: columns.add(deltas(accelerations)),
      after: columns.add(nodes.map((node, i) => step(node.after ?? node.acceleration ?? 0, accelerationStep) - step(next(i).acceleration ?? 0, accelerationStep))),
      jerk: columns.add(of('jerk', jerkStep)),
      error: columns.add(of('error', steps.length)),
      feed: columns.add(of('feed', steps.feed)),
      line: columns.add(of('line', 1)),
      cause: columns.add(of('cause', 1)),
      kind: columns.add(of('kind', 1)),
    },
  };
}

/** `points`: time and value of each. */
function rotaryOf({ points, ...curve }, columns) {
  const quantum = curve.limit / 1000;
  const of = (k, size) => columns.add(deltas(points.map((point) => step(point[k], size))));
  return { ...curve, step: quantum, count: points.length, columns: { time: of(0, steps.time), value: of(1, quantum) } };
}

/** `points`: of the programmed path; `runs`: {letter, nodes, ...} with plain nodes. */
export function madePage({ points, runs, ...more }) {
  const columns = new Columns();
  const of = (name, quantum) => columns.add(deltas(points.map((point) => step(point[name] ?? 0, quantum))));
  const axis = (k) => columns.add(deltas(points.map((point) => step(point.position[k], steps.position))));
  const programmed = [
    {
      count: points.length,
      columns: { place: of('place', steps.length), x: axis(0), y: axis(1), z: axis(2), line: of('line', 1), kind: of('kind', 1) },
    },
  ];
  const described = {
    steps,
    programmed,
    runs: runs.map((run) => ({
      ...run,
      programmed: 0,
      nodes: nodesOf(run.nodes, points, columns),
      rotary: (run.rotary ?? []).map((curve) => rotaryOf(curve, columns)),
    })),
    ...more,
  };
  const json = new TextEncoder().encode(JSON.stringify(described));
  const bytes = new Uint8Array(4 + json.length + columns.bytes.length);
  new DataView(bytes.buffer).setUint32(0, json.length, true);
  bytes.set(json, 4);
  bytes.set(columns.bytes, 4 + json.length);
  return bytes;
}
