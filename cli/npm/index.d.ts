/** Bytes of a file; a string is UTF-8. */
export type Bytes = Uint8Array | ArrayBuffer | string;
/** Files by name. Names may have folders. */
export type Files = Record<string, Uint8Array | string>;
/** Options of a command of the tool, in camel case: {perKlm: true, size: '64x64'} is --per-klm --size 64x64. */
export type Options = Record<string, string | number | boolean | (string | number)[] | undefined>;

export interface Diagnostic {
  code: string;
  severity: 'note' | 'warning' | 'error';
  file: string;
  /** From 1; 0 where it is about the whole file. */
  line: number;
  column: number;
  message: string;
  hint: string;
}

export class GonioError extends Error {
  /** The exit status of the tool: 2 usage, 3 files, 4 malformed input, 5 unsupported, 70 an internal error. */
  status: number;
  code: string;
  hint: string;
  diagnostics: Diagnostic[];
}

export interface RunResult {
  status: number;
  diagnostics: Diagnostic[];
  stdout: Uint8Array;
  stderr: string;
  /** The files that the command wrote. */
  files: Record<string, Uint8Array>;
}

/** What `gonio info --json` reports: names end in their unit. */
export interface Info {
  schema: 'gonio.info/1';
  file: string;
  format: 'IES' | 'LDT' | 'TM-33';
  version: string;
  photometry: 'A' | 'B' | 'C';
  flux_lm: number;
  declared_flux_lm: number | null;
  absolute: boolean;
  peak_cd: number;
  peak_c_deg: number;
  peak_gamma_deg: number;
  beam_angle_deg: number | null;
  field_angle_deg: number | null;
  input_W: number | null;
  efficacy_lm_per_W: number | null;
  luminous_opening: { shape: string; width_m: number; length_m: number; height_m: number };
  diagnostics: Diagnostic[];
  [name: string]: unknown;
}

export interface BakeOptions {
  /** A name of `list('layouts')`; 'latlong' by default. */
  layout?: string;
  /** Instead of a layout, a name of `list('engines')`. */
  engine?: string;
  width?: number;
  height?: number;
  /** Gnomonic: full angle from edge to edge. */
  cone_deg?: number;
  border?: number;
  /** A name of `list('normalizations')`. */
  normalization?: string;
  texel_type?: 'float32' | 'half' | 'uint16' | 'uint8';
  /** The smallest texture within this error. */
  max_error_cd?: number;
}

export interface Texture {
  layout: string;
  texel_convention: string;
  width: number;
  height: number;
  channels: number;
  /** Rows from top to bottom. Candela are texel × cd_per_unit. */
  data: Float32Array;
  cd_per_unit: number;
  peak_cd: number;
  flux_lm: number;
  texture_flux_lm: number;
  max_error_cd: number;
  solid_angle_sr: number;
}

/** A profile in the memory of WebAssembly, which is not collected: call delete(). */
export interface Profile {
  readonly diagnostics: Diagnostic[];
  info(): Info;
  /** Intensity [cd] towards C and gamma [°]. */
  candela(c_deg: number, gamma_deg: number): number;
  /** Intensities [cd] along gamma [°] in the plane C [°]. */
  sample(c_deg: number, gammas_deg: ArrayLike<number>): Float64Array;
  /** An SVG document of a kind of `list('diagrams')`. */
  diagram(kind: string, width_px: number, height_px: number): string;
  bake(options: BakeOptions): Texture;
  delete(): void;
}

export type Vector = [x: number, y: number, z: number];

/** The keys of a light that do not place it. */
export interface Luminaire {
  /** As in `list('shapes')`: 'sphere:r=10cm', 'ies:lamp.ies'. */
  shape: string;
  /** 800lm, 1200cd, 300lx@2m, 60W@90lm/W; a profile without one shines as measured. */
  intensity?: string;
  color?: string;
  rotate?: string;
  /** Of a profile: a smooth curve through its table, in steps of this angle. */
  smooth?: string;
  range?: string;
  /** A share from 0 to 1, or '80%'; shares multiply. */
  dimming?: number | string;
  maintenance?: number | string;
}

/** Copies in rows along X, Y and Z, centred at the position. */
export type LightArray = { count: [number, number] | Vector } &
  ({ /** From centre to centre [m]. */ spacing?: [number, number] | Vector; room?: never } |
   { /** Length and width of a room [m], with half the spacing to its walls. */ room: [number, number]; spacing?: never });

/** One place [m] or several. */
export type Placed = { position?: Vector; positions?: never } | { positions: Vector[]; position?: never };

/** Along which it shines, or the point that it is aimed at. */
export type Aimed = { direction?: Vector; target?: never } | { target: Vector; direction?: never };

/** A light with a shape, or with the name of a luminaire of the rig and what differs from it. */
export type RigLight = Placed & Aimed & (Luminaire | (Omit<Luminaire, 'shape'> & { luminaire: string; shape?: never })) &
  { name?: string; up?: Vector; array?: LightArray; lights?: never };

/** Lights and groups in the frame of the group. */
export type RigGroup = Placed & {
  name?: string;
  lights: (RigLight | RigGroup)[];
  /** Its Z axis. */
  up?: Vector;
  /** About its Z axis, X towards Y. */
  rotate?: string;
  array?: LightArray;
  dimming?: number | string;
  maintenance?: number | string;
};

/** One of plane, panel, box, sphere and capsule. */
export interface RigSurface {
  name: string;
  material?: string;
  emits?: string;
  plane?: { point?: Vector; normal?: Vector };
  panel?: { center: Vector; normal: Vector; up?: Vector; width: string; height: string };
  box?: { center: Vector; size: Vector; up?: Vector; rotate?: string };
  sphere?: { center: Vector; radius: string };
  capsule?: { from: Vector; to: Vector; radius: string };
}

/** The lights of a scene, and what they are shown on. */
export interface Rig {
  schema: 'gonio.rig/1';
  lights: (RigLight | RigGroup)[];
  /** By name: what lights use instead of a shape. */
  luminaires?: Record<string, Luminaire>;
  maintenance?: number | string;
  sky?: string;
  /** A name of `list('stages')`, or a stage of one's own. */
  stage?: string | { name?: string; surfaces: RigSurface[]; figure?: Vector };
  camera?: { position?: Vector; target?: Vector; up?: Vector; fov?: string };
  /** Of named surfaces of the stage. */
  materials?: Record<string, string>;
  emits?: Record<string, string>;
}

export interface RenderOptions {
  width: number;
  height: number;
  /** Metres; the stage's camera by default. */
  camera?: { position: [number, number, number]; target: [number, number, number]; fov_deg?: number };
  shadows?: 'off' | 'hard' | 'soft';
  /** How often light bounces: 0 not at all, -1 (the default) until it is absorbed. */
  bounces?: number;
  /** The display mode. */
  mode?: 'beauty' | 'falsecolour' | 'isolux' | 'luminance';
  /** Of the display mode: lx, fc, nt, fL. */
  unit?: string;
  /** EV100, or 'auto'. */
  exposure?: 'auto' | number;
  view?: 'Standard' | 'Filmic' | 'Raw';
  /** More options of `gonio preview`, as words. */
  words?: string[];
}

export interface Picture {
  width: number;
  height: number;
  /** sRGB-encoded, opaque: what `new ImageData(rgba, width, height)` takes. */
  rgba: Uint8ClampedArray;
  ev100: number;
  /** False: it followed from the last one, as where only amounts and colours of lights, or the display, are others. */
  rendered: boolean;
  /** Of the display modes falsecolour and luminance, in lux or cd/m². */
  scale: { low: number; high: number; logarithmic: boolean } | null;
  /** Of the display mode isolux: the lines, the lowest first, in lux or cd/m², and their colours from 0 to 255. */
  lines: { value: number; rgb: [number, number, number] }[];
  diagnostics: Diagnostic[];
}

/** A rig on its stage, for pictures one after another. It keeps memory: call delete(). */
export interface Scene {
  /** Another rig with the same files, and perhaps more. What is not changed is not computed again. */
  set(rig: Rig | string, files?: Files): void;
  render(options: RenderOptions): Picture;
  /** Of a pixel of the last picture; null outside of it. */
  at(column: number, row: number): { illuminance_lx: number; luminance_nt: number } | null;
  delete(): void;
}

export interface WrittenProfile {
  name: string;
  bytes: Uint8Array;
  /** Errors and fluxes, as `--json` reports them. */
  report: Record<string, unknown>;
  diagnostics: Diagnostic[];
}

export interface Gonio {
  /** Any command of the tool in memory. Throws nothing: look at `status`. */
  run(words: string[], files?: Files): RunResult;
  /** Throws an Error with `code`, `message` and `diagnostics`. `name` decides where the format is ambiguous. */
  read(bytes: Bytes, name: string): Profile;
  /** What `gonio check` finds. Throws nothing. */
  check(bytes: Bytes, name: string): { readable: boolean; diagnostics: Diagnostic[] };
  /** What a code means. */
  explain(code: string): { code: string; severity: string; title: string; explanation: string };
  /** A list of `gonio list`: 'layouts', 'stages', 'targets', …. */
  list(name: string): { name: string; summary: string }[];
  /** Options of `gonio convert`; `to` is 'ies', 'ldt' or 'tm33'. */
  convert(bytes: Uint8Array | string, name: string, options?: Options & { to?: string }): WrittenProfile;
  /** Options of `gonio edit`; several files with `sum` or `blend`. */
  edit(files: Files, options?: Options & { to?: string }): WrittenProfile;
  /** units('800lm', 'nt', {shape: 'sphere:r=3cm'}); options of `gonio units`. */
  units(value: string, to: string, options?: Options): number;
  units(value: string, to: string[], options?: Options): number[];
  /** What `gonio cct --json` reports of '3000K', '2700K/0.003', 'xy(0.44,0.4)', …. */
  cct(color: string, options?: Options): Record<string, any>;
  /** Illuminance of a rig (schema gonio.rig/1): what `gonio probe --json` reports. */
  probe(rig: Rig | string, files: Files, options: Options): Record<string, any>;
  /** One picture of a rig. */
  preview(rig: Rig | string, files: Files, options: RenderOptions): Picture;
  Scene: new (rig: Rig | string, files?: Files) => Scene;
  /** Profiles, or with `rig` a rig, as files of targets: what `gonio import` writes, by path. */
  importTo(targets: string | string[], files: Files, options?: Options & { rig?: Rig | string }):
    { files: Record<string, Uint8Array>; diagnostics: Diagnostic[] };
  /** Of the WebAssembly; it grows, and never shrinks. */
  readonly memoryBytes: number;
}

export function createGonio(): Promise<Gonio>;
export function wordsOf(options: Options): string[];
