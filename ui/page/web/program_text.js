// The program's text around the cursor, with the time that each line loses.

import { el } from './elements.js';
import { gainText } from './numbers.js';
import { tr } from './texts.js';

const rowHeight = 18;

export class ProgramText {
  constructor(page, store, host) {
    Object.assign(this, { page, store, host });
    this.lines = page.program.text.split('\n');
    if (this.lines[this.lines.length - 1] === '') this.lines.pop();
    this.space = el('div', { class: 'text-space', style: { height: `${this.lines.length * rowHeight}px` } });
    this.list = el('div', { class: 'text-scroll', tabindex: 0, role: 'list', 'aria-label': tr('Program') }, this.space);
    host.append(this.list);
    this.list.addEventListener('scroll', () => this.show());
    this.space.addEventListener('pointermove', (event) => {
      if (event.pointerType !== 'touch' && !store.get('playing')) this.pick(event);
    });
    this.space.addEventListener('click', (event) => this.pick(event));
    new ResizeObserver(() => this.follow()).observe(host);
    store.on(['run'], () => this.measure());
    store.on(['time', 'run'], () => this.follow());
    this.measure();
  }

  get run() {
    return this.page.runs[this.store.get('run')];
  }

  measure() {
    this.lost = this.run.lostByLine();
    this.most = Math.max(1e-9, ...[...this.lost.values()].slice(0, 100000));
  }

  follow() {
    this.line = this.run.at(this.store.get('time')).line;
    if (!this.hovered) {
      const top = (this.line - 1) * rowHeight;
      const { clientHeight, scrollTop } = this.list;
      if (top < scrollTop + 2 * rowHeight || top > scrollTop + clientHeight - 3 * rowHeight) {
        this.list.scrollTop = Math.max(0, top - clientHeight / 2);
      }
    }
    this.hovered = false;
    this.show();
  }

  show() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / rowHeight) - 2);
    const last = Math.min(this.lines.length, first + Math.ceil(this.list.clientHeight / rowHeight) + 4);
    const rows = [];
    for (let i = first; i < last; ++i) rows.push(this.row(i + 1));
    this.space.replaceChildren(...rows);
  }

  row(line) {
    const lost = this.lost.get(line) ?? 0;
    const bar =
      lost > 1e-3
        ? el('i', { class: 'bar', style: { opacity: String(0.15 + 0.85 * Math.sqrt(lost / this.most)) }, title: tr('%1 lost here', gainText(lost)) })
        : null;
    return el(
      'div',
      {
        class: line === this.line ? 'row here' : 'row',
        role: 'listitem',
        'data-line': line,
        style: { top: `${(line - 1) * rowHeight}px` },
      },
      bar,
      el('span', { class: 'line-number' }, String(line)),
      el('code', {}, this.lines[line - 1]),
    );
  }

  pick(event) {
    const line = Number(event.target.closest('.row')?.dataset.line);
    if (!line || line === this.line) return;
    this.hovered = true;
    this.store.set({ time: this.run.timeOfLine(line) });
  }
}
