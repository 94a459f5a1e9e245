// Run, cursor, colours, range and camera in the fragment of the address, so that a link leads to a place.

const decimals = 4;

export function readAddress(page) {
  const parts = new URLSearchParams(window.location.hash.slice(1));
  const number = (name) => {
    const value = parts.get(name);
    return value !== null && Number.isFinite(Number(value)) ? Number(value) : null;
  };
  const run = page.runs.findIndex((one) => one.letter === parts.get('run') && one.moves);
  const range = (parts.get('range') ?? '').split(',').map(Number);
  return {
    run: run >= 0 ? run : null,
    time: number('t'),
    colour: parts.get('colour'),
    within: number('within'),
    camera: parts.get('camera'),
    range: range.length === 2 && range[1] > range[0] ? range : null,
  };
}

export function keepAddress(page, store) {
  let waiting = null;
  const write = () => {
    waiting = null;
    const parts = new URLSearchParams();
    parts.set('run', page.runs[store.get('run')].letter);
    parts.set('t', store.get('time').toFixed(decimals));
    parts.set('colour', store.get('colour'));
    if (store.get('within') !== null) parts.set('within', store.get('within').toFixed(6));
    if (store.get('range')) parts.set('range', store.get('range').map((end) => end.toFixed(decimals)).join());
    if (store.get('camera')) parts.set('camera', store.get('camera'));
    try {
      window.history.replaceState(null, '', `#${parts.toString().replaceAll('%2C', ',')}`);
    } catch {
      // Some browsers keep the address of a local file as it is.
    }
  };
  store.on(['run', 'time', 'colour', 'range', 'camera', 'within'], () => {
    waiting ??= setTimeout(write, 300);
  });
}
