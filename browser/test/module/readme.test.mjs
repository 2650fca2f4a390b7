// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// The blocks of the package's README are run. A comment that begins with an arrow is the value of
// its line.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import load from 'geometric-continuity';

const readme = readFileSync(new URL('README.md', import.meta.resolve('geometric-continuity')), 'utf8');
const blocks = [...readme.matchAll(/```js\n(.*?)```/gs)].map((match) => match[1]);
const run = Object.getPrototypeOf(async () => {}).constructor;
// Arrays of numbers that have a type are compared as arrays.
const plain = (value) => (ArrayBuffer.isView(value) ? [...value] : value);

test('the README prints what the module answers', async () => {
  assert.equal(blocks.length, 3);
  let values = 0;
  for (const block of blocks) {
    const lines = block.replace(/^import load .*\n/, '').split('\n').map((line) => {
      const found = line.match(/^(.*); *\/\/ → (\[.*\]|[^,]*)/);
      if (!found) return line;
      ++values;
      return `check(${found[1]}, ${found[2]});`;
    });
    await new run('load', 'check', lines.join('\n'))(load, (value, expected) => assert.deepEqual(plain(value), expected));
  }
  assert.equal(values, 13);
});
