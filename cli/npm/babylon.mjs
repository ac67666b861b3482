// Lights of Babylon.js from profiles. Babylon.js itself is an argument, so that the package depends on no release of it.

/**
 * A SpotLight that emits as the profile was measured, in candela. Babylon.js looks up the angle to the axis alone, so
 * intensities are means over the azimuth. Y up, left-handed, metres.
 */
export function iesSpotLight(BABYLON, scene, profile, { name = 'profile', position = [0, 0, 0], direction = [0, -1, 0],
                                                        color = [1, 1, 1], flux_lm } = {}) {
  const texture = profile.bake({ engine: 'babylon' });
  const light = new BABYLON.SpotLight(name, new BABYLON.Vector3(...position), new BABYLON.Vector3(...direction), Math.PI, 0,
                                      scene);
  light.iesProfileTexture = new BABYLON.RawTexture(
    texture.data, texture.width, texture.height, BABYLON.Constants.TEXTUREFORMAT_R, scene, false, false,
    BABYLON.Constants.TEXTURE_BILINEAR_SAMPLINGMODE, BABYLON.Constants.TEXTURETYPE_FLOAT);
  light.intensityMode = BABYLON.Light.INTENSITYMODE_LUMINOUSINTENSITY;
  light.falloffType = BABYLON.Light.FALLOFF_GLTF;
  light.intensity = texture.cd_per_unit * (flux_lm === undefined ? 1 : flux_lm / texture.flux_lm);
  light.diffuse = light.specular = new BABYLON.Color3(...color);
  return light;
}
