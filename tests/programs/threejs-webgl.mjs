// three.js: WebGLRenderer, which ignores profiles.
import * as THREE from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import { floorScene, size } from './threejs_floor.mjs';

export const version = `r${THREE.REVISION}`;

export async function render(name) {
  const renderer = new THREE.WebGLRenderer();
  RectAreaLightUniformsLib.init();
  const { scene, camera } = await floorScene(name);
  const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const pixels = new Float32Array(4 * size * size);
  renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
  return pixels.filter((_, i) => i % 4 < 3);
}
