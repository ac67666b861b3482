// Every function that `gonio shader` prints, run in headless Chromium at 10,000 random poses: GLSL ES by WebGL 2 into a
// float target, WGSL by WebGPU in a compute shader. Each result is compared with the core in double, within the error
// that the comment of the function states. Those that are written by hand too (by_hand/) are timed beside them, and
// highlights by rows of points beside those by a share. Run by run.sh.
//   node browser.mjs WORK_FOLDER
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const work = resolve(process.argv[2]);
const need = createRequire(join(work, 'package.json'));
const { default: puppeteer } = await import(pathToFileURL(need.resolve('puppeteer-core')));
const made = join(work, 'made');
const side = 100; // poses are 100 by 100

const browser = await puppeteer.launch({ executablePath: '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', '--enable-features=Vulkan,WebGPU'] });
const tab = await browser.newPage();
writeFileSync(join(work, 'empty.html'), '<!DOCTYPE html><title>shader</title>\n'); // WebGPU wants a file's origin
await tab.goto(pathToFileURL(join(work, 'empty.html')).href);

// Runs in the page: the four numbers of each pose.
async function byWebGl({ source, call, vector, perCase, inputs, side, repeat = 1 }) {
  window.gl ??= document.createElement('canvas').getContext('webgl2');
  const gl = window.gl;
  if (!gl?.getExtension('EXT_color_buffer_float')) throw new Error('no WebGL 2 with float targets');
  const wide = Math.ceil(perCase / 4);
  const fragment = `#version 300 es\n${source}
uniform highp sampler2D inputs;
out vec4 result;
void main() {
    float n[${4 * wide}];
    ivec2 at = ivec2(gl_FragCoord.xy) % ${side};
    for (int i = 0; i < ${wide}; ++i) {
        vec4 four = texelFetch(inputs, ivec2(at.x * ${wide} + i, at.y), 0);
        for (int k = 0; k < 4; ++k) n[4 * i + k] = four[k];
    }
    result = ${vector ? `vec4(${call}, 1.0)` : `vec4(${call})`};
}`;
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, '#version 300 es\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }'], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const padded = new Float32Array(side * side * wide * 4);
  for (let pose = 0; pose < side * side; ++pose)
    for (let k = 0; k < perCase; ++k) padded[pose * wide * 4 + k] = inputs[pose * perCase + k];
  const texture = (width, height, data) => {
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, data);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return made;
  };
  const wideTarget = side * repeat;
  const target = texture(wideTarget, wideTarget, null);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  const given = texture(side * wide, side, padded);
  gl.viewport(0, 0, wideTarget, wideTarget);
  gl.useProgram(program);
  const out = new Float32Array(side * side * 4);
  let best = Infinity; // nanoseconds for each pose
  for (let run = 0; run < (repeat > 1 ? 6 : 1); ++run) {
    const start = performance.now();
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, side, side, gl.RGBA, gl.FLOAT, out);
    best = Math.min(best, (1e6 * (performance.now() - start)) / wideTarget ** 2);
  }
  for (const each of [target, given]) gl.deleteTexture(each);
  gl.deleteFramebuffer(frame);
  gl.deleteProgram(program);
  if (gl.getError() !== gl.NO_ERROR) throw new Error('WebGL reports an error');
  return repeat > 1 ? best : [...out];
}

async function byWebGpu({ source, call, vector, perCase, inputs, side }) {
  if (!window.gpu) {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) throw new Error('no WebGPU');
    window.gpu = await adapter.requestDevice();
  }
  const device = window.gpu;
  const count = side * side;
  const module = device.createShaderModule({ code: `${source}
@group(0) @binding(0) var<storage, read> all: array<f32>;
@group(0) @binding(1) var<storage, read_write> results: array<vec4<f32>>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= ${count}u) { return; }
    var n: array<f32, ${perCase}>;
    for (var i = 0u; i < ${perCase}u; i++) { n[i] = all[id.x * ${perCase}u + i]; }
    results[id.x] = ${vector ? `vec4<f32>(${call}, 1.0)` : `vec4<f32>(${call})`};
}` });
  const { messages } = await module.getCompilationInfo();
  if (messages.length > 0) throw new Error(messages.map((each) => `${each.lineNum}: ${each.message}`).join('\n'));
  const numbers = new Float32Array(inputs);
  const given = device.createBuffer({ size: numbers.byteLength, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST });
  device.queue.writeBuffer(given, 0, numbers);
  const results = device.createBuffer({ size: 16 * count, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC });
  const copy = device.createBuffer({ size: 16 * count, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
  const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module, entryPoint: 'main' } });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries: [given, results].map((buffer, binding) => ({ binding, resource: { buffer } })) }));
  pass.dispatchWorkgroups(Math.ceil(count / 64));
  pass.end();
  encoder.copyBufferToBuffer(results, 0, copy, 0, 16 * count);
  device.queue.submit([encoder.finish()]);
  await copy.mapAsync(GPUMapMode.READ);
  const out = [...new Float32Array(copy.getMappedRange())];
  for (const buffer of [given, results, copy]) buffer.destroy();
  return out;
}

// The largest share of the stated error, apart and near.
function worst(pose, out) {
  const found = [0, 0];
  pose.scale.forEach((scale, i) => {
    for (let k = 0; k < (pose.vector ? 3 : 1); ++k) {
      const error = Math.abs(out[4 * i + k] - pose.expected[3 * i + k]) / (Math.abs(pose.expected[3 * i + k]) + scale);
      found[pose.is_near[i]] = Number.isNaN(error) ? Infinity : Math.max(found[pose.is_near[i]], error);
    }
  });
  return found;
}

const instructions = new Map(readFileSync(join(made, 'instructions.txt'), 'utf8').trim().split('\n').map((line) => [line.split(' ')[0], line.split(' ').slice(1)]));
const shown = (x) => x.toExponential(1);
const failures = [];
const byHand = [];
const highlights = [];
console.log('| function | instructions: early returns | selects | error in WebGL 2 | near | in WebGPU | near |\n|---|---:|---:|---:|---:|---:|---:|');
for (const file of readdirSync(join(made, 'cases')).sort()) {
  const pose = JSON.parse(readFileSync(join(made, 'cases', file), 'utf8'));
  const name = pose.function;
  const stated = [pose.apart, pose.near];
  const given = { call: `${name}(${pose.arguments})`, vector: pose.vector, perCase: pose.per_case, inputs: pose.inputs, side };
  const row = [];
  for (const branches of ['real', 'select']) {
    const found = [worst(pose, await tab.evaluate(byWebGl, { ...given, source: pose[branches] }))];
    found.push(worst(pose, await tab.evaluate(byWebGpu, { ...given, source: pose[`${branches}_wgsl`], call: given.call.replaceAll('vec3(', 'vec3<f32>(') })));
    found.forEach((errors, i) => errors.forEach((error, near) => {
      if (!(error <= stated[near])) failures.push(`${name}, ${branches}, ${['WebGL 2', 'WebGPU'][i]}: ${shown(error)}, not ${shown(stated[near])}`);
    }));
    row.push(found);
  }
  const [real] = row;
  if (pose.hand) byHand.push({ name, given, pose, mine: real[0] });
  if (/_ltc(_share)?$/.test(name)) highlights.push({ name, given, pose });
  const cell = (errors, near) => (pose.is_near.includes(1) || !near ? shown(errors[near]) : '');
  console.log(`| ${name} | ${instructions.get(name).slice(0, 2).join(' | ')} | ${cell(real[0], 0)} | ${cell(real[0], 1)} | ${cell(real[1], 0)} | ${cell(real[1], 1)} |`);
}
console.log('\n| function | instructions: printed | by hand | ns: printed | by hand | inputs alone | error: printed | near | by hand | near |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|');
for (const { name, given, pose, mine } of byHand) {
  const time = (source, call) => tab.evaluate(byWebGl, { ...given, call, source, repeat: 10 });
  const ns = [Infinity, Infinity, Infinity]; // the last one reads the inputs alone
  for (let round = 0; round < 4; ++round) {
    const took = [await time(pose.real, given.call), await time(pose.hand, given.call), await time('precision highp float;', pose.vector ? 'vec3(n[0])' : 'n[0]')];
    took.forEach((each, i) => { ns[i] = Math.min(ns[i], each); });
  }
  const theirs = worst(pose, await tab.evaluate(byWebGl, { ...given, source: pose.hand }));
  const cells = [mine[0], mine[1], theirs[0], theirs[1]].map((error, i) => (i % 2 === 0 || pose.is_near.includes(1) ? shown(error) : ''));
  console.log(`| ${name} | ${instructions.get(name)[0]} | ${instructions.get(name)[2]} | ${ns.map((x) => x.toFixed(1)).join(' | ')} | ${cells.join(' | ')} |`);
}
console.log('\n| function | instructions | operations of a call | ns | inputs alone |\n|---|---:|---:|---:|---:|');
for (const { name, given, pose } of highlights) {
  const time = (source, call) => tab.evaluate(byWebGl, { ...given, call, source, repeat: 4 });
  const ns = [Infinity, Infinity];
  for (let round = 0; round < 3; ++round) {
    const took = [await time(pose.real, given.call), await time('precision highp float;', 'vec3(n[0])')];
    took.forEach((each, i) => { ns[i] = Math.min(ns[i], each); });
  }
  console.log(`| ${name} | ${instructions.get(name)[0]} | ${pose.operations} | ${ns.map((x) => x.toFixed(0)).join(' | ')} |`);
}
await browser.close();
assert.deepEqual(failures, []);
