// Annotations of a session: labels beside their places of the path.

import { el } from './elements.js';

export class Annotations {
  constructor(page, store, view) {
    Object.assign(this, { page, store, view });
    this.labels = page.annotations.map((annotation) => {
      const label = el(
        'button',
        {
          class: `annotation ${annotation.kind}`,
          style: { color: annotation.colour, borderColor: annotation.colour },
          onclick: () => store.set({ time: annotation.time }),
        },
        annotation.text,
      );
      const line = el('div', { class: 'annotation-line', style: { background: annotation.colour } });
      view.host.append(line, label);
      return { annotation, label, line };
    });
  }

  /** At the places where the run of the page's first picture is. */
  place() {
    const run = this.page.runs[this.page.current];
    for (const { annotation, label, line } of this.labels) {
      const [x, y] = this.view.toScreen(run.at(annotation.time).position);
      const length = Math.hypot(annotation.right, annotation.down);
      const angle = Math.atan2(annotation.down, annotation.right);
      label.style.transform = `translate(${x + annotation.right}px, ${y + annotation.down}px) translate(-50%, -50%)`;
      line.style.width = `${length}px`;
      line.style.transform = `translate(${x}px, ${y}px) rotate(${angle}rad)`;
    }
  }
}
