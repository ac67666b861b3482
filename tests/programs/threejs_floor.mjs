// The floor and the camera of three.js, far above it: it sees one unit to every side of the origin. From straight above,
// three.js' area lights are black, because their basis around the normal is that of the view.
import * as THREE from 'three';

export const size = 32;

// What a WebGLRenderer makes of it: red, green and blue of each pixel.
export function webglPixels(renderer, scene, camera) {
  const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const pixels = new Float32Array(4 * size * size);
  renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
  return pixels.filter((_, i) => i % 4 < 3);
}

// Waits for the textures that lights load.
async function loaded(light) {
  if (!light.map?.isTexture) return;
  for (let tries = 0; !light.map.image?.data && tries < 500; tries++) await new Promise((done) => setTimeout(done, 20));
}

// Without a name there are no lights. `finish`: of the material.
export async function floorScene(name, finish = {}) {
  const { makeLights = () => [], addSky } = name ? await import(`/assets/threejs/${name}.js`) : {};
  const scene = new THREE.Scene();
  // Only the diffuse part reflects.
  const material = new THREE.MeshPhysicalMaterial({ roughness: 1, metalness: 0, specularIntensity: 0, ...finish });
  material.color.setRGB(0.5, 0.5, 0.5);
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
  floor.rotation.x = -Math.PI / 2;
  scene.add(floor);
  const height = 20;
  const camera = new THREE.PerspectiveCamera(360 / Math.PI * Math.atan(1 / height), 1, 1, 2 * height);
  camera.position.set(0, height, 0);
  camera.up.set(0, 0, -1);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  for (const light of makeLights()) {
    scene.add(light);
    if (light.target) scene.add(light.target);
    await loaded(light);
  }
  if (addSky) await addSky(scene);
  scene.updateMatrixWorld();
  return { scene, camera };
}
