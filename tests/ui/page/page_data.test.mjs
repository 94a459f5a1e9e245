import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readPage } from '../../../ui/page/web/page_data.js';
import { madePage } from './made_page.mjs';

/** A line of 10 mm along X: 0.1 s of constant acceleration from rest to 100 mm/s, then constant speed. */
const straight = (tolerance = 0) => ({
  points: [
    { place: 0, position: [0, 0, 0], kind: 3 },
    { place: 10, position: [10, 0, 0], line: 1 },
  ],
  runs: [
    {
      letter: 'A',
      tolerance,
      nodes: [
        { time: 0, length: 0, position: [0, 0, 0], speed: 0, middle: 50, acceleration: 1000, after: 1000, feed: 100, line: 1 },
        { time: 0.1, length: 5, position: [5, 0, 0], speed: 100, middle: 100, acceleration: 0, feed: 100, line: 1 },
        { time: 0.15, length: 10, position: [10, 0, 0], speed: 100, middle: 100, acceleration: 0, feed: 100, line: 1 },
      ],
    },
  ],
});

const close = (value, expected, tolerance) =>
  assert.ok(Math.abs(value - expected) <= tolerance, `${value} is not ${expected} within ${tolerance}`);

test('constant acceleration gives v = a t and s = a t^2 / 2 between two nodes', () => {
  const [run] = readPage(madePage(straight())).runs;
  for (const time of [0, 0.013, 0.05, 0.0999]) {
    const state = run.at(time);
    close(state.speed, 1000 * time, 0.02);
    close(state.length, 500 * time * time, 2e-3);
    close(state.position[0], 500 * time * time, 2e-3);
    close(state.acceleration, 1000, 4);
  }
  close(run.at(0.125).speed, 100, 0.02);
  close(run.at(99).time, 0.15, 1e-6);
});

test('time of a place is the inverse of the place at a time', () => {
  const [run] = readPage(madePage(straight())).runs;
  for (const time of [0.002, 0.04, 0.1, 0.12]) close(run.timeAtPlace(run.at(time).place), time, 2e-5);
});

test('a run against itself loses nothing, against one that starts later the delay', () => {
  const made = straight();
  const later = structuredClone(made.runs[0]);
  later.nodes = [
    { ...later.nodes[0], middle: 0, speed: 0, acceleration: 0, kind: 2 },
    ...later.nodes.map((node) => ({ ...node, time: node.time + 0.02 })),
  ];
  made.runs.push(later);
  const [run, other] = readPage(madePage(made)).runs;
  for (const lost of run.lostAgainst(run)) close(lost, 0, 2e-6);
  close(other.lostAgainst(run).at(-1), 0.02, 2e-6);
  close(run.lostAgainst(other).at(-1), -0.02, 2e-6);
});

test('positions off the programmed path come back to the step', () => {
  const made = straight();
  made.runs[0].nodes[1].position = [5.0124, -0.0456, 0.0008];
  const [run] = readPage(madePage(made)).runs;
  [5.0124, -0.0456, 0.0008].forEach((value, k) => close(run.positions[k][1], value, 1e-9));
});

test('a curve of a rotary axis is straight between its points, and jumps where two are at one time', () => {
  const made = straight();
  made.runs[0].rotary = [{ kind: 'axis_jerk', axis: 'C', limit: 40, precision: 0.01, points: [[0, 0], [0.05, 10], [0.05, -20], [0.15, -20]] }];
  const [curve] = readPage(madePage(made)).runs[0].rotary;
  close(curve.at(0.025), 5, 0.03);
  close(curve.at(0.0499), 10, 0.1);
  close(curve.at(0.0501), -20, 0.1);
  close(curve.at(9), -20, 0.03);
});

test('lost time is counted by line', () => {
  const [run] = readPage(madePage(straight())).runs;
  close(run.lostByLine().get(1), 0.05, 1e-5);
});
