// Where the light and the camera are on the stages by name: what `gonio preview` starts from. tests/page compares them with
// the tool's.
export const stages = {
  floor: { camera: { position: [0, -4.7, 1.5], target: [0, 0.4, 1.08], fov: 36 }, light: { position: [0, 0, 2.6] }, surfaces: ['floor', 'wall', 'sphere'] },
  wall: { camera: { position: [0, -4.6, 1.5], target: [0, 0.5, 1.5], fov: 42 }, light: { position: [0, 0, 2.85], up: [-1, 0, 0] }, surfaces: ['floor', 'wall', 'ceiling'] },
  corridor: { camera: { position: [0, -0.5, 1.6], target: [0, 8, 1.25], fov: 52 }, light: { position: [0, 4, 2.55] }, surfaces: ['floor', 'ceiling', 'wall'] },
  street: { camera: { position: [-17, 5, 1.7], target: [0, 2.6, 2.9], fov: 46 }, light: { position: [0, 0.6, 8] }, surfaces: ['road', 'kerb', 'pavement', 'verge', 'pole'] },
  spheres: { camera: { position: [0, -4.6, 3.3], target: [0, -0.05, 0.15], fov: 36 }, light: { position: [0, -0.8, 2.4] }, surfaces: ['floor', 'sphere'] },
  card: { camera: { position: [0.8, -2, 2.3], target: [0, 2, 1.22], fov: 28 }, light: { position: [0, 0, 1.2], direction: [0, 1, 0], up: [0, 0, 1] }, surfaces: ['floor', 'card', 'stand'] },
  room: { camera: { position: [-0.3, -2.4, 1.55], target: [0.05, 1.2, 1.15], fov: 58 }, light: { position: [0, 0.3, 2.3] }, surfaces: ['floor', 'ceiling', 'wall', 'box', 'sphere'] },
};

const elsewhere = { camera: { position: [0, -5, 1.5], target: [0, 0, 1], fov: 40 }, light: { position: [0, 0, 2.5] }, surfaces: [] };

// Of a rig's `stage`: a name, a custom stage or nothing.
export function stageOf(rig) {
  if (rig.stage && typeof rig.stage === 'object')
    return { ...elsewhere, surfaces: [...new Set(rig.stage.surfaces.map((surface) => String(surface.name)))] };
  return stages[rig.stage ?? 'floor'] ?? elsewhere;
}

const down = [0, 0, -1];
export const add = (a, b) => a.map((value, i) => value + b[i]);
export const subtract = (a, b) => a.map((value, i) => value - b[i]);
export const times = (a, factor) => a.map((value) => value * factor);
export const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => times(a, 1 / (Math.hypot(...a) || 1));

// `v` turned as the shortest turn takes unit vector `from` to unit vector `to`.
function turnedAlong(v, from, to) {
  const axis = cross(from, to);
  const cosine = dot(from, to);
  if (cosine < -0.999999) return times(v, -1);
  return add(add(times(v, cosine), cross(axis, v)), times(axis, dot(axis, v) / (1 + cosine)));
}

// The tilt from straight down and its azimuth, X towards Y [deg], of a direction; and back.
export function anglesOf(direction) {
  const [x, y, z] = unit(direction);
  const tilt = Math.acos(Math.min(1, Math.max(-1, -z))) * 180 / Math.PI;
  return { tilt, azimuth: Math.hypot(x, y) < 1e-9 ? 0 : Math.atan2(y, x) * 180 / Math.PI };
}

export function directionOf(tilt, azimuth) {
  const t = tilt * Math.PI / 180;
  const a = azimuth * Math.PI / 180;
  const clean = (value) => Math.round(value * 1e6) / 1e6 || 0;
  return [clean(Math.sin(t) * Math.cos(a)), clean(Math.sin(t) * Math.sin(a)), clean(-Math.cos(t))];
}

// A light of `rig` with its defaults from the stage. Up turns with the direction, so that it is never parallel to it.
export function placed({ target, ...light }, rig) {
  const stage = stageOf(rig).light;
  const base = stage.direction ?? down;
  const position = light.position ?? stage.position;
  const direction = target ? subtract(target, position) : light.direction ?? base;
  return {
    ...light,
    position,
    direction,
    up: light.up ?? turnedAlong(stage.up ?? [0, 1, 0], base, unit(direction)).map((value) => Math.round(value * 1e6) / 1e6 || 0),
  };
}

// A light of a rig file with the defaults that rigs have, which are not those of the stage.
export function withRigDefaults(light) {
  const position = light.position ?? [0, 0, 0];
  const direction = light.target ? subtract(light.target, position) : light.direction ?? down;
  const isAlongY = Math.hypot(...cross(unit(direction), [0, 1, 0])) < 1e-6;
  return {
    ...light, position, ...(light.target ? {} : { direction }),
    up: light.up ?? (isAlongY ? [0, 0, 1] : [0, 1, 0]),
  };
}
