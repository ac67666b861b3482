// three.js: WebGPURenderer, on its WebGL 2 backend.
import * as THREE from 'three/webgpu';
import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';
import { floorScene, size } from './threejs_floor.mjs';

export const version = `r${THREE.REVISION}`;

export async function render(name) {
  const renderer = new THREE.WebGPURenderer({ forceWebGL: true });
  await renderer.init();
  if (THREE.RectAreaLightNode) THREE.RectAreaLightNode.setLTC(RectAreaLightTexturesLib.init());
  const { scene, camera } = await floorScene(name);
  const target = new THREE.RenderTarget(size, size, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  await renderer.renderAsync(scene, camera); // textures of profiles and lights are made by the first one
  await renderer.renderAsync(scene, camera);
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size);
  return pixels.filter((_, i) => i % 4 < 3);
}
