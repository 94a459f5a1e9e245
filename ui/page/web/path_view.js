// The path in 3D: three.js with parallel projection, drawn when something has changed.

import {
  BufferGeometry,
  ColorManagement,
  Float32BufferAttribute,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  LinearSRGBColorSpace,
  MOUSE,
  OrthographicCamera,
  Scene,
  TOUCH,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { Annotations } from './annotations.js';
import { colouredPath, causeColour, scaleTicks } from './colouring.js';
import { el, themeColour } from './elements.js';
import { clockText, inShownUnit, roundUp, shareText, tickText, unitOf } from './numbers.js';
import { kinds } from './page_data.js';
import { tr } from './texts.js';

ColorManagement.enabled = false; // colours are as they are shown

const mostWhileTurning = 40000; // segments
const reach = 24; // of the pointer [pixels]
const margin = 0.06;
const lensWidth = 220; // [pixels]

const directions = {
  iso: [1, -1, 1],
  top: [0, 0, 1],
  front: [0, -1, 0],
  right: [1, 0, 0],
};

/** Segments of a run by nodes [from, to] whose kind is `wanted`; short ones left out below `spacing`. */
function segmentsOf(run, wanted, spacing) {
  const pairs = [];
  const [x, y, z] = run.positions;
  let from = -1;
  for (let i = 0; i + 1 < run.count; ++i) {
    if (run.kind[i] !== wanted) {
      from = -1;
      continue;
    }
    if (from < 0) from = i;
    const end = i + 1;
    const goesOn = end + 1 < run.count && run.kind[end] === wanted;
    const length = Math.hypot(x[end] - x[from], y[end] - y[from], z[end] - z[from]);
    if (length > spacing || (!goesOn && length > 0)) {
      pairs.push(from, end);
      from = end;
    }
  }
  return pairs;
}

export class PathView {
  constructor(page, store, host) {
    this.page = page;
    this.store = store;
    this.host = host;
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.canvas = this.renderer.domElement;
    this.canvas.setAttribute('aria-label', tr('Path'));
    this.canvas.setAttribute('role', 'img');
    this.marker = el('div', { class: 'marker' });
    this.key = el('div', { class: 'key' });
    this.scaleBar = el('div', { class: 'scale-bar' }, el('i'), el('span'));
    host.prepend(this.canvas, this.marker, this.key, this.scaleBar);
    this.scene = new Scene();
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -1e6, 1e6);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    Object.assign(this.controls, {
      zoomToCursor: true,
      enableDamping: false,
      mouseButtons: { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN },
      touches: { ONE: TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN },
    });
    this.findBounds();
    this.material = new LineMaterial({ linewidth: 2.5, vertexColors: true });
    this.build();
    this.annotations = new Annotations(page, store, this);
    this.follow();
    this.look('iso');
  }

  follow() {
    const { store } = this;
    this.controls.addEventListener('change', () => {
      this.screen = null;
      this.draw();
      store.set({ camera: this.cameraText() });
    });
    this.controls.addEventListener('start', () => {
      this.fitted = false;
      this.turn(true);
    });
    this.controls.addEventListener('end', () => this.turn(false));
    new ResizeObserver(() => this.resize()).observe(this.host);
    store.on(['run', 'colour', 'reference', 'rapids', 'theme'], () => this.build());
    store.on(['showProgrammed'], () => {
      this.programmed.visible = store.get('showProgrammed');
      this.draw();
    });
    store.on(['time', 'run'], () => this.place());
    this.canvas.addEventListener('pointermove', (event) => this.hover(event));
    this.canvas.addEventListener('pointerdown', (event) => {
      this.pressed = [event.clientX, event.clientY];
    });
    this.canvas.addEventListener('pointerup', (event) => {
      const [x, y] = this.pressed ?? [1e9, 1e9];
      if (Math.hypot(event.clientX - x, event.clientY - y) < 5) this.pick(event);
      this.pressed = null;
    });
    this.canvas.addEventListener('dblclick', () => this.fit());
  }

  get run() {
    return this.page.runs[this.store.get('run')];
  }

  findBounds() {
    const low = [Infinity, Infinity, Infinity];
    const high = low.map((value) => -value);
    const { positions, kind } = this.run;
    positions.forEach((axis, k) => {
      for (let i = 0; i < axis.length; ++i) {
        if (kind[i] === kinds.cut || kind[Math.max(0, i - 1)] === kinds.cut) {
          low[k] = Math.min(low[k], axis[i]);
          high[k] = Math.max(high[k], axis[i]);
        }
      }
    });
    if (!(low[0] <= high[0])) {
      positions.forEach((axis, k) => {
        low[k] = axis.reduce((a, b) => Math.min(a, b));
        high[k] = axis.reduce((a, b) => Math.max(a, b));
      });
    }
    this.low = low;
    this.high = high;
    this.origin = low.map((value, k) => (value + high[k]) / 2);
    this.size = Math.max(1e-3, Math.hypot(...low.map((value, k) => high[k] - value)));
  }

  local(i, out, at) {
    this.run.positions.forEach((axis, k) => {
      out[at + k] = axis[i] - this.origin[k];
    });
  }

  build() {
    const { run, store } = this;
    for (const old of this.scene.children) old.geometry.dispose();
    this.scene.clear();
    this.screen = null;
    const reference = this.page.runs[store.get('reference')];
    this.colouring = colouredPath(this.page, run, store.get('colour'), reference);
    this.fine = this.fatLines(segmentsOf(run, kinds.cut, 0));
    this.coarse = this.fine.segments > mostWhileTurning ? this.coarseLines() : this.fine;
    this.coarse.visible = this.coarse === this.fine;
    this.programmed = this.programmedLines();
    this.programmed.visible = store.get('showProgrammed');
    this.rapids = this.rapidLines();
    this.scene.add(this.rapids, this.programmed, this.fine);
    if (this.coarse !== this.fine) this.scene.add(this.coarse);
    this.showKey();
    this.place();
    this.draw();
  }

  fatLines(pairs) {
    const count = pairs.length / 2;
    const points = new Float32Array(6 * count);
    const colours = new Uint8Array(8 * count);
    const table = this.colouring.colours;
    const flows = this.colouring.scale !== null;
    for (let k = 0; k < count; ++k) {
      const from = pairs[2 * k];
      const to = pairs[2 * k + 1];
      this.local(from, points, 6 * k);
      this.local(to, points, 6 * k + 3);
      const end = flows ? to : from;
      for (let c = 0; c < 3; ++c) {
        colours[8 * k + c] = table[3 * from + c];
        colours[8 * k + 4 + c] = table[3 * end + c];
      }
    }
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(points);
    const buffer = new InstancedInterleavedBuffer(colours, 8, 1);
    geometry.setAttribute('instanceColorStart', new InterleavedBufferAttribute(buffer, 3, 0, true));
    geometry.setAttribute('instanceColorEnd', new InterleavedBufferAttribute(buffer, 3, 4, true));
    const lines = new LineSegments2(geometry, this.material);
    lines.frustumCulled = false;
    lines.segments = count;
    return lines;
  }

  coarseLines() {
    let spacing = this.run.length[this.run.count - 1] / mostWhileTurning;
    let pairs = segmentsOf(this.run, kinds.cut, spacing);
    while (pairs.length > 2 * mostWhileTurning) {
      spacing *= 1.5;
      pairs = segmentsOf(this.run, kinds.cut, spacing);
    }
    return this.fatLines(pairs);
  }

  thinLines(points, material) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
    const lines = new LineSegments(geometry, material);
    lines.frustumCulled = false;
    return lines;
  }

  programmedLines() {
    const path = this.run.programmedPath;
    const points = new Float32Array(6 * path.count);
    let count = 0;
    for (let i = 1; i < path.count; ++i) {
      if (path.kind[i] !== kinds.cut && path.kind[i] !== kinds.arc) continue;
      for (const end of [i - 1, i]) {
        for (let k = 0; k < 3; ++k) points[count++] = path.positions[k][end] - this.origin[k];
      }
    }
    const material = new LineBasicMaterial({ color: themeColour(this.host, '--programmed') });
    return this.thinLines(points.subarray(0, count), material);
  }

  rapidLines() {
    const pairs = segmentsOf(this.run, kinds.rapid, 0);
    const points = new Float32Array(3 * pairs.length);
    pairs.forEach((node, k) => this.local(node, points, 3 * k));
    const dash = this.size / 120;
    const material = new LineDashedMaterial({
      color: themeColour(this.host, '--rapid'),
      dashSize: dash,
      gapSize: dash,
    });
    const lines = this.thinLines(points, material);
    if (pairs.length) lines.computeLineDistances();
    lines.visible = this.store.get('rapids');
    return lines;
  }

  showKey() {
    const { scale, causes } = this.colouring;
    this.key.replaceChildren();
    if (scale) {
      const stops = scale.colours.join(', ');
      const ticks = scaleTicks(scale);
      this.key.append(
        el('div', { class: 'ramp', style: { background: `linear-gradient(to right, ${stops})` } }),
        el(
          'div',
          { class: 'ticks' },
          ...ticks.map((tick, k) => el('span', {}, k === 2 ? `${tick} ${scale.unit}` : tick)),
        ),
      );
      return;
    }
    for (const { cause, share } of causes.slice(0, 6)) {
      const colour = causeColour(this.page, cause);
      this.key.append(
        el(
          'div',
          { class: 'cause' },
          el('i', { style: { background: colour } }),
          `${this.page.causes[cause]} ${shareText(share)}`,
        ),
      );
    }
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height);
    const half = (this.camera.top - this.camera.bottom) / 2;
    this.camera.left = (-half * width) / height;
    this.camera.right = -this.camera.left;
    this.camera.updateProjectionMatrix();
    if (this.fitted) this.fit();
    if (!this.sized) {
      this.sized = true;
      this.fit();
      const wanted = this.store.get('wantedCamera');
      if (wanted) this.useCamera(wanted);
    }
    this.screen = null;
    this.draw();
  }

  look(name) {
    this.controls.target.set(0, 0, 0);
    const direction = new Vector3(...directions[name]).normalize();
    this.camera.position.copy(direction.multiplyScalar(this.size * 2));
    if (name === 'top') this.camera.position.y -= this.size * 1e-4;
    this.camera.lookAt(0, 0, 0);
    this.fit();
  }

  /** The box of the cutting path fills the picture in at least one direction. */
  fit() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0) return;
    this.camera.updateMatrixWorld();
    const inverse = this.camera.matrixWorldInverse;
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    const point = new Vector3();
    const { run } = this;
    const stride = Math.max(1, Math.floor(run.count / 20000));
    for (let i = 0; i < run.count; i += stride) {
      if (run.kind[i] !== kinds.cut) continue;
      point.set(...run.positions.map((axis, k) => axis[i] - this.origin[k])).applyMatrix4(inverse);
      low[0] = Math.min(low[0], point.x);
      low[1] = Math.min(low[1], point.y);
      high[0] = Math.max(high[0], point.x);
      high[1] = Math.max(high[1], point.y);
    }
    if (!(low[0] <= high[0])) return;
    const beside = this.store.get('lens') && width > 3 * lensWidth ? lensWidth : 0;
    const free = { width: width - beside, top: 8, bottom: height - 40 };
    const scale = Math.max(
      (high[0] - low[0]) / ((1 - 2 * margin) * free.width),
      (high[1] - low[1]) / ((1 - 2 * margin) * (free.bottom - free.top)),
      this.size * 1e-6,
    );
    this.camera.zoom = 1;
    this.camera.top = (scale * height) / 2;
    this.camera.bottom = -this.camera.top;
    this.camera.right = (scale * width) / 2;
    this.camera.left = -this.camera.right;
    const shift = new Vector3(
      (low[0] + high[0]) / 2 + (scale * beside) / 2,
      (low[1] + high[1]) / 2 + scale * ((free.top + free.bottom - height) / 2),
      0,
    );
    const turn = this.camera.matrixWorld.clone().setPosition(0, 0, 0);
    const move = shift.applyMatrix4(turn);
    this.camera.position.add(move);
    this.controls.target.add(move);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.fitted = true; // until the user moves it, in a window of any size
    this.screen = null;
    this.draw();
  }

  cameraText() {
    const numbers = [
      ...this.camera.position.toArray(),
      ...this.controls.target.toArray(),
      this.camera.zoom,
      this.camera.top,
    ];
    return numbers.map((number) => Number(number.toPrecision(6))).join(',');
  }

  useCamera(text) {
    const numbers = text.split(',').map(Number);
    if (numbers.length !== 8 || !numbers.every(Number.isFinite) || !(numbers[6] > 0) || !(numbers[7] > 0)) return;
    const distance = Math.hypot(...[0, 1, 2].map((k) => numbers[k] - numbers[k + 3]));
    if (!(distance > 0 && distance < 1e3 * this.size)) return;
    this.fitted = false;
    this.camera.position.fromArray(numbers, 0);
    this.controls.target.fromArray(numbers, 3);
    this.camera.zoom = numbers[6];
    this.camera.top = numbers[7];
    this.camera.bottom = -numbers[7];
    this.resize();
    this.controls.update();
  }

  /** Moves the camera so that the cursor is in the middle; `width`: of what is seen then [mm]. */
  show(time, width) {
    this.fitted = false;
    const at = this.run.at(time).position.map((value, k) => value - this.origin[k]);
    const move = new Vector3(...at).sub(this.controls.target);
    this.camera.position.add(move);
    this.controls.target.add(move);
    const seen = (this.camera.right - this.camera.left) / this.camera.zoom;
    if (width && seen > width) this.camera.zoom *= seen / width;
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  turn(turning) {
    this.fine.visible = !turning || this.coarse === this.fine;
    this.coarse.visible = turning || this.coarse === this.fine;
    this.draw();
  }

  draw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.host.clientWidth === 0) return;
      this.renderer.render(this.scene, this.camera);
      if (!this.pictured) performance.mark('first-picture');
      this.pictured = true;
      this.place();
      this.annotations.place();
      this.showScaleBar();
    });
  }

  showScaleBar() {
    const width = (this.camera.right - this.camera.left) / this.camera.zoom;
    const pixel = width / this.host.clientWidth;
    const length = roundUp(inShownUnit(70 * pixel, 'length'));
    const pixels = length / inShownUnit(1, 'length') / pixel;
    this.scaleBar.firstChild.style.width = `${pixels}px`;
    this.scaleBar.lastChild.textContent = `${tickText(length)} ${unitOf('length')}`;
  }

  toScreen(position) {
    const point = new Vector3(...position.map((value, k) => value - this.origin[k])).project(this.camera);
    return [
      ((point.x + 1) / 2) * this.host.clientWidth,
      ((1 - point.y) / 2) * this.host.clientHeight,
    ];
  }

  place() {
    const at = this.run.at(this.store.get('time'));
    const [x, y] = this.toScreen(at.position);
    this.marker.style.transform = `translate(${x}px, ${y}px)`;
    this.marker.style.borderColor = this.run.colour;
  }

  /** Places of all nodes on the screen, and how near they are. */
  screenOf() {
    if (this.screen) return this.screen;
    this.camera.updateMatrixWorld();
    const { elements: m } = this.camera.projectionMatrix
      .clone()
      .multiply(this.camera.matrixWorldInverse);
    const { run, host } = this;
    const [x, y, z] = run.positions;
    const places = new Float32Array(3 * run.count);
    for (let i = 0; i < run.count; ++i) {
      const a = x[i] - this.origin[0];
      const b = y[i] - this.origin[1];
      const c = z[i] - this.origin[2];
      places[3 * i] = ((m[0] * a + m[4] * b + m[8] * c + m[12] + 1) / 2) * host.clientWidth;
      places[3 * i + 1] = ((1 - (m[1] * a + m[5] * b + m[9] * c + m[13])) / 2) * host.clientHeight;
      places[3 * i + 2] = m[2] * a + m[6] * b + m[10] * c + m[14];
    }
    this.screen = places;
    return places;
  }

  /** Time of the place of the path that is nearest to the pointer; null if none is near. */
  timeUnder(event) {
    const box = this.canvas.getBoundingClientRect();
    const px = event.clientX - box.left;
    const py = event.clientY - box.top;
    const places = this.screenOf();
    const { run } = this;
    let best = null;
    let least = reach * reach;
    for (let i = 0; i + 1 < run.count; ++i) {
      const kind = run.kind[i];
      if (kind === kinds.gap || (kind === kinds.rapid && !this.rapids.visible)) continue;
      const ax = places[3 * i];
      const ay = places[3 * i + 1];
      const dx = places[3 * i + 3] - ax;
      const dy = places[3 * i + 4] - ay;
      const squared = dx * dx + dy * dy;
      const share = squared > 0 ? Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / squared)) : 0;
      const away = (px - ax - share * dx) ** 2 + (py - ay - share * dy) ** 2;
      if (away < least - 1 || (away < least && (best === null || places[3 * i + 2] < best.depth))) {
        least = Math.min(least, away);
        best = { i, share, depth: places[3 * i + 2] };
      }
    }
    return best && run.timeWithin(best.i, best.share);
  }

  hover(event) {
    if (event.buttons !== 0 || event.pointerType === 'touch' || this.store.get('playing')) return;
    this.pick(event);
  }

  pick(event) {
    const time = this.timeUnder(event);
    if (time !== null) this.store.set({ time });
  }
}

/** What the picture shows, in one line below it. */
export const pathCaption = (page, run) =>
  [page.program.name, run.figures.machine.name, run.full_name, clockText(run.duration)].join(' · ');
