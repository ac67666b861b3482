// PlayCanvas: StandardMaterial, WebGL 2, lights without clusters.
import * as pc from 'playcanvas';

export const version = pc.version;
const size = 32;

export async function render(name) {
  const { makeLights } = await import(`/assets/playcanvas/${name}.js`);
  const canvas = document.getElementById('canvas');
  const app = new pc.Application(canvas, { graphicsDeviceOptions: { preferWebGl2: true } });
  app.scene.clusteredLightingEnabled = false;
  app.scene.physicalUnits = true;
  app.scene.ambientLight = new pc.Color(0, 0, 0);
  app.scene.ambientLuminance = 0;
  const material = new pc.StandardMaterial();
  material.diffuse = new pc.Color().gamma(new pc.Color(0.5, 0.5, 0.5)); // linear 0.5
  material.useMetalness = false;
  material.specular = new pc.Color(0, 0, 0);
  material.useFog = false;
  material.useTonemap = false;
  material.update();
  const floor = new pc.Entity('floor', app);
  floor.addComponent('render', { type: 'plane', material, castShadows: false });
  floor.setLocalScale(2, 1, 2);
  app.root.addChild(floor);
  const target = new pc.RenderTarget({ depth: true, colorBuffer: new pc.Texture(app.graphicsDevice, {
    width: size, height: size, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false,
    minFilter: pc.FILTER_NEAREST, magFilter: pc.FILTER_NEAREST }) });
  const height = 20;
  const camera = new pc.Entity('camera', app);
  // An aperture, a shutter and a sensitivity that make an exposure of 1.
  camera.addComponent('camera', { renderTarget: target, fov: 360 / Math.PI * Math.atan(1 / height), nearClip: 1,
    farClip: 2 * height, clearColor: new pc.Color(0, 0, 0, 0), toneMapping: pc.TONEMAP_NONE, gammaCorrection: pc.GAMMA_NONE,
    aperture: 1, shutter: 1, sensitivity: 120 });
  camera.setPosition(0, height, 0);
  camera.setEulerAngles(-90, 0, 0);
  app.root.addChild(camera);
  makeLights(app);
  app.start();
  for (let frame = 0; frame < 4; frame++) await new Promise((done) => app.once('frameend', done));
  const pixels = await target.colorBuffer.read(0, 0, size, size, { renderTarget: target, immediate: true });
  return Float32Array.from(pixels).filter((_, i) => i % 4 < 3);
}
