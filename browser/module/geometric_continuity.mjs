// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// The package compiled to WebAssembly: exact verdicts on joins, blends that are proved. See
// geometric_continuity.d.ts for the functions.

/** Thrown by functions on bad input; `code` is the code of the package, e.g. `malformed_input`. */
export class GeometricContinuityError extends Error {
  constructor(code, message) {
    super(`${code}: ${message}`);
    this.name = 'GeometricContinuityError';
    this.code = code;
  }
}

const refuse = (code, message) => {
  throw new GeometricContinuityError(code, message);
};

const described = (x) => {
  const text = typeof x === 'string' ? JSON.stringify(x) : typeof x === 'object' && x !== null ? Object.prototype.toString.call(x) : String(x);
  return text.length > 60 ? `${text.slice(0, 60)}…` : text;
};

// How alike two names are, from 0 to 1: by the pairs of letters that both have.
function likeness(a, b) {
  const pairs = (name) => new Set(Array.from(name.slice(1), (_, i) => name.slice(i, i + 2).toLowerCase()));
  const [p, q] = [pairs(a.replace(/_/g, '')), pairs(b)];
  return (2 * [...p].filter((pair) => q.has(pair)).length) / (p.size + q.size);
}

function nearest(name, names) {
  const best = names.reduce((one, other) => (likeness(name, other) > likeness(name, one) ? other : one));
  return likeness(name, best) > 0.5 ? best : null;
}

// Options that one may look for, and what there is.
const otherOptions = {
  tolerance: 'decisions are exact, and deviation(left, right) encloses gap and angles',
  radius: 'a circle of radius r touches the sides of a corner at the distance r * Math.tan(turn / 2)',
  order: "a strategy has its order: 'fair' G2, 'fair_g3' G3; joins are decided up to maxOrder",
};

// The options of a function, which has those named and no others.
function options(given = {}, place, names) {
  if (typeof given !== 'object' || given === null || isList(given))
    refuse('malformed_input', `${place}: the options are an object { ${names.join(', ')} }, not ${described(given)}`);
  for (const name of Object.keys(given)) {
    if (names.includes(name)) continue;
    const best = nearest(name, names), meant = otherOptions[name] ? `${otherOptions[name]}; there` : best ? `did you mean '${best}'? There` : 'there';
    refuse('malformed_input', `${place}: there is no option '${name}'; ${meant} are ${names.join(', ')}`);
  }
  return given;
}

// Numbers as the words that Request.h reads: the bits of a number, or the text of an exact one.
const bits = new DataView(new ArrayBuffer(8));
function number(x, place) {
  if (typeof x === 'number') {
    if (!Number.isFinite(x)) refuse('not_finite', `${place}: ${x}`);
    bits.setFloat64(0, x);
    return `#${bits.getUint32(0).toString(16)}${bits.getUint32(4).toString(16).padStart(8, '0')}`;
  }
  if (typeof x === 'bigint') return String(x);
  if (typeof x !== 'string') refuse('malformed_input', `${place}: a number is expected, not ${described(x)}`);
  if (!/^[-+0-9.eE/]+$/.test(x)) refuse('malformed_input', `${place}: ${described(x)} is not a number`);
  return x;
}

const isList = (x) => Array.isArray(x) || (ArrayBuffer.isView(x) && !(x instanceof DataView));

const patches = "edgeContinuity(patchA, 'u1', patchB, 'u0') decides two patches";

// A point as an array. A DOMPoint, which has a w, lies in the plane.
function point(p, place) {
  if (isList(p) && p.length > 0 && typeof p[0] === 'object')
    refuse('malformed_input', `${place}: the coordinates of a point are numbers; ${patches}; failingJoins(curves) takes several curves`);
  if (isList(p)) return p;
  if (typeof p !== 'object' || p === null || p.x === undefined || p.y === undefined)
    refuse('malformed_input', `${place}: a point is an array [x, y] or an object { x, y }, in space with z, not ${described(p)}`);
  return p.z === undefined || p.w !== undefined ? [p.x, p.y] : [p.x, p.y, p.z];
}

// Points as arrays of one dimension.
function points(list, place) {
  if (!isList(list)) refuse('malformed_input', `${place}: an array of points is expected, not ${described(list)}`);
  if (list.length === 0) refuse('wrong_number_of_points', `${place}: no points`);
  const result = Array.from(list, (p, j) => point(p, `${place}[${j}]`)), dimension = result[0].length;
  for (const [j, { length }] of result.entries())
    if (length !== dimension || dimension === 0) refuse('dimension_mismatch', `${place}[${j}]: ${length} coordinates, ${dimension} in the first point`);
  return result;
}

// Path data of SVG as one word, of which the module takes the last segment or the first one.
function path(d, place, end) {
  if (!/^[\sA-Za-z0-9.,+-]+$/.test(d)) refuse('malformed_input', `${place}: ${described(d)} is no path data, such as "M0 0C1 0 2 1 3 1"`);
  return `${end} ${place} ${d.replace(/\s/g, '~')}`;
}

// A number as a whole number of the smallest steps between numbers.
const stepsOfOne = 1n << 1074n;
function steps(x) {
  bits.setFloat64(0, Math.abs(x));
  const all = bits.getBigUint64(0), exponent = all >> 52n, mantissa = all & ((1n << 52n) - 1n);
  const n = exponent === 0n ? mantissa : (mantissa | (1n << 52n)) << (exponent - 1n);
  return x < 0 ? -n : n;
}

// The sum of two numbers, exactly: a number where it is one, otherwise a fraction.
function sum(x, y) {
  const s = x + y, z = s - x, rest = x - (s - z) + (y - z);
  if (rest === 0 || !Number.isFinite(s)) return s;
  const n = steps(x) + steps(y), common = n & -n;
  return `${n / common}/${stepsOfOne / common}`;
}

// A number as the text of an exact one, and nearly.
function exactly(x) {
  if (typeof x !== 'number') return String(x);
  if (Number.isInteger(x)) return String(BigInt(x));
  const n = steps(x), common = n & -n;
  return `${n / common}/${stepsOfOne / common}`;
}
const nearly = (x) => (typeof x === 'string' ? x.split('/').map(Number).reduce((p, q) => p / q) : Number(x));

// The curves between segments of paper.js, whose handles are relative to their points: cubics, and
// lines where there are no handles.
function segmentCurves(segments, closed, place) {
  const curves = [], last = segments.length - (closed ? 0 : 1);
  for (let i = 0; i < last; ++i) {
    const a = segments[i], b = segments[(i + 1) % segments.length];
    const [p, q, out, into] = [a.point, b.point, a.handleOut, b.handleIn].map((x) => point(x, `${place}: segment ${i}`));
    const isLine = [...out, ...into].every((x) => x === 0);
    curves.push(isLine ? [p, q] : [p, p.map((x, k) => sum(x, out[k])), q.map((x, k) => sum(x, into[k])), q]);
  }
  return curves;
}

// The curves of a Path, of a Curve or of Segments of paper.js, of a PolyBezier of bezier-js, or of
// lines, Bézier curves and paths of three.js, and null of anything else.
function curvesOf(c, place) {
  if (typeof c !== 'object' || c === null) return null;
  const isSegment = (s) => typeof s === 'object' && s !== null && s.point !== undefined && s.handleIn !== undefined && s.handleOut !== undefined;
  if (isList(c)) return isSegment(c[0]) ? segmentCurves(c, false, place) : null;
  if (/^(Spline|CatmullRom|Ellipse|Arc)Curve3?$/.test(c.type)) refuse('malformed_input', `${place}: ${c.type} of three.js is no Bézier curve; give the control points of one`);
  if (isList(c.commands)) refuse('malformed_input', `${place}: a path with commands, as of opentype.js; give its path data, path.toPathData(17)`);
  if (c.v1 !== undefined && c.v2 !== undefined) return [[c.v0, c.v1, c.v2, c.v3].filter((v) => v !== undefined)];
  if (isSegment(c.segment1) && isSegment(c.segment2)) return segmentCurves([c.segment1, c.segment2], false, place);
  if (isList(c.children)) refuse('malformed_input', `${place}: a group of ${c.children.length} paths, such as a CompoundPath; give one of its children`);
  if (isList(c.segments)) return segmentCurves(c.segments, Boolean(c.closed), place);
  return isList(c.curves) ? Array.from(c.curves) : null;
}

const isObject = (c) => typeof c === 'object' && c !== null && !isList(c);
const controlPoints = (c, place) => points(isObject(c) ? c.control_points ?? c.points : c, place);

// An array of control points, or an object with them, weights and a domain, or path data or the
// curves of another library, of which one is at this end of a join.
function curve(c, place, end) {
  if (c === undefined) refuse('malformed_input', `${place}: this curve is missing: a join is that of two; verifySvg() decides those inside of a path`);
  if (typeof c?.getAttribute === 'function') return curve(c.getAttribute('d'), place, end);
  if (typeof c === 'string') return path(c, place, end);
  const curves = curvesOf(c, place);
  if (curves?.length === 0) refuse('wrong_number_of_points', `${place}: the path draws nothing`);
  if (curves) return curve(curves.at(end === 'last' ? -1 : 0), place, end);
  const list = controlPoints(c, place);
  const weights = (isObject(c) && c.weights) || null, domain = (isObject(c) && c.domain) || [0, 1];
  const dimension = list[0].length;
  if (weights && weights.length !== list.length)
    refuse('wrong_number_of_points', `${place}: ${weights.length} weights of ${list.length} points`);
  if (!isList(domain) || domain.length !== 2) refuse('malformed_input', `${place}: a domain is two numbers`);
  const words = [dimension, list.length, weights ? 1 : 0, number(domain[0], `${place}.domain`), number(domain[1], `${place}.domain`)];
  for (let j = 0; j < list.length; ++j) {
    if (weights) words.push(number(weights[j], `${place}.weights[${j}]`));
    for (let i = 0; i < dimension; ++i) words.push(number(list[j][i], `${place}[${j}][${i}]`));
  }
  return words.join(' ');
}

// The control points of a patch, those of one u together.
function patch(net, place) {
  if (!isList(net) || net.length === 0) refuse('wrong_number_of_points', `${place}: an array of rows of points is expected`);
  const words = [];
  for (let i = 0; i < net.length; ++i) {
    const row = points(net[i], `${place}[${i}]`);
    if (row[0].length !== 3) refuse('dimension_mismatch', `${place}[${i}]: points in space are expected`);
    if (row.length !== net[0].length) refuse('wrong_number_of_points', `${place}[${i}]: rows of different lengths`);
    for (let j = 0; j < row.length; ++j)
      for (let k = 0; k < 3; ++k) words.push(number(row[j][k], `${place}[${i}][${j}][${k}]`));
  }
  return `${net.length - 1} ${net[0].length - 1} ${words.join(' ')}`;
}

// The numbers of a chain, one after the other, and the degree and dimension: those of the options,
// or of curves; or the curves, where they are no numbers of one degree.
function chain(given, degree, dimension) {
  const curves = curvesOf(given, 'failingJoins') ?? given;
  if (!isList(curves)) refuse('malformed_input', `failingJoins: an array of numbers or of curves is expected, not ${described(curves)}; verifySvg() takes path data`);
  if (curves.length === 0 || typeof curves[0] !== 'object')
    return { numbers: curves instanceof Float64Array ? curves : Float64Array.from(curves), degree, dimension };
  const all = Array.from(curves).flatMap((c) => curvesOf(c, 'failingJoins') ?? [c]);
  const lists = all.map((c, i) => controlPoints(c, `failingJoins: curve ${i}`)), [first] = lists;
  for (const [i, list] of lists.entries())
    if (list[0].length !== first[0].length) refuse('dimension_mismatch', `failingJoins: curve ${i} has ${list[0].length} coordinates, the first one ${first[0].length}`);
  const shape = { degree: first.length - 1, dimension: first[0].length };
  const arePlain = all.every((c, i) => lists[i].length === first.length && !c.weights && !c.domain && lists[i].every((p) => Array.from(p).every((x) => typeof x === 'number')));
  return arePlain ? { numbers: Float64Array.from(lists.flatMap((list) => list.flatMap((p) => [...p]))), ...shape } : { curves: all, ...shape };
}

function integer(x, place, low, high) {
  if (!Number.isInteger(x) || x < low || high < x) refuse('malformed_input', `${place}: an integer from ${low} to ${high} is expected, not ${described(x)}`);
  return x;
}

const word = (x, place) => {
  if (typeof x !== 'string' || !/^\w+$/.test(x)) refuse('malformed_input', `${place}: a name is expected, not ${described(x)}`);
  return x;
};

const glyphNames = (x) => {
  if (typeof x !== 'string' || !/^[^\s]+$/.test(x)) refuse('malformed_input', `options.glyphs: names without spaces are expected, not ${described(x)}`);
  return x;
};

// The names, and the scalars of the strategies that take some.
function strategy(asked) {
  const name = asked.strategy ?? 'energy3';
  const given = (key) => (asked[key] === undefined ? '-' : number(asked[key], `options.${key}`));
  let scalars = [];
  if (asked.s1 !== undefined || asked.s2 !== undefined) scalars = [asked.s1, asked.s2];
  if (asked.start !== undefined || asked.end !== undefined)
    scalars = [asked.start, asked.end].flatMap((end) => (end ? [end.beta2, end.mu, end.beta3] : [undefined]));
  return [word(name, 'options.strategy'), given('beta'), given('eta'), scalars.length, ...scalars.map((x) => number(x, 'options: a parameter'))].join(' ');
}

const ofBlends = ['strategy', 'beta', 'eta', 's1', 's2', 'start', 'end'];

const questions = ['C0', 'C1', 'C2', 'C3', 'G1', 'G2', 'G3', 'F3'];

async function compiled(source, name) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  const url = new URL(source ?? `./${name}.wasm`, import.meta.url);
  if (url.protocol === 'file:' && typeof process === 'object') {
    const { readFile } = await import('node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) refuse('cannot_read_file', `${url}: ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

const encoder = new TextEncoder(), decoder = new TextDecoder();

// A compiled module with its memory.
class Instance {
  static async of(source, name) {
    const module = await compiled(source, name), instance = new Instance(), system = instance.#system(), imports = {};
    for (const { module: from, name: what, kind } of WebAssembly.Module.imports(module)) {
      const missing = from === 'env' ? -52 : 52; // "not implemented", of system calls and of WASI
      const call = what.startsWith('invoke_') ? system.invoke : system[what];
      if (kind === 'function') (imports[from] ??= {})[what] = call ?? (() => missing);
    }
    instance.functions = (await WebAssembly.instantiate(module, imports)).exports;
    instance.functions._initialize?.();
    return instance;
  }

  get memory() {
    return this.functions.memory.buffer;
  }

  // The functions of a system that the C library calls: there are no variables and no standard
  // streams.
  #system() {
    const set = (address, x) => new DataView(this.memory).setUint32(address, x, true), success = 0;
    let high = 0; // of a result of 64 bits
    return {
      // setjmp() and longjmp() of C, by which FreeType leaves out tables of characters that are
      // malformed: the latter throws a number, which ends the call that the former has made.
      invoke: (index, ...args) => {
        const { __indirect_function_table: table, setThrew, stackRestore, stackSave } = this.functions, top = stackSave();
        try {
          return table.get(index)(...args);
        } catch (e) {
          stackRestore(top);
          if (typeof e !== 'number') throw e;
          setThrew(1, 0);
          return 0;
        }
      },
      _emscripten_throw_longjmp: () => {
        throw Infinity;
      },
      setTempRet0: (x) => void (high = x),
      getTempRet0: () => high,
      proc_exit: (code) => refuse('work_limit', `the module has stopped with code ${code}`),
      environ_sizes_get: (count, size) => (set(count, 0), set(size, 0), success),
      environ_get: () => success,
      clock_time_get: (_id, _precision, time) => (new DataView(this.memory).setBigUint64(time, BigInt(Date.now()) * 1000000n, true), success),
      fd_write: (_descriptor, vectors, n, written) => {
        let size = 0;
        for (let i = 0; i < n; ++i) size += new DataView(this.memory).getUint32(vectors + 8 * i + 4, true);
        set(written, size);
        return success;
      },
    };
  }

  // Calls f(address, size) with bytes in the memory.
  withBytes(bytes, f) {
    const address = this.functions.gc_allocate(bytes.byteLength || 1);
    if (address === 0) refuse('work_limit', 'there is not enough memory');
    try {
      new Uint8Array(this.memory).set(bytes, address);
      return f(address, bytes.byteLength);
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
        refuse('work_limit', `the module has run out of memory or stack (${error.message})`);
      throw error;
    } finally {
      this.functions.gc_free(address);
    }
  }

  answer() {
    const begin = this.functions.gc_answer(), size = this.functions.gc_answer_size();
    const text = decoder.decode(new Uint8Array(this.memory, begin, size));
    const result = text === '' ? undefined : JSON.parse(text);
    if (result?.error) refuse(result.error.code, result.error.message);
    return result;
  }

  call(...words) {
    return this.callWithFile(new Uint8Array(0), ...words);
  }

  // Calls a function with words, which the bytes of a file follow.
  callWithFile(file, ...words) {
    const head = encoder.encode(`${words.join(' ')}\n`), all = new Uint8Array(head.length + file.length);
    all.set(head);
    all.set(file, head.length);
    return this.withBytes(all, (address, size) => {
      this.functions.gc_call(address, size);
      return this.answer();
    });
  }
}

// Path data alone becomes a drawing of one path.
const isPath = (text) => typeof text === 'string' && /^\s*[Mm]/.test(text);
const drawing = (text) => {
  if (typeof text === 'string' && !isPath(text) && !text.includes('<'))
    refuse('malformed_input', `${described(text)} is neither a drawing nor path data, such as "M0 0C1 0 2 1 3 1"; give the text of a file, and not its name`);
  if (!isPath(text)) return text;
  const escaped = text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  return `<svg xmlns="http://www.w3.org/2000/svg"><path d="${escaped}"/></svg>`;
};

const fontBytes = (font) => (typeof font === 'string' ? refuse('malformed_input', 'a font is bytes, e.g. of fs.readFileSync(path), not a text') : font);

const fileBytes = (text) => {
  const bytes = typeof text === 'string' ? encoder.encode(text) : text instanceof ArrayBuffer ? new Uint8Array(text) : text;
  if (!(bytes instanceof Uint8Array)) refuse('malformed_input', `a text or bytes are expected, not ${described(text)}`);
  return bytes;
};

/** Loads the module. What reads files is a second one, which is loaded when it is needed first. */
async function load({ wasm, filesWasm } = {}) {
  const module = await Instance.of(wasm, 'geometric_continuity');
  const call = (...words) => module.call(...words);
  let files = null;
  const callWithFile = async (text, ...words) => {
    const bytes = fileBytes(text);
    files ??= Instance.of(filesWasm, 'geometric_continuity_files').catch((error) => {
      files = null;
      throw error;
    });
    return (await files).callWithFile(bytes, ...words);
  };
  const withoutNumbers = ({ left: _left, right: _right, ...join }) => join;
  const blendResult = (result) => {
    const joins = Object.entries(result).filter(([name]) => name.endsWith('_join')).map(([name, join]) => [name, withoutNumbers(join)]);
    return { ...result, ...Object.fromEntries(joins) };
  };

  const sides = (left, right) => [curve(left, 'left', 'last'), curve(right, 'right', 'first')];

  const functions = {
    continuity(left, right, given) {
      const { maxOrder = 3 } = options(given, 'continuity', ['maxOrder']);
      return withoutNumbers(call('continuity', integer(maxOrder, 'options.maxOrder', 0, 32), ...sides(left, right)));
    },
    deviation(left, right) {
      return call('deviation', ...sides(left, right));
    },
    joinGrade(left, right, given) {
      const { kinkAngle = 5 } = options(given, 'joinGrade', ['kinkAngle']);
      return call('joinGrade', number(kinkAngle, 'options.kinkAngle'), ...sides(left, right));
    },
    blend(phi, psi, given) {
      return blendResult(call('blend', strategy(options(given, 'blend', ofBlends)), curve(phi, 'phi', 'last'), curve(psi, 'psi', 'first')));
    },
    roundCorner(left, right, distance, given) {
      const result = call('roundCorner', strategy({ strategy: 'fair', ...options(given, 'roundCorner', ofBlends) }), number(distance, 'distance'), ...sides(left, right));
      return { ...result, blend: blendResult(result.blend) };
    },
    roundCorners(vertices, distance, given) {
      const { closed = false, ...asked } = options(given, 'roundCorners', ['closed', ...ofBlends]);
      number(distance, 'distance');
      const list = points(vertices, 'vertices'), meets = (a, b) => functions.continuity([a, a], [b, b], { maxOrder: 0 }).c_order === 0;
      for (const [i, p] of list.entries()) for (const x of p) number(x, `vertices[${i}]`);
      const isClosed = closed || (list.length > 2 && meets(list.at(-1), list[0]));
      if (list.length > 2 && meets(list.at(-1), list[0])) list.pop();
      const n = list.length, sides = list.map((p, i) => [p, list[(i + 1) % n]]).slice(0, isClosed ? n : -1), following = (i) => (i + 1) % sides.length;
      if (n < 2) refuse('wrong_number_of_points', 'roundCorners: two vertices are needed at least');
      for (const [i, [a, b]] of sides.entries()) if (meets(a, b)) refuse('parameter_outside_domain', `roundCorners: the vertices ${i} and ${(i + 1) % n} are one point`);
      const isCorner = sides.map((side, i) => (isClosed || i + 1 < sides.length) && functions.continuity(side, sides[following(i)]).g_order < 2);
      const longest = sides.map(([a, b], i) => Math.hypot(...a.map((x, k) => nearly(x) - nearly(b[k]))) * (isCorner[i] && isCorner.at(i - 1) ? 0.375 : 0.75));
      const corners = sides.map((side, i) => {
        const limit = Math.min(longest[i], longest[following(i)]);
        try {
          return isCorner[i] ? functions.roundCorner(side, sides[following(i)], limit < nearly(distance) ? limit : distance, asked) : null;
        } catch ({ code, message }) {
          return refuse(code, message.replace(`${code}: `, `vertex ${(i + 1) % n}: `));
        }
      });
      const curveOf = (control_points, doubles) => ({ control_points, points: doubles, domain: ['0', '1'] });
      return sides.flatMap(([a, b], i) => {
        const before = corners.at(i - 1)?.right ?? curveOf([a.map(exactly)], [a.map(nearly)]);
        const behind = corners[i]?.left ?? curveOf([b.map(exactly)], [b.map(nearly)]), blend = corners[i]?.blend;
        const side = curveOf([before.control_points[0], behind.control_points.at(-1)], [before.points[0], behind.points.at(-1)]);
        return [side, ...(blend ? blend.curves ?? [blend.curve] : [])];
      });
    },
    curvatureExcess(given, bound) {
      return call('curvatureExcess', number(bound, 'bound'), curve(given, 'curve', 'first')) ?? null;
    },
    edgeContinuity(patchA, edgeA, patchB, edgeB) {
      if (typeof edgeA !== 'string') refuse('malformed_input', "edgeContinuity: each patch stands before its edge: edgeContinuity(patchA, 'u1', patchB, 'u0')");
      return call('edgeContinuity', word(edgeA, 'edgeA'), word(edgeB, 'edgeB'), patch(patchA, 'patchA'), patch(patchB, 'patchB'));
    },
    alignHandles(left, right, maxMove = 16) {
      const vector = (v, place) => {
        const [x] = points([v], place);
        if (x.length !== 2) refuse('dimension_mismatch', `${place}: two coordinates are expected`);
        return `${number(x[0], place)} ${number(x[1], place)}`;
      };
      return call('alignHandles', vector(left, 'left'), vector(right, 'right'), number(maxMove, 'maxMove'));
    },
    failingJoins(given, asked) {
      const { order = 'G1', closed = Boolean(given?.closed), ...shape } = options(asked, 'failingJoins', ['order', 'closed', 'degree', 'dimension']);
      const { numbers, curves, degree, dimension } = chain(given, shape.degree ?? 3, shape.dimension ?? 2);
      integer(degree, 'options.degree', 1, 1000);
      integer(dimension, 'options.dimension', 2, 3);
      const question = questions.indexOf(order);
      if (question < 0) refuse('malformed_input', `options.order: one of ${questions.join(', ')} is expected, not ${described(order)}`);
      if (order === 'F3' && dimension === 2) refuse('dimension_mismatch', 'failingJoins: in the plane the order F ends with 2');
      if (curves) {
        const kind = { C: 'c_order', G: 'g_order', F: 'f_order' }[order[0]], joins = curves.map((_, i) => i).slice(0, closed ? undefined : -1);
        const at = (i, end) => curve(curves[i % curves.length], `failingJoins: curve ${i % curves.length}`, end);
        return Uint32Array.from(joins.filter((i) => call('continuity', 3, at(i, 'last'), at(i + 1, 'first'))[kind] < Number(order[1])));
      }
      const step = (degree + 1) * dimension;
      if (numbers.length % step !== 0) refuse('wrong_number_of_points', `failingJoins: ${numbers.length} numbers are no multiple of ${step}`);
      return module.withBytes(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength), (address) => {
        const n = module.functions.gc_failing_joins(address, numbers.length / step, degree, dimension, question, closed ? 1 : 0);
        if (n < 0) module.answer();
        const begin = module.functions.gc_failing();
        return new Uint32Array(module.memory.slice(begin, begin + 4 * n));
      });
    },
    async verifySvg(svg, given) {
      const { maxOrder = 3, require = null, kinkAngle = 5 } = options(given, 'verifySvg', ['maxOrder', 'require', 'kinkAngle']);
      return callWithFile(drawing(svg), 'verifySvg', integer(maxOrder, 'options.maxOrder', 0, 32), require === null ? '-' : word(require, 'options.require'), number(kinkAngle, 'options.kinkAngle'));
    },
    async repairSvg(svg, given) {
      const { kinkAngle = 5, maxMove = null, harmonise = false } = options(given, 'repairSvg', ['kinkAngle', 'maxMove', 'harmonise']);
      const repaired = await callWithFile(drawing(svg), 'repairSvg', number(kinkAngle, 'options.kinkAngle'), maxMove === null ? '-' : number(maxMove, 'options.maxMove'), harmonise ? 1 : 0);
      return isPath(svg) ? { ...repaired, d: repaired.svg.match(/ d="([^"]*)"/)[1] } : repaired;
    },
    async svgCurves(svg) {
      return callWithFile(drawing(svg), 'svgCurves');
    },
    async verifyFont(font, given) {
      const { glyphs = '-', require = null, kinkAngle = 5, worst = 0 } = options(given, 'verifyFont', ['glyphs', 'require', 'kinkAngle', 'worst']);
      return callWithFile(fontBytes(font), 'verifyFont', require === null ? '-' : word(require, 'options.require'), number(kinkAngle, 'options.kinkAngle'), integer(worst, 'options.worst', 0, 1000000), glyphNames(glyphs));
    },
    async fontCurves(font, given) {
      const { glyphs = '-' } = options(given, 'fontCurves', ['glyphs']);
      return callWithFile(fontBytes(font), 'fontCurves', glyphNames(glyphs));
    },
    async verifyG2(g2, given) {
      const ofG2 = ['maxOrder', 'require', 'closed', 'surfaces', 'maxCurvature'];
      const { maxOrder = 3, require = null, closed = false, surfaces = false, maxCurvature = null } = options(given, 'verifyG2', ofG2);
      return callWithFile(g2, 'verifyG2', integer(maxOrder, 'options.maxOrder', 0, 32), require === null ? '-' : word(require, 'options.require'), closed ? 1 : 0, surfaces ? 1 : 0, maxCurvature === null ? '-' : number(maxCurvature, 'options.maxCurvature'));
    },
  };
  current = new Proxy(functions, { get: (all, name) => (name in all || isAsked(name) ? all[name] : missing(name, Object.keys(all))) });
  return current;
}

// Languages, frameworks and tests ask any object for these names.
const isAsked = (name) => typeof name === 'symbol' || /^[_$@]|^(then|toJSON|asymmetricMatch|nodeType|tagName)$/.test(name);

// Names that other libraries have, and the call here.
const guesses = [
  [/^is_?([CG])_?([123])|^([CG])([123])$|^(geometric|parametric)_?Continuity$/i, "continuity(left, right).g_order >= 1, c_order with derivatives; failingJoins(curves, { order: 'G1' }) for many"],
  [/font|glyph/i, 'verifyFont(bytes), fontCurves(bytes)'],
  [/surface|patch|face/i, "edgeContinuity(patchA, 'u1', patchB, 'u0')"],
  [/^(smooth|mend|fix|repair|harmoni)|simplify/i, 'repairSvg(d) for path data or a drawing, alignHandles(left, right) for two handles, blend(left, right) between curves'],
  [/^(analy|check|inspect|find|parse|read|load.|verify|svg)|kink|smooth/i, 'verifySvg(d) for path data or a drawing, continuity(left, right) for two curves, failingJoins(curves) for many'],
  [/fillet|^round|corner/i, 'roundCorner(left, right, distance) for two curves, roundCorners(points, distance, { closed: true }) for a polygon'],
  [/class|angle/i, 'joinGrade(left, right), deviation(left, right)'],
  [/within|tolerance|distance/i, 'deviation(left, right), which encloses gap, angle and jumps'],
  [/^chain|joins/i, "failingJoins(curves, { order: 'G1' })"],
  [/^connect|^bridge|^fair|^join$/i, "blend(left, right, { strategy: 'fair' })"],
  [/^(fit|interpolate|evaluate|spline|length|split|offset|intersect|derivative|bbox|get)/i, 'evaluate(), interpolate() or fit() of the Python module or of C++; curves of bezier-js, paper.js and three.js are taken here'],
  [/^(init|load|default)$/, 'gc.continuity(left, right) and the others at once: the module is loaded'],
  [/bezier|spline$|nurbs|curve$|^(line|path|point|segment)$/i, 'continuity(left, right) with arrays of control points or path data, which are curves; no class is needed'],
];

function missing(name, names) {
  const same = names.find((n) => n.toLowerCase() === name.replace(/_/g, '').toLowerCase());
  const meant = (same ? null : guesses.find(([pattern]) => pattern.test(name))?.[1]), best = nearest(name, names);
  throw new TypeError(`gc.${name} is not there: ${meant ? `call ${meant}` : best ? `did you mean ${best}(...)?` : `there are ${names.join(', ')}`}`);
}

// Names that are imported though they are not there: when called they tell what is.
const guessed = ['BezierCurve', 'BSpline', 'Nurbs', 'isC1', 'isC2', 'isG1', 'isG2', 'isG3', 'geometricContinuity'];

// The functions by their names work when the module has been loaded.
let current = null;
const byName = new Proxy({}, {
  get: (_, name) => function called(...given) { // no arrow, so that new also gets the answer
    if (guessed.includes(name)) missing(name, ['continuity']);
    if (current === null) throw new Error(`${name}: the module is not loaded yet; call const gc = await load(); gc.${name}(...)`);
    return current[name](...given);
  },
});
// A function that is asked of what loads it.
const loader = new Proxy(load, {
  get(all, name) {
    if (name in all || isAsked(name)) return Reflect.get(all, name);
    throw new TypeError(`${String(name)}: what is imported is the function that loads the module; call const gc = await load(); then gc.${String(name)}(...)`);
  },
});
export { loader as load, loader as default };
export const {
  continuity, deviation, joinGrade, blend, roundCorner, roundCorners, curvatureExcess, edgeContinuity, alignHandles, failingJoins, verifySvg, repairSvg,
  svgCurves, verifyFont, fontCurves, verifyG2,
  BezierCurve, BSpline, Nurbs, isC1, isC2, isG1, isG2, isG3, geometricContinuity,
} = byName;
