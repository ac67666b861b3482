import type { ColorRepresentation, Light } from 'three';

export type AreaLightShape = 'rect' | 'disk' | 'sphere' | 'tube';
/** As the tool names it: `gonio shader --material ggx --method …`. */
export type AreaLightMethod = 'ltc' | 'ltc-share';

/**
 * Area lights for the WebGLRenderer of three.js r160 to r187: RectAreaLight by gonio's formulas, and disks, spheres and tubes.
 * Light falls on MeshStandardMaterial and MeshPhysicalMaterial; nothing casts a shadow in it.
 */
export const GonioAreaLights: {
  /** Whether materials that are compiled now have these lights. */
  readonly isReady: boolean;
  /**
   * Patches three.js, before the first frame. `shapes` are those to compile, 'rect' by default; a light of another shape adds
   * its own. `method` is that of the highlights: 'ltc-share', the usual one, or 'ltc', which is more accurate and takes longer. Without
   * it the method stays; a change needs `needsUpdate` of materials. Throws an Error that names the line if this release of three.js lacks a line that is patched.
   */
  init(options?: { shapes?: AreaLightShape[]; method?: AreaLightMethod }): void;
  /** Frees the tables and gives three.js its own code back. Materials that were compiled need `needsUpdate`. */
  dispose(): void;
};

// Without this a declaration file exports all it declares.
export {};

/** What disks, spheres and tubes have in common. Sizes are in metres, and no scale of a matrix changes them. */
declare abstract class AreaLight extends Light {
  readonly isRectAreaLight: true;
  /** The luminance [nt] = [cd/m²], times `color`. */
  intensity: number;
  /** The luminous flux [lm]: π × the luminance × the area. Setting it changes `intensity`. */
  power: number;
  /** The area that emits [m²]. */
  readonly area: number;
}

/** A disk that emits to its local -z, as RectAreaLight does. */
export class DiskAreaLight extends AreaLight {
  constructor(color?: ColorRepresentation, intensity?: number, radius?: number);
  readonly isDiskAreaLight: true;
  radius: number;
}

/** A sphere. */
export class SphereAreaLight extends AreaLight {
  constructor(color?: ColorRepresentation, intensity?: number, radius?: number);
  readonly isSphereAreaLight: true;
  radius: number;
}

/** A tube with half spheres at its ends, along its local y: the shape of `CapsuleGeometry(radius, length)`. */
export class TubeAreaLight extends AreaLight {
  constructor(color?: ColorRepresentation, intensity?: number, radius?: number, length?: number);
  readonly isTubeAreaLight: true;
  radius: number;
  /** Without the half spheres. */
  length: number;
}
