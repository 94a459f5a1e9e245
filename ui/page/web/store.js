// What all views of the page share; a view is told of the names that it follows.

export class Store {
  constructor(values) {
    this.values = values;
    this.listeners = [];
    this.changed = new Set();
  }

  get(name) {
    return this.values[name];
  }

  /** Calls `listener` once a frame in which one of `names` has changed. */
  on(names, listener) {
    this.listeners.push({ names, listener });
  }

  set(changes) {
    let any = false;
    for (const [name, value] of Object.entries(changes)) {
      if (this.values[name] !== value) {
        this.values[name] = value;
        this.changed.add(name);
        any = true;
      }
    }
    if (any && !this.waiting) {
      this.waiting = true;
      requestAnimationFrame(() => this.tell());
    }
  }

  tell() {
    this.waiting = false;
    const changed = this.changed;
    this.changed = new Set();
    for (const { names, listener } of this.listeners) {
      if (names.some((name) => changed.has(name))) listener();
    }
  }
}
