// The module gonio.mjs: the tool in a folder of memory that lasts for one call, scenes, which keep one, and what gonio-core
// has. join.mjs puts this after the module that Emscripten writes, whose createTool() it calls with the options. README.md shows its use.
export default async function createGonio(options) {
  const tool = await createTool(options);
  const { FS } = tool;
  const gonio = { read: tool.read, check: tool.check, memoryBytes: () => tool.HEAPU8.length };

  let folders = 0;

  // A folder of its own with these files; names may have folders, and may not leave it.
  function makeFolder(files) {
    const folder = `/folder-${++folders}`;
    FS.mkdir(folder);
    putFiles(folder, files);
    return folder;
  }

  function putFiles(folder, files) {
    for (const [name, bytes] of Object.entries(files)) {
      if (name === '-') continue; // standard input
      const parts = name.replace(/\/$/, '').split('/');
      if (parts.some((part) => part === '' || part === '.' || part === '..'))
        throw new Error(`'${name}' is not the name of a file in the folder`);
      parts.slice(0, -1).reduce((path, part) => {
        const next = `${path}/${part}`;
        if (!FS.analyzePath(next).exists) FS.mkdir(next);
        return next;
      }, folder);
      if (name.endsWith('/')) FS.mkdir(`${folder}/${name}`);
      else FS.writeFile(`${folder}/${name}`, bytes);
    }
  }

  // [name, path] of every file below a folder, in the order of names.
  function listFiles(folder, prefix = '') {
    return FS.readdir(folder).filter((name) => name !== '.' && name !== '..').sort().flatMap((name) => {
      const path = `${folder}/${name}`;
      return FS.isDir(FS.stat(path).mode) ? listFiles(path, `${prefix}${name}/`) : [[prefix + name, path]];
    });
  }

  function removeFolder(folder) {
    for (const name of FS.readdir(folder)) {
      if (name === '.' || name === '..') continue;
      const path = `${folder}/${name}`;
      if (FS.isDir(FS.lstat(path).mode)) removeFolder(path);
      else FS.unlink(path);
    }
    FS.rmdir(folder);
  }

  function inFolder(folder, work) {
    FS.chdir(folder);
    try {
      return work();
    } finally {
      FS.chdir('/');
    }
  }

  // The words of a command line, and files by name; '-' is standard input, and a name that ends in '/' a
  // folder. {status, diagnostics, stdout, stderr, files}: the files that
  // the command wrote.
  gonio.run = (words, files = {}) => {
    const folder = makeFolder(files);
    try {
      // gonio replaces files and never writes into one, so a file that is still the same node was only read.
      const given = new Map(listFiles(folder).map(([name, path]) => [name, FS.lookupPath(path).node]));
      FS.writeFile('/stdin', files['-'] ?? '');
      const { status, diagnostics } = inFolder(folder, () => tool.runWords(words));
      const written = {};
      for (const [name, path] of listFiles(folder))
        if (given.get(name) !== FS.lookupPath(path).node) written[name] = FS.readFile(path);
      return {
        status, diagnostics, stdout: FS.readFile('/stdout'), stderr: FS.readFile('/stderr', { encoding: 'utf8' }),
        files: written,
      };
    } finally {
      removeFolder(folder);
    }
  };

  const rigName = 'rig.json';

  // A rig but for its lights, as text: what stays where only they change. A rig with comments is compared as a whole.
  function surroundingsOf(rig) {
    try {
      const { lights, luminaires, ...others } = JSON.parse(rig);
      return JSON.stringify(others);
    } catch {
      return rig;
    }
  }

  // A rig and its files, for pictures one after another. What a change leaves as it was is not computed again.
  gonio.Scene = class {
    constructor(rig, files = {}) {
      this.folder = makeFolder({ ...files, [rigName]: rig });
      this.rig = rig;
      this.surroundings = surroundingsOf(rig);
      this.preview = new tool.LivePreview();
    }

    // Another rig with the same files, and perhaps more.
    set(rig, files = {}) {
      if (rig === this.rig && Object.keys(files).length === 0) return;
      this.rig = rig;
      this.surroundings = surroundingsOf(rig);
      this.lightWords = undefined;
      if (Object.keys(files).length) this.preview.forget();
      putFiles(this.folder, { ...files, [rigName]: rig });
    }

    render({ width, height, camera, shadows, bounces, mode, unit, exposure, view, words = [] } = {}) {
      const list = ['--rig', rigName, '-o', 'picture.png', '-s', `${width}x${height}`];
      if (camera) {
        list.push(`--camera=${camera.position.join(',')}`, `--target=${camera.target.join(',')}`);
        if (camera.fov_deg) list.push('--fov', `${camera.fov_deg}deg`);
      }
      if (shadows) list.push('--shadows', shadows);
      if (bounces !== undefined) list.push('--indirect', bounces < 0 ? 'all' : bounces === 0 ? 'off' : `${bounces}`);
      list.push(...words);
      const scene = [this.surroundings, ...list].join('\n');
      const shown = mode && mode !== 'beauty';
      if (shown) list.push('--look', mode, '--no-legend');
      if (shown && unit) list.push('--unit', unit);
      if (mode !== 'falsecolour' && exposure !== undefined && exposure !== 'auto') list.push('--exposure', `${exposure}ev`);
      if (view) list.push('--view', view);
      const lightWords = words.join('\n');
      const [hasSameLights, hasSameScene] = [lightWords === this.lightWords, scene === this.scene];
      this.lightWords = this.scene = undefined; // until there is a picture
      const picture = inFolder(this.folder, () => this.preview.render(list, hasSameLights, hasSameScene));
      this.lightWords = lightWords;
      this.scene = scene;
      return picture;
    }

    at(column, row) {
      return this.preview.at(column, row);
    }

    delete() {
      this.preview.delete();
      removeFolder(this.folder);
    }
  };

  return gonio;
}
