// The interactive view on top of a report: reads the data of the page and joins the views.

import chartStyle from 'uplot/dist/uPlot.min.css';
import { keepAddress, readAddress } from './address.js';
import { Charts } from './charts.js';
import { colourings } from './colouring.js';
import { Decide } from './decide.js';
import { el } from './elements.js';
import { LensView } from './lens.js';
import { amountText, numberText, shareText, unitOf, useNumbers } from './numbers.js';
import { kinds, readPage } from './page_data.js';
import { PathView, pathCaption } from './path_view.js';
import { Places } from './places.js';
import { Player } from './player.js';
import { ProgramText } from './program_text.js';
import { Store } from './store.js';
import style from './style.css';
import { tr, useTexts } from './texts.js';

const mostRapids = 200; // that are shown without being asked for

function otherRun(page, run) {
  const other = page.runs.findIndex((one, index) => index !== run && one.moves);
  return other >= 0 ? other : run;
}

function firstState(page) {
  const asked = readAddress(page);
  const moving = page.runs.findIndex((run) => run.moves);
  const run = asked.run ?? (page.runs[page.current].moves ? page.current : moving);
  const isCut = (place) => page.runs[run].at(place.at).kind === kinds.cut;
  const [worst] = [...page.runs[run].places].sort((a, b) => isCut(b) - isCut(a) || b.loss - a.loss);
  const { duration } = page.runs[run];
  const inRun = (time) => Math.min(Math.max(time, 0), duration);
  const range = asked.range?.map(inRun);
  const known = colourings().map(([name]) => name);
  const rapids = page.runs[run].kind.reduce((count, kind) => count + (kind === kinds.rapid), 0);
  return new Store({
    run,
    time: inRun(asked.time ?? worst?.at ?? 0),
    colour: known.includes(asked.colour) ? asked.colour : 'feed',
    reference: otherRun(page, run),
    axis: 'time',
    range: range?.[0] < range?.[1] ? range : null,
    within: asked.within > 0 && asked.within < 1e3 ? asked.within : page.within,
    wantedCamera: asked.camera,
    camera: null,
    rapids: rapids < mostRapids,
    showProgrammed: true,
    lens: page.runs.length > 1,
    playing: false,
    speed: 1,
    theme: 0,
    goTo: null,
  });
}

/** Another run at the same place of the program. */
function chooseRun(page, store, index) {
  const { place, share } = page.runs[store.get('run')].whereAt(store.get('time'));
  const reference = store.get('reference') === index ? otherRun(page, index) : store.get('reference');
  store.set({ run: index, reference, time: page.runs[index].timeAtPlace(place, share), range: null });
}

const button = (text, title, onclick, id) => el('button', { title, onclick, id }, text);

function toggle(store, name, text, title) {
  const made = el('button', { title, id: name, class: 'toggle', onclick: () => store.set({ [name]: !store.get(name) }) }, text);
  const show = () => made.setAttribute('aria-pressed', String(store.get(name)));
  store.on([name], show);
  show();
  return made;
}

function choice(store, name, title, options) {
  const made = el(
    'select',
    { id: name, 'aria-label': title, title },
    ...options.map(([value, text]) => el('option', { value }, text)),
  );
  const show = () => {
    made.value = store.get(name);
  };
  store.on([name], show);
  show();
  return made;
}

function colourChoice(page, store) {
  const several = page.runs.filter((run) => run.moves).length > 1;
  const colour = choice(store, 'colour', tr('Colour'), colourings().filter(([name]) => several || name !== 'lost'));
  colour.onchange = () => store.set({ colour: colour.value });
  const against = choice(
    store,
    'reference',
    tr('Against'),
    page.runs.map((run, index) => [index, `${tr('against %1', run.letter)} (${run.name})`]),
  );
  against.onchange = () => store.set({ reference: Number(against.value) });
  const show = () => {
    against.hidden = store.get('colour') !== 'lost';
    [...against.options].forEach((option, index) => {
      option.hidden = index === store.get('run') || !page.runs[index].moves;
    });
  };
  store.on(['colour', 'run'], show);
  show();
  return [colour, against];
}

function runChoice(page, store) {
  const made = choice(
    store,
    'run',
    tr('Run'),
    page.runs.map((run, index) => [index, page.runs.length > 1 ? `${run.letter} (${run.name})` : run.full_name]),
  );
  [...made.options].forEach((option, index) => {
    option.disabled = !page.runs[index].moves;
  });
  made.onchange = () => chooseRun(page, store, Number(made.value));
  return made;
}

/** Of a long program nodes are left out. */
const rotaryPrecision = (run) => Math.max(0, ...run.rotary.map(({ precision }) => precision));
const isCoarse = (run) =>
  run.precision.position > 1.5e-3 || run.precision.speed > 1.5e-3 * run.top_feed || rotaryPrecision(run) > 0.015;

/** "path within 1 µm, feed within 0.1 %" of the run. */
function precisionText(run) {
  const text = [
    amountText(run.precision.position, 'error'),
    shareText(run.precision.speed / (run.top_feed || 1)),
  ];
  const path = isCoarse(run)
    ? tr('Long program, drawn coarser away from the listed places: path within %1, feed within %2 of the largest', ...text)
    : tr('Path within %1, feed within %2 of the largest', ...text);
  const turning = rotaryPrecision(run);
  return turning > 0 ? `${path}, ${tr('rotary axes within %1 of their limits', shareText(turning))}` : path;
}

function about(page) {
  const close = () => dialog.close();
  const dialog = el(
    'dialog',
    { 'aria-label': tr('About this page') },
    el('h2', {}, tr('About this page')),
    el('p', {}, tr('Made with Feedscope %1. Simulated, not measured.', page.version)),
    el('p', {}, tr('All data is in this file; it asks no other one and no network.')),
    el('p', {}, tr('Drag: turn. Right button or two fingers: move. Wheel or pinch: zoom. Double click: fit. In charts drag to move, wheel or pinch to zoom. Space plays, N and P go to the next and previous worst place, F fits, arrows move the cursor.')),
    ...page.licences.map(({ name, text }) => el('details', {}, el('summary', {}, name), el('pre', {}, text))),
    el('button', { onclick: close }, tr('Close')),
  );
  return dialog;
}

function statusLine(page, store) {
  const left = el('span', {});
  const middle = el('span', { class: 'precision' });
  const right = el('span', { class: 'number' });
  const show = () => {
    const run = page.runs[store.get('run')];
    left.textContent = pathCaption(page, run);
    middle.textContent = precisionText(run);
    middle.classList.toggle('coarse', isCoarse(run));
    const state = run.at(store.get('time'));
    const [x, y, z] = state.position.map((value) => numberText(value, 'length'));
    right.textContent = `${numberText(state.time, 'time')} s · ${tr('Line %1', state.line)} · X ${x} Y ${y} Z ${z} ${unitOf('length')}`;
  };
  store.on(['time', 'run'], show);
  show();
  return el('footer', {}, left, middle, right);
}

/** Where no 3D can be drawn the report's picture of the path, its first bitmap, stands in. */
function pictureOf(report) {
  const image = report.querySelector('img[src^="data:image/png"]') ?? report.querySelector('img');
  return el(
    'figure',
    { class: 'picture' },
    image ? el('img', { src: image.src, alt: image.alt }) : null,
    el('figcaption', {}, tr('This browser draws no 3D (WebGL 2): a picture of the report.')),
  );
}

/** The path in 3D in `stage`, or a picture of the report; null then. */
function pathIn(stage, page, store, report) {
  try {
    return new PathView(page, store, stage);
  } catch {
    stage.prepend(pictureOf(report));
    return null;
  }
}

function viewButtons(view) {
  if (!view) return [];
  const names = [
    ['iso', tr('Iso')],
    ['top', tr('Top')],
    ['front', tr('Front')],
    ['right', tr('Right')],
  ];
  return [
    button(tr('Fit'), tr('Fit the path into the picture (F)'), () => view.fit(), 'fit'),
    ...names.map(([name, text]) => button(text, tr('Look from here'), () => view.look(name), `look-${name}`)),
  ];
}

function listenToKeys(page, store, view, places, player) {
  const steps = { ArrowLeft: -1, ArrowRight: 1 };
  const keys = {
    ' ': () => player.toggle(),
    n: () => places.step(1),
    p: () => places.step(-1),
    f: () => view?.fit(),
    l: () => store.set({ lens: !store.get('lens') }),
  };
  return (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.composedPath()[0];
    if (/^(SELECT|INPUT|BUTTON|SUMMARY)$/.test(target.tagName) || target.closest?.('[role=slider]')) return;
    if (steps[event.key]) {
      const run = page.runs[store.get('run')];
      const [from, to] = store.get('range') ?? [0, run.duration];
      const time = store.get('time') + (steps[event.key] * (store.get('axis') === 'time' ? to - from : run.duration)) / 500;
      store.set({ time: Math.min(run.duration, Math.max(0, time)) });
    } else if (keys[event.key.toLowerCase()]) {
      keys[event.key.toLowerCase()]();
    } else {
      return;
    }
    event.preventDefault();
  };
}

/** Everything that was in the page becomes the report below the view. */
function reportBelow() {
  const report = el('main', { id: 'feedscope-report' });
  report.append(...[...document.body.childNodes].filter((node) => node.nodeName !== 'SCRIPT'));
  const host = el('div', { id: 'feedscope-view' });
  document.head.append(
    el(
      'style',
      {},
      'body { max-width: none; margin: 0; padding: 0; }',
      '#feedscope-report { max-width: 720px; margin: 32px auto; padding: 0 16px; }',
      '@media print { #feedscope-view { display: none; } #feedscope-report { max-width: none; margin: 0; padding: 0; } }',
    ),
  );
  document.body.prepend(host, report);
  // A view that is wider than the screen begins in its middle, where the path is; charts at their ordinates.
  for (const view of report.querySelectorAll('td img[src^="data:image/png"]')) {
    const frame = view.closest('td');
    frame.scrollLeft = (frame.scrollWidth - frame.clientWidth) / 2;
  }
  return { host, report };
}

function start(page) {
  useTexts(page.texts);
  useNumbers(page.decimal, page.units);
  const store = firstState(page);
  store.set({ chooseRun: (index) => chooseRun(page, store, index) });
  const { host, report } = reportBelow();
  const root = host.attachShadow({ mode: 'open' });
  root.append(el('style', {}, chartStyle, style));

  const part = (name) => el('section', { class: name });
  const [text, stage, lens, charts, playing, decide, places] = [
    'text', 'stage', 'lens', 'charts', 'player', 'decide', 'why-here',
  ].map(part);
  const tools = el('div', { class: 'tools' });
  const header = el(
    'header',
    {},
    el('h1', {}, page.title),
    runChoice(page, store),
    colourChoice(page, store),
    tools,
  );
  const app = el(
    'div',
    { class: 'app', lang: page.language },
    header,
    text,
    stage,
    charts,
    playing,
    el('aside', {}, decide, places),
  );
  root.append(app);
  stage.append(lens);
  const view = pathIn(stage, page, store, report);
  const axis = choice(store, 'axis', tr('Charts over'), [['time', tr('over time')], ['place', tr('over path')]]);
  axis.onchange = () => store.set({ axis: axis.value, range: null });
  const dialog = about(page);
  root.append(dialog);
  tools.append(
    ...viewButtons(view),
    toggle(store, 'rapids', tr('Rapids'), tr('Show rapids')),
    toggle(store, 'showProgrammed', tr('Programmed'), tr('Show the programmed path')),
    toggle(store, 'lens', tr('Lens'), tr('Show the lens (L)')),
    axis,
    button(tr('Report'), tr('Go to the report below'), () => report.scrollIntoView({ behavior: 'smooth' }), 'report'),
    button('?', tr('About this page'), () => dialog.showModal(), 'about'),
  );
  const showLens = () => {
    lens.hidden = !store.get('lens');
  };
  store.on(['lens'], showLens);
  showLens();
  new ProgramText(page, store, text);
  new LensView(page, store, lens);
  new Charts(page, store, charts);
  const player = new Player(page, store, playing);
  new Decide(page, store, decide);
  const worst = new Places(page, store, places);
  app.append(statusLine(page, store));
  store.on(['goTo'], () => view?.show(store.get('goTo').time, view.size / 5));
  keepAddress(page, store);
  document.addEventListener('keydown', listenToKeys(page, store, view, worst, player));
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => store.set({ theme: store.get('theme') + 1 }));
  window.feedscope = { page, store, view };
}

Promise.all(window.feedscopeParts).then(([data, licences]) => {
  const page = readPage(data);
  page.licences = JSON.parse(new TextDecoder().decode(licences));
  if (page.runs.some((run) => run.moves)) start(page);
});
