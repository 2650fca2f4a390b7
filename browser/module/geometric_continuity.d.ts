// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

/** A number as it is, or the text of an exact one: a decimal or a fraction, e.g. "0.1", "1/3". */
export type Exact = number | bigint | string;
/** A point: an array of any dimension, or an object. A DOMPoint lies in the plane. */
export type Point = ArrayLike<Exact> | { readonly x: Exact; readonly y: Exact; readonly z?: Exact };

/** A Segment of paper.js: handles are relative to the point, and added exactly. */
export interface HandledPoint {
  readonly point: Point;
  readonly handleIn: Point;
  readonly handleOut: Point;
}

/**
 * Several curves: Segments of paper.js, or a Path of these; or the curves of a PolyBezier of
 * bezier-js, or of a path of three.js.
 */
export type CurveChain =
  | ReadonlyArray<HandledPoint>
  | { readonly segments: ReadonlyArray<HandledPoint>; readonly closed?: boolean }
  | { readonly curves: ReadonlyArray<Curve> };

/**
 * The control points of a Bézier curve, of any degree and dimension; with weights a rational one.
 * A text is path data of SVG, the attribute `d`, whose decimals are taken exactly. Of it, and of
 * several curves, the last one is that on the left of a join, and the first one that on the right.
 * A Curve of paper.js, a Bezier of bezier-js, a line and a Bézier curve of three.js are curves,
 * too, and so is a path element of a drawing.
 */
export type Curve = string | CurveChain | ReadonlyArray<Point> | { readonly v0?: Point; readonly v1: Point; readonly v2: Point; readonly v3?: Point }
  | { getAttribute(name: 'd'): string | null } | { readonly segment1: HandledPoint; readonly segment2: HandledPoint } | {
  control_points?: ReadonlyArray<Point>;
  points?: ReadonlyArray<Point>;
  weights?: ReadonlyArray<Exact>;
  /** The domain, [0, 1] by default. */
  domain?: readonly [Exact, Exact];
};

/** The control points of a Bézier patch in space; each row has the points of one u. */
export type Patch = ReadonlyArray<ReadonlyArray<Point>>;
export type Edge = 'u0' | 'u1' | 'v0' | 'v1';

/** Guaranteed bounds; an upper bound of null is infinite. */
export type Enclosure = [number, number | null];

/**
 * The decision about the join of the end of one curve and the start of another one, with the
 * members of the C++ class Join_continuity.
 */
export interface Join {
  /** The largest k such that all derivatives up to order k agree; -1 at a gap. */
  c_order: number;
  /** The same for derivatives with respect to arc length. */
  g_order: number;
  /** The same for the Frenet frame and the curvatures. */
  f_order: number;
  /** The shape parameters, exactly. */
  betas: string[];
  regular: boolean;
  tangent_equal: boolean | null;
  curvature_equal: boolean | null;
  curvature_vector_equal: boolean | null;
  torsion_equal: boolean | null;
}

export interface Deviation {
  gap: Enclosure;
  /** In radians. */
  tangent_angle: Enclosure | null;
  /** Relative to the larger curvature. */
  curvature_jump: Enclosure | null;
  torsion_jump: Enclosure | null;
  angle_degrees: Enclosure | null;
  curvature_percent: Enclosure | null;
}

export interface Grade {
  grade: 'gap' | 'corner' | 'kink' | 'G1' | 'G2' | null;
  angle_degrees: Enclosure | null;
  handle_offset: Enclosure | null;
}

export interface ResultCurve {
  /** Exact numbers. */
  control_points: string[][];
  /** The doubles that are nearest to them. */
  points: number[][];
  weights?: string[];
  domain: [string, string];
}

export type QuinticStrategy = 'c2' | 'normal' | 'min_second' | 'near_line' | 'energy2' | 'energy3' | 'fair' | 'free';
export type SepticStrategy = 'c3' | 'seq_g3' | 'seq_f3' | 'joint_g3' | 'energy3_g3' | 'energy4_g3' | 'fair_g3' | 'fair_f3' | 'free3';

export interface SepticEnd<Number> {
  beta2: Number;
  mu: Number;
  beta3: Number;
}

export interface BlendOptions {
  /** The default is "energy3", and "fair" for roundCorner. */
  strategy?: QuinticStrategy | SepticStrategy;
  /** The shape parameters; where they are not given, they are chosen. */
  beta?: Exact;
  eta?: Exact;
  /** Of the strategy "free". */
  s1?: Exact;
  s2?: Exact;
  /** Of the strategy "free3". */
  start?: SepticEnd<Exact>;
  end?: SepticEnd<Exact>;
}

export interface Blend {
  strategy: string;
  curve: ResultCurve;
  shape: { beta: string; eta: string };
  parameters: { s1: string; s2: string } | { start: SepticEnd<string>; end: SepticEnd<string> };
  fallback_start: boolean;
  fallback_end: boolean;
  /** Both joins, decided exactly. */
  start_join: Join;
  end_join: Join;
  /** Null if it is infinite. */
  fairness: number | null;
  /** Of the fair strategies. */
  report?: { iterations: number; automatic_fairness: number | null; fairness: number | null; converged: boolean };
}

/** One or two cubics with G2 joins. */
export interface CubicBlend {
  strategy: 'cubic' | 'two_cubics';
  curves: ResultCurve[];
  start_join: Join;
  /** Between two cubics. */
  inner_join?: Join;
  end_join: Join;
  fairness: number | null;
}

export interface RoundedCorner<BlendOfCorner = Blend> {
  left: ResultCurve;
  right: ResultCurve;
  left_cut: string;
  right_cut: string;
  blend: BlendOfCorner;
}

/** The place where a curve is bent most, if its curvature exceeds a bound. */
export interface CurvatureExcess {
  parameter: Enclosure;
  /** The curvature, in the plane with a sign; null where it has no bound, as in a cusp. */
  curvature: Enclosure | null;
}

export interface EdgeContinuity {
  /** The order: -1 when the edges differ, otherwise 0, 1 or 2. */
  g_order: number;
  is_g3: boolean;
  defect: string;
  side: string;
  reversed: boolean;
  coplanar: boolean;
  collapsed: boolean;
  normal_vanishes: boolean;
  whole_a: boolean;
  whole_b: boolean;
  /** A guaranteed upper bound of the angle of the normals. */
  largest_angle_degrees: number | null;
}

/** A curve as it is drawn: x and y of its control points by turns, the nearest doubles. */
export interface DrawnCurve {
  points: number[];
  /** Of an arc, which is rounded. */
  weights?: number[];
  /** The control points of a drawing's curve that is no arc, exactly: e.g. "0,0;1/3,2". */
  exact?: string;
}

export interface Module {
  /** Decides the orders of a join, exactly for the numbers as given. */
  continuity(left: Curve, right: Curve, options?: { maxOrder?: number }): Join;
  /** Encloses how far a join is from being continuous. */
  deviation(left: Curve, right: Curve): Deviation;
  /**
   * Decides what a join in the plane looks like. Angles up to kinkAngle, in degrees, are kinks;
   * larger ones are corners.
   */
  joinGrade(left: Curve, right: Curve, options?: { kinkAngle?: Exact }): Grade;
  /**
   * A curve from the end of phi to the start of psi, exactly G2 with both, or G3 or F3 with the
   * strategies of degree 7.
   */
  blend(phi: Curve, psi: Curve, options?: BlendOptions): Blend;
  /** Cuts off a corner at a distance along both curves, and puts a blend in its place. */
  roundCorner(left: Curve, right: Curve, distance: number, options?: BlendOptions): RoundedCorner;
  /**
   * Rounds the corner by cubics: "cubic" takes one with both handles in the corner between lines
   * and two, in the plane, elsewhere; "two_cubics" always takes two, which are fuller.
   */
  roundCorner(left: Curve, right: Curve, distance: number, options: { strategy: 'cubic' | 'two_cubics' }): RoundedCorner<CubicBlend>;
  /**
   * Rounds all corners of a polyline, or of a polygon, which is closed or ends where it starts.
   * Returns what remains of the sides, and the blends between them, in their order. Corners of
   * short sides are cut nearer, so that a quarter of each side remains.
   */
  roundCorners(vertices: ReadonlyArray<Point>, distance: Exact, options?: Omit<BlendOptions, 'strategy'> & { closed?: boolean; strategy?: BlendOptions['strategy'] | 'cubic' | 'two_cubics' }): ResultCurve[];
  /**
   * Decides exactly whether the curvature is nowhere larger than a bound, which it may reach: null
   * if so, otherwise the place where the curve is bent most. The bound is 1/R where no radius may
   * be less than R, e.g. "1/12".
   */
  curvatureExcess(curve: Curve, bound: Exact): CurvatureExcess | null;
  /** Decides the continuity along whole edges of two patches. */
  edgeContinuity(patchA: Patch, edgeA: Edge, patchB: Patch, edgeB: Edge): EdgeContinuity;
  /**
   * Returns the nearest handles of one direction on the integers, as vectors to and from the node,
   * or null where there are none so near.
   */
  alignHandles(left: Point, right: Point, maxMove?: number): { left: [number, number]; right: [number, number] } | null;
  /**
   * Returns the joins of a chain of Bézier curves that do not have an order: numbers i, for the
   * join between the curves i and i + 1. The control points of curves of one degree stand one after
   * the other, or are those of curves, which have a degree and a dimension. The answer is exact for
   * the numbers as given, and fast for curves of one degree whose control points are numbers. Of a
   * Path of paper.js `closed` is that of the path unless it is given.
   */
  failingJoins(
    curves: Float64Array | ArrayLike<number> | CurveChain | ReadonlyArray<Curve>,
    options?: { degree?: number; dimension?: 2 | 3; order?: 'C0' | 'C1' | 'C2' | 'C3' | 'G1' | 'G2' | 'G3' | 'F3'; closed?: boolean },
  ): Uint32Array;
  /**
   * The JSON of `geometric_continuity verify --json` of a drawing. A text that begins with M is
   * path data of SVG, as for all functions on drawings.
   */
  verifySvg(svg: string | Uint8Array | ArrayBuffer, options?: { maxOrder?: number; require?: string | null; kinkAngle?: Exact }): Promise<any>;
  /**
   * A drawing without kinks where handles can move on the grid of its decimals, and the JSON of
   * `geometric_continuity repair --json`; of path data the path as `d`, too.
   */
  repairSvg(
    svg: string | Uint8Array | ArrayBuffer,
    options?: { kinkAngle?: Exact; maxMove?: Exact | null; harmonise?: boolean },
  ): Promise<{ svg: string; report: any; d?: string }>;
  /**
   * The curves of a drawing: segment i is that which a join of `verifySvg` names by its number
   * `left` or `right`.
   */
  svgCurves(svg: string | Uint8Array | ArrayBuffer): Promise<{
    subpaths: { element: string; id: string; line: number; subpath: number; closed: boolean; curves: DrawnCurve[] }[];
  }>;
  /**
   * The JSON of `geometric_continuity verify --json` of a font (TrueType, OpenType, Type 1, WOFF),
   * with `worst` joins of each glyph; glyphs as of `--glyphs`.
   */
  verifyFont(
    font: Uint8Array | ArrayBuffer,
    options?: { glyphs?: string; require?: 'G1' | 'G2' | null; kinkAngle?: Exact; worst?: number },
  ): Promise<any>;
  /** The outlines of glyphs in units of the font: contours of curves. */
  fontCurves(font: Uint8Array | ArrayBuffer, options?: { glyphs?: string }): Promise<{ glyphs: { index: number; name: string; contours: DrawnCurve[][] }[] }>;
  /**
   * The JSON of `geometric_continuity verify --json` of curves or, with surfaces, of a model in
   * SINTEF's format.
   */
  verifyG2(
    g2: string | Uint8Array | ArrayBuffer,
    options?: { maxOrder?: number; require?: string | null; closed?: boolean; surfaces?: boolean; maxCurvature?: Exact | null },
  ): Promise<any>;
}

/** What the functions throw, or reject with, on bad input. */
export class GeometricContinuityError extends Error {
  /** The code of the package, e.g. "malformed_input", "zero_tangent". */
  readonly code: string;
  constructor(code: string, message: string);
}

/**
 * Loads the module; the WebAssembly is taken from files next to it unless an address, its bytes or
 * a compiled module is given.
 */
declare function load(options?: {
  wasm?: string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module;
  filesWasm?: string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module;
}): Promise<Module>;
export { load, load as default };

/** The functions of the module that was loaded last; they throw until one is. */
export const continuity: Module['continuity'];
export const deviation: Module['deviation'];
export const joinGrade: Module['joinGrade'];
export const blend: Module['blend'];
export const roundCorner: Module['roundCorner'];
export const roundCorners: Module['roundCorners'];
export const curvatureExcess: Module['curvatureExcess'];
export const edgeContinuity: Module['edgeContinuity'];
export const alignHandles: Module['alignHandles'];
export const failingJoins: Module['failingJoins'];
export const verifySvg: Module['verifySvg'];
export const repairSvg: Module['repairSvg'];
export const svgCurves: Module['svgCurves'];
export const verifyFont: Module['verifyFont'];
export const fontCurves: Module['fontCurves'];
export const verifyG2: Module['verifyG2'];
