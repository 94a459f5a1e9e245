// The place at the cursor with all runs over each other, stretched across the programmed direction: the rules
// of core/analysis/lens on what the page has.

import { labelFont } from './colouring.js';
import { el, prepared, themeColour } from './elements.js';
import { amountText, inShownUnit, numberText, roundUp, tickText, unitOf } from './numbers.js';
import { firstAtLeast, kinds, lastAtMost } from './page_data.js';
import { tr } from './texts.js';

const shareOfWidth = 2 / 3; // of the longest rounding
const shareOfHeight = 1 / 3; // of the largest deviation
const seenWays = 1.5; // path that is drawn to either side, in widths
const straight = 1e-3; // [rad]
const leastDeviation = 1e-3; // what columns can tell [mm]

const minus = (a, b) => a.map((value, k) => value - b[k]);
const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
const norm = (a) => Math.hypot(...a);
const scaled = (a, factor) => a.map((value) => value * factor);
const unit = (a) => scaled(a, 1 / (norm(a) || 1));
const isCut = (kind) => kind === kinds.cut || kind === kinds.arc || kind === kinds.rapid;

/** Point `i` of the programmed path where two segments meet at an angle; null if they do not. */
function cornerAt(path, i) {
  if (i < 1 || i + 1 >= path.count || !isCut(path.kind[i]) || !isCut(path.kind[i + 1])) return null;
  if (path.kind[i] === kinds.arc) return null;
  const point = path.point(i);
  const before = minus(point, path.point(i - 1));
  const after = minus(path.point(i + 1), point);
  if (norm(before) === 0 || norm(after) === 0) return null;
  const into = unit(before);
  const out = unit(after);
  const turn = Math.acos(Math.min(1, Math.max(-1, dot(into, out))));
  const room = Math.min(wayToCorner(path, i, -1), wayToCorner(path, i, 1));
  return turn > straight ? { i, point, into, out, place: path.place[i], room } : null;
}

/** Length of the segment before or after point `i`: inner points of arcs do not end one [mm]. */
function wayToCorner(path, i, step) {
  let end = i + step;
  while (end > 0 && end + 1 < path.count && path.kind[end] === kinds.arc) end += step;
  return Math.abs(path.place[end] - path.place[i]);
}

/** How far around a corner a run is away from the programmed path, at most half of its segments [mm]. */
function roundedLength(run, corner) {
  const reach = corner.room / 2;
  const from = lastAtMost(run.place, corner.place - reach);
  const to = firstAtLeast(run.place, corner.place + reach);
  let largest = 0;
  for (let i = from; i <= to; ++i) largest = Math.max(largest, run.error[i]);
  if (largest < leastDeviation) return 0;
  let first = null;
  let last = null;
  for (let i = from; i <= to; ++i) {
    if (run.error[i] > 0.05 * largest) {
      first ??= Math.max(from, i - 1);
      last = Math.min(to, i + 1);
    }
  }
  return Math.min(2 * reach, run.length[last] - run.length[first]);
}

function nearestCorner(path, place) {
  const next = firstAtLeast(path.place, place);
  let before = next - 1;
  while (before > 0 && path.kind[before] === kinds.arc) --before;
  let after = next;
  while (after + 1 < path.count && path.kind[after] === kinds.arc) ++after;
  const found = [before, after].map((i) => cornerAt(path, i)).filter(Boolean);
  return found.sort((a, b) => Math.abs(a.place - place) - Math.abs(b.place - place))[0] ?? null;
}

function across(along, direction) {
  const part = minus(direction, scaled(along, dot(along, direction)));
  if (norm(part) > 1e-9) return unit(part);
  const flat = [-along[1], along[0], 0];
  return norm(flat) > 1e-3 ? unit(flat) : [1, 0, 0];
}

/** What the lens shows at a time of `shown`: as Lens of core/analysis. */
export function lensAt(runs, shown, time) {
  const path = shown.programmedPath;
  const { place, share } = shown.whereAt(time);
  const nearest = nearestCorner(path, place);
  let width = nearest
    ? Math.max(...runs.map((run) => roundedLength(run, nearest))) / shareOfWidth || nearest.room
    : 1;
  width = Math.max(width, 0.01);
  const corner = nearest && Math.abs(nearest.place - place) <= width / 2 ? nearest : null;
  const next = Math.max(1, firstAtLeast(path.place, place));
  const along = corner?.into ?? unit(minus(path.point(next), path.point(next - 1)));
  const bend = corner?.out ?? minus(path.point(Math.min(next + 1, path.count - 1)), path.point(next));
  const centre = corner?.point ?? path.at(place);
  if (!corner && !nearest) width = Math.max(0.01, path.place[next] - path.place[next - 1]);
  const lens = { centre, along, across: across(along, bend), width, line: path.line[corner?.i ?? next] };
  const middle = corner?.place ?? place;
  const seen = (point) => {
    const away = minus(point, centre);
    return [dot(away, lens.along), dot(away, lens.across)];
  };
  lens.programmed = programmedThrough(path, middle, width, seen);
  lens.runs = runs.map((run) => runThrough(run, middle, width, seen, place, share));
  const largest = Math.max(...lens.runs.map((run) => run.largestError));
  lens.deviates = largest >= leastDeviation;
  lens.height = lens.deviates ? largest / shareOfHeight : width;
  lens.tolerance = shown.tolerance ?? 0;
  return lens;
}

function programmedThrough(path, middle, width, seen) {
  const lines = [[]];
  const from = middle - seenWays * width;
  const to = middle + seenWays * width;
  const first = Math.max(1, firstAtLeast(path.place, from));
  lines[0].push(seen(path.at(Math.max(from, 0))));
  for (let i = first; i < path.count && path.place[i - 1] < to; ++i) {
    if (path.kind[i] === kinds.gap) lines.push([]);
    lines[lines.length - 1].push(seen(path.place[i] > to ? path.at(to) : path.point(i)));
  }
  return lines;
}

function runThrough(run, middle, width, seen, place, share) {
  const first = Math.max(0, lastAtMost(run.place, middle - seenWays * width) - 1);
  const last = Math.min(run.count - 1, firstAtLeast(run.place, middle + seenWays * width) + 1);
  const at = run.at(run.timeAtPlace(place, share));
  const through = { path: [], cursor: seen(at.position), error: at.error, feed: at.speed, largestError: 0 };
  for (let i = first; i <= last; ++i) {
    const point = seen(run.positions.map((axis) => axis[i]));
    through.path.push(point);
    if (Math.hypot(...point) <= width / 2) through.largestError = Math.max(through.largestError, run.error[i]);
  }
  return through;
}

export class LensView {
  constructor(page, store, host) {
    Object.assign(this, { page, store, host });
    this.title = el('div', { class: 'lens-title' }, el('span'), el('span'));
    this.canvas = el('canvas', { role: 'img', 'aria-label': tr('Lens') });
    this.table = el('div', { class: 'lens-table' });
    host.append(this.title, this.canvas, this.table);
    new ResizeObserver(() => this.draw()).observe(host);
    store.on(['time', 'run', 'theme', 'lens'], () => this.draw());
    this.canvas.addEventListener('click', (event) => this.pick(event));
  }

  get runs() {
    return this.page.runs.filter((run) => run.moves);
  }

  draw() {
    const canvas = prepared(this.canvas);
    if (!canvas) return;
    const shown = this.page.runs[this.store.get('run')];
    const lens = lensAt(this.runs, shown, this.store.get('time'));
    this.lens = lens;
    this.size = canvas.width;
    this.title.firstChild.textContent = tr('Lens: line %1', lens.line);
    const stretch = lens.width / lens.height;
    this.title.lastChild.textContent =
      stretch > 1.05 ? tr('across × %1', tickText(Number(stretch.toPrecision(2)))) : '';
    this.centreY = this.middleOf(lens);
    this.drawPaths(canvas.context, lens);
    this.drawScales(canvas, lens);
    this.showTable(lens);
  }

  /** Where the centre lies so that the curves are in the middle of the picture [share of the height]. */
  middleOf(lens) {
    return lens.deviates ? 0.68 : 0.5;
  }

  toPicture([along, over], lens) {
    return [
      this.size / 2 + (along / lens.width) * this.size,
      this.centreY * this.canvas.clientHeight - (over / lens.height) * this.size,
    ];
  }

  stroke(context, points, lens) {
    context.beginPath();
    points.forEach((point, k) => {
      const [x, y] = this.toPicture(point, lens).map((value) => Math.min(1e5, Math.max(-1e5, value)));
      if (k === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    });
    context.stroke();
  }

  drawPaths(context, lens) {
    context.lineJoin = 'round';
    if (lens.tolerance > 0) this.drawTolerance(context, lens);
    context.strokeStyle = themeColour(this.host, '--programmed');
    context.lineWidth = 1;
    for (const line of lens.programmed) this.stroke(context, line, lens);
    lens.runs.forEach((through, k) => {
      const run = this.runs[k];
      context.strokeStyle = run.colour;
      context.lineWidth = 2;
      context.setLineDash(run.dashes.map((dash) => 2 * dash));
      this.stroke(context, through.path, lens);
      context.setLineDash([]);
    });
    lens.runs.forEach((through, k) => {
      context.fillStyle = this.runs[k].colour;
      context.beginPath();
      context.arc(...this.toPicture(through.cursor, lens), 3.5, 0, 2 * Math.PI);
      context.fill();
    });
  }

  drawTolerance(context, lens) {
    context.strokeStyle = themeColour(this.host, '--band');
    context.lineWidth = 1;
    for (const line of lens.programmed) {
      for (let i = 0; i + 1 < line.length; ++i) {
        const [a, b] = [line[i], line[i + 1]];
        const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
        if (length === 0) continue;
        const side = [(-(b[1] - a[1]) / length) * lens.tolerance, ((b[0] - a[0]) / length) * lens.tolerance];
        for (const sign of [1, -1]) {
          this.stroke(context, [a, b].map((p) => [p[0] + sign * side[0], p[1] + sign * side[1]]), lens);
        }
      }
    }
  }

  drawScales({ context, width, height }, lens) {
    context.strokeStyle = context.fillStyle = themeColour(this.host, '--muted');
    context.font = labelFont();
    context.lineWidth = 1;
    const along = roundUp(inShownUnit((0.2 * lens.width), 'length'));
    const pixels = (along / inShownUnit(1, 'length') / lens.width) * width;
    const y = height - 9.5;
    context.beginPath();
    context.moveTo(8.5, y - 4);
    context.lineTo(8.5, y);
    context.lineTo(8.5 + pixels, y);
    context.lineTo(8.5 + pixels, y - 4);
    context.stroke();
    context.fillText(`${tickText(along)} ${unitOf('length')}`, 12, y - 6);
    if (!lens.deviates) return;
    const over = roundUp(inShownUnit(0.16 * lens.height, 'error'));
    const tall = (over / inShownUnit(1, 'error') / lens.height) * width;
    const x = width - 9.5;
    context.beginPath();
    context.moveTo(x - 4, y);
    context.lineTo(x, y);
    context.lineTo(x, y - tall);
    context.lineTo(x - 4, y - tall);
    context.stroke();
    const text = `${tickText(over)} ${unitOf('error')}`;
    context.fillText(text, x - 8 - context.measureText(text).width, y - tall / 2 + 4);
  }

  showTable(lens) {
    this.table.replaceChildren(
      ...lens.runs.map((through, k) =>
        el(
          'span',
          {},
          el('b', { style: { color: this.runs[k].colour } }, this.runs[k].letter),
          ` ${amountText(through.error, 'error')} · ${numberText(through.feed, 'feed')}`,
        ),
      ),
    );
  }

  /** Moves the cursor to the place of the shown run that is nearest to a click. */
  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = [event.clientX - box.left, event.clientY - box.top];
    const run = this.page.runs[this.store.get('run')];
    const { place } = run.whereAt(this.store.get('time'));
    const first = lastAtMost(run.place, place - seenWays * this.lens.width);
    const last = firstAtLeast(run.place, place + seenWays * this.lens.width);
    let best = null;
    let least = Infinity;
    for (let i = first; i < last; ++i) {
      for (let k = 0; k < 8; ++k) {
        const time = run.time[i] + ((run.time[i + 1] - run.time[i]) * k) / 8;
        const away = minus(run.at(time).position, this.lens.centre);
        const point = this.toPicture([dot(away, this.lens.along), dot(away, this.lens.across)], this.lens);
        const distance = Math.hypot(point[0] - at[0], point[1] - at[1]);
        if (distance < least) {
          least = distance;
          best = time;
        }
      }
    }
    if (best !== null) this.store.set({ time: best });
  }
}
