// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// A headless Chromium with one page, spoken to over a pipe in the protocol of its developer tools.
export class Chromium {
  #next = 1;
  #waiting = new Map();
  #session = undefined;
  #folder = mkdtempSync(join(tmpdir(), 'chromium'));
  errors = []; // of the console and of scripts

  static async open(url, ...options) {
    const browser = new Chromium();
    browser.process = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--window-size=1200,800', `--user-data-dir=${browser.#folder}`,
      '--remote-debugging-pipe', ...options, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    let rest = '';
    browser.process.stdio[4].setEncoding('utf8').on('data', (text) => {
      const messages = (rest + text).split('\0');
      rest = messages.pop();
      for (const message of messages) browser.#take(JSON.parse(message));
    });
    const { targetInfos } = await browser.send('Target.getTargets');
    const { targetId } = targetInfos.find((t) => t.type === 'page');
    browser.#session = (await browser.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    for (const domain of ['Page', 'Runtime', 'Log']) await browser.send(`${domain}.enable`);
    await browser.send('Page.navigate', { url });
    return browser;
  }

  #take({ id, result, error, method, params }) {
    if (id) {
      const { resolve, reject } = this.#waiting.get(id);
      this.#waiting.delete(id);
      return error ? reject(new Error(error.message)) : resolve(result);
    }
    if (method === 'Runtime.exceptionThrown') this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type)) this.errors.push(JSON.stringify(params.args));
    if (method === 'Log.entryAdded' && ['error', 'warning'].includes(params.entry.level)) this.errors.push(params.entry.text);
    if (method === 'Page.javascriptDialogOpening') this.errors.push(`a dialog: ${params.message}`);
    return undefined;
  }

  send(method, params = {}) {
    const id = this.#next++;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.#session })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  // The value of an expression, which may be a promise.
  async value(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  // Waits until an expression is true.
  async until(expression, seconds = 60) {
    for (const end = Date.now() + 1000 * seconds; ;) {
      if (await this.value(expression).catch(() => false)) return; // not while a page comes in the place of another
      if (Date.now() > end) throw new Error(`not in ${seconds} s: ${expression}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  mouse(type, x, y) {
    return this.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1 });
  }

  async drag(selector, dx, dy, steps = 10) {
    const [x, y] = await this.value(`(() => { const r = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
    await this.mouse('mousePressed', x, y);
    for (let k = 1; k <= steps; ++k) await this.mouse('mouseMoved', x + (dx * k) / steps, y + (dy * k) / steps);
    await this.mouse('mouseReleased', x + dx, y + dy);
  }

  // As `drag`, by a finger that is put down beside the middle of what it drags.
  async swipe(selector, beside, dx, dy, steps = 10) {
    const [x, y] = await this.value(`(() => { const r = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return [r.x + r.width / 2 + ${beside[0]}, r.y + r.height / 2 + ${beside[1]}]; })()`);
    const touch = (type, ...touchPoints) => this.send('Input.dispatchTouchEvent', { type, touchPoints });
    await touch('touchStart', { x, y });
    for (let k = 1; k <= steps; ++k) await touch('touchMove', { x: x + (dx * k) / steps, y: y + (dy * k) / steps });
    await touch('touchEnd');
  }

  async key(key, modifiers = 0) {
    for (const type of ['keyDown', 'keyUp']) await this.send('Input.dispatchKeyEvent', { type, key, code: key, modifiers });
  }

  async close() {
    const end = new Promise((resolve) => this.process.on('exit', resolve));
    this.#session = undefined;
    this.send('Browser.close').catch(() => {});
    await end;
    rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }
}
