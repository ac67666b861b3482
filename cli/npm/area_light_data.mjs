// What the area lights of three.js (three-area-lights.mjs) take from the tool: formulas as GLSL and the table of lobes, as
// the text of a module. `run(words)` runs a command of the tool in a folder of its own and returns its stdout and files.
const lights = 'rect,disk,sphere,tube';
export const table_size = 32;

// One text of several, with each function once and a name of its own in a shader of other people.
function joined(texts) {
  const blocks = [...new Set(texts.flatMap((text) => text.trim().split('\n\n')))].filter((block) => !/^(\/\/ Printed by|precision )/.test(block));
  const text = blocks.join('\n\n');
  const names = [...text.matchAll(/^(?:float|vec3) (\w+)\(/gm)].map((match) => match[1]);
  if (new Set(names).size !== names.length) throw new Error('gonio shader printed two functions of one name');
  return text.replaceAll(new RegExp(`\\b(${names.join('|')})(?=\\()`, 'g'), 'gonio_$1');
}

// The layers of the raw file, one after the other: four halves a texel, then two.
function layers(bytes) {
  const first = table_size * table_size * 8;
  if (bytes.length !== first + table_size * table_size * 4) throw new Error(`the table has ${bytes.length} bytes`);
  return [bytes.subarray(0, first), bytes.subarray(first)].map((part) => Buffer.from(part).toString('base64'));
}

export function areaLightData(run) {
  const print = (...words) => run(['shader', '--light', lights, '--lang', 'glsl-es300', ...words]).stdout;
  const glsl = joined([print(), print('--method', 'ltc', '--material', 'ggx')]);
  const { files } = run(['bake', '--table', 'ltc-ggx', '-s', `${table_size}`, '--pixel', 'half', '-o', 'ltc.raw']);
  const [leaning, reflected] = layers(files['ltc.raw']);
  return `// Written by build.mjs: what \`gonio shader\` and \`gonio bake --table ltc-ggx\` print.
export const table_size = ${table_size};
export const leaning = '${leaning}';
export const reflected = '${reflected}';
export const glsl = \`${glsl.replaceAll('\\', '\\\\').replaceAll('`', '\\`').replaceAll('$', '\\$')}\`;
`;
}
