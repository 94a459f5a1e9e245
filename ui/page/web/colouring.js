// Colours of the nodes of a run, and the scale that explains them.

import { kinds } from './page_data.js';
import { inShownUnit, roundUp, tickText, unitOf } from './numbers.js';
import { tr } from './texts.js';

// Share of the path beyond the ends of the scale: a stop loses much time on little path.
const beyondScale = { error: 0.003, lost: 0.03 };

const rgbOf = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

export const isDark = () => window.matchMedia('(prefers-color-scheme: dark)').matches;

/** Height of the labels of charts and lens: on a phone that of the page's text, by the width of style.css [pixels]. */
export const labelHeight = () => (window.matchMedia('(max-width: 760px)').matches ? 14 : 11);
export const labelFont = () => `${labelHeight()}px "DejaVu Sans", Verdana, sans-serif`;

export const colourings = () => [
  ['feed', tr('Feed')],
  ['cause', tr('Limiting cause')],
  ['error', tr('Contour error')],
  ['lost', tr('Time lost')],
];

/** Value that is exceeded on a `share` of the length of what is cut. */
function topOf(run, values, share) {
  const spans = [];
  let whole = 0;
  for (let i = 0; i + 1 < run.count; ++i) {
    const length = run.length[i + 1] - run.length[i];
    if (run.kind[i] === kinds.cut && length > 0) {
      spans.push([Math.abs(values[i]), length]);
      whole += length;
    }
  }
  spans.sort((a, b) => b[0] - a[0]);
  let beyond = 0;
  for (const [value, length] of spans) {
    beyond += length;
    if (beyond > share * whole) return value;
  }
  return 0;
}

/** Time lost against `other` per programmed length, from each node to the next [s/mm]. */
function paceOf(run, other) {
  const lost = run.lostAgainst(other);
  const pace = new Float64Array(run.count);
  for (let i = 0; i + 1 < run.count; ++i) {
    let end = i + 1;
    while (end + 1 < run.count && run.place[end] - run.place[i] < 2e-3) ++end;
    const length = run.place[end] - run.place[i];
    pace[i] = length > 0 ? (lost[end] - lost[i]) / length : 0;
  }
  return pace;
}

function shareOfScale(colouring, value, scale) {
  return colouring === 'lost' ? (value / scale + 1) / 2 : value / scale;
}

/**
 * What the path of `run` is coloured by: {colours: bytes of three a node, scale, causes}. `scale`: {low, high,
 * unit, colours} in the unit shown, null for causes; `causes`: causesOf().
 */
export function colouredPath(page, run, colouring, reference) {
  const theme = page.colours[isDark() ? 'dark' : 'light'];
  const colours = new Uint8Array(3 * run.count);
  if (colouring === 'cause') {
    const table = theme.causes.map(rgbOf);
    for (let i = 0; i < run.count; ++i) colours.set(table[run.cause[i]], 3 * i);
    return { colours, scale: null, causes: causesOf(page, run) };
  }
  const values =
    colouring === 'feed' ? run.speed : colouring === 'error' ? run.error : paceOf(run, reference);
  const dimension = { feed: 'feed', error: 'error', lost: 'pace' }[colouring];
  const top = colouring === 'feed' ? run.top_feed : topOf(run, values, beyondScale[colouring]);
  const shownTop = roundUp(inShownUnit(top, dimension));
  const scale = shownTop / inShownUnit(1, dimension);
  const table = (colouring === 'lost' ? theme.lost : theme.feed).map(rgbOf);
  const last = table.length - 1;
  for (let i = 0; i < run.count; ++i) {
    const share = shareOfScale(colouring, values[i], scale);
    colours.set(table[Math.round(last * Math.min(1, Math.max(0, share)))], 3 * i);
  }
  return {
    colours,
    scale: {
      low: colouring === 'lost' ? -shownTop : 0,
      high: shownTop,
      unit: unitOf(dimension),
      colours: colouring === 'lost' ? theme.lost : theme.feed,
    },
    causes: null,
  };
}

/** What limits a run, as `simulate --json` says it: [{cause, time, share}] [s], the longest first. */
export function causesOf(page, run) {
  return page.cause_keys
    .map((key, cause) => ({ cause, time: run.figures.time_by_cause_s[key] ?? 0 }))
    .filter(({ time }) => time > 0)
    .map((one) => ({ ...one, share: one.time / run.figures.cycle_time_s }))
    .sort((a, b) => b.time - a.time);
}

export const scaleTicks = ({ low, high }) =>
  [low, (low + high) / 2, high].map((number) => tickText(number));

export const causeColour = (page, cause) => page.colours[isDark() ? 'dark' : 'light'].causes[cause];
