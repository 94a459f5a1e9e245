import assert from 'node:assert/strict';
import { test } from 'node:test';
import { changeText, clockText, gainText, numberText, shareText, signedPercent, useNumbers } from '../../../ui/page/web/numbers.js';
import { leadingRun, recommend, whyOnly } from '../../../ui/page/web/recommend.js';

const run = (time, error, more = {}) => ({ time, error, lines_not_run: 0, competes: true, ...more });

test('the smallest error within one percent of the fastest', () => {
  const runs = [run(100.9, 0.01), run(100, 0.05), run(120, 0.001)];
  const taken = recommend(runs, null);
  assert.equal(taken.run, 0);
  assert.equal(taken.against, 2);
  assert.equal(taken.reason, 'smallest-error-within-1-percent');
  assert.ok(Math.abs(taken.gainShare - 19.1 / 120) < 1e-12);
});

test('runs beyond the bound do not count, exactly on it they do', () => {
  const runs = [run(120, 0.01), run(100, 0.05)];
  assert.equal(recommend(runs, 0.05).run, 1);
  assert.equal(recommend(runs, 0.0499).run, 0);
  assert.equal(recommend(runs, 0.0499).reason, 'only');
  assert.equal(recommend(runs, 0.001), null);
});

test('results are about the recommended run, else about that with the smallest error of the whole program', () => {
  const runs = [run(120, 0.02), run(130, 0.01), run(110, 0.01), run(10, 0.001, { lines_not_run: 2 })];
  assert.equal(leadingRun(runs, null), recommend(runs, null).run);
  assert.equal(leadingRun(runs, 0.005), 2);
  assert.equal(leadingRun([run(1, 0, { competes: false })], 0.005), null);
});

test('a run that is alone has a reason', () => {
  const runs = [run(120, 0.01), run(100, 0.05)];
  const other = run(90, 0.001, { competes: false, other_model: true });
  assert.equal(whyOnly(runs, 0.02), 'within-bound');
  assert.equal(whyOnly([...runs, other], 0.02), 'within-bound-of-machine');
  assert.equal(whyOnly([runs[0], other], 0.02), 'of-machine');
  assert.equal(whyOnly([runs[0], run(0, 0, { competes: false, other_model: false })], null), 'possible');
  assert.equal(whyOnly([runs[0], run(1, 0, { lines_not_run: 4 }), other], null), 'possible');
});

test('differences below one percent are none', () => {
  assert.equal(recommend([run(100, 0.02), run(100.5, 0.01)], null).reason, 'no-difference');
});

test('a run of which fewer lines are refused goes first', () => {
  const runs = [run(50, 0.01, { lines_not_run: 3 }), run(100, 0.01), run(10, 0.01, { competes: false })];
  assert.equal(recommend(runs, null).run, 1);
});

test('numbers are written as the program writes them', () => {
  useNumbers('.', { error: { text: 'µm', factor: 1000, decimals: 1 } });
  assert.deepEqual([0, 0.0123, 2, 9.996, 12.34, 59.94, 108.5, 3725].map(clockText), ['0 s', '12.3 ms', '2.00 s', '10.0 s', '12.3 s', '59.9 s', '1:48.5', '1:02:05']);
  assert.deepEqual([0.0123, 0.158, 12.34, 59.94, 108.5].map(gainText), ['0.012 s', '0.158 s', '12.3 s', '59.9 s', '1:48.5']);
  assert.deepEqual([0.0002, 0.2, -4.92].map(changeText), ['0', '+0.200 s', '−4.9 s']);
  assert.deepEqual([0.08, 0.0118, 0.003, 1].map(shareText), ['8 %', '1.2 %', '0.3 %', '100 %']);
  assert.deepEqual([-0.0818, 0.012, -0.0001, 0].map(signedPercent), ['−8.2', '+1.2', '0.0', '0.0']);
  assert.equal(numberText(-0.00001, 'error'), '0.0');
  useNumbers(',', { error: { text: 'µm', factor: 1000, decimals: 1 } });
  assert.equal(numberText(-0.0113, 'error'), '−11,3');
});
