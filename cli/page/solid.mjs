// The photometric solid: the surface whose distance from the middle is the intensity in that direction. Drawn on a 2-D canvas
// from the farthest facet to the nearest; some 6,000 facets take a few milliseconds, need no GPU and cannot lose it.
//
// Frame: Z up; gamma counts from straight down, C0 along +X, C90 along +Y.
import { el } from './dom.mjs';
import { commands } from './app.mjs';
import { briefNumber } from './numbers.mjs';
import { viridis } from './palette.mjs';

const planeCount = 72; // every 5°, as many tables have it
const gammaCount = 91;
const planes = Array.from({ length: planeCount }, (_, i) => (i * 360) / planeCount);
const gammas = Array.from({ length: gammaCount }, (_, i) => (i * 180) / (gammaCount - 1));

function facetsOf(candela) {
  const peak = candela.reduce((greatest, value) => Math.max(greatest, value), 0) || 1;
  const points = new Float32Array(planeCount * gammaCount * 3);
  for (let c = 0; c < planeCount; ++c)
    for (let g = 0; g < gammaCount; ++g) {
      const at = (c * gammaCount + g) * 3;
      const r = candela[c * gammaCount + g] / peak;
      const phi = (planes[c] * Math.PI) / 180;
      const theta = (gammas[g] * Math.PI) / 180;
      points[at] = r * Math.sin(theta) * Math.cos(phi);
      points[at + 1] = r * Math.sin(theta) * Math.sin(phi);
      points[at + 2] = -r * Math.cos(theta);
    }
  const facets = [];
  for (let c = 0; c < planeCount; ++c)
    for (let g = 0; g + 1 < gammaCount; ++g) {
      const d = (c + 1) % planeCount;
      const corners = [c * gammaCount + g, c * gammaCount + g + 1, d * gammaCount + g + 1, d * gammaCount + g];
      const level = corners.reduce((sum, index) => sum + candela[index] / peak, 0) / 4;
      if (level < 1e-4) continue;
      const p = corners.map((index) => [points[index * 3], points[index * 3 + 1], points[index * 3 + 2]]);
      // Of the diagonals: right for facets that are triangles at the poles too.
      const [ux, uy, uz] = p[2].map((value, i) => value - p[0][i]);
      const [vx, vy, vz] = p[3].map((value, i) => value - p[1][i]);
      const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      const size = Math.hypot(...n) || 1;
      facets.push({ corners, level, normal: n.map((value) => value / size), color: viridis(level) });
    }
  // The middle and the size of what is drawn, the lamp included; and how far it reaches sideways, for the ring.
  const low = [0, 0, 0];
  const high = [0, 0, 0];
  let reach = 0.1;
  for (let i = 0; i < points.length; i += 3) {
    for (let axis = 0; axis < 3; ++axis) {
      low[axis] = Math.min(low[axis], points[i + axis]);
      high[axis] = Math.max(high[axis], points[i + axis]);
    }
    reach = Math.max(reach, Math.hypot(points[i], points[i + 1]));
  }
  for (const axis of [0, 1]) {
    low[axis] = Math.min(low[axis], -reach);
    high[axis] = Math.max(high[axis], reach);
  }
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  let size = Math.max(0.3, 1.15 * reach);
  for (let i = 0; i < points.length; i += 3)
    size = Math.max(size, Math.hypot(points[i] - middle[0], points[i + 1] - middle[1], points[i + 2] - middle[2]));
  return { points, facets, peak, middle, size, reach };
}

export function solidView() {
  const canvas = el('canvas', { width: 720, height: 720, tabindex: 0, role: 'img', 'aria-label': 'Photometric solid' });
  const note = el('p', { class: 'solid-note muted' });
  const view = el('div', { class: 'solid', hidden: true }, canvas, note);
  const first = { yaw: 0.6, pitch: 0.35, zoom: 1 };
  const pose = { ...first };
  let mesh;
  let asked = false;

  function draw() {
    asked = false;
    const context = canvas.getContext('2d');
    const size = Math.max(64, Math.round(canvas.clientWidth * Math.min(devicePixelRatio, 2)) || 720);
    if (canvas.width !== size) canvas.width = canvas.height = size;
    context.clearRect(0, 0, size, size);
    if (!mesh) return;
    const style = getComputedStyle(canvas);
    const [cy, sy, cp, sp] = [Math.cos(pose.yaw), Math.sin(pose.yaw), Math.cos(pose.pitch), Math.sin(pose.pitch)];
    const scale = (size * 0.42 * pose.zoom) / mesh.size;
    const turn = (px, py, pz) => {
      const [x, y, z] = [px - mesh.middle[0], py - mesh.middle[1], pz - mesh.middle[2]];
      const right = x * cy + y * sy;
      const ahead = -x * sy + y * cy;
      return [size / 2 + right * scale, size / 2 - (z * cp + ahead * sp) * scale, ahead * cp - z * sp];
    };
    const ring = (radius, color) => {
      context.strokeStyle = color;
      context.lineWidth = Math.max(1, size / 720);
      context.beginPath();
      for (let i = 0; i <= 72; ++i) {
        const [x, y] = turn(radius * Math.cos((i * Math.PI) / 36), radius * Math.sin((i * Math.PI) / 36), 0);
        if (i) context.lineTo(x, y);
        else context.moveTo(x, y);
      }
      context.stroke();
    };
    const faint = style.getPropertyValue('--line').trim();
    const grey = style.getPropertyValue('--muted').trim();
    ring(mesh.reach / 2, faint);
    ring(mesh.reach, faint);
    const flat = new Float32Array((mesh.points.length / 3) * 3);
    for (let i = 0; i < mesh.points.length; i += 3) {
      const [x, y, depth] = turn(mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]);
      flat[i] = x;
      flat[i + 1] = y;
      flat[i + 2] = depth;
    }
    const lamp = [-0.4, -0.5, 0.77]; // in the eye's frame: right, ahead, up
    const order = mesh.facets.map((facet) => [facet, facet.corners.reduce((sum, index) => sum + flat[index * 3 + 2], 0)]);
    order.sort((a, b) => b[1] - a[1]);
    context.lineWidth = Math.max(0.6, size / 900);
    context.lineJoin = 'round';
    for (const [facet] of order) {
      const [nx, ny, nz] = facet.normal;
      const right = nx * cy + ny * sy;
      const level = -nx * sy + ny * cy;
      const shade = 0.62 + 0.38 * Math.abs(right * lamp[0] + (level * cp - nz * sp) * lamp[1] + (nz * cp + level * sp) * lamp[2]);
      const color = `rgb(${facet.color.map((value) => Math.round(value * shade)).join(',')})`;
      context.fillStyle = color;
      context.strokeStyle = color;
      context.beginPath();
      facet.corners.forEach((index, i) => {
        if (i) context.lineTo(flat[index * 3], flat[index * 3 + 1]);
        else context.moveTo(flat[index * 3], flat[index * 3 + 1]);
      });
      context.closePath();
      context.fill();
      context.stroke();
    }
    context.font = `${Math.round(size / 45)}px system-ui, sans-serif`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.strokeStyle = grey;
    context.fillStyle = grey;
    for (const [label, x, y, z] of [['C0', 1, 0, 0], ['C90', 0, 1, 0], ['C180', -1, 0, 0], ['C270', 0, -1, 0]]) {
      const [px, py] = turn(x * mesh.reach * 1.12, y * mesh.reach * 1.12, z);
      context.fillText(label, px, py);
    }
    context.beginPath();
    const [a, b] = [turn(0, 0, 0), turn(0, 0, -1)];
    context.moveTo(a[0], a[1]);
    context.lineTo(b[0], b[1]);
    context.setLineDash([4, 4]);
    context.stroke();
    context.setLineDash([]);
  }

  function ask() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  }

  canvas.addEventListener('pointerdown', (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    canvas.dataset.dragging = '1';
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    pose.yaw -= event.movementX * 0.01;
    pose.pitch = Math.max(-1.57, Math.min(1.57, pose.pitch + event.movementY * 0.01));
    ask();
  });
  canvas.addEventListener('pointerup', () => delete canvas.dataset.dragging);
  canvas.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && document.activeElement !== canvas) return; // the page scrolls
    pose.zoom = Math.max(0.4, Math.min(6, pose.zoom * Math.exp(-event.deltaY * 0.001)));
    ask();
    event.preventDefault();
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const keys = {
      ArrowLeft: () => { pose.yaw += 0.1; }, ArrowRight: () => { pose.yaw -= 0.1; },
      ArrowUp: () => { pose.pitch = Math.min(1.57, pose.pitch + 0.1); }, ArrowDown: () => { pose.pitch = Math.max(-1.57, pose.pitch - 0.1); },
      '+': () => { pose.zoom = Math.min(6, pose.zoom * 1.15); }, '-': () => { pose.zoom = Math.max(0.4, pose.zoom / 1.15); },
      Home: () => Object.assign(pose, first),
    };
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    keys[event.key]();
    ask();
    event.preventDefault();
    event.stopPropagation();
  });
  new ResizeObserver(ask).observe(canvas);

  let shownFile;
  view.show = async (file) => {
    shownFile = file;
    if (!file) {
      mesh = undefined;
      return;
    }
    file.mesh ??= facetsOf((await commands.call('sample', { name: file.path, bytes: file.bytes, planes, gammas }, { label: 'sampling' })).candela);
    if (shownFile !== file) return;
    mesh = file.mesh;
    canvas.setAttribute('aria-label', `Photometric solid of ${file.name}. Arrow keys turn it, plus and minus zoom.`);
    note.textContent = `Radius and colour: intensity; the outer ring is ${briefNumber(mesh.peak * mesh.reach)} cd, the peak ${briefNumber(file.info.peak_cd)} cd. Drag to turn.`;
    draw();
  };
  view.redraw = ask;
  return view;
}
