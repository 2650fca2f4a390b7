// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// The page in headless Firefox, by WebDriver BiDi: that each scene says what it says in Chromium,
// and that the console is free of errors. Skipped without firefox-esr, or where node has no
// WebSocket (node --experimental-websocket).

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

const skip = typeof WebSocket === 'undefined' || spawnSync('firefox-esr', ['--version']).error !== undefined;

test('the scenes in Firefox', { skip }, async () => {
  const profile = mkdtempSync(join(tmpdir(), 'firefox'));
  const firefox = spawn('firefox-esr', ['--headless', '--no-remote', '--profile', profile, '--remote-debugging-port=0'], { stdio: ['ignore', 'ignore', 'pipe'] });
  try {
    const address = await new Promise((found, failed) => {
      let text = '';
      firefox.stderr.setEncoding('utf8').on('data', (more) => {
        const match = /WebDriver BiDi listening on (ws:\/\/\S+)/.exec((text += more));
        if (match) found(match[1]);
      });
      firefox.on('exit', () => failed(new Error(text)));
    });
    const socket = new WebSocket(`${address}/session`), waiting = new Map(), errors = [];
    await new Promise((opened, failed) => ((socket.onopen = opened), (socket.onerror = failed)));
    let next = 1;
    const send = (method, params = {}) => {
      socket.send(JSON.stringify({ id: next, method, params }));
      return new Promise((done, failed) => waiting.set(next++, { done, failed }));
    };
    socket.onmessage = ({ data }) => {
      const message = JSON.parse(data);
      if (message.method === 'log.entryAdded' && message.params.level !== 'info' && message.params.level !== 'debug') errors.push(message.params.text);
      if (!message.id) return;
      const { done, failed } = waiting.get(message.id);
      message.error ? failed(new Error(message.message)) : done(message.result);
    };
    await send('session.new', { capabilities: {} });
    await send('session.subscribe', { events: ['log.entryAdded'] });
    const context = (await send('browsingContext.getTree')).contexts[0].context;
    await send('browsingContext.navigate', { context, url: pathToFileURL(resolve(process.env.GEOMETRIC_CONTINUITY_PAGE)).href, wait: 'complete' });
    const value = async (expression) => (await send('script.evaluate', { expression, target: { context }, awaitPromise: true })).result?.value;
    const until = async (expression) => {
      for (const end = Date.now() + 60000; !(await value(expression)); await new Promise((again) => setTimeout(again, 50)))
        assert.ok(Date.now() < end, `${expression}: ${await value("document.getElementById('verdict').textContent")}`);
    };
    await until("document.documentElement.dataset.ready === 'yes'");
    for (const [scene, says] of [['join', /C0 G1 F1β = \(3\/4\)angle 0°/], ['blend', /Every join is proved[^]*fair: C0 G2 F2/], ['corner', /C0 G2 F2 and C0 G2 F2/], ['grid', /kink|corner/],
      ['drawing', /2 kinks/], ['surfaces', /G[23] along the whole edge/]]) {
      await value(`location.hash = '${scene}'`);
      await until(`document.querySelector('#scene-${scene}[aria-current]') !== null && ${says}.test(document.getElementById('verdict').textContent)`);
      const { data } = await send('browsingContext.captureScreenshot', { context });
      if (process.env.GEOMETRIC_CONTINUITY_PICTURES) writeFileSync(join(process.env.GEOMETRIC_CONTINUITY_PICTURES, `firefox_${scene}.png`), Buffer.from(data, 'base64'));
    }
    assert.deepEqual(errors, []);
    await send('browser.close').catch(() => {});
    socket.close();
  } finally {
    firefox.kill();
    await new Promise((end) => (firefox.exitCode === null && firefox.signalCode === null ? firefox.on('exit', end) : end()));
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
});
