import type { Profile } from './index.js';

/** `THREE` is the module 'three/webgpu' of r187 or later. `color` as three.js takes it; `flux_lm` is the profile's by default. */
export function iesSpotLight(THREE: any, profile: Profile, options?: { color?: unknown; flux_lm?: number }): any;
