// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes the package.json of the npm package: that of the module, with the version and the address
// of the project, which stand in CMakeLists.txt.
// Usage: node describe.mjs SOURCE_FOLDER >package.json

import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const source = process.argv[2];
const project = readFileSync(join(source, 'CMakeLists.txt'), 'utf8');
const value = (pattern) => project.match(pattern)?.[1] ?? '';
const { name, version, ...rest } = JSON.parse(readFileSync(join(source, 'browser/module/package.json'), 'utf8'));
const homepage = value(/^ *HOMEPAGE_URL "(.*?)"/m);
const described = { name, version: value(/^project\(Geometric_continuity VERSION ([0-9.]+)/m), ...rest };
if (homepage) Object.assign(described, { homepage, repository: { type: 'git', url: `git+${homepage}.git` } });
console.log(JSON.stringify(described, null, 2));
