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

// A point as an array. A DOMPoint, which has a w, lies in the plane.
function point(p, place) {
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

// The curves of a Path, of a Curve or of Segments of paper.js, or of a PolyBezier of bezier-js, and
// null of anything else.
function curvesOf(c, place) {
  if (typeof c !== 'object' || c === null) return null;
  const isSegment = (s) => typeof s === 'object' && s !== null && s.point !== undefined && s.handleIn !== undefined && s.handleOut !== undefined;
  if (isList(c)) return isSegment(c[0]) ? segmentCurves(c, false, place) : null;
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
function strategy(options) {
  const name = options.strategy ?? 'energy3';
  const given = (key) => (options[key] === undefined ? '-' : number(options[key], `options.${key}`));
  let scalars = [];
  if (options.s1 !== undefined || options.s2 !== undefined) scalars = [options.s1, options.s2];
  if (options.start !== undefined || options.end !== undefined)
    scalars = [options.start, options.end].flatMap((end) => (end ? [end.beta2, end.mu, end.beta3] : [undefined]));
  return [word(name, 'options.strategy'), given('beta'), given('eta'), scalars.length, ...scalars.map((x) => number(x, 'options: a parameter'))].join(' ');
}

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
  if (!isPath(text)) return text;
  const escaped = text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  return `<svg xmlns="http://www.w3.org/2000/svg"><path d="${escaped}"/></svg>`;
};

const fileBytes = (text) => {
  const bytes = typeof text === 'string' ? encoder.encode(text) : text instanceof ArrayBuffer ? new Uint8Array(text) : text;
  if (!(bytes instanceof Uint8Array)) refuse('malformed_input', `a text or bytes are expected, not ${described(text)}`);
  return bytes;
};

/** Loads the module. What reads files is a second one, which is loaded when it is needed first. */
export default async function load({ wasm, filesWasm } = {}) {
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

  return {
    continuity(left, right, { maxOrder = 3 } = {}) {
      return withoutNumbers(call('continuity', integer(maxOrder, 'options.maxOrder', 0, 32), ...sides(left, right)));
    },
    deviation(left, right) {
      return call('deviation', ...sides(left, right));
    },
    joinGrade(left, right, { kinkAngle = 5 } = {}) {
      return call('joinGrade', number(kinkAngle, 'options.kinkAngle'), ...sides(left, right));
    },
    blend(phi, psi, options = {}) {
      return blendResult(call('blend', strategy(options), curve(phi, 'phi', 'last'), curve(psi, 'psi', 'first')));
    },
    roundCorner(left, right, distance, options = {}) {
      const given = { strategy: 'fair', ...options };
      const result = call('roundCorner', strategy(given), number(distance, 'distance'), ...sides(left, right));
      return { ...result, blend: blendResult(result.blend) };
    },
    curvatureExcess(given, bound) {
      return call('curvatureExcess', number(bound, 'bound'), curve(given, 'curve', 'first')) ?? null;
    },
    edgeContinuity(patchA, edgeA, patchB, edgeB) {
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
    failingJoins(given, { order = 'G1', closed = Boolean(given?.closed), ...shape } = {}) {
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
    async verifySvg(svg, { maxOrder = 3, require = null, kinkAngle = 5 } = {}) {
      return callWithFile(drawing(svg), 'verifySvg', integer(maxOrder, 'options.maxOrder', 0, 32), require === null ? '-' : word(require, 'options.require'), number(kinkAngle, 'options.kinkAngle'));
    },
    async repairSvg(svg, { kinkAngle = 5, maxMove = null, harmonise = false } = {}) {
      const repaired = await callWithFile(drawing(svg), 'repairSvg', number(kinkAngle, 'options.kinkAngle'), maxMove === null ? '-' : number(maxMove, 'options.maxMove'), harmonise ? 1 : 0);
      return isPath(svg) ? { ...repaired, d: repaired.svg.match(/ d="([^"]*)"/)[1] } : repaired;
    },
    async svgCurves(svg) {
      return callWithFile(drawing(svg), 'svgCurves');
    },
    async verifyFont(font, { glyphs = '-', require = null, kinkAngle = 5, worst = 0 } = {}) {
      return callWithFile(font, 'verifyFont', require === null ? '-' : word(require, 'options.require'), number(kinkAngle, 'options.kinkAngle'), integer(worst, 'options.worst', 0, 1000000), glyphNames(glyphs));
    },
    async fontCurves(font, { glyphs = '-' } = {}) {
      return callWithFile(font, 'fontCurves', glyphNames(glyphs));
    },
    async verifyG2(g2, { maxOrder = 3, require = null, closed = false, surfaces = false, maxCurvature = null } = {}) {
      return callWithFile(g2, 'verifyG2', integer(maxOrder, 'options.maxOrder', 0, 32), require === null ? '-' : word(require, 'options.require'), closed ? 1 : 0, surfaces ? 1 : 0, maxCurvature === null ? '-' : number(maxCurvature, 'options.maxCurvature'));
    },
  };
}
