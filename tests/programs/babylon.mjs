// Babylon.js: PBRMaterial, WebGL 2.
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Color3 } from '@babylonjs/core/Maths/math.color.js';
import { Constants } from '@babylonjs/core/Engines/constants.js';
import { CreateGround } from '@babylonjs/core/Meshes/Builders/groundBuilder.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';
import '@babylonjs/core/Engines/Extensions/engine.readTexture.js';

export const version = Engine.Version;
const size = 32;

export async function render(name) {
  const { makeLights, addSky } = await import(`/assets/babylon/${name}.js`);
  const engine = new Engine(document.getElementById('canvas'), false);
  const scene = new Scene(engine);
  scene.imageProcessingConfiguration.applyByPostProcess = true; // the material gives linear numbers
  const height = 20; // straight above, the basis of area lights around the normal would be undefined
  const camera = new FreeCamera('camera', new Vector3(0, height, 0), scene);
  camera.fov = 2 * Math.atan(1 / height);
  [camera.minZ, camera.maxZ] = [1, 2 * height];
  camera.upVector = new Vector3(0, 0, 1);
  camera.setTarget(Vector3.Zero());
  const floor = CreateGround('floor', { width: 2, height: 2 }, scene);
  const material = new PBRMaterial('grey', scene);
  material.albedoColor = new Color3(0.5, 0.5, 0.5);
  material.metallic = 0;
  material.roughness = 1;
  material.metallicF0Factor = 0; // only the diffuse part reflects
  material.maxSimultaneousLights = 8;
  material.brdf.baseDiffuseModel = Constants.MATERIAL_DIFFUSE_MODEL_LAMBERT;
  floor.material = material;
  // Babylon.js loads the tables of area lights from a server; three.js has the same in its package. The floor's diffuse
  // part does not need them.
  const { LTC_HALF_1, LTC_HALF_2 } = RectAreaLightTexturesLib.init();
  const table = (texture) => RawTexture.CreateRGBATexture(texture.image.data, 64, 64, scene, false, false,
    Constants.TEXTURE_BILINEAR_SAMPLINGMODE, Constants.TEXTURETYPE_HALF_FLOAT);
  scene._ltcTextures = { LTC1: table(LTC_HALF_1), LTC2: table(LTC_HALF_2) };
  makeLights(scene);
  if (addSky) {
    const sky = addSky(scene);
    await new Promise((done, fail) => {
      if (sky.isReady()) done();
      sky.onLoadObservable.add(done);
      setTimeout(() => fail(new Error('the sky was not loaded')), 60000);
    });
  }
  const target = new RenderTargetTexture('floor', size, scene, { type: Constants.TEXTURETYPE_FLOAT, generateMipMaps: false });
  target.activeCamera = camera;
  target.renderList = [floor];
  await scene.whenReadyAsync();
  while (!material.isReadyForSubMesh(floor, floor.subMeshes[0])) await new Promise((done) => setTimeout(done, 20));
  for (let frame = 0; frame < 3; frame++) target.render();
  const pixels = await target.readPixels();
  return pixels.filter((_, i) => i % 4 < 3);
}
