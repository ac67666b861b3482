import type { Profile } from './index.js';

type Triple = [number, number, number];

/** `BABYLON` is the module '@babylonjs/core'. `flux_lm` is the profile's by default; `color` is linear RGB. */
export function iesSpotLight(BABYLON: any, scene: any, profile: Profile, options?: {
  name?: string; position?: Triple; direction?: Triple; color?: Triple; flux_lm?: number;
}): any;
