// SPDX-License-Identifier: CC0-1.0

// The npm package geometric-continuity: its functions on numbers as texts, drawings and fonts.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { Unsupported, least, level, pairs, readChain, serve } from '../answers.mjs';

// The folder of the package, if it is not installed here.
const module = process.env.GEOMETRIC_CONTINUITY_NPM ? pathToFileURL(`${process.env.GEOMETRIC_CONTINUITY_NPM}/geometric_continuity.mjs`).href
                                                    : createRequire(import.meta.url).resolve('geometric-continuity');
const gc = await (await import(module)).default();

const curve = ({ points, weights }) => (weights ? { control_points: points, weights } : points);

function join(left, right, order) {
  const decided = gc.continuity(curve(left), curve(right));
  if (decided.c_order < 0) return 'gap';
  if (order[0] === 'C') return `C${decided.c_order}`;
  if (!decided.regular) throw new Unsupported('G orders where a first derivative is 0');
  const reached = order[0] === 'F' ? decided.f_order : decided.g_order;
  return order === 'F3' && reached === 3 ? 'F3' : `G${reached}`;
}

async function drawing(file) {
  const grades = { corner: 'G0', kink: 'G0', bend: 'G0', rounding: 'G0', G1: 'G1', G2: 'G2' };
  const found = await gc.verifySvg(readFileSync(file, 'utf8'));
  const reached = least(found.joins.map(j => grades[j.grade]));
  return reached === 'G2' ? 'G2+' : reached;
}

async function font(file) {
  const bytes = readFileSync(file); // the glyph 1 is the letter A
  if (bytes.subarray(0, 400).includes('fvar')) throw new Unsupported('all instances of a variable font by this adapter');
  const counts = (await gc.verifyFont(bytes, { glyphs: '#1' })).summary;
  const first = ['corners', 'kinks', 'bends', 'rounding', 'G1', 'G2'].find(k => counts[k]);
  return first === 'G2' ? 'G2+' : first === 'G1' ? 'G1' : 'G0';
}

serve((file, order, within) => {
  if (within) throw new Unsupported('tolerances by this adapter');
  if (file.endsWith('.svg')) return drawing(file);
  if (/\.[to]tf$/.test(file)) return font(file);
  const chain = readChain(file);
  if (chain.curves.some(c => c.knots)) throw new Unsupported('splines by this adapter');
  return least(pairs(chain).map(([a, b]) => join(a, b, order)));
});
