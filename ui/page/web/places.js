// Why here? and the places that lose most.

import { el } from './elements.js';
import { causeColour } from './colouring.js';
import { amountText, changeText, gainText, numberText, shareText, unitOf } from './numbers.js';
import { kinds } from './page_data.js';
import { tr } from './texts.js';

/** What limits the run at a state, in a sentence with its numbers; `place`: of run.places, or null. */
export function whyText(page, state, place) {
  const cause = page.causes[state.cause];
  if (state.kind === kinds.pause) return tr('%1: the axes stand.', cause);
  const feed = numberText(state.speed, 'feed');
  const asked = `${numberText(state.feed, 'feed')} ${unitOf('feed')}`;
  const here = tr('%1: %2 of %3 (%4).', cause, feed, asked, shareText(state.speed / (state.feed || 1)));
  return place ? `${here} ${place.why}` : here;
}

export const placeAt = (run, time) =>
  run.places.find((place) => place.from <= time && time <= place.to) ?? null;

export class Places {
  constructor(page, store, host) {
    Object.assign(this, { page, store, host });
    this.title = el('h3', {}, tr('Why here?'));
    this.sentence = el('p', { class: 'why', 'aria-live': 'off' });
    this.lost = el('p', { class: 'rule' });
    this.rank = el('span', { class: 'rank' });
    const step = (way) => () => this.step(way);
    this.list = el('div', { class: 'places' });
    host.append(
      this.title,
      this.sentence,
      this.lost,
      el(
        'div',
        { class: 'stepper' },
        el('button', { id: 'previous-place', onclick: step(-1), title: tr('Previous worst place') }, '\u2039'),
        this.rank,
        el('button', { id: 'next-place', onclick: step(1), title: tr('Next worst place') }, '\u203a'),
      ),
      el('h3', { class: 'list-title' }, tr('Places that lose most')),
      this.list,
    );
    store.on(['time', 'run'], () => this.show());
    store.on(['run', 'theme'], () => this.showList());
    this.showList();
    this.show();
  }

  get run() {
    return this.page.runs[this.store.get('run')];
  }

  get worst() {
    return [...this.run.places].sort((a, b) => b.loss - a.loss);
  }

  show() {
    const { run } = this;
    const time = this.store.get('time');
    const state = run.at(time);
    const place = placeAt(run, time);
    this.sentence.textContent = whyText(this.page, state, place);
    const details = [
      tr('Line %1', state.line),
      tr('contour error %1', amountText(state.error, 'error')),
    ];
    if (place) details.push(tr('%1 lost here', gainText(place.loss)));
    this.lost.textContent = details.join(' · ');
    const rank = place ? this.worst.indexOf(place) : -1;
    this.rank.textContent =
      rank >= 0
        ? tr('place %1 of %2', rank + 1, run.places.length)
        : tr('%1 places', run.places.length);
  }

  step(way) {
    const { worst } = this;
    if (worst.length === 0) return;
    const place = placeAt(this.run, this.store.get('time'));
    const rank = place ? worst.indexOf(place) + way : way > 0 ? 0 : worst.length - 1;
    this.go(worst[(rank + worst.length) % worst.length]);
  }

  go(place) {
    this.store.set({ time: place.at, goTo: { time: place.at } });
  }

  showList() {
    const longest = this.worst[0]?.loss ?? 1;
    this.list.replaceChildren(
      ...this.worst.slice(0, 8).map((place) =>
        el(
          'button',
          { class: 'place', onclick: () => this.go(place) },
          el('i', { style: { width: `${(60 * place.loss) / longest}%`, background: causeColour(this.page, place.cause) } }),
          el('span', { class: 'cause' }, this.page.causes[place.cause]),
          el('span', { class: 'number' }, `${tr('Line %1', place.line)}  ${changeText(place.loss)}`),
        ),
      ),
    );
  }
}
