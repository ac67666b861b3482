// The lit stage: a canvas that a worker fills. While something moves, one worker draws pictures of the size that it manages 30
// times a second; when all is still, a second one draws the full picture, and is ended when the next move begins.
import { el, fill, problem, segmented } from './dom.mjs';
import {
  activeLight, cameraOf, cancelAll, change, doc, emit, files, filesOf, newEngine, on, prefs, rigOf, say, selected, watch,
} from './app.mjs';
import { add, anglesOf, cross, directionOf, dot, subtract, times, unit } from './stages.mjs';
import { Cancelled } from './engine.mjs';
import { briefNumber, lx_per_fc } from './numbers.mjs';
import { viridisGradient } from './palette.mjs';

const frame_ms = 30; // from one picture to the next while moving
const ready_ms = 2000; // a full picture that takes longer is too much to solve beside it
const leastPicture = 120 * 80; // pixels of a picture while moving
const firstPicture = 160 * 107; // of the very first: quick on any machine
const solving_ms = 60; // that bounced light of other amounts may take in a moving picture
const still_ms = 140; // without a change, before refining begins
const refine_ms = 120000; // for a full picture; the next move ends it
const greatestPicture = 1.6e6; // pixels

const rounded = (value, digits = 4) => Number(value.toFixed(digits)) || 0;

const dragModes = [
  ['orbit', 'Orbit', 'Drag or arrow keys: the camera goes around (O)'],
  ['move', 'Move light', 'Drag or arrow keys, Page Up and Page Down: the light moves (M, or Shift)'],
  ['turn', 'Turn light', 'Drag or arrow keys: the light turns (T, or Ctrl)'],
  ['measure', 'Measure', 'Arrow keys: read lux at a point (L)'],
];

// What a picture shows, for a worker: the rig's text, its files, and a key of these files.
export function sceneOf(document) {
  const rig = rigOf(document);
  const { camera, ...lit } = rig;
  const named = filesOf(lit);
  return { rig: JSON.stringify(lit), files: named, key: Object.keys(named).join('|') };
}

// Sends files only to a worker that does not have them.
export class Renderer {
  #told = { key: undefined, generation: -1 };

  constructor() {
    this.engine = newEngine();
    watch(this.engine);
  }

  async render(scene, options, { label = '', patience } = {}) {
    await this.engine.start();
    const known = this.#told.key === scene.key && this.#told.generation === this.engine.generation;
    this.#told = { key: scene.key, generation: this.engine.generation };
    try {
      return await this.engine.call('render', { rig: scene.rig, key: scene.key, files: known ? undefined : scene.files, options }, { label, patience });
    } catch (error) {
      this.#told.key = undefined; // the worker may have kept half of it
      throw error;
    }
  }
}

// `knows`: a moving picture's light that bounces is known already.
export function renderOptions(document, width, height, final = true, knows = false) {
  const { position, target, fov } = cameraOf(document);
  const { mode, exposure, view, shadows, bounces } = document.view;
  return {
    width, height, mode, exposure, view, unit: prefs.illuminance,
    camera: { position, target, ...(fov ? { fov_deg: fov } : {}) },
    shadows: final || shadows === 'off' ? shadows : 'hard',
    bounces: final || knows ? bounces : 0,
    // The opening of a luminaire costs five times the rest of a small picture; as a point it lights nearly the same.
    words: final ? [] : ['--profile-size', 'off'],
  };
}

function legendTicks({ low, high, logarithmic }) {
  if (!(high > low)) return [];
  if (!logarithmic) return [0, 0.25, 0.5, 0.75, 1].map((place) => [place, low + place * (high - low)]);
  const ticks = [];
  for (let decade = Math.ceil(Math.log10(low) - 1e-9); 10 ** decade <= high * 1.000001; ++decade)
    ticks.push([Math.log(10 ** decade / low) / Math.log(high / low), 10 ** decade]);
  return ticks.length > 1 ? ticks : [[0, low], [1, high]];
}

export function stageView() {
  const canvas = el('canvas', { width: 480, height: 320, tabindex: 0, role: 'application', 'aria-roledescription': 'lit stage', 'aria-label': 'Lit stage', 'aria-describedby': 'stage-keys' });
  const handle = el('div', { class: 'light-handle', title: 'The light: drag it', 'aria-hidden': 'true' });
  const aim = el('div', { class: 'light-aim', 'aria-hidden': 'true' });
  const reticle = el('div', { class: 'crosshair', hidden: true, 'aria-hidden': 'true' });
  const legend = el('div', { class: 'legend', hidden: true, role: 'img' });
  const readout = el('output', { class: 'readout', 'aria-live': 'off' });
  const state = el('span', { class: 'stage-state muted' });
  const busy = el('progress', { class: 'busy', hidden: true, 'aria-label': 'Refining the picture' });
  const stop = el('button', { type: 'button', class: 'small', hidden: true, onclick: () => cancelAll() }, 'Cancel');
  const errors = el('div', { class: 'stage-errors' });
  let dragMode = 'orbit';
  const modes = segmented('Dragging and arrow keys', dragModes, dragMode, (mode) => setMode(mode));
  const reset = el('button', { type: 'button', class: 'small', title: 'Camera and light as the stage has them (R)', onclick: () => resetView() }, 'Reset');
  const keys = el('p', { class: 'hidden', id: 'stage-keys' }, 'Arrow keys orbit the camera, plus and minus zoom. With Shift they move the light, with Control they turn it. O, M, T and L choose what plain arrow keys do; R resets.');
  const box = el('div', { class: 'stage-box' }, canvas, aim, handle, reticle, legend, errors);
  const view = el('div', { class: 'stage', 'data-quality': 'none' }, box,
    el('div', { class: 'stage-bar' }, modes, reset),
    el('div', { class: 'stage-line' }, state, busy, stop, el('span', { class: 'spring' }), readout), keys);

  const quick = new Renderer();
  const full = new Renderer();
  let shown; // the renderer of the picture on the canvas
  let dirty = false;
  let drawing = false;
  let refineTimer;
  let scale = 0; // of the moving picture, against the full one; 0: not known yet
  let pace_ms = 0; // of a picture while moving, from question to answer, smoothed
  let cost = 0; // ms per pixel, smoothed
  let pace = []; // times of the last pictures while moving
  let ready; // {key, rig, solvesSlowly}: what the moving pictures' worker has solved, and for which lights
  let goodCamera;
  let exposed; // the last full picture: its rig and exposure
  let drawn; // {key, rig}: what the full pictures' worker drew last, and for which lights; undefined: a smaller picture
  let drawsAnew; // the key of full pictures that other amounts of light do not follow from
  let refiningNow = false;
  let dark = true; // nothing to show
  view.full = full;

  const fullSize = () => {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    let width = Math.max(64, Math.round(canvas.clientWidth * ratio) || 480);
    let height = Math.max(48, Math.round(canvas.clientHeight * ratio) || 320);
    const shrink = Math.min(1, Math.sqrt(greatestPicture / (width * height)));
    return { width: Math.round(width * shrink), height: Math.round(height * shrink) };
  };

  function quickSize() {
    const { width, height } = fullSize();
    const least = Math.min(1, Math.sqrt(leastPicture / (width * height)));
    scale = scale ? Math.min(1, Math.max(least, scale)) : Math.min(1, Math.sqrt(firstPicture / (width * height)));
    return { width: Math.max(16, Math.round(width * scale)), height: Math.max(16, Math.round(height * scale)) };
  }

  // Larger while there is time left, smaller while there is not. A part of the time does not depend on the size, so the size
  // is steered, not computed. Between the two bounds it stays, so that the picture does not swim.
  function learn(picture, took) {
    const pixels = picture.width * picture.height;
    const perPixel = picture.ms / pixels;
    cost = cost ? cost + 0.3 * (perPixel - cost) : perPixel;
    pace_ms = pace_ms ? pace_ms + 0.35 * (took - pace_ms) : took;
    const ratio = frame_ms / pace_ms;
    if (ratio > 1.2 || ratio < 0.95) {
      const step = Math.min(1.25, Math.max(0.8, Math.sqrt(ratio)));
      scale *= step;
      pace_ms *= 1 + 0.6 * (step * step - 1);
    }
  }

  function show(picture, renderer, refined) {
    const { width, height } = picture;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    canvas.getContext('2d').putImageData(new ImageData(picture.rgba, width, height), 0, 0);
    shown = renderer;
    dark = false;
    view.dataset.size = `${width}x${height}`;
    view.dataset.quality = refined ? 'refined' : 'moving';
    view.dataset.shown = String(Number(view.dataset.shown ?? 0) + 1);
    const file = selected();
    if (file && file.lit_ms === undefined) {
      file.lit_ms = performance.now() - file.added_ms;
      emit('lit');
      view.dataset.firstPicture = file.lit_ms.toFixed(1);
    }
    fill(errors);
    showLegend(picture);
    placeHandle();
    view.dispatchEvent(new CustomEvent('picture', { detail: picture }));
  }

  function showLines(lines) {
    const [per, unitName] = prefs.illuminance === 'fc' ? [lx_per_fc, 'fc'] : [1, 'lx'];
    const values = lines.map(({ value }) => briefNumber(value / per, 3));
    legend.setAttribute('aria-label', `Lines of equal illuminance: ${values.join(', ')} ${unitName}`);
    fill(legend, ...lines.map(({ rgb }, i) => {
      const mark = el('span', { class: 'legend-mark' });
      mark.style.background = `rgb(${rgb.join(' ')})`;
      return el('span', { class: 'legend-line' }, mark, values[i]);
    }), el('span', {}, unitName));
  }

  // The scale of a picture is in lux, with round numbers in the unit that was asked for.
  function showLegend({ scale: given, lines = [] }) {
    const isScale = doc.view.mode === 'falsecolour' && Boolean(given);
    const isLines = doc.view.mode === 'isolux' && lines.length > 0;
    legend.hidden = !isScale && !isLines;
    legend.classList.toggle('lines', isLines);
    if (isLines) showLines(lines);
    if (!isScale) return;
    const range = prefs.illuminance === 'fc' ? { ...given, low: given.low / lx_per_fc, high: given.high / lx_per_fc, unit: 'fc' } : given;
    const ticks = legendTicks(range);
    legend.setAttribute('aria-label', `Scale from ${briefNumber(range.low)} to ${briefNumber(range.high)} ${range.unit}`);
    const bar = el('span', { class: 'legend-bar' });
    bar.style.background = viridisGradient;
    fill(legend, bar, el('span', { class: 'legend-ticks' }, ...ticks.map(([place, value]) => {
      const tick = el('span', {}, briefNumber(value, 3));
      tick.style.left = `${(place * 100).toFixed(2)}%`;
      return tick;
    })), el('span', { class: 'legend-unit' }, range.unit));
  }

  function describe(picture, refined) {
    const size = `${picture.width} × ${picture.height}`;
    const exposed = doc.view.mode === 'beauty' && Number.isFinite(picture.ev100) ? `, EV100 ${picture.ev100.toFixed(1)}` : '';
    if (refined) return `${size}${exposed}`;
    const rate = pace.length > 4 ? (1000 * (pace.length - 1)) / (pace.at(-1) - pace[0]) : 0;
    if (rate) view.dataset.rate = rate.toFixed(1);
    return rate ? `${size}${exposed}, ${rate.toFixed(0)} pictures/s` : `${size}${exposed}`;
  }

  function fail(error, document) {
    if (error instanceof Cancelled) return;
    // A camera that went into a wall goes back to where it was.
    if (goodCamera !== undefined && JSON.stringify(document.rig.camera ?? null) !== goodCamera && view.dataset.moved === 'camera') {
      doc.rig.camera = JSON.parse(goodCamera) ?? undefined;
      say(error.message);
      readout.textContent = error.message;
      return;
    }
    fill(errors, problem(error));
    view.dataset.quality = 'failed';
    state.textContent = '';
    handle.hidden = aim.hidden = legend.hidden = true;
  }

  // ---- pictures while moving

  async function pump() {
    if (drawing || !dirty || !view.isConnected || canvas.clientWidth === 0) return;
    if (!doc.rig.lights[doc.active]?.shape) return;
    drawing = true;
    dirty = false;
    const size = quickSize();
    const begin = performance.now();
    const snapshot = JSON.parse(JSON.stringify(doc));
    try {
      const scene = sceneOf(snapshot);
      const isLit = scene.rig === ready?.rig; // only the camera or the display is another
      const knows = ready?.key === readiness(scene, snapshot) && (isLit || (!ready.solvesSlowly && placesOf(ready.rig) === placesOf(scene.rig)));
      const options = renderOptions(snapshot, size.width, size.height, false, knows);
      // While only the camera moves, the exposure of the full picture stays: without bounced light another would be chosen.
      if (options.exposure === 'auto' && scene.rig === exposed?.rig) options.exposure = exposed.ev100;
      const usual_ms = cost * size.width * size.height;
      const picture = await quick.render(scene, options);
      const end = performance.now();
      if (picture.rendered) learn(picture, end - begin);
      // Where even the smallest picture is too slow, bounced light is left out, and where it takes long to solve for other
      // amounts, while they change.
      if (options.bounces && pace_ms > 2 * frame_ms && size.width * size.height <= 1.1 * leastPicture) ready = undefined;
      else if (options.bounces && !isLit && picture.ms > usual_ms + solving_ms) ready.solvesSlowly = true;
      if (options.bounces && ready) ready.rig = scene.rig;
      if (pace.length && end - pace.at(-1) > 250) pace = [];
      pace.push(end);
      if (pace.length > 20) pace.shift();
      if (!refiningNow) {
        show(picture, quick, false);
        state.textContent = describe(picture, false);
      }
      goodCamera = JSON.stringify(snapshot.rig.camera ?? null);
    } catch (error) {
      fail(error, snapshot);
    }
    drawing = false;
    if (dirty) pump();
  }

  function invalidate() {
    dirty = true;
    if (full.engine.busy) full.engine.cancel();
    clearTimeout(refineTimer);
    refineTimer = setTimeout(refine, still_ms);
    pump();
  }

  // What the moving pictures' worker must have solved for the light that bounces to cost little: that of the same lights in the
  // same surroundings, whose amounts alone may change.
  const placesOf = (rig) => JSON.stringify(JSON.parse(rig).lights.map(({ intensity, dimming, ...rest }) => rest));
  const surroundingsOf = (rig) => ({ ...JSON.parse(rig), lights: undefined });
  const readiness = (scene, { view: { bounces, shadows } }) =>
    JSON.stringify([quick.engine.generation, scene.key, surroundingsOf(scene.rig), bounces, shadows === 'off']);

  // While nothing moves, it solves that by the smallest of pictures.
  async function getReady(scene, snapshot) {
    const key = readiness(scene, snapshot);
    if (drawing || dirty || (ready?.key === key && ready.rig === scene.rig)) return;
    drawing = true;
    try {
      await quick.render(scene, renderOptions(snapshot, 16, 16, false, true), { patience: refine_ms });
      ready = { key, rig: scene.rig, solvesSlowly: ready?.key === key && ready.solvesSlowly };
    } catch (error) {
      ready = undefined; // the pictures themselves say what is wrong
    }
    drawing = false;
    if (dirty) pump();
  }

  // ---- the full picture

  // All that a full picture is drawn from but for the lights; how it is shown is no part of that.
  const fullKey = (scene, { mode, exposure, view: look, unit: lux, ...options }) =>
    JSON.stringify([full.engine.generation, scene.key, surroundingsOf(scene.rig), options]);

  async function refine() {
    if (!view.isConnected || canvas.clientWidth === 0 || !doc.rig.lights[doc.active]?.shape) return;
    if (dirty || drawing) {
      refineTimer = setTimeout(refine, 30);
      return;
    }
    const size = fullSize();
    const snapshot = JSON.parse(JSON.stringify(doc));
    const scene = sceneOf(snapshot);
    const token = (refine.token = {});
    const current = () => refine.token === token && !dirty;
    const waiting = setTimeout(() => {
      busy.hidden = stop.hidden = !current();
    }, 250);
    const optionsAt = (step) => renderOptions(snapshot, Math.round(size.width * step), Math.round(size.height * step));
    const key = fullKey(scene, optionsAt(1));
    // A picture that follows from the one before, of the same lights or of other amounts of them, takes little time.
    const follows = drawn?.key === key && (drawn.rig === scene.rig || (drawsAnew !== key && placesOf(drawn.rig) === placesOf(scene.rig)));
    drawn = undefined;
    try {
      // A smaller one first where the full one takes long.
      const expected = follows ? 0 : cost * size.width * size.height;
      const steps = expected > 1500 ? [0.25, 0.5, 1] : expected > 400 ? [0.5, 1] : [1];
      let last;
      for (const step of steps) {
        const picture = await full.render(scene, optionsAt(step), { label: 'refining the picture', patience: refine_ms });
        if (step === 1) drawn = { key, rig: scene.rig };
        if (follows && picture.rendered) drawsAnew = key;
        if (!current()) return;
        last = picture;
        exposed = { rig: scene.rig, ev100: picture.ev100 };
        show(picture, full, step === 1);
        state.textContent = describe(picture, true);
      }
      if (last.ms < ready_ms) getReady(scene, snapshot);
    } catch (error) {
      if (error instanceof Cancelled || error.code === 'TIMEOUT') {
        if (error.code === 'TIMEOUT') say(`The full picture: ${error.message}`);
        if (current()) state.textContent = `${state.textContent.replace(/ \(not refined\)$/, '')} (not refined)`;
      } else if (current()) {
        fail(error, snapshot);
      }
    } finally {
      clearTimeout(waiting);
      if (refine.token === token) busy.hidden = stop.hidden = true;
    }
  }

  // ---- the light's mark

  function basis() {
    const { position, target, fov, stageFov } = cameraOf();
    const ahead = unit(subtract(target, position));
    const right = unit(cross(ahead, doc.rig.camera?.up ?? [0, 0, 1]));
    return { position, ahead, right, up: cross(right, ahead), tangent: Math.tan(((fov ?? stageFov) * Math.PI) / 360) };
  }

  function project(point) {
    const { position, ahead, right, up, tangent } = basis();
    const ray = subtract(point, position);
    const depth = dot(ray, ahead);
    if (depth < 0.05) return undefined;
    const half = canvas.clientHeight / 2;
    return [canvas.clientWidth / 2 + (dot(ray, right) / depth / tangent) * half, half - (dot(ray, up) / depth / tangent) * half];
  }

  function placeHandle() {
    const light = activeLight();
    const at = project(light.position);
    const inside = at && at[0] >= 0 && at[1] >= 0 && at[0] <= canvas.clientWidth && at[1] <= canvas.clientHeight;
    handle.hidden = aim.hidden = !inside || dark;
    if (!inside) return;
    handle.style.transform = `translate(${at[0]}px, ${at[1]}px)`;
    const tip = project(add(light.position, times(unit(light.direction), 0.5)));
    aim.hidden ||= !tip;
    if (!tip) return;
    const [dx, dy] = [tip[0] - at[0], tip[1] - at[1]];
    aim.style.width = `${Math.min(120, Math.hypot(dx, dy))}px`;
    aim.style.transform = `translate(${at[0]}px, ${at[1]}px) rotate(${Math.atan2(dy, dx)}rad)`;
  }

  // ---- moves

  function orbit(yaw, pitch, zoom = 1) {
    const { position, target } = cameraOf();
    const offset = subtract(position, target);
    const distance = Math.min(400, Math.max(0.2, Math.hypot(...offset) * zoom));
    const tilt = Math.min(1.55, Math.max(-1.2, Math.asin(offset[2] / Math.hypot(...offset)) + pitch));
    const angle = Math.atan2(offset[1], offset[0]) + yaw;
    const next = add(target, [distance * Math.cos(tilt) * Math.cos(angle), distance * Math.cos(tilt) * Math.sin(angle), distance * Math.sin(tilt)]);
    if (next[2] < 0.05) next[2] = 0.05; // the floor
    view.dataset.moved = 'camera';
    change('camera', (document) => {
      document.rig.camera = { ...document.rig.camera, position: next.map((value) => rounded(value)), target };
    });
  }

  function editLight(key, edit) {
    view.dataset.moved = 'light';
    change(key, (document) => edit(document.rig.lights[document.active]));
  }

  const moveLight = (offset) => editLight('move', (light) => {
    light.position = add(activeLight().position, offset).map((value) => rounded(value, 3));
  });

  function turnLight(tiltBy, azimuthBy) {
    const { tilt, azimuth } = anglesOf(activeLight().direction);
    // Past straight down it comes up on the other side.
    const next = tilt + tiltBy;
    const crossed = next < 0;
    editLight('turn', (light) => {
      light.direction = directionOf(Math.min(180, Math.abs(next)), azimuth + azimuthBy + (crossed ? 180 : 0));
      delete light.target;
      delete light.up;
    });
  }

  function dragBy(mode, dx, dy) {
    if (mode === 'orbit' || mode === 'measure') return orbit(-dx * 0.007, dy * 0.007);
    if (mode === 'turn') return turnLight(-dy * 0.35, dx * 0.35);
    const { position, right, up, ahead, tangent } = basis();
    const depth = Math.max(0.2, dot(subtract(activeLight().position, position), ahead));
    const perPixel = (2 * depth * tangent) / canvas.clientHeight;
    return moveLight(add(times(right, dx * perPixel), times(up, -dy * perPixel)));
  }

  const modeOf = (event) => (event.shiftKey ? 'move' : event.ctrlKey || event.metaKey ? 'turn' : dragMode);

  let dragging;
  const pointers = new Map();
  let spread = 0;
  function beginDrag(event, mode) {
    if (event.button !== 0) return;
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
    if (pointers.size === 2) spread = 0;
    dragging = { mode, x: event.clientX, y: event.clientY };
    box.dataset.dragging = mode;
    event.preventDefault();
  }
  canvas.addEventListener('pointerdown', (event) => beginDrag(event, modeOf(event)));
  handle.addEventListener('pointerdown', (event) => beginDrag(event, event.ctrlKey ? 'turn' : 'move'));
  canvas.addEventListener('pointermove', (event) => {
    if (!dragging) return measureAt(event.offsetX, event.offsetY, false);
    pointers.set(event.pointerId, event);
    if (pointers.size === 2) { // two fingers zoom
      const [a, b] = [...pointers.values()];
      const now = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      if (spread) orbit(0, 0, spread / now);
      spread = now;
      return undefined;
    }
    const [dx, dy] = [event.clientX - dragging.x, event.clientY - dragging.y];
    if (!dx && !dy) return undefined;
    Object.assign(dragging, { x: event.clientX, y: event.clientY });
    return dragBy(dragging.mode, dx, dy);
  });
  for (const name of ['pointerup', 'pointercancel'])
    canvas.addEventListener(name, (event) => {
      pointers.delete(event.pointerId);
      if (pointers.size === 0) dragging = undefined;
      delete box.dataset.dragging;
    });
  canvas.addEventListener('pointerleave', () => {
    if (dragMode !== 'measure') readout.textContent = '';
  });
  canvas.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && document.activeElement !== canvas) return; // the page scrolls
    orbit(0, 0, Math.exp(event.deltaY * 0.001));
    event.preventDefault();
  }, { passive: false });

  canvas.addEventListener('keydown', (event) => {
    if (event.altKey) return;
    const mode = modeOf(event);
    const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    let used = true;
    if (x || y) {
      if (mode === 'measure') moveReticle(x * 8, y * 8);
      else if (mode === 'orbit') orbit(x * 0.06, -y * 0.06);
      else if (mode === 'turn') turnLight(-y * 2, x * 4);
      else moveLight([x * 0.05, -y * 0.05, 0]);
    } else if (event.key === 'PageUp' || event.key === 'PageDown') moveLight([0, 0, event.key === 'PageUp' ? 0.05 : -0.05]);
    else if (event.key === '+' || event.key === '=') orbit(0, 0, 0.93);
    else if (event.key === '-') orbit(0, 0, 1 / 0.93);
    else if (event.key === 'Home') resetView();
    else if (!event.ctrlKey && !event.metaKey && prefs.keys === 'on' && /^[omtlr]$/i.test(event.key)) {
      const chosen = { o: 'orbit', m: 'move', t: 'turn', l: 'measure' }[event.key.toLowerCase()];
      if (chosen) {
        modes.set(chosen);
        setMode(chosen);
        say(dragModes.find(([name]) => name === chosen)[1]);
      } else resetView();
    } else used = false;
    if (!used) return;
    event.preventDefault();
    event.stopPropagation();
  });

  function setMode(mode) {
    dragMode = mode;
    box.dataset.mode = mode;
    reticle.hidden = mode !== 'measure';
    if (mode === 'measure') moveReticle(0, 0);
  }
  setMode(dragMode);

  function resetView() {
    change('reset', (document) => {
      delete document.rig.camera;
      const light = document.rig.lights[document.active];
      for (const key of ['position', 'direction', 'target', 'up', 'rotate']) delete light[key];
    });
    say('Camera and light are reset');
  }
  view.reset = resetView;

  // ---- measuring

  let reticleAt;
  function moveReticle(dx, dy) {
    reticleAt ??= [canvas.clientWidth / 2, canvas.clientHeight / 2];
    reticleAt = [Math.min(canvas.clientWidth - 1, Math.max(0, reticleAt[0] + dx)), Math.min(canvas.clientHeight - 1, Math.max(0, reticleAt[1] + dy))];
    reticle.style.transform = `translate(${reticleAt[0]}px, ${reticleAt[1]}px)`;
    measureAt(...reticleAt, true);
  }

  function amount(measured) {
    if (!measured) return 'no surface';
    const lux = measured.illuminance_lx;
    const illuminance = prefs.illuminance === 'fc' ? `${briefNumber(lux / lx_per_fc)} fc` : `${briefNumber(lux)} lx`;
    return `${illuminance} · ${briefNumber(measured.luminance_nt)} cd/m²`;
  }

  let measuring = false;
  let nextMeasure;
  async function measureAt(x, y, aloud) {
    if (!shown || dark) return;
    if (measuring) {
      nextMeasure = [x, y, aloud];
      return;
    }
    measuring = true;
    const pixel = {
      x: Math.min(canvas.width - 1, Math.max(0, Math.floor((x * canvas.width) / canvas.clientWidth))),
      y: Math.min(canvas.height - 1, Math.max(0, Math.floor((y * canvas.height) / canvas.clientHeight))),
    };
    try {
      if (!shown.engine.busy) {
        const measured = await shown.engine.call('at', pixel);
        readout.textContent = amount(measured);
        readout.dataset.lux = measured?.illuminance_lx ?? '';
        if (aloud) say(readout.textContent);
      }
    } catch { /* the worker was ended: the next picture is measured */ }
    measuring = false;
    if (nextMeasure) {
      const next = nextMeasure;
      nextMeasure = undefined;
      measureAt(...next);
    }
  }

  // ---- when to draw

  on('doc', (key) => {
    if (key === 'camera') view.dataset.moved = 'camera';
    invalidate();
  });
  on('select', (file) => {
    canvas.setAttribute('aria-label', file ? `Stage lit by ${file.name}` : 'Lit stage');
    invalidate();
  });
  on('prefs', (key) => key === 'illuminance' && invalidate());
  on('tab', () => setTimeout(invalidate));
  let lastSize = '';
  new ResizeObserver(() => {
    const size = `${canvas.clientWidth}x${canvas.clientHeight}`;
    if (size === lastSize || canvas.clientWidth === 0) return;
    lastSize = size;
    reticleAt = undefined;
    placeHandle();
    invalidate();
  }).observe(canvas);
  view.invalidate = invalidate;
  // Draws small pictures where nobody sees them: what the browser compiles for them is ready for the first real one.
  view.warm = async (profiles) => {
    const document = (name) => ({ rig: { schema: 'gonio.rig/1', stage: 'room', lights: [{ shape: `ies:${name},opening` }] }, view: doc.view });
    const scene = ({ name, bytes }) => ({ ...sceneOf(document(name)), key: `warm ${name}`, files: { [name]: bytes } });
    const busyElsewhere = () => dirty || drawing || files.length > 0;
    for (const profile of [...profiles, ...profiles])
      if (!busyElsewhere()) await quick.render(scene(profile), renderOptions(document(profile.name), 160, 107, false));
    if (!busyElsewhere()) await full.render(scene(profiles[0]), renderOptions(document(profiles[0].name), 64, 48));
  };
  return view;
}
