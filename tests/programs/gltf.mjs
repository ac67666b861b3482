// glTF: three.js' GLTFLoader, which reads KHR_lights_punctual and, by EXT_lights_ies' fallback, lights of the same flux.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { floorScene, size } from './threejs_floor.mjs';

export const version = `r${THREE.REVISION}`;

export async function render(name) {
  const { scene, camera } = await floorScene(null);
  const { scene: loaded } = await new GLTFLoader().loadAsync(`/assets/gltf/${name}.glb`);
  scene.add(loaded);
  scene.updateMatrixWorld();
  const renderer = new THREE.WebGLRenderer();
  const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const pixels = new Float32Array(4 * size * size);
  renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
  return pixels.filter((_, i) => i % 4 < 3);
}
