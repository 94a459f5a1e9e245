// Chromium without a display, driven by its DevTools protocol over two pipes: one page, and what it complains of.

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const program = process.env.FEEDSCOPE_CHROMIUM ?? 'chromium';
const patience = 30000; // [ms]

export class Browser {
  constructor(options = []) {
    this.folder = mkdtempSync(join(tmpdir(), 'feedscope-page-'));
    this.process = spawn(
      program,
      [
        '--headless=new', '--remote-debugging-pipe', '--no-sandbox', '--no-first-run', '--disable-dev-shm-usage',
        '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars', '--force-color-profile=srgb',
        `--user-data-dir=${this.folder}`, ...options, 'about:blank',
      ],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], env: { ...process.env, HOME: this.folder } },
    );
    this.waiting = new Map();
    this.listeners = [];
    this.last = 0;
    this.rest = '';
    this.process.stdio[4].on('data', (data) => this.read(data.toString()));
    this.process.on('error', (error) => this.fail(error));
    this.process.on('exit', () => this.fail(new Error(`${program} has ended`)));
  }

  fail(error) {
    for (const { reject } of this.waiting.values()) reject(error);
    this.waiting.clear();
  }

  read(text) {
    const messages = (this.rest + text).split('\0');
    this.rest = messages.pop();
    for (const message of messages.map((one) => JSON.parse(one))) {
      const waiting = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (waiting && message.error) waiting.reject(new Error(message.error.message));
      else if (waiting) waiting.resolve(message.result);
      else for (const listener of this.listeners) listener(message);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    const id = ++this.last;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  async page(size = { width: 1280, height: 800 }) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this, sessionId);
    await page.prepare(size);
    return page;
  }

  async close() {
    const ended = new Promise((resolve) => this.process.once('exit', resolve));
    await this.send('Browser.close').catch(() => {});
    await ended;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Page {
  /** Messages of the console and exceptions, and addresses that were asked for. */
  complaints = [];
  requests = [];

  constructor(browser, session) {
    this.browser = browser;
    this.session = session;
    this.loaded = () => {};
    browser.listeners.push((message) => message.sessionId === session && this.hear(message));
  }

  send(method, params) {
    return this.browser.send(method, params, this.session);
  }

  hear({ method, params }) {
    if (method === 'Page.loadEventFired') this.loaded();
    if (method === 'Runtime.exceptionThrown') {
      const { exception, text } = params.exceptionDetails;
      this.complaints.push(exception?.description ?? text);
    }
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(params.entry.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(params.type)) {
      this.complaints.push(params.args.map((arg) => arg.value ?? arg.description).join(' '));
    }
    if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
  }

  async prepare(size) {
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await this.send(`${domain}.enable`);
    await this.resize(size);
  }

  resize({ width, height, phone = false }) {
    return this.send('Emulation.setDeviceMetricsOverride', {
      width, height, deviceScaleFactor: phone ? 2 : 1, mobile: phone,
    }).then(() => this.send('Emulation.setTouchEmulationEnabled', { enabled: phone }));
  }

  media(features, media = '') {
    return this.send('Emulation.setEmulatedMedia', {
      media, features: Object.entries(features).map(([name, value]) => ({ name, value })),
    });
  }

  scripts(on) {
    return this.send('Emulation.setScriptExecutionDisabled', { value: !on });
  }

  async open(url) {
    const loaded = new Promise((resolve) => { this.loaded = resolve; });
    await this.send('Page.navigate', { url });
    await loaded;
  }

  /** Opens a page and waits for its view. */
  async openView(url) {
    await this.open(url);
    await this.until(() => Boolean(window.feedscope));
    await this.settle();
  }

  /** The value of a function of the page. */
  async ask(question, ...values) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', {
      expression: `(${question})(...${JSON.stringify(values)})`, returnByValue: true, awaitPromise: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(question, ...values) {
    const end = Date.now() + patience;
    while (!(await this.ask(question, ...values))) {
      if (Date.now() > end) throw new Error(`not within ${patience} ms: ${question}; ${this.complaints.join('; ')}`);
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
  }

  /** Until what has changed is drawn; a page behind another draws nothing. */
  async settle() {
    await this.send('Page.bringToFront');
    return this.ask(
      () => new Promise((resolve) => {
        let frames = 4;
        const step = () => (--frames > 0 ? requestAnimationFrame(step) : resolve());
        requestAnimationFrame(step);
      }),
    );
  }

  mouse(type, x, y, more = {}) {
    return this.send('Input.dispatchMouseEvent', { type, x, y, button: 'none', ...more });
  }

  async move(x, y) {
    await this.mouse('mouseMoved', x, y);
    await this.settle();
  }

  async drag(from, to, button = 'left') {
    const buttons = button === 'left' ? 1 : 2;
    await this.mouse('mouseMoved', ...from);
    await this.mouse('mousePressed', ...from, { button, buttons, clickCount: 1 });
    await this.mouse('mouseMoved', (from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { button, buttons });
    await this.mouse('mouseMoved', ...to, { button, buttons });
    await this.mouse('mouseReleased', ...to, { button, buttons: 0, clickCount: 1 });
    await this.settle();
  }

  async click(x, y) {
    await this.mouse('mousePressed', x, y, { button: 'left', buttons: 1, clickCount: 1 });
    await this.mouse('mouseReleased', x, y, { button: 'left', buttons: 0, clickCount: 1 });
    await this.settle();
  }

  async wheel(x, y, deltaY) {
    await this.mouse('mouseWheel', x, y, { deltaX: 0, deltaY });
    await this.settle();
  }

  /** Fingers from place to place, each [[x, y], [x, y]]. */
  async touch(...fingers) {
    const points = (at) => fingers.map((ways, id) => ({ id, x: ways[0][0] + at * (ways[1][0] - ways[0][0]), y: ways[0][1] + at * (ways[1][1] - ways[0][1]) }));
    await this.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
    for (const at of [0.25, 0.5, 0.75, 1]) {
      await this.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(at) });
    }
    await this.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await this.settle();
  }

  async key(key) {
    for (const type of ['keyDown', 'keyUp']) {
      await this.send('Input.dispatchKeyEvent', { type, key, text: type === 'keyDown' && key.length === 1 ? key : undefined });
    }
    await this.settle();
  }

  /** A picture of the window or of a `box` {x, y, width, height} in it. */
  async picture(file, box) {
    const clip = box && { ...box, scale: 1 };
    const { data } = await this.send('Page.captureScreenshot', { format: 'png', clip });
    const bytes = Buffer.from(data, 'base64');
    if (file) writeFileSync(file, bytes);
    return bytes;
  }
}
