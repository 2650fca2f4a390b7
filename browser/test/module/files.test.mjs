// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// The functions of the npm package on files. Where GEOMETRIC_CONTINUITY_PROGRAM names the program,
// its reports of the project's drawings, chains and models are the same as those of the package.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import load, { GeometricContinuityError } from 'geometric-continuity';

const gc = await load();
const program = process.env.GEOMETRIC_CONTINUITY_PROGRAM, source = process.env.GEOMETRIC_CONTINUITY_SOURCE;
const data = source && join(source, 'demo/Geometric_continuity/data');
const svg = (d) => `<svg xmlns="http://www.w3.org/2000/svg"><path id="p" d="${d}"/></svg>`;

const rejects = (code, promise, text = '') =>
  assert.rejects(promise, (error) => {
    assert.ok(error instanceof GeometricContinuityError, String(error));
    assert.equal(error.code, code, error.message);
    assert.ok(error.message.includes(text), error.message);
    return true;
  });

test('a kink is found and mended', async () => {
  const kink = svg('M0 0 C10 0 20 0 30 0 C40 1 50 10 60 20');
  const report = await gc.verifySvg(kink, { require: 'G1' });
  assert.deepEqual([report.joins.length, report.joins[0].grade, report.met, report.summary.kinks], [1, 'corner', true, 0]);
  const again = await gc.verifySvg(kink, { require: 'G1', kinkAngle: 6 });
  assert.deepEqual([again.joins[0].grade, again.met, again.summary.kinks, again.joins[0].id], ['kink', false, 1, 'p']);
  const repaired = await gc.repairSvg(kink, { kinkAngle: 6 });
  assert.equal(repaired.report.moves.length, 1);
  assert.equal((await gc.verifySvg(repaired.svg, { require: 'G1', kinkAngle: 6 })).met, true);
  assert.equal((await gc.repairSvg(repaired.svg, { kinkAngle: 6 })).svg, repaired.svg);
});

test('path data is a drawing', async () => {
  const kink = 'M0 0 C10 0 20 0 30 0 C40 1 50 10 60 20';
  assert.deepEqual(await gc.verifySvg(kink), await gc.verifySvg(svg(kink).replace(' id="p"', '')));
  const { d, svg: drawn } = await gc.repairSvg(kink, { kinkAngle: 6 });
  assert.ok(drawn.includes(` d="${d}"`) && d !== kink);
  assert.equal((await gc.verifySvg(d, { require: 'G1', kinkAngle: 6 })).met, true);
  assert.equal((await gc.svgCurves(kink)).subpaths[0].curves.length, 2);
  assert.ok(!(await gc.repairSvg('M0 0L1"/><script/>')).svg.includes('<script'), 'and remains one');
});

test('chains and models', async () => {
  const line = (a, b) => `100 1 0 0\n2 0\n2 2\n0 0 1 1\n${a}\n${b}\n`;
  const report = await gc.verifyG2(line('0 0', '0.1 0.3') + line('0.1 0.3', '0.3 0.9'), { require: 'G2' });
  assert.deepEqual([report.joins[0].g_order, report.joins[0].betas[0], report.met], [3, '2', true]);
  const parabola = '100 1 0 0\n2 0\n3 3\n0 0 0 1 1 1\n-1 1\n0 -1\n1 1\n';
  const bent = await gc.verifyG2(parabola, { maxCurvature: 1 });
  assert.deepEqual([bent.met, bent.bent_curves], [false, [{ curve: 0, parameter: [0.5, 0.5], curvature: [2, 2] }]]);
  assert.equal((await gc.verifyG2(parabola, { maxCurvature: 2 })).met, true);
});

test('bad files are refused with code, line and reason', async () => {
  await rejects('malformed_input', gc.verifySvg('drawing.svg'), 'give the text of a file, and not its name');
  await rejects('malformed_input', gc.verifyFont('font.ttf'), 'a font is bytes');
  await rejects('malformed_input', gc.verifySvg('M0 0L1 1', { requires: 'G1' }), "did you mean 'require'?");
  await rejects('malformed_input', gc.repairSvg('M0 0L1 1', { tolerance: 0.1 }), 'there are kinkAngle, maxMove, harmonise');
  await rejects('malformed_input', gc.verifySvg('<svg xmlns="http://www.w3.org/2000/svg">\n<path></svg>'), 'drawing.svg:2:');
  await rejects('malformed_input', gc.verifySvg('no drawing'));
  await rejects('malformed_input', gc.verifySvg('<html/>'));
  await rejects('malformed_input', gc.verifySvg(svg('M0 0 L1 1'), { require: 'G99' }), 'G99');
  await rejects('malformed_input', gc.verifySvg(17));
  await rejects('malformed_input', gc.verifyG2('100 1 0 0\n2 0\n'), 'curves.g2');
  await rejects('malformed_input', gc.repairSvg('<svg'));
  assert.equal((await gc.verifySvg(svg('M0 0 L1 1 L2 2'))).joins.length, 1, 'and the module works on');
});

test('an element that cannot be read is not covered', async () => {
  const report = await gc.verifySvg('<svg xmlns="http://www.w3.org/2000/svg">\n<path d="M0 0 L1"/><path d="M0 0 L1 1 L2 2"/></svg>', { require: 'G1' });
  assert.deepEqual([report.joins.length, report.not_verified.length, report.not_verified[0].line, report.met], [1, 1, 2, false]);
  assert.match(report.not_verified[0].reason, /character/);
});

test('entities that expand without end are refused', async () => {
  let declarations = '<!ENTITY a0 "M0 0L1 1">';
  for (let i = 1; i < 12; ++i) declarations += `<!ENTITY a${i} "${`&a${i - 1};`.repeat(10)}">`;
  await rejects('malformed_input', gc.verifySvg(`<!DOCTYPE svg [${declarations}]><svg xmlns="http://www.w3.org/2000/svg"><path d="&a11;"/></svg>`));
});

test('what a drawing says is data', async () => {
  const report = await gc.verifySvg('<svg xmlns="http://www.w3.org/2000/svg"><path id="&lt;script&gt;\'&quot;" d="M0 0 L1 1 L2 0"/></svg>');
  assert.equal(report.joins[0].id, '<script>\'"');
});

test('the curves of a drawing are those that joins name', async () => {
  const drawing = svg('M0 0 C1 0 20 0 30 0 L31 1 A5 5 0 0 1 41 1 Z M0.1 0 L1 1');
  const { subpaths } = await gc.svgCurves(drawing), { joins } = await gc.verifySvg(drawing), curves = subpaths.flatMap((p) => p.curves);
  assert.deepEqual([subpaths.length, subpaths[0].closed, curves[0].exact, curves[0].points, curves[2].weights.length], [2, true, '0,0;1,0;20,0;30,0', [0, 0, 1, 0, 20, 0, 30, 0], 5]);
  assert.equal(curves[4].exact, '1/10,0;1,1');
  for (const { left, right } of joins)
    for (const k of [0, 1]) assert.ok(Math.abs(curves[left].points.at(k - 2) - curves[right].points[k]) < 1e-12); // arcs are rounded
});

// FreeType reads tables of characters within setjmp(). This font has no names of glyphs, of which
// such a table could be made.
test('glyphs are found by their character', { skip: !source }, async () => {
  const font = new Uint8Array(readFileSync(join(source, 'conformance/data/font/one-unit.ttf')));
  for (const glyphs of ['A', 'U+0041', 'A-Z']) {
    const { summary } = await gc.verifyFont(font, { glyphs });
    assert.deepEqual([summary.glyphs, summary.joins], [1, 4]);
  }
  await rejects('malformed_input', gc.verifyFont(font, { glyphs: 'B' }));
  const place = new DataView(font.buffer), tables = place.getUint16(4);
  for (let i = 0; i < tables; ++i)
    if (String.fromCharCode(...font.slice(12 + 16 * i, 16 + 16 * i)) === 'cmap') place.setUint16(place.getUint32(20 + 16 * i) + 18, 3); // segments times 2
  await rejects('malformed_input', gc.verifyFont(font, { glyphs: 'A' }));
  assert.equal((await gc.verifyFont(font)).summary.joins, 4);
});

test('bad fonts are refused', async () => {
  await rejects('malformed_input', gc.verifyFont(new Uint8Array(100)));
  await rejects('malformed_input', gc.fontCurves(new Uint8Array([79, 84, 84, 79])));
  await rejects('malformed_input', gc.verifyFont(new Uint8Array(100), { glyphs: 'a b' }), 'options.glyphs');
});

test('the reports of the program', { skip: !program || !source }, async () => {
  const work = mkdtempSync(join(tmpdir(), 'geometric_continuity'));
  try {
    const corpus = (name) => readdirSync(join(source, 'test/fuzz/corpus', name)).map((file) => join(source, 'test/fuzz/corpus', name, file));
    const demos = (end) => readdirSync(data).filter((name) => name.endsWith(end)).map((name) => join(data, name));
    let compared = 0, refused = 0;
    const compare = async (path, name, command, own, known = (report) => report) => {
      const bytes = readFileSync(path);
      writeFileSync(join(work, name), bytes);
      const { status, stdout, stderr } = spawnSync(program, command, { cwd: work, encoding: 'utf8', maxBuffer: 1 << 28 });
      try {
        const report = await own(bytes);
        assert.ok(status === 0 || status === 1, `${path}: ${stderr}`);
        assert.deepEqual(known(report), known(JSON.parse(stdout)), path);
        ++compared;
      } catch (error) {
        if (!(error instanceof GeometricContinuityError)) throw error;
        assert.equal(status, 2, `${path}: ${error.message}`);
        assert.ok(stderr.includes(error.message.slice(error.code.length + 2)), `${path}: ${error.message}\n${stderr}`);
        ++refused;
      }
    };
    const verify = (name, ...options) => ['verify', name, '--json', '--allow-empty', ...options];
    for (const path of [...demos('.svg'), ...corpus('drawings')]) {
      await compare(path, 'drawing.svg', verify('drawing.svg'), (bytes) => gc.verifySvg(bytes));
      for (const harmonise of [false, true])
        await compare(path, 'drawing.svg', ['repair', 'drawing.svg', '--json', '--to', harmonise ? 'G2' : 'G1', '-o', 'repaired.svg'], async (bytes) => {
          const { svg, report } = await gc.repairSvg(bytes, { harmonise });
          assert.equal(svg, readFileSync(join(work, 'repaired.svg'), 'utf8'), path);
          return report;
        });
    }
    for (const path of [...demos('.g2').filter((p) => /planar|space|lm/.test(p)), ...corpus('curves')])
      for (const closed of [false, true])
        await compare(path, 'curves.g2', verify('curves.g2', ...(closed ? ['--closed'] : [])), (bytes) => gc.verifyG2(bytes, { closed }));
    for (const path of [...demos('.g2').filter((p) => /box|fillet|hill|teapot/.test(p)), ...corpus('surfaces')])
      await compare(path, 'curves.g2', verify('curves.g2', '--surfaces'), (bytes) => gc.verifyG2(bytes, { surfaces: true }));
    // fonts of the system, of each format two; the bounds of angles are intervals, whose last
    // digits depend on the rounding
    const twelve_digits = (report) => JSON.parse(JSON.stringify(report), (key, x) => (key === 'angle_degrees' && x ? x.map((a) => a?.toPrecision(12)) : x));
    const fonts = spawnSync('sh', ['-c', 'find /usr/share/fonts /usr/share/texmf/fonts -name "*.[topw][tfo][fbt]*" -size -800k 2>/dev/null | sort | awk -F. \'++n[$NF] <= 2\''], { encoding: 'utf8' }).stdout.split('\n').filter((name) => name !== '');
    for (const path of fonts)
      await compare(path, 'font', ['verify', 'font', '--json', '--allow-empty', '--worst', '2'], (bytes) => gc.verifyFont(bytes, { worst: 2 }), twelve_digits);
    console.log(`# of them ${fonts.length} fonts`);
    console.log(`# ${compared} reports are the same, ${refused} files are refused by both`);
    assert.ok(compared > 20 && refused > 20);
  } finally {
    rmSync(work, { recursive: true });
  }
});
