// three.js: WebGLRenderer, which ignores profiles.
import * as THREE from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import { floorScene, webglPixels } from './threejs_floor.mjs';

export const version = `r${THREE.REVISION}`;

export async function render(name) {
  const renderer = new THREE.WebGLRenderer();
  RectAreaLightUniformsLib.init();
  const { scene, camera } = await floorScene(name);
  return webglPixels(renderer, scene, camera);
}
