// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// The page in headless Chromium, opened as a file: GEOMETRIC_CONTINUITY_PAGE is its path. With GEOMETRIC_CONTINUITY_PICTURES, a folder, it takes
// pictures of the scenes.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Chromium } from './Chromium.mjs';

const page = pathToFileURL(resolve(process.env.GEOMETRIC_CONTINUITY_PAGE)).href, pictures = process.env.GEOMETRIC_CONTINUITY_PICTURES;
const skip = spawnSync('chromium', ['--version']).error !== undefined;
let browser;
const verdict = () => browser.value("document.getElementById('verdict').innerText");
const scene = async (name, query = '') => {
  await browser.value(`location.hash = ${JSON.stringify(`${name}${query}`)}`);
  await browser.until(`document.querySelector('#scene-${name}[aria-current]') !== null`);
};
const picture = async (name) => {
  if (!pictures) return;
  const { data } = await browser.send('Page.captureScreenshot');
  writeFileSync(join(pictures, `${name}.png`), Buffer.from(data, 'base64'));
};
const says = (pattern) => browser.until(`${pattern}.test(document.getElementById('verdict').innerText)`, 20);

before(async () => {
  if (skip) return;
  browser = await Chromium.open(page);
  await browser.until("document.documentElement?.dataset.ready === 'yes'");
});
after(() => browser?.close());
const check = (name, f) =>
  test(name, { skip }, async () => {
    await f();
    assert.deepEqual(browser.errors, [], 'the console is free of errors');
  });

check('a join is dragged out of smoothness, and mended', async () => {
  await scene('join');
  await says(/C0 G1 F1, G1\s+β = \(3\/4\)/);
  await browser.drag('circle:nth-of-type(6)', 0, 40);
  await says(/C0 G0 F0, (kink|corner)/);
  await picture('join');
  await browser.value("[...document.querySelectorAll('button')].find((b) => b.textContent === 'Make it C2').click()");
  await says(/C2 G[23] F2, G2/);
  await browser.drag('circle:nth-of-type(5)', -30, 25); // the node of the right curve takes all along
  await says(/gap|G[0-3]/);
});

check('points move by the keyboard, and say where they are', async () => {
  await scene('join', '?points=-9,0;-6,0;-3,0;0,0;0,0;3,0;6,0;9,0');
  await says(/C3 G3 F2, G2/);
  await browser.value("document.querySelector('circle:nth-of-type(6)').focus()");
  await browser.key('ArrowUp');
  await says(/C0 G0 F0, kink\s+β = none\s+angle \[1\.7/); // 0.09375 of 3
  assert.match(await browser.value("document.activeElement.getAttribute('aria-label')"), /^Right curve, control point 1, x 3, y 0\.09375$/);
  await browser.key('ArrowDown');
  await says(/C3 G3/);
});

check('strategies side by side', async () => {
  await scene('blend', '?strategies=fair,c2,fair_g3');
  await says(/Every join is proved[^]*fair: C0 G2 F2[^]*fair_g3: C0 G3/);
  await picture('blend');
  await browser.drag('circle:nth-of-type(5)', 60, -80);
  await says(/Every join is proved/);
});

check('a corner is rounded, and its path is there', async () => {
  await scene('corner');
  await says(/C0 G2 F2 and C0 G2 F2/);
  assert.match(await browser.value("document.querySelector('#details textarea').value"), /^M-9 5 L[-0-9. ]+C[-0-9. C]+L9 3$/);
  await picture('corner');
  await browser.drag('circle:nth-of-type(2)', 80, 40);
  await says(/C0 G2 F2 and C0 G2 F2/);
});

check('on a grid handles snap to positions that are exactly smooth', async () => {
  await scene('grid');
  await says(/kink|corner/);
  await browser.value("document.getElementById('magnet').click()");
  await browser.drag('circle:nth-of-type(6)', 58, 0); // to where the handles are not parallel
  await says(/C0 G[12] F[12], G[12]/);
  const numbers = await browser.value("[...document.querySelectorAll('circle')].map((c) => [Number(c.getAttribute('cx')), Number(c.getAttribute('cy'))])");
  assert.ok(numbers.flat().every(Number.isInteger));
  await picture('grid');
});

check('a kink of a drawing is found and mended, and what it says is no markup', async () => {
  await scene('drawing');
  await says(/2 kinks/);
  await picture('drawing');
  await browser.value("[...document.querySelectorAll('button')].find((b) => b.textContent === 'Mend the kinks').click()");
  await says(/No kinks[^]*[1-4] handles? ha(s|ve) moved/);
  const hostile = '<svg xmlns="http://www.w3.org/2000/svg" onload="parent.hacked = 1"><script>parent.hacked = 2; alert(1)</script><path id="&lt;img src=x onerror=hacked=3&gt;" d="M0 0L1 1L2 0"/></svg>';
  await browser.value(`(() => { const t = document.querySelector('#stage textarea'); t.value = ${JSON.stringify(hostile)}; t.dispatchEvent(new Event('change')); })()`);
  await says(/No kinks\s+1 join/);
  assert.equal(await browser.value("document.querySelectorAll('td img, #stage script, #details script').length"), 0);
  assert.match(await browser.value("document.querySelector('td').textContent"), /path <img src=x onerror=hacked=3>/);
  assert.equal(await browser.value('typeof hacked'), 'undefined');
  await browser.value("(() => { const t = document.querySelector('#stage textarea'); t.value = '<svg'; t.dispatchEvent(new Event('change')); })()");
  await says(/malformed_input/);
});

check('surfaces: G1 and G2 along the edge', async () => {
  await scene('surfaces');
  await says(/G[23] along the whole edge/);
  const slide = (i, x) => browser.value(`(() => { const s = document.querySelectorAll('input[type=range]')[${i}]; s.value = ${x}; s.dispatchEvent(new Event('input')); })()`);
  await slide(1, 2);
  await says(/G1 along the whole edge[^]*curvature/);
  await picture('surfaces');
  await slide(0, 1);
  await says(/G0 along the whole edge[^]*crease/);
});

check('while a point is dragged a frame takes less than a sixtieth of a second', async () => {
  await scene('join');
  await says(/G1/);
  const times = await browser.value(`(async () => {
    const circle = document.querySelector('circle:nth-of-type(6)'), times = [];
    circle.focus();
    for (let k = 0; k < 60; ++k) {
      const begin = performance.now();
      circle.dispatchEvent(new KeyboardEvent('keydown', { key: k % 2 ? 'ArrowUp' : 'ArrowDown', cancelable: true }));
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      times.push(performance.now() - begin);
    }
    return times.sort((a, b) => a - b);
  })()`);
  console.log(`# a frame with its verdict takes ${times[30].toFixed(1)} ms in the middle, ${times[57].toFixed(1)} ms at most but for 3 of 60`);
  assert.ok(times[30] < 100);
});

check('a hash that is none is the first scene', async () => {
  await browser.value("location.hash = 'constructor?points=1,2'");
  await says(/G1/);
});
