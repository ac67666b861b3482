// gonio in JavaScript: the tool's commands as functions. README.md shows their use, index.d.ts says what they take.
import createTool from './gonio.mjs';

/** A failure in the words of the tool: `code`, `hint`, `status`, and all `diagnostics`. */
export class GonioError extends Error {
  constructor(status, diagnostics, stderr) {
    const last = diagnostics.filter(({ severity }) => severity === 'error').at(-1);
    super(last ? last.message : stderr.trim() || `exit status ${status}`);
    this.name = 'GonioError';
    this.status = status;
    this.code = last?.code ?? '';
    this.hint = last?.hint ?? '';
    this.diagnostics = diagnostics;
  }
}

/** {perKlm: true, size: '64x64', position: ['0,0,1', '1,0,1']} → --per-klm --size 64x64 --position 0,0,1 --position 1,0,1 */
export function wordsOf(options) {
  return Object.entries(options).flatMap(([key, value]) => {
    const name = `--${key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
    if (value === undefined || value === null || value === false) return [];
    if (value === true) return [name];
    return (Array.isArray(value) ? value : [value]).map((one) => `${name}=${one}`);
  });
}

const text = new TextDecoder();
const jsonText = (rig) => (typeof rig === 'string' ? rig : JSON.stringify(rig));

/** Loads the WebAssembly. Each call makes an instance with memory of its own. */
export async function createGonio() {
  const tool = await createTool();

  const run = (words, files) => {
    const result = tool.run(words, files);
    if (result.status !== 0) throw new GonioError(result.status, result.diagnostics, result.stderr);
    return result;
  };
  const report = (words, files) => JSON.parse(text.decode(run([...words, '--json'], files).stdout));

  // A command that writes one profile.
  function written(command, files, { to, ...options }) {
    const extension = to === undefined ? 'ies' : { tm33: 'xml' }[to] ?? to;
    const names = Object.keys(files);
    const output = `output/${names[0].replace(/^.*\//, '').replace(/\.[^.]*$/, '')}.${extension}`;
    const words = [command, ...names, ...wordsOf({ to, ...options }), '-o', output, '--json'];
    const result = run(words, { ...files, 'output/': '' });
    return { name: output.slice('output/'.length), bytes: result.files[output],
             report: JSON.parse(text.decode(result.stdout)), diagnostics: result.diagnostics };
  }

  return {
    run: tool.run,
    read: tool.read,
    check: tool.check,
    Scene: class extends tool.Scene {
      constructor(rig, files) {
        super(jsonText(rig), files);
      }

      set(rig, files) {
        super.set(jsonText(rig), files);
      }
    },

    get memoryBytes() {
      return tool.memoryBytes();
    },

    list: (name) => report(['list', name]).entries,
    explain: (code) => report(['explain', code]).codes[0],

    convert: (bytes, name, options = {}) => written('convert', { [name]: bytes }, options),
    edit: (files, options = {}) => written('edit', files, options),

    units(value, to, options = {}) {
      const { results } = report(['units', value, ...wordsOf({ to: [to].flat().join(','), ...options })]);
      const numbers = results.map((result) => result.value);
      return Array.isArray(to) ? numbers : numbers[0];
    },

    cct: (color, options = {}) => report(['cct', color, ...wordsOf(options)]),

    probe: (rig, files = {}, options = {}) =>
      report(['probe', '--rig', 'rig.json', ...wordsOf(options)], { ...files, 'rig.json': jsonText(rig) }),

    preview(rig, files = {}, options = {}) {
      const scene = new tool.Scene(jsonText(rig), files);
      try {
        return scene.render(options);
      } finally {
        scene.delete();
      }
    },

    importTo(targets, files, options = {}) {
      const { rig, ...others } = options;
      const words = ['import', '--to', [targets].flat().join(','), '-O', 'output', ...wordsOf(others)];
      const all = { ...files, 'output/': '' };
      if (rig !== undefined) all['rig.json'] = jsonText(rig);
      words.push(...(rig === undefined ? Object.keys(files) : ['rig.json']));
      const result = run(words, all);
      const made = Object.entries(result.files).map(([path, bytes]) => [path.replace(/^output\//, ''), bytes]);
      return { files: Object.fromEntries(made), diagnostics: result.diagnostics };
    },
  };
}
