// The worker: holds one instance of the module and answers one message after another. The page ends it when it takes too
// long, so nothing here needs to be interrupted.
let gonio;
let module;
let scene;
let sceneFiles; // which files the scene was made with
let sceneRig;

function closeScene() {
  scene?.delete();
  scene = undefined;
}

// A file that is wrong belongs to the answer; a trap or a lack of memory leaves the instance in an unknown state.
const isFatal = (error) => error instanceof WebAssembly.RuntimeError || error instanceof RangeError
  || !(error instanceof Error);

// Without `fetch` the module does not ask for what the policy of the page forbids.
async function open() {
  self.fetch = undefined;
  gonio = await self.createGonio({ module });
}

const tasks = {
  // The module as the page holds it, or as another worker compiled it.
  async start({ packed, wasm }) {
    module = wasm ?? await compileText(packed);
    await open();
    return { wasm: module };
  },

  async run({ words, files }) {
    const result = gonio.run(words, files);
    if (result.diagnostics.some(({ code }) => code === 'UNS0103')) { // out of memory: what was in use then stays so
      scene = undefined;
      await open();
    }
    return result;
  },

  // Candela over C (rows) and gamma (columns), for the solid.
  sample({ name, bytes, planes, gammas }) {
    const profile = gonio.read(bytes, name);
    try {
      const candela = new Float32Array(planes.length * gammas.length);
      planes.forEach((c, row) => candela.set(profile.sample(c, gammas), row * gammas.length));
      return { candela };
    } finally {
      profile.delete();
    }
  },

  // `files` comes only when this worker does not have the files named by `key` yet.
  render({ rig, key, files, options }) {
    if (!scene || sceneFiles !== key) {
      if (!files) throw Object.assign(new Error('the files of the scene are missing'), { code: 'PAGE' });
      closeScene();
      scene = new gonio.Scene(rig, files);
      sceneFiles = key;
      sceneRig = rig;
    } else if (sceneRig !== rig) {
      scene.set(rig);
      sceneRig = rig;
    }
    const begin = performance.now();
    const picture = scene.render(options);
    return { ...picture, ms: performance.now() - begin };
  },

  at({ x, y }) {
    return scene ? scene.at(x, y) : null;
  },
};

self.onmessage = async ({ data: { id, task, argument } }) => {
  try {
    const result = await tasks[task](argument);
    const transfer = result?.rgba ? [result.rgba.buffer] : [];
    self.postMessage({ id, result }, transfer);
  } catch (error) {
    const fatal = isFatal(error);
    if (fatal) scene = undefined;
    self.postMessage({
      id,
      error: {
        message: String(error?.message ?? error), code: error?.code ?? '', hint: error?.hint ?? '',
        diagnostics: error?.diagnostics ?? [], fatal,
      },
    });
  }
};
