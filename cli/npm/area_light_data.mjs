// What the area lights of three.js (three-area-lights.mjs) take from the tool: formulas as GLSL and the table of lobes, as
// the text of a module. `run(words)` runs a command of the tool in a folder of its own and returns its stdout and files.
const lights = 'rect,disk,sphere,tube';
export const table_size = 32;

// Names of their own in a shader of other people, and no first lines, which a shader has once.
function prefixed(text) {
  const code = text.slice(text.indexOf('\n', text.indexOf('precision highp float;'))).trim();
  const names = [...code.matchAll(/^(?:float|vec3|const float) (\w+)[([]/gm)].map((match) => match[1]);
  return code.replaceAll(new RegExp(`\\b(${names.join('|')})(?=[([])`, 'g'), 'gonio_$1');
}

// The layers of the raw file, one after the other: four halves a texel, then two.
function layers(bytes) {
  const first = table_size * table_size * 8;
  if (bytes.length !== first + table_size * table_size * 4) throw new Error(`the table has ${bytes.length} bytes`);
  return [bytes.subarray(0, first), bytes.subarray(first)].map((part) => Buffer.from(part).toString('base64'));
}

const quoted = (text) => `\`${text.replaceAll('\\', '\\\\').replaceAll('`', '\\`').replaceAll('$', '\\$')}\``;

export function areaLightData(run) {
  const glsl = (method) => quoted(prefixed(run(['shader', '--light', lights, '--material', 'ggx', '--method', method, '--what', 'irradiance,shade', '--lang', 'glsl-es300']).stdout));
  const { files } = run(['bake', '--table', 'ltc-ggx', '-s', `${table_size}`, '--pixel', 'half', '-o', 'ltc.raw']);
  const [leaning, reflected] = layers(files['ltc.raw']);
  return `// Written by build.mjs: what \`gonio shader\` and \`gonio bake --table ltc-ggx\` print.
export const table_size = ${table_size};
export const leaning = '${leaning}';
export const reflected = '${reflected}';
export const glsl = { // by the method of the highlights
  ltc: ${glsl('ltc')},
  'ltc-share': ${glsl('ltc-share')},
};
`;
}
