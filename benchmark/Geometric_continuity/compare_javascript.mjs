// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// Smooth corners, offsets, rounded numbers and letters of libraries of JavaScript beside the
// package for browsers: each result is decided by the package, exactly for its numbers, and the
// time of an operation is that of the middle of many, in three runs in which the methods take
// turns. The libraries come from the npm registry into a temporary folder. Writes rows as of
// measured/, on which see `measure`. Usage: node compare_javascript.mjs PACKAGE.tgz FONT.ttf
// >OUTPUT, with the package that browser/build makes

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { cpus, tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const libraries = ['figma-squircle@1.1.0', 'bezier-js@6.1.4', 'paper@0.12.18', 'svgpath@2.6.0', 'opentype.js@1.3.4'];
const [packed, fontFile] = process.argv.slice(2).map((name) => resolve(name));
const folder = mkdtempSync(join(tmpdir(), 'geometric_continuity'));
try {
  const npm = (...words) => execFileSync('npm', words, { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  npm('init', '-y');
  npm('install', '--silent', '--no-audit', '--no-fund', ...libraries, packed);
  const require = createRequire(join(folder, 'package.json'));
  const load = (name, file) => import(pathToFileURL(join(folder, 'node_modules', name, file)).href);
  const gc = await (await load('geometric-continuity', 'geometric_continuity.mjs')).default();
  const { getSvgPath } = await load('figma-squircle', 'dist/index.js'), { Bezier } = await load('bezier-js', 'src/bezier.js');
  const paper = require('paper/dist/paper-core.js'), svgpath = require('svgpath'), opentype = require('opentype.js');
  paper.setup(new paper.Size(100, 100));

  const drawing = (d) => `<svg xmlns="http://www.w3.org/2000/svg"><path d="${d}"/></svg>`;
  const exact = (c) => c.exact?.split(';').map((p) => p.split(',')) ?? { control_points: c.weights.map((_, i) => c.points.slice(2 * i, 2 * i + 2)), weights: c.weights };
  const number = (x) => (x === 0 ? '0' : x.toPrecision(2));
  const words = (all) => {
    const joins = all.filter((j) => !(j.angle > 5)), corners = all.length - joins.length;
    const most = (key) => Math.max(0, ...joins.map((j) => j[key] ?? 0));
    return `${joins.length} joins${corners ? ` and ${corners} corners` : ''}, G1 ${joins.filter((j) => j.g >= 1).length}, G2 ${joins.filter((j) => j.g >= 2).length}, kinks to ${number(most('angle'))} degrees, curvature off by up to ${number(most('jump'))} %`;
  };
  // Decides the orders of a path exactly, for its numbers. The bounds of arcs, which are rounded
  // there, belong to their nearest doubles.
  const decided = async (d) => {
    const text = drawing(d), curves = (await gc.svgCurves(text)).subpaths.flatMap((p) => p.curves);
    return words((await gc.verifySvg(text)).joins.map(({ left, right, g_order }) => {
      const { angle_degrees, curvature_percent } = gc.deviation(exact(curves[left]), exact(curves[right]));
      return { g: g_order, angle: g_order >= 1 ? 0 : angle_degrees?.[1], jump: g_order >= 2 ? 0 : curvature_percent?.[1] };
    }));
  };
  const decided_curves = (curves, points) => words(curves.map((left, i) => {
    const sides = [left, curves[(i + 1) % curves.length]].map((c) => c[points]), { g_order } = gc.continuity(...sides), d = gc.deviation(...sides);
    return { g: g_order, angle: g_order >= 1 ? 0 : d.angle_degrees?.[1], jump: g_order >= 2 ? 0 : d.curvature_percent?.[1] };
  }));

  // 1. corners
  const [w, h, radius, smoothing] = [200, 100, 20, 0.6], box = [[0, 0], [w, 0], [w, h], [0, h]];
  const side = (i) => [box[i % 4], box[(i + 1) % 4]], half = (i) => side(i)[0].map((x, k) => (x + side(i)[1][k]) / 2);
  const rounded_box = () => [0, 1, 2, 3].flatMap((i) => {
    const r = gc.roundCorner([half(i), side(i)[1]], [side(i)[1], half(i + 1)], radius * (1 + smoothing));
    return [r.left, r.blend.curve, r.right];
  });
  const squircle = () => getSvgPath({ width: w, height: h, cornerRadius: radius, cornerSmoothing: smoothing, preserveSmoothing: true });
  const paper_box = () => new paper.Path.Rectangle({ point: [0, 0], size: [w, h], radius, insert: false });
  // 2. an offset
  const bezier = new Bezier([[0, 0], [40, 120], [160, 120], [200, -20]].flat());
  const offset_path = (pieces) => pieces.map(({ points: p }, i) => `${i === 0 ? `M${p[0].x} ${p[0].y}` : ''}C${p.slice(1).map((q) => `${q.x} ${q.y}`).join(' ')}`).join('');
  // 3. rounded numbers: a wave with handles that are exactly parallel
  let wave = 'M0 0';
  for (let i = 0; i < 100; ++i) wave += `s${10.37 + (i % 7) * 0.11} ${(i % 2 ? 1 : -1) * (5.13 + (i % 5) * 0.17)} 20.25 ${(i % 3) * 0.75}`;
  const round = () => svgpath(wave).abs().unshort().round(1).toString();
  // 4. letters
  const font = opentype.parse(readFileSync(fontFile).buffer.slice(0)), letters = () => font.getPath('Geometric', 0, 0, 72).toPathData(2);
  // 5. a curve through points
  const through = () => {
    const path = new paper.Path({ segments: Array.from({ length: 24 }, (_, i) => [30 * i, (i * i * 7) % 50]), insert: false });
    path.smooth({ type: 'continuous' });
    return path;
  };

  const rounded_wave = round(), rounded_letters = letters();
  const mend = async (d) => (await gc.repairSvg(drawing(d))).svg.match(/ d="([^"]*)"/)[1];
  const works = [
    ['a rectangle with round corners', [
      [`figma-squircle: ${await decided(squircle())}`, squircle],
      [`paper.js, a rectangle with a radius: ${await decided(paper_box().pathData)}`, paper_box],
      [`roundCorner(), exact numbers: ${decided_curves(rounded_box(), 'control_points')}`, rounded_box]]],
    ['an offset of a cubic', [[`bezier-js, offset(): ${await decided(offset_path(bezier.offset(10)))}`, () => bezier.offset(10)]]],
    ['a curve through 24 points', [[`paper.js, smooth(): ${await decided(through().pathData)}`, through]]],
    ['a smooth path of 100 cubics, rounded to one decimal', [
      [`svgpath, round(1): ${await decided(rounded_wave)}`, round],
      [`repairSvg() of that: ${await decided(await mend(rounded_wave))}`, () => mend(rounded_wave)]]],
    ['a word at 72 px, two decimals', [
      [`opentype.js, toPathData(2): ${await decided(rounded_letters)}`, letters],
      [`repairSvg() of that: ${await decided(await mend(rounded_letters))}`, () => mend(rounded_letters)]]],
  ];

  const runs = 3, time = async (f) => {
    const times = [];
    for (const end = performance.now() + 300; performance.now() < end || times.length < 5; ) {
      const begin = performance.now();
      await f();
      times.push(performance.now() - begin);
    }
    return 1e6 * times.sort((a, b) => a - b)[times.length >> 1];
  };
  console.log(`# node ${process.version}; ${cpus()[0].model.split(/ \d/)[0]}; three runs, ${new Date().toISOString().slice(0, 10)}`);
  for (const [work, methods] of works) {
    const all = [];
    for (let run = 0; run < runs; ++run) {
      const times = [];
      for (const [, f] of methods) times.push(await time(f));
      all.push(times);
    }
    const range = (list) => [Math.min(...list), Math.max(...list)];
    for (const [k, [method]] of methods.entries())
      console.log([`${work} | ${method}`, ...range(all.map((t) => t[k])).map((x) => x.toPrecision(4)), 'ns', ...range(all.map((t) => t[k] / t[0])).map((x) => x.toPrecision(3))].join('\t'));
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
