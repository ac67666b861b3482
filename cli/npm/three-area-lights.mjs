// Area lights for the WebGLRenderer of three.js: RectAreaLight with exact irradiance and gonio's highlights, and disks,
// spheres and tubes beside it, for MeshStandardMaterial and MeshPhysicalMaterial.
//
// They travel on the renderer's own path for RectAreaLight, which gives a shader two vectors for each light, in the space of
// the view. Here the lengths of both tell the shape: whatever is shorter than any real light stands for something else.
import { ClampToEdgeWrapping, DataTexture, HalfFloatType, Light, LinearFilter, MeshStandardMaterial, REVISION, RGBAFormat, RGFormat, ShaderChunk, UniformsLib } from 'three';
import { glsl, leaning, reflected, table_size } from './area-light-data.mjs';

const shapes = ['rect', 'disk', 'sphere', 'tube'];
const usual_method = 'ltc-share';

// Halves of the second vector (disk, sphere) or of the first (tube: times the radius), in metres.
const least_size = 2 ** -40;
const disk_mark = 2 ** -99;
const sphere_mark = 2 ** -115;
const marks_between = 2 ** -108;
const tube_scale = 2 ** -64;

const functions = (used, method) => `
#if NUM_RECT_AREA_LIGHTS > 0

${glsl[method]}

struct GonioLobe {
	vec3 leaning;
	vec3 reflected;
};

// ltc_1 and ltc_2 hold gonio's table: columns by the root of n.v, rows by the roughness.
GonioLobe gonio_lobe( const in vec3 normal, const in vec3 view, const in float roughness ) {

	vec2 at = vec2( sqrt( clamp( dot( normal, view ), 0.0, 1.0 ) ), roughness ) * ${(table_size - 1) / table_size} + ${0.5 / table_size};
	vec4 first = textureLod( ltc_1, at, 0.0 );
	return GonioLobe( first.xyz, vec3( first.w, textureLod( ltc_2, at, 0.0 ).xy ) );

}

struct GonioAreaLight {
	int shape; // as in: ${shapes.map((shape, i) => `${i} ${shape}`).join(', ')}
	vec3 to_center;
	vec3 axis;  // in which a rectangle or disk emits; along a tube
	vec3 width_direction;
	float width;  // of a rectangle; the radius of another shape
	float height; // of a rectangle; the length of a tube
};

float gonio_largest( const in vec3 v ) {

	return max( max( abs( v.x ), abs( v.y ) ), abs( v.z ) );

}

vec3 gonio_unit( const in vec3 v ) {

	float largest = gonio_largest( v );
	return largest > 0.0 ? normalize( v / largest ) : vec3( 0.0, 0.0, 1.0 );

}

GonioAreaLight gonio_area_light( const in RectAreaLight light, const in vec3 position ) {

	GonioAreaLight area;
	float second = gonio_largest( light.halfHeight );
	float first = gonio_largest( light.halfWidth );
	bool is_tube = first > 0.0 && first < ${least_size};
	area.shape = is_tube ? 3 : second > ${least_size} ? 0 : second > ${marks_between} ? 1 : second > 0.0 ? 2 : 4; // 4: a rectangle without height
	area.to_center = light.position - position;
	area.width_direction = gonio_unit( light.halfWidth );
	area.axis = gonio_unit( light.halfHeight );
	area.width = is_tube ? length( light.halfWidth * ${(1 / tube_scale).toExponential()} ) : length( light.halfWidth ) * ( area.shape == 0 ? 2.0 : 1.0 );
	area.height = 2.0 * length( light.halfHeight );
	if ( ! is_tube ) area.axis = cross( area.axis, area.width_direction ); // local -z
	return area;

}

float gonio_irradiance( const in GonioAreaLight area, const in vec3 normal ) {

${cases(used, {
    rect: 'gonio_rect_irradiance( area.to_center, area.axis, area.width_direction, area.width, area.height, normal )',
    disk: 'gonio_disk_irradiance( area.to_center, area.axis, area.width, normal )',
    sphere: 'gonio_sphere_irradiance( area.to_center, area.width, normal )',
    tube: 'gonio_tube_irradiance( area.to_center, area.axis, area.width, area.height, normal )',
  })}
	return 0.0;

}

vec3 gonio_highlight( const in GonioAreaLight area, const in vec3 normal, const in vec3 view, const in vec3 f0, const in float f90, const in float roughness, const in GonioLobe lobe ) {

${cases(used, {
    rect: 'gonio_rect_shade_ggx_METHOD( area.to_center, area.axis, area.width_direction, area.width, area.height, normal, view, f0, f90, roughness, lobe.leaning, lobe.reflected )',
    disk: 'gonio_disk_shade_ggx_METHOD( area.to_center, area.axis, area.width, normal, view, f0, f90, roughness, lobe.leaning, lobe.reflected )',
    sphere: 'gonio_sphere_shade_ggx_METHOD( area.to_center, area.width, normal, view, f0, f90, roughness, lobe.leaning, lobe.reflected )',
    tube: 'gonio_tube_shade_ggx_METHOD( area.to_center, area.axis, area.width, area.height, normal, view, f0, f90, roughness, lobe.leaning, lobe.reflected )',
  }).replaceAll('METHOD', method.replace('-', '_'))}
	return vec3( 0.0 );

}

// Unrolled, as three.js unrolls its loops over lights: some compilers take minutes for a loop with so much in it.
void gonio_area_lights( const in vec3 position, const in vec3 normal, const in vec3 view, const in vec3 clearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {

	GonioLobe lobe = gonio_lobe( normal, view, material.roughness );

	#ifdef USE_CLEARCOAT

		GonioLobe clearcoatLobe = gonio_lobe( clearcoatNormal, view, material.clearcoatRoughness );

	#endif

	GonioAreaLight area;
	vec3 luminance;

	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {

		area = gonio_area_light( rectAreaLights[ i ], position );
		luminance = rectAreaLights[ i ].color;

		reflectedLight.directDiffuse += luminance * RECIPROCAL_PI * gonio_irradiance( area, normal ) * material.GONIO_DIFFUSE;
		reflectedLight.directSpecular += luminance * gonio_highlight( area, normal, view, material.GONIO_F0, material.specularF90, material.roughness, lobe );

		#ifdef USE_CLEARCOAT

			clearcoatSpecularDirect += luminance * gonio_highlight( area, clearcoatNormal, view, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness, clearcoatLobe );

		#endif

	}
	#pragma unroll_loop_end

}

#define GONIO_AREA_LIGHTS

#endif

`;

function cases(used, calls) {
  return used.map((shape) => `	if ( area.shape == ${shapes.indexOf(shape)} ) return ${calls[shape]};`).join('\n');
}

// The lines where the chunks are patched: the end of the functions of a physical material, and the loop over the lights.
const anchors = {
  lights_physical_pars_fragment: ['#define RE_Direct_RectArea RE_Direct_RectArea_Physical', /^#define RE_Direct_RectArea[ \t]+RE_Direct_RectArea_Physical$/m],
  lights_fragment_begin: ['#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )', /^#if \( NUM_RECT_AREA_LIGHTS > 0 \) && defined\( RE_Direct_RectArea \)$/m],
};

function checkAnchors() {
  const needs = [...Object.entries(anchors).map(([chunk, [line, pattern]]) => [chunk, line, pattern]), ['lights_fragment_begin', 'vec3 geometryClearcoatNormal = vec3( 0.0 );', /^vec3 geometryClearcoatNormal\b/m]];
  for (const [chunk, line, pattern] of needs)
    if (!pattern.test(ShaderChunk[chunk] ?? '')) throw new Error(`gonio/three-area-lights: three.js r${REVISION} has no line '${line}' in ShaderChunk.${chunk}; r160 to r187 are supported`);
}

function texture(text, format) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const made = new DataTexture(new Uint16Array(bytes.buffer), table_size, table_size, format, HalfFloatType);
  made.minFilter = made.magFilter = LinearFilter;
  made.wrapS = made.wrapT = ClampToEdgeWrapping;
  made.needsUpdate = true;
  return made;
}

let before = null; // what init() replaced
let compiled = new Set(); // the shapes in the chunks
let method = usual_method; // of their highlights

// The chunks with the code of these shapes alone: compilers work on what a scene does not use, too.
function patch() {
  const { pars, begin } = before;
  const added = functions(shapes.filter((shape) => compiled.has(shape)), method)
    .replaceAll('GONIO_DIFFUSE', pars.includes('diffuseContribution') ? 'diffuseContribution' : 'diffuseColor')
    .replaceAll('GONIO_F0', pars.includes('specularColorBlended') ? 'specularColorBlended' : 'specularColor');
  ShaderChunk.lights_physical_pars_fragment = pars.replace(anchors.lights_physical_pars_fragment[1], (line) => added + line);
  ShaderChunk.lights_fragment_begin = begin.replace(anchors.lights_fragment_begin[1], (line) => `#ifdef GONIO_AREA_LIGHTS

	gonio_area_lights( geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );

#elif${line.slice('#if'.length)}`);
}

export const GonioAreaLights = {
  /** Whether materials that are compiled now have these lights. */
  get isReady() { return before !== null; },

  /** Patches three.js, before the first frame. `shapes` are compiled; a light of another shape adds its own. `method` is that of highlights. */
  init({ shapes: wanted = ['rect'], method: asked = method } = {}) {
    const known = (word, value, all) => { if (!all.includes(value)) throw new Error(`gonio/three-area-lights: unknown ${word} '${value}'; there are: ${all.join(', ')}`); };
    for (const shape of wanted) known('shape', shape, shapes);
    known('method', asked, Object.keys(glsl));
    const more = wanted.filter((shape) => !compiled.has(shape));
    if (before && more.length === 0 && asked === method) return;
    if (!before) {
      checkAnchors();
      const tables = [texture(leaning, RGBAFormat), texture(reflected, RGFormat)];
      before = { pars: ShaderChunk.lights_physical_pars_fragment, begin: ShaderChunk.lights_fragment_begin, key: MeshStandardMaterial.prototype.customProgramCacheKey, tables, slots: {} };
      // The renderer reads its tables from here. RectAreaLightUniformsLib.init(), which would put others there, changes nothing now.
      for (const [i, table] of tables.entries())
        for (const slot of [`LTC_FLOAT_${i + 1}`, `LTC_HALF_${i + 1}`]) {
          before.slots[slot] = UniformsLib[slot];
          Object.defineProperty(UniformsLib, slot, { configurable: true, enumerable: true, get: () => table, set: () => {} });
        }
      // Else the renderer would take programs without these lights, or without a shape, for the same as those with them.
      const key = before.key;
      MeshStandardMaterial.prototype.customProgramCacheKey = function () {
        return `${key.call(this)} gonio ${method} ${[...compiled].join()}`;
      };
    }
    for (const shape of more) compiled.add(shape);
    method = asked;
    patch();
  },

  /** Frees the tables and gives three.js its own chunks back. Materials that were compiled need an update. */
  dispose() {
    if (!before) return;
    ShaderChunk.lights_physical_pars_fragment = before.pars;
    ShaderChunk.lights_fragment_begin = before.begin;
    delete MeshStandardMaterial.prototype.customProgramCacheKey;
    if (before.key !== MeshStandardMaterial.prototype.customProgramCacheKey) MeshStandardMaterial.prototype.customProgramCacheKey = before.key;
    for (const [slot, value] of Object.entries(before.slots)) {
      delete UniformsLib[slot];
      if (value !== undefined) UniformsLib[slot] = value;
    }
    for (const table of before.tables) table.dispose();
    before = null;
    compiled = new Set();
    method = usual_method;
  },
};

// What the three have in common; `area` [m²] emits uniformly, `power` [lm] is π times the luminance [nt] times the area.
class AreaLight extends Light {
  constructor(shape, color, intensity) {
    GonioAreaLights.init(before ? { shapes: [shape] } : { shapes: ['rect', shape] });
    super(color, intensity);
    this.isRectAreaLight = true; // takes the renderer's path
    this.type = 'RectAreaLight'; // and its uniforms
  }

  get power() { return this.intensity * Math.PI * this.area; }
  set power(lm) { this.intensity = lm / (Math.PI * this.area); }

  copy(source, recursive) {
    super.copy(source, recursive);
    for (const size of this.sizes) this[size] = source[size];
    return this;
  }

  toJSON(meta) {
    const data = super.toJSON(meta);
    data.object.type = this.name_of_type;
    for (const size of this.sizes) data.object[size] = this[size];
    return data;
  }
}

/** A disk that emits to its local -z, as RectAreaLight does. `intensity` is its luminance [nt], `radius` in metres. */
export class DiskAreaLight extends AreaLight {
  constructor(color, intensity, radius = 1) {
    super('disk', color, intensity);
    this.isDiskAreaLight = true;
    this.radius = radius;
  }

  get name_of_type() { return 'DiskAreaLight'; }
  get sizes() { return ['radius']; }
  get area() { return Math.PI * this.radius ** 2; }
  get width() { return 2 * this.radius; }
  get height() { return 2 * disk_mark; }
}

/** A sphere. `intensity` is its luminance [nt], `radius` in metres. */
export class SphereAreaLight extends AreaLight {
  constructor(color, intensity, radius = 1) {
    super('sphere', color, intensity);
    this.isSphereAreaLight = true;
    this.radius = radius;
  }

  get name_of_type() { return 'SphereAreaLight'; }
  get sizes() { return ['radius']; }
  get area() { return 4 * Math.PI * this.radius ** 2; }
  get width() { return 2 * this.radius; }
  get height() { return 2 * sphere_mark; }
}

/** A tube with half spheres at its ends, along its local y, as CapsuleGeometry(radius, length) is. `intensity` is its luminance [nt]. */
export class TubeAreaLight extends AreaLight {
  constructor(color, intensity, radius = 0.1, length = 1) {
    super('tube', color, intensity);
    this.isTubeAreaLight = true;
    this.radius = radius;
    this.length = length;
  }

  get name_of_type() { return 'TubeAreaLight'; }
  get sizes() { return ['radius', 'length']; }
  get area() { return 2 * Math.PI * this.radius * (this.length + 2 * this.radius); }
  get width() { return 2 * this.radius * tube_scale; }
  get height() { return Math.max(this.length, 1e-4 * this.radius); }
}
