// The scenes that three.mjs renders: a light over a floor and a sphere, for each shape and several roughnesses. Runs in the
// page, with three.js and the module of the package.
import * as THREE from 'three';
import { DiskAreaLight, GonioAreaLights, SphereAreaLight, TubeAreaLight } from 'gonio/three-area-lights';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';

export const version = THREE.REVISION;
const luminance_nt = 1000;

// What users of three.js alone put in its place: a rectangle of the same shape seen from the middle of the scene.
const lights = {
  rect: { make: () => new THREE.RectAreaLight(0xffffff, luminance_nt, 1.2, 0.6), own: () => new THREE.RectAreaLight(0xffffff, luminance_nt, 1.2, 0.6), width: 1.2, height: 0.6 },
  disk: { make: () => new DiskAreaLight(0xffffff, luminance_nt, 0.5), own: () => new THREE.RectAreaLight(0xffffff, luminance_nt, 0.5 * Math.sqrt(Math.PI), 0.5 * Math.sqrt(Math.PI)), radius: 0.5 },
  sphere: { make: () => new SphereAreaLight(0xffffff, luminance_nt, 0.3), own: () => new THREE.RectAreaLight(0xffffff, luminance_nt, 0.3 * Math.sqrt(Math.PI), 0.3 * Math.sqrt(Math.PI)), radius: 0.3 },
  tube: { make: () => new TubeAreaLight(0xffffff, luminance_nt, 0.05, 1.6), own: () => new THREE.RectAreaLight(0xffffff, luminance_nt, 0.1, 1.7), radius: 0.05, length: 1.6 },
};
export const shapes = Object.keys(lights);
const middle = new THREE.Vector3(0, 0, 0.3);

function place(light) {
  light.position.set(-0.6, 0.9, 0.9);
  light.up.set(0, 0, 1);
  light.lookAt(middle); // a light looks along its -z
}

// `kind`: 'own' (RectAreaLight as three.js has it), 'gonio', or 'rows' (the package's lights with method 'ltc').
export function sceneOf(shape, kind, roughness, metallic, base) {
  const scene = new THREE.Scene();
  const material = new THREE.MeshStandardMaterial({ color: new THREE.Color(base, base, base), roughness, metalness: metallic });
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(6, 6), material);
  const sphere = new THREE.Mesh(new THREE.SphereGeometry(0.4, 128, 64), material);
  sphere.position.set(0.45, 0.1, 0.4);
  const light = lights[shape][kind === 'own' ? 'own' : 'make']();
  place(light);
  scene.add(floor, sphere, light);
  const camera = new THREE.PerspectiveCamera(45, 4 / 3, 0.1, 20);
  camera.up.set(0, 0, 1);
  camera.position.set(0.4, -2.6, 1.1);
  camera.lookAt(middle);
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  return { scene, camera, material, light };
}

let renderer = null;
export function rendererOf(kind, shape) {
  GonioAreaLights.dispose();
  if (kind === 'own') RectAreaLightUniformsLib.init();
  else GonioAreaLights.init({ shapes: shape === 'all four' ? shapes : [shape], method: kind === 'rows' ? 'ltc' : 'ltc-share' });
  renderer?.forceContextLoss();
  renderer?.dispose();
  renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
  return renderer;
}

// The pixels in float, the lowest row first.
function rendered({ scene, camera }, width, height) {
  const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.setClearColor(0, 0);
  renderer.clear();
  renderer.render(scene, camera);
  const out = new Float32Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, out);
  renderer.setRenderTarget(null);
  target.dispose();
  return [...out];
}

// Linear luminance of each pixel, the lowest row first; alpha is 0 where there is nothing.
export function picture(kind, shape, roughness, metallic, base, width, height) {
  return rendered(sceneOf(shape, kind, roughness, metallic, base), width, height);
}

// What the shader of three.js knows of each pixel: position, normal and direction to the eye in the space of the view, and
// the roughness after its own changes; and the light in the same space.
export function surfaces(shape, roughness, width, height) {
  const of = (expression) => {
    const made = sceneOf(shape, 'gonio', roughness, 0, 0.5);
    made.material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace('#include <dithering_fragment>', `gl_FragColor = ${expression};`);
    };
    made.material.customProgramCacheKey = () => expression;
    return rendered(made, width, height);
  };
  const { light, camera } = sceneOf(shape, 'gonio', roughness, 0, 0.5);
  const toView = camera.matrixWorldInverse.copy(camera.matrixWorld).invert().multiply(light.matrixWorld);
  const axis = (x, y, z) => new THREE.Vector3(x, y, z).transformDirection(toView).toArray();
  const { width: w, height: h, radius, length } = lights[shape];
  return {
    position: of('vec4( geometryPosition, 1.0 )'), normal: of('vec4( geometryNormal, 1.0 )'), view: of('vec4( geometryViewDir, material.roughness )'),
    light: { shape, luminance_nt, center: new THREE.Vector3().setFromMatrixPosition(toView).toArray(), axis: shape === 'tube' ? axis(0, 1, 0) : axis(0, 0, -1), width_direction: axis(1, 0, 0), width: w, height: h, radius, length },
  };
}

// `shape` may be 'all four', which are then in the scene together. Milliseconds until the first frame is there, and for each of the next ones.
export function frameTime(kind, shape, count, width, height) {
  const made = sceneOf(shape === 'all four' ? shapes[0] : shape, kind, 0.3, 0, 0.5);
  if (shape === 'all four')
    for (const more of shapes.slice(1)) made.scene.add(sceneOf(more, kind, 0.3, 0, 0.5).light);
  renderer.setSize(width, height, false);
  const gl = renderer.getContext();
  const one = new Uint8Array(4);
  const frame = () => {
    const start = performance.now();
    renderer.render(made.scene, made.camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, one); // waits
    return performance.now() - start;
  };
  const first = frame();
  let best = Infinity;
  for (let i = 0; i < count; ++i) best = Math.min(best, frame());
  return [first, best];
}

// For looking at: the usual output of three.js, with the light's shape drawn.
export function shown(kind, shape, roughness, width, height) {
  const made = sceneOf(shape, kind, roughness, 0, 0.5);
  const geometry = { rect: () => new THREE.PlaneGeometry(1.2, 0.6), disk: () => new THREE.CircleGeometry(0.5, 64), sphere: () => new THREE.SphereGeometry(0.3, 64, 32), tube: () => new THREE.CapsuleGeometry(0.05, 1.6, 16, 32) }[shape]();
  made.light.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: new THREE.Color(luminance_nt, luminance_nt, luminance_nt), side: THREE.DoubleSide })));
  renderer.toneMapping = THREE.ACESFilmicToneMapping;
  renderer.toneMappingExposure = 0.004;
  renderer.setSize(width, height, false);
  renderer.render(made.scene, made.camera);
  renderer.toneMapping = THREE.NoToneMapping;
  return renderer.domElement.toDataURL('image/png');
}

// Pictures (data URLs) side by side, in rows.
export async function joined(rows, width, height) {
  const canvas = document.createElement('canvas');
  canvas.width = width * rows[0].length;
  canvas.height = height * rows.length;
  const context = canvas.getContext('2d');
  for (const [row, urls] of rows.entries())
    for (const [column, url] of urls.entries()) {
      const image = new Image();
      image.src = url;
      await image.decode();
      context.drawImage(image, width * column, height * row, width, height);
    }
  return canvas.toDataURL('image/png');
}

// What users do beside looking at one light: sentences about what went wrong.
export function checks() {
  const failures = [];
  const check = (holds, sentence) => { if (!holds) failures.push(sentence); };
  const [width, height] = [40, 30];
  const render = (scene, camera) => rendered({ scene, camera }, width, height);
  const apart = (a, b) => a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i]) / (Math.abs(b[i]) + 1)), 0);
  const alone = (light, material) => {
    const made = sceneOf('rect', 'own', 0.3, 0, 0.5);
    made.scene.remove(made.light);
    if (material) for (const mesh of made.scene.children) mesh.material = material;
    if (light) made.scene.add(light);
    made.scene.updateMatrixWorld();
    return { out: render(made.scene, made.camera), ...made };
  };
  const four = () => shapes.map((shape, i) => {
    const light = lights[shape].make();
    place(light);
    light.position.x += 0.3 * i;
    light.lookAt(middle);
    return light;
  });

  // Shapes that come later, several lights in one scene, lights with a parent.
  const each = four().map((light) => alone(light).out);
  const group = new THREE.Group();
  group.add(...four());
  const together = alone(group);
  const sum = each[0].map((_, i) => (i % 4 === 3 ? each[0][i] : each.reduce((all, out) => all + out[i], 0)));
  check(apart(together.out, sum) < 1e-4, `four lights are not the sum of each: ${apart(together.out, sum)}`);
  group.position.set(0.2, 0.1, 0.3);
  const moved = render(together.scene, together.camera);
  const separate = four();
  for (const light of separate) light.position.add(group.position);
  const parts = separate.map((light) => alone(light).out);
  const movedSum = parts[0].map((_, i) => (i % 4 === 3 ? parts[0][i] : parts.reduce((all, out) => all + out[i], 0)));
  check(apart(moved, movedSum) < 1e-4, `a group does not move its lights: ${apart(moved, movedSum)}`);
  group.visible = false;
  check(render(together.scene, together.camera).every((x, i) => i % 4 === 3 || x === 0), 'invisible lights shine');

  // Properties.
  for (const light of four().slice(1)) {
    const lm = light.power;
    light.power = 2 * lm;
    check(Math.abs(light.intensity / (2 * luminance_nt) - 1) < 1e-12, `${light.name_of_type}: power`);
    const copy = light.clone();
    check(copy.constructor === light.constructor && copy.sizes.every((size) => copy[size] === light[size]) && copy.intensity === light.intensity, `${light.name_of_type}: clone`);
    check(light.toJSON().object.type === light.name_of_type && light.sizes.every((size) => light.toJSON().object[size] === light[size]), `${light.name_of_type}: toJSON`);
  }
  check(Math.abs(new SphereAreaLight(0xffffff, 1, 0.5).power / (Math.PI * Math.PI) - 1) < 1e-12, 'the power of a sphere of 1 m²·π is not π² lm');
  check(alone(new TubeAreaLight(0xffffff, luminance_nt, 0.3, 0)).out.every((x, i, all) => !Number.isNaN(x)), 'a tube without a length gives NaN');

  // Materials. A black base leaves the clear coat alone.
  const coat = new THREE.MeshPhysicalMaterial({ color: 0, roughness: 0.3, clearcoat: 1, clearcoatRoughness: 0.2 });
  const plain = new THREE.MeshPhysicalMaterial({ color: 0, roughness: 0.3 });
  const lit = (material) => alone(four()[1], material).out.reduce((all, x, i) => (i % 4 === 3 ? all : all + x), 0);
  check(lit(coat) > 1.2 * lit(plain), 'a clear coat has no highlight');
  const odd = new THREE.MeshStandardMaterial({ color: 0x808080, roughness: 0.3 });
  let called = 0;
  odd.onBeforeCompile = () => { ++called; };
  check(apart(alone(four()[0], odd).out, alone(four()[0], new THREE.MeshStandardMaterial({ color: 0x808080, roughness: 0.3 })).out) < 1e-6 && called === 1, 'onBeforeCompile is not called, or changes the picture');
  const foggy = alone(four()[0]);
  foggy.scene.fog = new THREE.Fog(0x4060ff, 1, 4);
  check(apart(render(foggy.scene, foggy.camera), foggy.out) > 0.1, 'fog does not change the picture');

  // three.js' own tables do not come back by init(); its own light does by dispose().
  const before = alone(four()[0]).out;
  RectAreaLightUniformsLib.init();
  check(apart(alone(four()[0]).out, before) === 0, 'RectAreaLightUniformsLib.init() changes the lights');
  check(GonioAreaLights.isReady === true, 'not ready after init()');
  const rect = lights.rect.own(); // the constructors of the others would call init()
  place(rect);
  GonioAreaLights.dispose();
  check(!GonioAreaLights.isReady && THREE.ShaderChunk.lights_fragment_begin.indexOf('GONIO') < 0, 'dispose() leaves its code');
  RectAreaLightUniformsLib.init();
  const own = alone(rect);
  check(apart(own.out, before) > 0.01, 'dispose() does not bring the lights of three.js back');
  for (const mesh of own.scene.children) if (mesh.material) mesh.material.needsUpdate = true;
  GonioAreaLights.init();
  check(apart(render(own.scene, own.camera), before) < 1e-6, 'init() after frames and needsUpdate does not change a material');
  GonioAreaLights.dispose();

  // Clear sentences.
  const said = (work) => { try { work(); } catch (error) { return error.message; } return ''; };
  check(said(() => GonioAreaLights.init({ shapes: ['ring'] })) === "gonio/three-area-lights: unknown shape 'ring'; there are: rect, disk, sphere, tube", 'an unknown shape');
  const chunk = THREE.ShaderChunk.lights_fragment_begin;
  THREE.ShaderChunk.lights_fragment_begin = chunk.replace('defined( RE_Direct_RectArea )', 'defined( RE_Other )');
  check(/^gonio\/three-area-lights: three\.js r\w+ has no line '#if \( NUM_RECT_AREA_LIGHTS > 0 \) && defined\( RE_Direct_RectArea \)' in ShaderChunk\.lights_fragment_begin; r160 to r187 are supported$/.test(said(() => GonioAreaLights.init())), `a missing anchor: ${said(() => GonioAreaLights.init())}`);
  check(!GonioAreaLights.isReady, 'ready without an anchor');
  THREE.ShaderChunk.lights_fragment_begin = chunk;
  return failures;
}
