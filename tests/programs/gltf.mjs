// glTF: three.js' GLTFLoader, which reads KHR_lights_punctual and, by EXT_lights_ies' fallback, lights of the same flux.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { floorScene, webglPixels } from './threejs_floor.mjs';

export const version = `r${THREE.REVISION}`;

export async function render(name) {
  const { scene, camera } = await floorScene(null);
  const { scene: loaded } = await new GLTFLoader().loadAsync(`/assets/gltf/${name}.glb`);
  scene.add(loaded);
  scene.updateMatrixWorld();
  const renderer = new THREE.WebGLRenderer();
  return webglPixels(renderer, scene, camera);
}
