// three-gpu-pathtracer, with the lights for three.js.
import * as THREE from 'three';
import { WebGLPathTracer } from 'three-gpu-pathtracer';
import { floorScene, size } from './threejs_floor.mjs';

const samples = 32;

export const version = (await (await fetch('/node_modules/three-gpu-pathtracer/package.json')).json()).version;

export async function render(name) {
  const { scene, camera } = await floorScene(name, { roughness: 0.01, ior: 1 }); // its diffuse part is then Lambert's
  const renderer = new THREE.WebGLRenderer();
  renderer.setSize(size, size, false);
  const tracer = new WebGLPathTracer(renderer);
  tracer.renderToCanvas = false;
  tracer.renderScale = 1;
  tracer.bounces = 2; // the second finds areas and skies
  tracer.filterGlossyFactor = 0;
  tracer.tiles.set(1, 1);
  tracer.renderDelay = 0;
  tracer.minSamples = 0;
  tracer.fadeDuration = 0;
  tracer.rasterizeScene = false;
  tracer.dynamicLowRes = false;
  tracer.setScene(scene, camera);
  for (let tries = 0; tracer.samples < samples && tries < 4000; tries++) {
    tracer.renderSample();
    await new Promise((done) => setTimeout(done, 0));
  }
  if (tracer.samples < samples) throw new Error(`only ${tracer.samples} samples`);
  const target = tracer.target;
  const pixels = new Float32Array(4 * target.width * target.height);
  renderer.readRenderTargetPixels(target, 0, 0, target.width, target.height, pixels);
  if (target.width !== size) throw new Error(`${target.width} pixels`);
  return pixels.filter((_, i) => i % 4 < 3);
}
