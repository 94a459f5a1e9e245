// Feed, limiting cause, acceleration and jerk over time or path: uPlot, one range and one cursor for all.

import uPlot from 'uplot';
import { causeColour, labelFont, labelHeight } from './colouring.js';
import { el, prepared, themeColour } from './elements.js';
import { inShownUnit, numberText, tickText, unitOf } from './numbers.js';
import { firstAtLeast, kinds, lastAtMost } from './page_data.js';
import { tr } from './texts.js';

const gutter = 46; // left of the plots, for their ticks [pixels]
const least = 1e-4; // width of a range, of the whole run
const phone = 560; // narrower charts [pixels]

/** Values of a run at its nodes, where the next one begins, and between them. */
const quantities = {
  feed: {
    title: () => tr('Feed'),
    dimension: 'feed',
    start: (run, i) => run.speed[i],
    end: (run, i) => run.speed[i + 1],
    at: (state) => state.speed,
  },
  acceleration: {
    title: () => tr('Acceleration'),
    dimension: 'acceleration',
    start: (run, i) => run.acceleration[i],
    end: (run, i) => run.after[i],
    at: (state) => state.acceleration,
  },
  jerk: {
    title: () => tr('Jerk'),
    dimension: 'jerk',
    start: (run, i) => run.jerk[i],
    end: (run, i) => run.jerk[i],
    at: (state) => state.jerk,
  },
};

/** Charts of rotary axes, by the limit that decides in one of the runs. */
const rotaryQuantities = {
  axis_velocity: { title: () => tr('Velocity of rotary axes'), dimension: 'turning' },
  axis_acceleration: { title: () => tr('Acceleration of rotary axes'), dimension: 'turning_acceleration' },
  axis_jerk: { title: () => tr('Jerk of rotary axes'), dimension: 'turning_jerk' },
};

/** Points of a curve, of many in a pixel only the first, least, largest and last. */
class Thinned {
  constructor(from, to, pixels) {
    this.from = from;
    this.step = (to - from) / pixels;
    this.x = [];
    this.y = [];
    this.column = NaN;
  }

  add(x, y) {
    const column = Math.floor((x - this.from) / this.step);
    if (column !== this.column) {
      this.close();
      this.column = column;
      this.bin = { least: [x, y], most: [x, y], last: [x, y] };
      this.push([x, y]);
      return;
    }
    if (y < this.bin.least[1]) this.bin.least = [x, y];
    if (y > this.bin.most[1]) this.bin.most = [x, y];
    this.bin.last = [x, y];
  }

  push([x, y]) {
    this.x.push(x);
    this.y.push(y);
  }

  close() {
    if (!this.bin) return;
    const { least: low, most: high, last } = this.bin;
    const points = [low, high].sort((a, b) => a[0] - b[0]);
    for (const point of [...points, last]) {
      if (point[0] > this.x[this.x.length - 1] || point[1] !== this.y[this.y.length - 1]) this.push(point);
    }
    this.bin = null;
  }

  done() {
    this.close();
    return [this.x, this.y];
  }
}

/** The curve of `quantity` over `axis`, "time" or "place", within a range. */
export function curveOf(run, quantity, axis, [from, to], pixels) {
  const xs = run[axis];
  const factor = inShownUnit(1, quantity.dimension);
  const first = Math.max(0, lastAtMost(xs, from) - 1);
  const last = Math.min(run.count - 2, firstAtLeast(xs, to) + 1);
  const points = new Thinned(from, to, pixels);
  const fine = last - first < pixels / 2;
  const inner = fine ? Math.ceil((2 * pixels) / (last - first + 1)) : 1;
  for (let i = first; i <= last; ++i) {
    const width = xs[i + 1] - xs[i];
    points.add(xs[i], factor * quantity.start(run, i));
    const parts = width > 0 ? Math.min(inner, Math.ceil((width / (to - from)) * pixels)) : 1;
    for (let k = 1; k < parts; ++k) {
      const state = run.at(run.time[i] + ((run.time[i + 1] - run.time[i]) * k) / parts);
      points.add(state[axis], factor * quantity.at(state));
    }
    points.add(xs[i + 1], factor * quantity.end(run, i));
  }
  return points.done();
}

/** A curve of a rotary axis within a range; where it jumps its points are close to each other, not at one place. */
export function rotaryCurveOf(run, curve, axis, [from, to], pixels) {
  const xs = axis === 'time' ? curve.time : curve.placesIn(run);
  const factor = inShownUnit(1, rotaryQuantities[curve.kind].dimension);
  const points = new Thinned(from, to, pixels);
  const last = Math.min(curve.count - 1, firstAtLeast(xs, to) + 1);
  for (let i = Math.max(0, lastAtMost(xs, from) - 1); i <= last; ++i) points.add(xs[i], factor * curve.value[i]);
  const [x, y] = points.done();
  const least = (to - from) * 1e-9;
  for (let i = 1; i < x.length; ++i) x[i] = Math.max(x[i], x[i - 1] + least);
  return [x, y];
}

/** The limit of a rotary axis, both ways. */
const limitOf = (curve, range) => {
  const limit = inShownUnit(curve.limit, rotaryQuantities[curve.kind].dimension);
  return [limit, -limit].map((value) => [range, [value, value]]);
};

/** Largest value of the curves; with their limits where these are near. */
function rotaryTop(curves, dimension) {
  const largest = Math.max(0, ...curves.map(({ value }) => value.reduce((most, one) => Math.max(most, Math.abs(one)), 0)));
  const near = curves.map(({ limit }) => limit).filter((limit) => limit < 1.3 * largest);
  return inShownUnit(Math.max(largest, ...near), dimension) || 1;
}

/** The programmed feed, rapids left out. */
function programmedFeed(run, axis, [from, to], pixels) {
  const xs = run[axis];
  const points = new Thinned(from, to, pixels);
  const last = Math.min(run.count - 2, firstAtLeast(xs, to) + 1);
  for (let i = Math.max(0, lastAtMost(xs, from) - 1); i <= last; ++i) {
    const feed = run.kind[i] === kinds.cut ? inShownUnit(run.feed[i], 'feed') : NaN;
    points.add(xs[i], feed);
    points.add(xs[i + 1], feed);
  }
  return points.done();
}

const drawable = ([x, y]) => [x, y.map((value) => (Number.isFinite(value) ? value : null))];

/** Largest value of what is cut: rapids do not set the scale. */
function topOf(run, quantity) {
  let top = 0;
  for (let i = 0; i + 1 < run.count; ++i) {
    if (run.kind[i] === kinds.cut) {
      top = Math.max(top, quantity.start(run, i), quantity.end(run, i));
    }
  }
  return inShownUnit(top, quantity.dimension);
}

export class Charts {
  constructor(page, store, host) {
    Object.assign(this, { page, store, host });
    this.strip = el('canvas', { class: 'strip', 'aria-label': tr('Limited by') });
    this.plots = [
      ...Object.entries(quantities).map(([name, quantity]) => ({ name, quantity })),
      ...Object.entries(rotaryQuantities)
        .map(([name, quantity]) => ({ name, quantity, axes: this.axesOf(name) }))
        .filter(({ axes }) => axes.length > 0),
    ];
    const boxes = this.plots.map((plot, k) => {
      const last = k === this.plots.length - 1;
      plot.box = el('div', { class: `chart ${plot.name}${last ? ' last' : ''}` });
      plot.values = plot.axes?.map((axis) => el('b', { style: { color: `var(--axis-${axis.toLowerCase()})` } }));
      plot.label = el('div', { class: 'chart-label' }, plot.quantity.title(), ' ', el('i', {}, unitOf(plot.quantity.dimension)), ...(plot.values ?? []));
      plot.box.append(plot.label);
      return plot.box;
    });
    host.style.setProperty('--rotary-charts', this.plots.length - Object.keys(quantities).length);
    this.readout = el('div', { class: 'readout' });
    this.line = el('div', { class: 'cursor-line' });
    host.append(boxes[0], this.strip, ...boxes.slice(1), this.line, this.readout);
    this.make();
    const observer = new ResizeObserver(() => this.resize());
    for (const box of [host, ...boxes]) observer.observe(box);
    store.on(['run', 'axis', 'range', 'theme'], () => this.update());
    store.on(['time', 'run', 'axis', 'range'], () => this.place());
    this.listen();
  }

  get run() {
    return this.page.runs[this.store.get('run')];
  }

  /** Rotary axes of which a run has curves of a kind. */
  axesOf(kind) {
    const curves = this.page.runs.flatMap((run) => run.rotary).filter((curve) => curve.kind === kind);
    return [...new Set(curves.map(({ axis }) => axis))].sort();
  }

  curvesOf({ name }) {
    return this.run.rotary.filter((curve) => curve.kind === name);
  }

  get axis() {
    return this.store.get('axis');
  }

  get whole() {
    const { run } = this;
    return [0, run[this.axis][run.count - 1]];
  }

  get range() {
    return this.store.get('range') ?? this.whole;
  }

  get width() {
    return Math.max(10, this.host.clientWidth - gutter - 12);
  }

  /** The unit behind the last tick. */
  withUnit(ticks) {
    const dimension = this.axis === 'time' ? 'time' : 'length';
    const last = ticks.length - 1;
    return ticks.map((tick, k) => {
      const text = tickText(Number(inShownUnit(tick, dimension).toPrecision(4)));
      return k === last ? `${text} ${unitOf(dimension)}` : text;
    });
  }

  /** A colour, paler where there are several nodes a pixel, which fill the plot. */
  inkOf(colour) {
    const { run, axis, range, width } = this;
    const nodes = firstAtLeast(run[axis], range[1]) - lastAtMost(run[axis], range[0]);
    return nodes > 3 * width ? `${colour}a6` : colour;
  }

  make() {
    const grid = () => themeColour(this.host, '--grid');
    const muted = () => themeColour(this.host, '--muted');
    const last = this.plots.length - 1;
    this.plots.forEach((plot, k) => {
      const line = (stroke, width) => ({ stroke, width, points: { show: false } });
      const asked = plot.name === 'feed' ? [line(() => themeColour(this.host, '--asked'), 1)] : [];
      const ofAxis = (name) => {
        const ink = () => themeColour(this.host, `--axis-${name.toLowerCase()}`);
        const limit = { ...line(ink, 1), dash: [6, 4] };
        return [limit, limit, line(() => this.inkOf(ink()), 1.25)];
      };
      const series = [{}, ...asked, ...(plot.axes?.flatMap(ofAxis) ?? [line(() => this.inkOf(this.run.colour), 1.25)])];
      const axis = {
        stroke: muted,
        grid: { stroke: grid, width: 1 },
        ticks: { show: false },
        font: labelFont(),
        values: (self, ticks) => ticks.map(tickText),
      };
      plot.chart = new uPlot(
        {
          width: this.host.clientWidth || 300,
          height: plot.box.clientHeight || 60,
          padding: [6, 12, k === last ? 0 : 6, 0],
          legend: { show: false },
          cursor: { show: false },
          scales: {
            x: { time: false, range: () => this.range },
            y: { range: () => this.scaleOf(plot) },
          },
          axes: [
            {
              ...axis,
              show: k === last,
              size: 2 * labelHeight(),
              grid: { show: false },
              values: (self, ticks) => this.withUnit(ticks),
            },
            { ...axis, size: gutter, space: 2 * labelHeight() + 2 },
          ],
          series,
        },
        series.map(() => [0]),
        plot.box,
      );
    });
  }

  scaleOf(plot) {
    const { dimension } = plot.quantity;
    const top = 1.08 * (plot.axes ? rotaryTop(this.curvesOf(plot), dimension) : topOf(this.run, plot.quantity) || 1);
    return [plot.axes ? -top : 0, top];
  }

  /** Limits and course of each axis; none of an axis of another run's machine. */
  rotaryData(plot) {
    const { run, axis, range, width } = this;
    const none = [[range[0]], [null]];
    return plot.axes.flatMap((name) => {
      const curve = this.curvesOf(plot).find((one) => one.axis === name);
      return curve ? [...limitOf(curve, range), rotaryCurveOf(run, curve, axis, range, width)] : [none, none, none];
    });
  }

  resize() {
    for (const { chart, box } of this.plots) {
      if (box.clientWidth) chart.setSize({ width: box.clientWidth, height: box.clientHeight });
    }
    this.update();
    this.place();
  }

  update() {
    const { run, axis, range, width } = this;
    for (const plot of this.plots) {
      const { name, quantity, chart } = plot;
      if (plot.axes) {
        chart.setData(uPlot.join(this.rotaryData(plot)));
        continue;
      }
      const [x, y] = drawable(curveOf(run, quantity, axis, range, width));
      const data = [x, y];
      if (name === 'feed') {
        const asked = drawable(programmedFeed(run, axis, range, width));
        chart.setData(uPlot.join([asked, data]));
      } else {
        chart.setData(data);
      }
    }
    this.drawStrip();
  }

  /** Colour of what limits the feed for most of each pixel. */
  drawStrip() {
    const canvas = prepared(this.strip);
    if (!canvas) return;
    const { run, axis } = this;
    const [from, to] = this.range;
    const xs = run[axis];
    const perPixel = (to - from) / this.width;
    let node = lastAtMost(xs, from);
    for (let pixel = 0; pixel < this.width; ++pixel) {
      const end = from + (pixel + 1) * perPixel;
      let longest = node;
      let most = 0;
      while (node + 1 < run.count) {
        const share = Math.min(xs[node + 1], end) - Math.max(xs[node], end - perPixel);
        if (share > most) {
          most = share;
          longest = node;
        }
        if (xs[node + 1] > end) break;
        ++node;
      }
      if (longest + 1 < run.count || most > 0) {
        canvas.context.fillStyle = causeColour(this.page, run.cause[longest]);
        canvas.context.fillRect(gutter + pixel, 0, 1, canvas.height);
      }
    }
  }

  xOf(value) {
    const [from, to] = this.range;
    return gutter + ((value - from) / (to - from)) * this.width;
  }

  valueAt(clientX) {
    const [from, to] = this.range;
    const x = clientX - this.host.getBoundingClientRect().left - gutter;
    return from + (Math.min(Math.max(x, 0), this.width) / this.width) * (to - from);
  }

  place() {
    const state = this.run.at(this.store.get('time'));
    const x = this.xOf(state[this.axis]);
    const seen = x >= gutter - 1 && x <= gutter + this.width + 1;
    this.line.hidden = !seen;
    this.line.style.transform = `translateX(${x}px)`;
    this.readout.hidden = !seen;
    this.showRotary(state.time);
    const axisText =
      this.axis === 'time' ? `${numberText(state.time, 'time')} s` : `${numberText(state.place, 'length')} ${unitOf('length')}`;
    this.readout.textContent = `${axisText} · ${tr('%1 of %2', numberText(state.speed, 'feed'), `${numberText(state.feed, 'feed')} ${unitOf('feed')}`)} · ${this.page.causes[state.cause]}`;
    const half = this.readout.offsetWidth;
    const label = this.plots[0].label;
    const free = label.offsetLeft + label.offsetWidth + 4;
    this.readout.style.left = `${Math.min(Math.max(x + 8, free), this.host.clientWidth - half - 6)}px`;
  }

  /** "C −12.5 of 40.0": the value at the cursor and the limit, which a phone has no room for. */
  showRotary(time) {
    for (const plot of this.plots.filter(({ axes }) => axes)) {
      const { dimension } = plot.quantity;
      plot.axes.forEach((name, k) => {
        const curve = this.curvesOf(plot).find((one) => one.axis === name);
        const value = curve && numberText(curve.at(time), dimension);
        const text = this.host.clientWidth < phone ? value : value && tr('%1 of %2', value, numberText(curve.limit, dimension));
        plot.values[k].textContent = text ? ` ${name} ${text}` : '';
      });
    }
  }

  timeOf(value) {
    return this.axis === 'time' ? value : this.run.timeAtPlace(value);
  }

  setRange(from, to) {
    const [low, high] = this.whole;
    const width = Math.min(Math.max(to - from, (high - low) * least), high - low);
    const middle = (from + to) / 2;
    const start = Math.min(Math.max(middle - width / 2, low), high - width);
    this.store.set({ range: width >= (high - low) * (1 - 1e-9) ? null : [start, start + width] });
  }

  zoom(factor, at) {
    const [from, to] = this.range;
    this.setRange(at - (at - from) * factor, at + (to - at) * factor);
  }

  listen() {
    const { host, store } = this;
    const pointers = new Map();
    let dragged = null;
    host.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
          const [from, to] = this.range;
          const way = ((event.deltaX || event.deltaY) / this.width) * (to - from);
          this.setRange(from + way, to + way);
        } else {
          this.zoom(1.0015 ** event.deltaY, this.valueAt(event.clientX));
        }
      },
      { passive: false },
    );
    host.addEventListener('pointerdown', (event) => {
      host.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event.clientX);
      dragged = { x: event.clientX, range: this.range, moved: false };
    });
    host.addEventListener('pointermove', (event) => {
      if (pointers.size === 0) {
        if (!store.get('playing')) store.set({ time: this.timeOf(this.valueAt(event.clientX)) });
        return;
      }
      const before = [...pointers.values()];
      pointers.set(event.pointerId, event.clientX);
      if (pointers.size === 2) {
        this.pinch(before, [...pointers.values()]);
        dragged = null;
      } else if (dragged && Math.abs(event.clientX - dragged.x) > 4) {
        dragged.moved = true;
        this.pan(event.clientX - dragged.x, dragged.range);
      }
    });
    const release = (event) => {
      pointers.delete(event.pointerId);
      if (dragged && !dragged.moved && event.type === 'pointerup') {
        store.set({ time: this.timeOf(this.valueAt(event.clientX)) });
      }
      dragged = null;
    };
    host.addEventListener('pointerup', release);
    host.addEventListener('pointercancel', release);
    host.addEventListener('dblclick', () => store.set({ range: null }));
  }

  pan(pixels, [from, to]) {
    const way = (-pixels / this.width) * (to - from);
    this.setRange(from + way, to + way);
  }

  pinch(before, after) {
    const wide = (pair) => Math.max(10, Math.abs(pair[0] - pair[1]));
    this.zoom(wide(before) / wide(after), this.valueAt((after[0] + after[1]) / 2));
  }
}
