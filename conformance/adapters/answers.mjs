// SPDX-License-Identifier: CC0-1.0

// All adapters in JavaScript answer lines "FILE ORDER [TOLERANCES]" with lines "= ...".
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

export class Unsupported extends Error {}

// Systems without a verdict of their own are asked with these tolerances.
export const close = { gap: 1e-9, angle: 1e-9, percent: 1e-4 };
export const claim = order => `${order} within gap=1e-9,angle_radians=1e-9,curvature_percent=1e-4`;

export function tolerances(text) {
  if (!text) return null;
  const given = Object.fromEntries(text.split(',').map(part => part.split('=')));
  return { gap: +(given.gap ?? 0), angle: (+(given.angle_degrees ?? 0) * Math.PI) / 180, percent: +(given.curvature_percent ?? 0) };
}

/** The curves of a JSON file, with their numbers as texts. */
export function readChain(file) {
  const content = JSON.parse(readFileSync(file, 'utf8'));
  if (!content.curves) throw new Unsupported('surfaces');
  return content;
}

export function number(text) {
  const [p, q] = text.split('/');
  return q ? p / q : +p;
}

/** All joins of a chain, as pairs of curves. */
export function pairs({ curves, closed }) {
  const result = curves.slice(1).map((curve, i) => [curves[i], curve]);
  if (closed) result.push([curves.at(-1), curves[0]]);
  return result;
}

export const level = order => (order === 'gap' ? -1 : +order[1]);
export function least(orders) {
  if (!orders.length) throw new Unsupported('joins inside of a spline');
  return orders.reduce((a, b) => (level(b) < level(a) ? b : a));
}

export async function serve(decide) {
  for await (const line of createInterface({ input: process.stdin })) {
    const [file, order, within] = line.trim().split(/\s+/);
    if (!file) continue;
    let answer;
    try {
      answer = await decide(file, order, within);
    } catch (error) {
      answer = error instanceof Unsupported ? `unsupported ${error.message}` : `refused ${String(error.message ?? error).split('\n')[0]}`;
    }
    console.log(`\n= ${answer}`);
  }
}
