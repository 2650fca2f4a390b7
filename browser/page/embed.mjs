// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makes one file of the page, the module and its WebAssembly. Usage: node embed.mjs PACKAGE_FOLDER
// OUTPUT

import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const [packageFolder, output] = process.argv.slice(2), here = dirname(fileURLToPath(import.meta.url));
const text = (...path) => readFileSync(join(...path), 'utf8');
const wasm = (name) => JSON.stringify(gzipSync(readFileSync(join(packageFolder, `${name}.wasm`)), { level: 9 }).toString('base64'));
const module = text(packageFolder, 'geometric_continuity.mjs').replace('export class', 'class').replace(/^export (const )?\{[^}]*\}.*$/gm, '');
if (/^export/m.test(module)) throw new Error('the module exports more than is known here');
const script = [`const MODULE = ${wasm('geometric_continuity')}, FILES = ${wasm('geometric_continuity_files')};`, module, text(here, 'curves.js'), text(here, 'page.js')].join('\n');
if (/<\/script/i.test(script)) throw new Error('a script ends within the script');
writeFileSync(output, text(here, 'page.html').replace('/*STYLE*/', () => text(here, 'page.css')).replace('/*SCRIPT*/', () => script));
