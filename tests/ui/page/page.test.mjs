// The page of a report in a browser. FEEDSCOPE: the program; FEEDSCOPE_CHROMIUM: the browser [chromium];
// FEEDSCOPE_PICTURES: a folder for pictures of what is tested. Those in pictures/ are what it is compared with.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { inflateSync } from 'node:zlib';
import { readPage } from '../../../ui/page/web/page_data.js';
import { Browser } from './browser.mjs';

const top = fileURLToPath(new URL('../../..', import.meta.url));
const program = process.env.FEEDSCOPE ?? join(top, 'build/test/app/feedscope');
const slot = join(top, 'resources/programs/trochoidal_slot.nc');
const folder = mkdtempSync(join(tmpdir(), 'feedscope-pages-'));
const url = (name) => pathToFileURL(join(folder, name)).href;
const tolerances = ['0.01', '0.02', '0.05', '0.1'];
const machine = ['--machine', 'huron-kx10'];
const hurt = 'window.hurt=1';
const nasty = `<script>${hurt}<script>'"&amp;.nc`;

function feedscope(...options) {
  try {
    return execFileSync(program, options, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 2 ** 28 });
  } catch (error) {
    if (error.status === 1) return error.stdout; // the program has wrong lines; results are written
    throw error;
  }
}

const picture = (name) => process.env.FEEDSCOPE_PICTURES && join(process.env.FEEDSCOPE_PICTURES, `${name}.png`);
const close = (value, expected, tolerance, what) =>
  assert.ok(Math.abs(value - expected) <= tolerance, `${what}: ${value} is not ${expected} within ${tolerance}`);

let browser;
let page;

before(async () => {
  const runs = tolerances.flatMap((tolerance) => ['--tolerance', tolerance]);
  feedscope('report', slot, ...machine, ...runs, '--out', 'slot.html');
  writeFileSync(
    join(folder, nasty),
    `G21 G90 G17\nG0 X0 Y0 Z0 (</script><img src=x onerror=${hurt}>)\n(\u2028\u2029 "'\\ <!--<script> ]]> &lt;)\nG1 X10 F2000\nG1 Y10\nG2 X20 Y0 R10\nM30\n`,
  );
  feedscope('report', nasty, '--language', 'fr', '--title', `</title><script>${hurt}</script>`, '--out', 'nasty.html');
  browser = new Browser();
  page = await browser.page();
  await page.openView(url('slot.html'));
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Box of an element of the view. */
const boxOf = (selector) =>
  page.ask((wanted) => {
    const box = document.querySelector('#feedscope-view').shadowRoot.querySelector(wanted).getBoundingClientRect();
    return { x: box.x, y: box.y, width: box.width, height: box.height };
  }, selector);

const middleOf = async (selector) => {
  const box = await boxOf(selector);
  return [box.x + box.width / 2, box.y + box.height / 2];
};

/** What the views show of the cursor. */
const shown = () =>
  page.ask(() => {
    const root = document.querySelector('#feedscope-view').shadowRoot;
    const text = (selector) => root.querySelector(selector).textContent;
    const { store, page: data } = window.feedscope;
    return {
      time: store.get('time'),
      run: store.get('run'),
      line: data.runs[store.get('run')].at(store.get('time')).line,
      textLine: Number(root.querySelector('.row.here')?.dataset.line),
      marker: root.querySelector('.marker').style.transform,
      chart: root.querySelector('.cursor-line').style.transform,
      readout: text('.readout'),
      status: text('footer'),
      lens: text('.lens-title'),
      why: text('.why'),
      headline: text('h2'),
      slider: Number(root.querySelector('.player input').value),
    };
  });

const set = async (changes) => {
  await page.ask((values) => window.feedscope.store.set(values), changes);
  await page.settle();
};

/** Share of the pixels of a canvas that something is drawn on, and how many colours there are. */
const drawn = (selector) =>
  page.ask((wanted) => {
    const canvas = document.querySelector('#feedscope-view').shadowRoot.querySelector(wanted);
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let count = 0;
    const colours = new Set();
    const box = [copy.width, copy.height, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 100) continue;
      ++count;
      const [x, y] = [(i / 4) % copy.width, Math.floor(i / 4 / copy.width)];
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
      colours.add((data[i] >> 5) * 64 + (data[i + 1] >> 5) * 8 + (data[i + 2] >> 5));
    }
    return { share: (4 * count) / data.length, colours: colours.size, width: (box[2] - box[0]) / copy.width, height: (box[3] - box[1]) / copy.height };
  }, selector);

test('figures are those of simulate --json, to the last digit', async () => {
  for (const [index, tolerance] of tolerances.entries()) {
    const json = JSON.parse(feedscope('simulate', slot, ...machine, '--tolerance', tolerance, '--json', '-'));
    const figures = await page.ask((run) => window.feedscope.page.runs[run].figures, index);
    for (const name of Object.keys(json).filter((key) => !['elapsed', 'diagnostics', 'settings'].includes(key))) {
      assert.deepEqual(figures[name], json[name], name);
    }
  }
});

test('what limits a run is listed with the times of simulate --json', async () => {
  await set({ within: null });
  const json = JSON.parse(feedscope('simulate', slot, ...machine, '--tolerance', '0.1', '--json', '-'));
  const longest = Math.max(...Object.values(json.time_by_cause_s));
  const texts = await page.ask(() => [...document.querySelector('#feedscope-view').shadowRoot.querySelectorAll('.time-use .cause')].map((row) => row.innerText));
  assert.ok(texts[0].includes(longest.toFixed(1)), `${texts[0]} | ${longest}`);
  const parts = await page.ask(() => document.querySelector('#feedscope-view').shadowRoot.querySelectorAll('.cause-bar i').length);
  assert.equal(parts, Object.keys(json.time_by_cause_s).length);
});

/** The data of a page, read as its script does. */
function dataOf(file) {
  const [, data] = readFileSync(join(folder, file), 'utf8').match(/id="feedscope-data">([^<]*)/);
  return readPage(new Uint8Array(inflateSync(Buffer.from(data, 'base64'))));
}

/** A run of a page against what `simulate --csv` says at every `step` seconds. */
function compare(run, step, ...options) {
  const [head, ...rows] = feedscope('simulate', ...options, '--step', step, '--csv', '-').trim().split('\n').map((row) => row.split(','));
  const column = (name) => rows.map((row) => Number(row[head.indexOf(name)]));
  const [times, feeds, lengths, lines, ...axes] = ['time_s', 'feed_mm_min', 'path_mm', 'line', 'x_mm', 'y_mm', 'z_mm'].map(column);
  const topFeed = 60 * run.top_feed;
  let wrong = 0;
  times.forEach((time, i) => {
    const { position, speed, length, line } = run.at(time);
    const away = Math.hypot(...position.map((value, k) => value - axes[k][i]));
    assert.ok(away < run.precision.position, `${away} mm at ${time} s`);
    if (feeds[i] <= topFeed) close(60 * speed, feeds[i], 60 * run.precision.speed, `feed at ${time} s`);
    close(length, lengths[i], run.precision.position, `path length at ${time} s`);
    wrong += line !== lines[i];
  });
  assert.ok(wrong <= 1 + times.length / 500, `${wrong} of ${times.length} lines differ`);
  close(run.precision.position, 1e-3, 1e-12, 'stated precision of the path');
  close(run.precision.speed / run.top_feed, 1e-3, 1e-12, 'stated precision of the feed');
}

test('the path is as near to simulate --csv as the page states: short lines, arcs, five axes', () => {
  compare(dataOf('slot.html').runs[1], '0.0037', slot, ...machine, '--tolerance', '0.02');
  for (const [name, ...options] of [['tapie_bore.nc', '--tolerance', '0.05'], ['lesson_singular.nc', '--machine', 'five-axis-table-ac', '--tolerance', '0.02']]) {
    const file = join(top, 'resources/programs', name);
    feedscope('report', file, ...options, '--brief', '--out', 'other.html');
    compare(dataOf('other.html').runs[0], '0.0007', file, ...options);
  }
});

test('rotary axes are drawn where their limits decide, as near to simulate --csv as stated', async () => {
  assert.deepEqual(await page.ask(() => [...document.querySelector('#feedscope-view').shadowRoot.querySelectorAll('.chart')].map((one) => one.classList[1])), ['feed', 'acceleration', 'jerk']);
  const options = [join(top, 'resources/programs/lesson_singular.nc'), '--machine', 'five-axis-table-ac', '--tolerance', '0.02'];
  feedscope('report', ...options, '--brief', '--out', 'turning.html');
  const [run] = dataOf('turning.html').runs;
  const lasting = Object.entries(run.figures.time_by_cause_s).filter(([key, time]) => /^axis_(velocity|acceleration|jerk)_[abc]$/.test(key) && time > 0.01 * run.duration);
  assert.deepEqual([...new Set(run.rotary.map(({ kind }) => kind))].sort(), [...new Set(lasting.map(([key]) => key.slice(0, -2)))].sort());
  const [head, ...rows] = feedscope('simulate', ...options, '--step', '0.0013', '--csv', '-').trim().split('\n').map((row) => row.split(','));
  const names = { axis_velocity: ['v', '_rev_min', 60], axis_acceleration: ['a', '_rev_s2', 1], axis_jerk: ['j', '_rev_s3', 1] };
  for (const curve of run.rotary) {
    const [letter, unit, factor] = names[curve.kind];
    const column = head.indexOf(`${letter}${curve.axis.toLowerCase()}${unit}`);
    const time = head.indexOf('time_s');
    const far = rows.filter((row) => Math.abs((curve.at(Number(row[time])) * factor) / (2 * Math.PI) - Number(row[column])) > (curve.precision * curve.limit * factor) / (2 * Math.PI));
    assert.ok(far.length < 0.003 * rows.length, `${curve.kind} ${curve.axis}: ${far.length} of ${rows.length} rows`);
  }
  const turning = await browser.page();
  await turning.openView(url('turning.html'));
  await turning.picture(picture('turning'));
  const labels = await turning.ask(() => [...document.querySelector('#feedscope-view').shadowRoot.querySelectorAll('.chart:nth-of-type(n+4) .chart-label')].map((one) => one.textContent));
  assert.match(labels.join(), /Jerk of rotary axes.*C [−\d.]+ of 40/);
  assert.match(await turning.ask(() => document.querySelector('#feedscope-view').shadowRoot.querySelector('.precision').textContent), /rotary axes within 1[.]1 % of their limits/);
  assert.deepEqual(turning.complaints, []);
  await page.send('Page.bringToFront');
});

test('the run to take is that of compare, whatever the bound', async () => {
  const runs = tolerances.flatMap((tolerance) => ['--tolerance', tolerance]);
  for (const within of [null, '0.2', '0.04', '0.02', '0.012', '0.009', '0.0001']) {
    const bound = within === null ? [] : ['--within', within];
    const json = JSON.parse(feedscope('compare', slot, ...machine, '--model', 'msaddek', ...runs, ...bound, '--json', '-'));
    await set({ within: within === null ? null : Number(within) });
    const { headline } = await shown();
    const taken = json.recommendation;
    const index = taken ? taken.run : -1;
    if (!taken) assert.match(headline, /^No run keeps/);
    else assert.ok(headline.includes(`${'ABCD'[index]} (${tolerances[index]} mm)`), `${headline} | ${JSON.stringify(taken)}`);
    const marked = await page.ask(() => [...document.querySelector('#feedscope-view').shadowRoot.querySelectorAll('.runs tbody tr')].map((row) => row.classList.contains('taken')));
    assert.deepEqual(marked, tolerances.map((one, k) => k === index));
  }
  await set({ within: null });
});

test('every view is drawn, in each colouring', async () => {
  await page.picture(picture('desktop'));
  for (const colour of ['feed', 'cause', 'error', 'lost']) {
    await set({ colour });
    await page.until(() => document.querySelector('#feedscope-view').shadowRoot.querySelector('.key').childElementCount > 0);
    const path = await drawn('.stage > canvas');
    assert.ok(path.colours >= 4, `${colour}: ${path.colours} colours`);
    await page.picture(picture(`colour-${colour}`));
  }
  await set({ colour: 'feed' });
  await page.ask(() => window.feedscope.view.fit());
  await page.settle();
  const path = await drawn('.stage > canvas');
  assert.ok(Math.max(path.width, path.height) > 0.6, `the path fills ${path.width} x ${path.height}`);
  for (const chart of ['.feed canvas', '.acceleration canvas', '.jerk canvas', '.strip', '.lens canvas']) {
    const { share, colours } = await drawn(chart);
    assert.ok(share > 0.01 && colours >= 2, `${chart}: ${share}, ${colours} colours`);
  }
});

/** Share of squares of 4 pixels whose mean colour differs to the eye; 1 if the sizes do. */
async function difference(picture, baseline) {
  const plain = await browser.page();
  await plain.send('Page.bringToFront');
  const found = await plain.ask(async (...pictures) => {
    const [one, other] = await Promise.all(pictures.map(async (data) => {
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const canvas = document.createElement('canvas');
      canvas.width = image.width / 4;
      canvas.height = image.height / 4;
      const context = canvas.getContext('2d');
      context.imageSmoothingQuality = 'high';
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      return context.getImageData(0, 0, canvas.width, canvas.height);
    }));
    if (one.width !== other.width || one.height !== other.height) return 1;
    let differ = 0;
    for (let i = 0; i < one.data.length; i += 4) {
      differ += [0, 1, 2].some((k) => Math.abs(one.data[i + k] - other.data[i + k]) > 32);
    }
    return (4 * differ) / one.data.length;
  }, picture.toString('base64'), baseline.toString('base64'));
  await page.send('Page.bringToFront');
  return found;
}

test('path, charts, lens and decision look as their pictures', async () => {
  await set({ time: 20, run: 3, colour: 'feed', range: null, within: null, lens: false });
  await page.click(...(await middleOf('#look-iso')));
  await page.move(640, 20);
  const missing = [];
  const check = async (name, selector) => {
    const bytes = await page.picture(picture(`like-${name}`), await boxOf(selector));
    const baseline = join(top, 'tests/ui/page/pictures', `${name}.png`);
    const differ = existsSync(baseline) ? await difference(bytes, readFileSync(baseline)) : 1;
    if (differ > 0.01) missing.push(`${name}: ${(100 * differ).toFixed(1)} % differ from ${baseline}`);
  };
  await check('path-feed', '.stage');
  await check('charts', '.charts');
  await check('decision', '.decision');
  await set({ colour: 'cause', lens: true });
  await check('lens', '.lens');
  await check('path-cause', '.stage');
  assert.deepEqual(missing, [], 'set FEEDSCOPE_PICTURES to a folder to see them as like-NAME.png');
  await set({ colour: 'feed' });
});

test('one cursor: chart, path, text, lens, table and slider follow each other', async () => {
  const chart = await boxOf('.charts');
  await page.move(chart.x + 0.6 * chart.width, chart.y + 40);
  const first = await shown();
  assert.equal(first.textLine, first.line);
  assert.ok(first.readout.startsWith(first.time.toFixed(3)), first.readout);
  close(first.slider, first.time / (await page.ask(() => window.feedscope.page.runs[window.feedscope.store.get('run')].duration)), 1e-6, 'slider');

  const place = await page.ask(() => {
    const { view, page: data, store } = window.feedscope;
    return view.toScreen(data.runs[store.get('run')].at(20).position);
  });
  const stage = await boxOf('.stage');
  await page.move(stage.x + place[0], stage.y + place[1]);
  const second = await shown();
  assert.notEqual(second.chart, first.chart);
  assert.notEqual(second.marker, first.marker);
  assert.equal(second.textLine, second.line);
  const marker = second.marker.match(/[\d.]+/g).map(Number);
  close(marker[0], place[0], 3, 'marker');
  close(marker[1], place[1], 3, 'marker');

  const row = await boxOf('.row:nth-child(9)');
  await page.move(row.x + 80, row.y + 9);
  const third = await shown();
  assert.notEqual(third.line, second.line);
  assert.equal(third.textLine, third.line);
  assert.notEqual(third.lens, second.lens);

  const before = third.line;
  await page.click(...(await middleOf('.runs tbody tr:nth-child(3)')));
  await page.settle();
  const fourth = await shown();
  assert.equal(fourth.run, 2);
  assert.equal(fourth.line, before, 'another run at the same place');
});

test('charts zoom by wheel and move by dragging; a double click shows all', async () => {
  const chart = await boxOf('.charts');
  const at = [chart.x + chart.width / 2, chart.y + 40];
  await page.wheel(...at, -800);
  const near = await page.ask(() => window.feedscope.store.get('range'));
  assert.ok(near[1] - near[0] < 60, String(near));
  await page.drag(at, [at[0] - 100, at[1]]);
  const moved = await page.ask(() => window.feedscope.store.get('range'));
  assert.ok(moved[0] > near[0]);
  close(moved[1] - moved[0], near[1] - near[0], 1e-6, 'width');
  await page.picture(picture('zoomed'));
  await set({ range: null });
});

test('the path turns, moves, and zooms to the pointer', async () => {
  const stage = await boxOf('.stage');
  const at = [stage.x + 200, stage.y + 150];
  const camera = () => page.ask(() => window.feedscope.view.cameraText());
  const start = await camera();
  await page.drag(at, [at[0] + 90, at[1] + 30]);
  const turned = await camera();
  assert.notEqual(turned, start);
  await page.drag(at, [at[0] + 60, at[1]], 'right');
  const panned = await camera();
  assert.notEqual(panned, turned);
  await page.wheel(...at, -400);
  assert.notEqual(await camera(), panned);
  await page.click(...(await middleOf('#look-top')));
  await page.picture(picture('top'));
  await page.click(...(await middleOf('#look-iso')));
});

test('the whole path stays in view when the window changes, until it is moved', async () => {
  await page.click(...(await middleOf('#fit')));
  const beyond = () =>
    page.ask(() => {
      const { view } = window.feedscope;
      const m = view.camera.projectionMatrix.clone().multiply(view.camera.matrixWorldInverse).elements;
      let most = 0;
      for (let i = 0; i < view.run.count; ++i) {
        if (view.run.kind[i] !== 0) continue; // no cut
        const [x, y, z] = view.run.positions.map((axis, k) => axis[i] - view.origin[k]);
        most = Math.max(most, Math.abs(m[0] * x + m[4] * y + m[8] * z + m[12]), Math.abs(m[1] * x + m[5] * y + m[9] * z + m[13]));
      }
      return most;
    });
  for (const size of [{ width: 900, height: 900 }, { width: 1280, height: 800 }]) {
    await page.resize(size);
    await page.settle();
    const most = await beyond();
    assert.ok(most > 0.3 && most <= 1, `${size.width}: ${most}`);
  }
});

test('the bound is dragged and moved by keys', async () => {
  const handle = await middleOf('.bound .grip');
  const chart = await boxOf('.decision');
  await page.drag(handle, [chart.x + chart.width * 0.5, handle[1]]);
  const dragged = await page.ask(() => window.feedscope.store.get('within'));
  assert.ok(dragged > 0, String(dragged));
  await page.picture(picture('bound'));
  await page.ask(() => document.querySelector('#feedscope-view').shadowRoot.querySelector('.bound').focus());
  await page.key('ArrowLeft');
  assert.ok((await page.ask(() => window.feedscope.store.get('within'))) < dragged);
  await set({ within: null });
});

test('worst places come in order of what they lose, each with its reason', async () => {
  await set({ time: 0 });
  const losses = [];
  for (let i = 0; i < 3; ++i) {
    await page.click(...(await middleOf('#next-place')));
    await page.settle();
    const { time, why } = await shown();
    losses.push(await page.ask((at) => {
      const run = window.feedscope.page.runs[window.feedscope.store.get('run')];
      return run.places.find((place) => place.from <= at && at <= place.to).loss;
    }, time));
    assert.match(why, /mm\/min/);
  }
  assert.deepEqual(losses, [...losses].sort((a, b) => b - a));
  await page.picture(picture('place'));
  await page.click(...(await middleOf('#fit')));
});

test('plays at true speed', async () => {
  await set({ time: 1, speed: 1 });
  await page.click(...(await middleOf('#play')));
  const [from, start] = await page.ask(() => [window.feedscope.store.get('time'), performance.now()]);
  await page.until((time) => window.feedscope.store.get('time') > time, from + 0.3);
  const [to, end] = await page.ask(() => [window.feedscope.store.get('time'), performance.now()]);
  await page.click(...(await middleOf('#play')));
  close(to - from, (end - start) / 1000, 0.3, 'time played');
  assert.ok(to > from);
});

test('the address leads to run, place, colours and camera', async () => {
  await set({ time: 12.5, colour: 'cause', range: [10, 15] });
  await page.ask(() => window.feedscope.view.look('top'));
  await page.until(() => window.location.hash.includes('t=12.5000') && window.location.hash.includes(`camera=${window.feedscope.view.cameraText()}`));
  const before = await page.ask(() => ({ hash: window.location.hash, camera: window.feedscope.view.cameraText(), run: window.feedscope.store.get('run') }));
  const again = await browser.page();
  await again.openView(url('slot.html') + before.hash);
  const found = await again.ask(() => {
    const { store, view } = window.feedscope;
    return { time: store.get('time'), colour: store.get('colour'), range: store.get('range'), run: store.get('run'), camera: view.cameraText() };
  });
  assert.deepEqual([found.time, found.colour, found.range, found.run], [12.5, 'cause', [10, 15], before.run]);
  found.camera.split(',').forEach((value, k) => close(Number(value), Number(before.camera.split(',')[k]), 1e-3 * Math.abs(Number(value)) + 1e-3, 'camera'));
  assert.deepEqual(again.complaints, []);
  await set({ colour: 'feed', range: null });
});

test('an address with nonsense leads to a page that works', async () => {
  const other = await browser.page();
  for (const hash of ['%', 'run=Z&t=1e999&camera=1,a,,&range=5,1&within=-1&colour=<b>', 'run=A&t=-3&camera=NaN,Infinity,0,0,0,0,0&range=1e300,2e300&within=1e300', 'run=__proto__&t=&camera=0,0,0,0,0,0,0,0,0']) {
    await other.open('about:blank');
    await other.openView(`${url('slot.html')}#${hash}`);
    const seen = await other.ask(() => {
      const { store, view, page: data } = window.feedscope;
      const run = data.runs[store.get('run')];
      const [from, to] = store.get('range') ?? [0, run.duration];
      return {
        sane: Number.isFinite(view.toScreen(run.at(store.get('time')).position)[0]) && from >= 0 && to <= run.duration && store.get('time') >= 0 && store.get('time') <= run.duration,
        text: document.querySelector('#feedscope-view').shadowRoot.textContent,
      };
    });
    assert.ok(seen.sane, hash);
    assert.doesNotMatch(seen.text, /NaN|Infinity|undefined/);
  }
  assert.deepEqual(other.complaints, []);
});

test('nothing is asked from a network, nor can be', async () => {
  const asked = page.requests.filter((address) => !/^(file|blob|data|about):/.test(address));
  assert.deepEqual(asked, []);
  const complaints = page.complaints.length;
  const blocked = await page.ask(() => fetch('https://example.org/').then(() => 'fetched', () => 'blocked'));
  assert.equal(blocked, 'blocked');
  assert.ok(page.complaints.slice(complaints).some((text) => text.includes('Content Security Policy')));
  page.complaints.length = complaints;
});

test('no complaint in the console', () => {
  assert.deepEqual(page.complaints, []);
});

test('a page of four runs is smaller than a megabyte, its view than half of one', async (context) => {
  const { size } = statSync(join(folder, 'slot.html'));
  const added = await page.ask(() => [...document.querySelectorAll('script')].reduce((sum, one) => sum + one.textContent.length, 0));
  const drawnAt = await page.ask(() => performance.getEntriesByName('first-picture')[0].startTime);
  context.diagnostic(`${size} bytes, ${added} of them the view; first picture after ${Math.round(drawnAt)} ms`);
  assert.ok(added < 5e5, `${added} bytes`);
  assert.ok(size < 1e6, `${size} bytes`);
});

test('a program called <script> harms nothing; texts are French', async () => {
  const other = await browser.page();
  await other.openView(url('nasty.html'));
  assert.equal(await other.ask(() => window.hurt), undefined);
  const { texts, name, title } = await other.ask(() => {
    const { page: data } = window.feedscope;
    return { texts: data.texts, name: data.program.name, title: document.title };
  });
  assert.equal(name, nasty);
  assert.ok(title.includes('<script>'));
  const row = await other.ask(() => document.querySelector('#feedscope-view').shadowRoot.querySelectorAll('.row code')[2].textContent);
  assert.equal(row, `(\u2028\u2029 "'\\ <!--<script> ]]> &lt;)`);
  const same = Object.entries(texts).filter(([english, french]) => english === french).map(([english]) => english);
  assert.deepEqual(same.filter((text) => !['Iso', 'Pause', 'Jerk'].includes(text)), []);
  const sources = readdirSync(join(top, 'ui/page/web')).filter((file) => file.endsWith('.js'));
  const used = sources.flatMap((file) => [...readFileSync(join(top, 'ui/page/web', file), 'utf8').matchAll(/\btr\(\s*'([^']+)'/g)].map((match) => match[1]));
  assert.deepEqual(used.filter((text) => !(text in texts)), []);
  assert.ok((await other.ask(() => document.querySelector('#feedscope-view').shadowRoot.textContent)).includes('Pourquoi ici'));
  assert.deepEqual(other.complaints, []);
  await other.picture(picture('french'));
});

test('a phone: touch turns, pinches and taps; nothing is wider than the screen', async () => {
  const phone = await browser.page({ width: 390, height: 844, phone: true });
  await phone.openView(url('slot.html'));
  assert.ok((await phone.ask(() => document.documentElement.scrollWidth)) <= 390);
  const box = await phone.ask(() => {
    const { x, y, width, height } = document.querySelector('#feedscope-view').shadowRoot.querySelector('.stage').getBoundingClientRect();
    return { x, y, width, height };
  });
  const at = [box.x + 120, box.y + box.height - 140];
  const camera = () => phone.ask(() => window.feedscope.view.cameraText());
  const start = await camera();
  await phone.touch([at, [at[0] + 60, at[1] + 10]]);
  const turned = await camera();
  assert.notEqual(turned, start);
  await phone.touch([at, [at[0] - 40, at[1]]], [[at[0] + 60, at[1]], [at[0] + 110, at[1]]]);
  assert.notEqual(await camera(), turned);
  await phone.ask(() => window.feedscope.view.look('iso'));
  await phone.settle();
  await phone.picture(picture('phone'));
  await phone.ask(() => {
    const view = document.querySelector('#feedscope-view').shadowRoot;
    view.querySelector('.charts').scrollIntoView();
  });
  await phone.settle();
  await phone.picture(picture('phone-charts'));
  assert.deepEqual(phone.complaints, []);
});

test('a phone: every text but those of pictures has 14 px, wide tables scroll, and fingers may enlarge', async () => {
  const phone = await browser.page({ width: 390, height: 844, phone: true });
  const found = () =>
    phone.ask(() => {
      const small = new Set();
      let texts = 0;
      const walk = (node) => {
        if (node.nodeType === Node.TEXT_NODE && node.textContent.trim()) {
          const range = document.createRange();
          range.selectNodeContents(node);
          const size = parseFloat(getComputedStyle(node.parentElement).fontSize);
          texts += 1;
          if (range.getClientRects().length && size < 14) small.add(`${size}: ${node.textContent.trim().slice(0, 40)}`);
        }
        if (['svg', 'STYLE', 'SCRIPT'].includes(node.nodeName)) return;
        for (const child of [...node.childNodes, ...(node.shadowRoot?.childNodes ?? [])]) walk(child);
      };
      walk(document.body);
      const wide = [...document.querySelectorAll('table.data')].filter(
        (table) => table.getBoundingClientRect().right > 390 && getComputedStyle(table).overflowX !== 'auto',
      ).length;
      const viewport = document.querySelector('meta[name=viewport]').content;
      return { any: texts > 20, small: [...small], wide, width: document.documentElement.scrollWidth, fixed: /user-scalable|maximum-scale/.test(viewport) };
    });
  const good = { any: true, small: [], wide: 0, width: 390, fixed: false };
  await phone.openView(url('slot.html'));
  assert.deepEqual(await found(), good);
  await phone.openView(url('nasty.html'));
  assert.deepEqual(await found(), good);
});

test('dark where the system is dark', async () => {
  const dark = await browser.page();
  await dark.media({ 'prefers-color-scheme': 'dark' });
  await dark.openView(url('slot.html'));
  await dark.picture(picture('dark'));
  const ground = await dark.ask(() => getComputedStyle(document.querySelector('#feedscope-view').shadowRoot.querySelector('.app')).backgroundColor);
  assert.ok(ground.match(/\d+/g).every((part) => Number(part) < 60), ground);
  assert.deepEqual(dark.complaints, []);
});

test('print and a browser without script have the report alone', async () => {
  await page.media({}, 'print');
  assert.equal(await page.ask(() => getComputedStyle(document.querySelector('#feedscope-view')).display), 'none');
  assert.ok((await page.ask(() => document.querySelector('#feedscope-report').innerText)).length > 500);
  await page.media({});
  const plain = await browser.page();
  await plain.scripts(false);
  await plain.open(url('slot.html'));
  await plain.picture(picture('no-script'));
  await plain.scripts(true);
  assert.equal(await plain.ask(() => document.querySelector('#feedscope-view')), null);
  assert.ok((await plain.ask(() => document.querySelector('h1').textContent)).length > 10);
});

test('without WebGL a picture of the report stands in', async () => {
  const poor = new Browser(['--disable-3d-apis']);
  try {
    const without = await poor.page();
    await without.openView(url('slot.html'));
    await without.picture(picture('no-webgl'));
    const image = await without.ask(() => document.querySelector('#feedscope-view').shadowRoot.querySelector('.picture img').naturalWidth);
    assert.ok(image > 100);
    const chart = await without.ask(() => document.querySelector('#feedscope-view').shadowRoot.querySelector('.feed canvas').width);
    assert.ok(chart > 100);
  } finally {
    await poor.close();
  }
});
