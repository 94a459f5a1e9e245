// Which run to take: sentence, cycle time over contour error with a bound that can be dragged, the runs, and
// where the time of the one to take goes.

import { causeColour, causesOf } from './colouring.js';
import { el, lineSample, svg } from './elements.js';
import { amountText, clockText, inShownUnit, numberText, shareText, signedPercent, tickText, unitOf } from './numbers.js';
import { leadingRun, recommend, whyOnly } from './recommend.js';
import { tr } from './texts.js';

const width = 276;
const height = 162;
const mostCauses = 4; // that are named
const plot = { left: 48, right: width - 14, top: 24, bottom: height - 34 };

const errorText = (choice) =>
  choice.actual
    ? tr('actual contour error %1', amountText(choice.error, 'error'))
    : tr('contour error %1', amountText(choice.error, 'error'));

const onlyText = (why) =>
  ({
    'within-bound': () => tr('No other run keeps the bound.'),
    'within-bound-of-machine': () => tr("No other run with the machine's own model keeps the bound."),
    'of-machine': () => tr("No other run of the machine's own model can be taken."),
    possible: () => tr('No other run can be taken.'),
  })[why]();

/** {headline, rule}: the sentences of DecisionTexts; `withoutChoice`: that of runs none of which can be chosen. */
export function decisionTexts(runs, taken, within, withoutChoice) {
  const choices = runs.map((run) => run.choice);
  const names = runs.map((run) => `${run.letter} (${run.name})`);
  if (!taken) {
    const least = leadingRun(choices, within);
    if (least === null) return { headline: withoutChoice, rule: '' };
    return {
      headline: tr(
        'No run keeps a contour error of %1. The smallest is %2, with %3.',
        amountText(within, 'error'),
        amountText(choices[least].error, 'error'),
        names[least],
      ),
      rule: '',
    };
  }
  const choice = choices[taken.run];
  const name = names[taken.run];
  const time = clockText(choice.time);
  if (taken.reason === 'only') {
    return { headline: tr('%1: %2, %3.', name, time, errorText(choice)), rule: onlyText(whyOnly(choices, within)) };
  }
  if (taken.reason === 'no-difference') {
    return {
      headline: tr('No difference worth having: %1 takes %2, %3.', name, time, errorText(choice)),
      rule: tr('The cycle times differ by less than 1 %. No run has a smaller error.'),
    };
  }
  const otherModel = choices.some(
    (run) => run.other_model && run.lines_not_run <= choice.lines_not_run && run.time < choice.time,
  );
  return {
    headline: tr('%1: %2, %3 less than %4, %5.', name, time, shareText(taken.gainShare), names[taken.against], errorText(choice)),
    rule:
      (taken.reason === 'fastest'
        ? tr('The fastest run. None within 1 % of it has a smaller error.')
        : tr('The smallest error within 1 % of the fastest run.')) +
      (otherModel ? ' ' + tr("Runs with another model than their machine's own do not count.") : ''),
  };
}

/** Of a single run: DecisionTexts::single(). */
export function singleTexts(run) {
  const programmed = run.figures.programmed_time_s;
  const { time } = run.choice;
  const lost = time - programmed;
  const share = time > 0 ? Math.abs(lost) / time : 0;
  const error = errorText(run.choice);
  const headline =
    share < 1e-6
      ? tr('%1, as long as programmed; %2.', clockText(time), error)
      : lost > 0
        ? tr('%1, of which %2 are lost (%3); %4.', clockText(time), clockText(lost), shareText(share), error)
        : tr('%1, %2 less than programmed (%3); %4.', clockText(time), clockText(-lost), shareText(share), error);
  return { headline, rule: tr('Programmed: %1, at the programmed feed.', clockText(programmed)) };
}

/** DecisionTexts::against(): the cycle time of a run against that of another. */
export function againstText(run, other) {
  const possible = ({ competes, other_model }) => competes || other_model;
  const comparable =
    run !== other && possible(run) && possible(other) && other.time > 0 && run.lines_not_run === other.lines_not_run;
  return comparable ? tr('%1 %', signedPercent(run.time / other.time - 1)) : '\u2013';
}

export class Decide {
  constructor(page, store, host) {
    Object.assign(this, { page, store, host });
    this.runs = page.runs.filter((run) => run.moves);
    this.headline = el('h2', { 'aria-live': 'polite' });
    this.rule = el('p', { class: 'rule' });
    this.chart = svg('svg', { class: 'decision', viewBox: `0 0 ${width} ${height}` });
    this.table = el('table', { class: 'runs' });
    this.time = el('div', { class: 'time-use' });
    host.append(this.headline, this.rule);
    if (page.runs.length > 1) host.append(this.chart, this.table);
    host.append(this.time);
    this.findScale();
    store.on(['within', 'run', 'theme'], () => this.show());
    this.show();
  }

  findScale() {
    const times = this.runs.map((run) => run.choice.time);
    const errors = this.runs.map((run) => run.choice.error);
    const low = Math.min(...times);
    const high = Math.max(...times);
    const room = Math.max(high - low, high * 0.01) * 0.15;
    this.times = [low - room, high + room];
    this.most = 1.12 * Math.max(...errors, 1e-6);
  }

  x(error) {
    return plot.left + (error / this.most) * (plot.right - plot.left);
  }

  y(time) {
    const [low, high] = this.times;
    return plot.bottom - ((time - low) / (high - low)) * (plot.bottom - plot.top);
  }

  show() {
    if (this.page.runs.length === 1) {
      const texts = singleTexts(this.page.runs[0]);
      this.headline.textContent = texts.headline;
      this.rule.textContent = texts.rule;
      this.showTime(this.page.runs[0]);
      return;
    }
    const within = this.store.get('within');
    this.taken = recommend(this.page.runs.map((run) => run.choice), within);
    const texts = decisionTexts(this.page.runs, this.taken, within, this.page.without_choice);
    this.headline.textContent = texts.headline;
    this.rule.textContent = texts.rule;
    this.draw(within);
    this.showTable(within);
    const leading = leadingRun(this.page.runs.map((run) => run.choice), within);
    this.showTime(this.page.runs[leading ?? this.store.get('run')]);
  }

  /** A bar of what limits `run`, the longest named below, then the remarks on the run. */
  showTime(run) {
    const causes = run.moves ? causesOf(this.page, run) : [];
    const colour = ({ cause }) => ({ background: causeColour(this.page, cause) });
    const text = ({ cause, time }) => [this.page.causes[cause], clockText(time)];
    this.time.replaceChildren(
      el('h3', {}, tr('Where the time goes'), this.page.runs.length > 1 ? ` (${run.letter})` : ''),
      el(
        'div',
        { class: 'cause-bar' },
        ...causes.map((one) => el('i', { title: text(one).join(': '), style: { flexGrow: one.time, ...colour(one) } })),
      ),
      ...causes.slice(0, mostCauses).map((one) =>
        el('div', { class: 'cause' }, el('i', { style: colour(one) }), ...text(one).map((part) => el('span', {}, part)), el('span', {}, shareText(one.share))),
      ),
      ...run.remarks.map((text) => el('p', { class: 'rule' }, text)),
    );
  }

  draw(within) {
    this.chart.replaceChildren(...this.axes(), ...this.dots(within), this.boundLine(within));
  }

  axes() {
    const line = (attributes) => svg('line', { class: 'axis', ...attributes });
    const text = (x, y, content, anchor) => svg('text', { x, y, 'text-anchor': anchor }, content);
    const parts = [
      line({ x1: plot.left, x2: plot.right, y1: plot.bottom, y2: plot.bottom }),
      line({ x1: plot.left, x2: plot.left, y1: plot.top, y2: plot.bottom }),
    ];
    const [low, high] = this.times;
    for (const time of [low + 0.12 * (high - low), high - 0.12 * (high - low)]) {
      parts.push(text(plot.left - 4, this.y(time) + 3, clockText(time), 'end'));
    }
    const top = inShownUnit(this.most, 'error');
    const step = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].map((s) => s * 10 ** Math.floor(Math.log10(top) - 1)).find((s) => top / s <= 5);
    for (let tick = 0; tick <= top; tick += step) {
      parts.push(text(this.x(tick / inShownUnit(1, 'error')), plot.bottom + 12, tickText(tick), 'middle'));
    }
    const title = this.runs.some((run) => run.choice.actual) ? tr('Actual contour error') : tr('Contour error');
    parts.push(text((plot.left + plot.right) / 2, height - 4, `${title} (${unitOf('error')})`, 'middle'));
    parts.push(text(0, 9, tr('Cycle time'), 'start'));
    return parts;
  }

  dots(within) {
    const order = [...this.runs].sort((a, b) => a.choice.error - b.choice.error);
    const way = order.map((run) => `${this.x(run.choice.error)},${this.y(run.choice.time)}`).join(' ');
    const parts = [svg('polyline', { class: 'way', points: way })];
    for (const run of this.runs) {
      const place = { cx: this.x(run.choice.error), cy: this.y(run.choice.time) };
      const index = this.page.runs.indexOf(run);
      if (this.taken?.run === index) parts.push(svg('circle', { ...place, r: 9, class: 'taken', stroke: run.colour }));
      const beyond = within !== null && run.choice.error > within + 1e-9;
      parts.push(svg('circle', { ...place, r: 5, fill: run.colour, class: beyond ? 'dot beyond' : 'dot', onclick: () => this.choose(index) }));
    }
    return parts.concat(this.letters());
  }

  /** Runs at nearly one place have one label: "C D". */
  letters() {
    const near = 9; // [pixels]
    const labels = [];
    for (const run of this.runs) {
      const [x, y] = [this.x(run.choice.error) + 8, this.y(run.choice.time) - 7];
      const same = labels.find((label) => Math.hypot(label.x - x, label.y - y) < near);
      if (same) same.text += ` ${run.letter}`;
      else labels.push({ x, y, text: run.letter });
    }
    return labels.map(({ text, ...place }) => svg('text', { ...place, class: 'label' }, text));
  }

  /** The bound can be dragged, by keys too; without one its line waits at the right end. */
  boundLine(within) {
    const x = within === null ? plot.right : Math.min(this.x(within), plot.right);
    const label =
      within === null ? tr('no bound') : tr('bound %1', amountText(within, 'error'));
    const left = x > (plot.left + plot.right) / 2;
    const handle = svg(
      'g',
      {
        class: 'bound',
        tabindex: 0,
        role: 'slider',
        'aria-label': tr('Max. error'),
        'aria-valuemin': 0,
        'aria-valuemax': inShownUnit(this.most, 'error').toFixed(1),
        'aria-valuenow': inShownUnit(within ?? this.most, 'error').toFixed(1),
        'aria-valuetext': label,
      },
      svg('line', { x1: x, x2: x, y1: plot.top - 6, y2: plot.bottom }),
      svg('rect', { x: x - 10, y: plot.top - 8, width: 20, height: plot.bottom - plot.top + 8, class: 'grip' }),
      svg('text', { x: left ? x - 5 : x + 5, y: plot.top, 'text-anchor': left ? 'end' : 'start' }, label),
    );
    handle.addEventListener('pointerdown', (event) => this.drag(event));
    handle.addEventListener('keydown', (event) => this.step(event, within));
    this.handle = handle;
    return handle;
  }

  errorAt(event) {
    const box = this.chart.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * width;
    const error = ((x - plot.left) / (plot.right - plot.left)) * this.most;
    const fine = this.most / 200;
    return x >= plot.right - 2 ? null : Math.max(fine, Math.round(error / fine) * fine);
  }

  drag(event) {
    event.preventDefault();
    const move = (moved) => this.store.set({ within: this.errorAt(moved) });
    const end = () => {
      window.removeEventListener('pointermove', move);
      window.removeEventListener('pointerup', end);
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', end);
  }

  step(event, within) {
    const ways = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1 };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    const next = (within ?? this.most) + (way * this.most) / 50;
    this.store.set({ within: next >= this.most ? null : Math.max(this.most / 200, next) });
    requestAnimationFrame(() => requestAnimationFrame(() => this.handle.focus()));
  }

  choose(index) {
    this.store.get('chooseRun')(index);
  }

  showTable(within) {
    const against = this.taken?.against ?? 0;
    const head = [tr('Run'), '', tr('Time'), tr('Against %1', this.page.runs[against].letter), tr('Error %1', unitOf('error'))];
    const rows = this.page.runs.map((run, index) => {
      const { choice } = run;
      const beyond = within !== null && choice.error > within + 1e-9;
      const current = this.store.get('run') === index;
      const classes = [current && 'current', this.taken?.run === index && 'taken', beyond && 'beyond'];
      const cells = run.moves
        ? [clockText(choice.time), againstText(choice, this.page.runs[against].choice), numberText(choice.error, 'error')]
        : [tr('refused'), '', ''];
      return el(
        'tr',
        { class: classes.filter(Boolean).join(' '), tabindex: run.moves ? 0 : null, 'aria-current': current ? 'true' : null,
          onclick: () => run.moves && this.choose(index),
          onkeydown: (event) => event.key === 'Enter' && run.moves && this.choose(index) },
        el('td', {}, `${run.letter} `, el('span', { class: 'name' }, run.name)),
        el('td', {}, lineSample(run)),
        ...cells.map((cell) => el('td', { class: 'number' }, cell)),
      );
    });
    this.table.replaceChildren(
      el('thead', {}, el('tr', {}, ...head.map((text, k) => el('th', { class: k > 1 ? 'number' : null }, text)))),
      el('tbody', {}, ...rows),
    );
  }
}
