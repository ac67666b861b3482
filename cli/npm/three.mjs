// Lights of three.js from profiles. three.js itself is an argument, so that the package depends on no release of it.

/**
 * An IESSpotLight that emits as the profile was measured, for WebGPURenderer: three.js r187 or later, imported from
 * 'three/webgpu'. It shines from its position to its target, in candela; C90 points along `light.shadow.camera.up`.
 */
export function iesSpotLight(THREE, profile, { color = 0xffffff, flux_lm } = {}) {
  const texture = profile.bake({ engine: 'three' });
  const texels = Uint16Array.from(texture.data, (value) => THREE.DataUtils.toHalfFloat(value));
  const map = new THREE.DataTexture(texels, texture.width, texture.height, THREE.RedFormat, THREE.HalfFloatType);
  map.minFilter = map.magFilter = THREE.LinearFilter;
  map.wrapT = THREE.RepeatWrapping;
  map.needsUpdate = true;
  const scale = flux_lm === undefined ? 1 : flux_lm / texture.flux_lm;
  const light = new THREE.IESSpotLight(color, texture.cd_per_unit * scale);
  light.angle = Math.PI / 2;
  light.shadow.focus = 0.5; // a projection of 90° for the azimuths
  light.iesMap = map;
  return light;
}
