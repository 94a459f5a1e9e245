// Playing the run at true speed and faster.

import { el } from './elements.js';
import { clockText } from './numbers.js';
import { tr } from './texts.js';

const speeds = [0.1, 1, 2, 5, 10, 50];

export class Player {
  constructor(page, store, host) {
    Object.assign(this, { page, store, host });
    this.button = el('button', { id: 'play', onclick: () => this.toggle() });
    this.slider = el('input', {
      type: 'range',
      min: 0,
      max: 1,
      step: 'any',
      'aria-label': tr('Time'),
      oninput: () => store.set({ time: Number(this.slider.value) * this.run.duration, playing: false }),
    });
    this.speed = el(
      'select',
      { 'aria-label': tr('Speed'), onchange: () => store.set({ speed: Number(this.speed.value) }) },
      ...speeds.map((speed) => el('option', { value: speed, selected: speed === 1 }, `× ${speed}`)),
    );
    this.clock = el('output', {});
    host.append(this.button, this.slider, this.clock, this.speed);
    store.on(['time', 'run'], () => this.show());
    store.on(['playing'], () => this.showButton());
    this.show();
    this.showButton();
  }

  get run() {
    return this.page.runs[this.store.get('run')];
  }

  show() {
    const time = this.store.get('time');
    this.slider.value = time / this.run.duration;
    this.clock.textContent = `${clockText(time)} / ${clockText(this.run.duration)}`;
  }

  showButton() {
    const playing = this.store.get('playing');
    this.button.textContent = playing ? '❚❚' : '▶';
    this.button.setAttribute('aria-label', playing ? tr('Pause') : tr('Play'));
    this.button.title = playing ? tr('Pause') : tr('Play');
  }

  toggle() {
    const { store } = this;
    if (store.get('playing')) {
      store.set({ playing: false });
      return;
    }
    const atEnd = store.get('time') >= this.run.duration;
    store.set({ playing: true, time: atEnd ? 0 : store.get('time') });
    let last = performance.now();
    const step = (now) => {
      if (!store.get('playing')) return;
      const time = store.get('time') + ((now - last) / 1000) * store.get('speed');
      last = now;
      store.set({ time: Math.min(time, this.run.duration), playing: time < this.run.duration });
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}
