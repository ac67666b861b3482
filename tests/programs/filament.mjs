// Filament: its WebAssembly, with one of the materials of its glTF loader.
export const version = (await (await fetch('/node_modules/filament/package.json')).json()).version;
const size = 32;
const textures = []; // of the size of the picture

// The only way to read numbers: the float texture that Filament makes, by its WebGL context.
function watchTextures() {
  const store = WebGL2RenderingContext.prototype.texStorage2D;
  WebGL2RenderingContext.prototype.texStorage2D = function (target, levels, format, width, height) {
    if (format === this.RGBA32F && width === size)
      textures.push({ gl: this, texture: this.getParameter(this.TEXTURE_BINDING_2D) });
    return store.call(this, target, levels, format, width, height);
  };
}

// A square of two units as glTF; `grey` is its base colour.
function floorGltf(grey) {
  const floats = Float32Array.from([-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, ...[0, 1, 0], ...[0, 1, 0], ...[0, 1, 0], ...[0, 1, 0]]);
  const bytes = new Uint8Array(96 + 12);
  bytes.set(new Uint8Array(floats.buffer));
  bytes.set(new Uint8Array(Uint16Array.from([0, 2, 1, 0, 3, 2]).buffer), 96);
  return JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [grey, grey, grey, 1], metallicFactor: 0, roughnessFactor: 1 } }],
    buffers: [{ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}` }],
    bufferViews: [{ buffer: 0, byteLength: 48 }, { buffer: 0, byteOffset: 48, byteLength: 48 }, { buffer: 0, byteOffset: 96, byteLength: 12 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [-1, 0, -1], max: [1, 0, 1] },
      { bufferView: 1, componentType: 5126, count: 4, type: 'VEC3' }, { bufferView: 2, componentType: 5123, count: 6, type: 'SCALAR' }],
  });
}

export async function render(name) {
  const { makeLights } = await import(`/assets/filament/${name}.js`);
  watchTextures();
  await new Promise((done) => Filament.init([], done));
  const engine = Filament.Engine.create(document.getElementById('canvas'));
  const scene = engine.createScene();
  makeLights(Filament, engine, scene);
  const camera = engine.createCamera(Filament.EntityManager.get().create());
  const height = 20;
  camera.setProjectionFov(360 / Math.PI * Math.atan(1 / height), 1, 1, 2 * height, Filament.Camera$Fov.VERTICAL);
  camera.lookAt([0, height, 0], [0, 0, 0], [0, 0, -1]);
  camera.setExposureDirect(1);
  const view = engine.createView();
  view.setCamera(camera);
  view.setScene(scene);
  view.setViewport([0, 0, size, size]);
  view.setPostProcessingEnabled(false);
  const usage = Filament.Texture$Usage ?? { COLOR_ATTACHMENT: 1, SAMPLEABLE: 16, DEPTH_ATTACHMENT: 2 };
  const bits = (one) => one.value ?? one;
  const color = Filament.Texture.Builder().width(size).height(size).levels(1).sampler(Filament.Texture$Sampler.SAMPLER_2D)
    .format(Filament.Texture$InternalFormat.RGBA32F).usage(bits(usage.COLOR_ATTACHMENT) | bits(usage.SAMPLEABLE)).build(engine);
  const depth = Filament.Texture.Builder().width(size).height(size).levels(1).sampler(Filament.Texture$Sampler.SAMPLER_2D)
    .format(Filament.Texture$InternalFormat.DEPTH32F).usage(bits(usage.DEPTH_ATTACHMENT)).build(engine);
  view.setRenderTarget(Filament.RenderTarget.Builder().texture(Filament.RenderTarget$AttachmentPoint.COLOR, color)
    .texture(Filament.RenderTarget$AttachmentPoint.DEPTH, depth).build(engine));
  const swapChain = engine.createSwapChain();
  const renderer = engine.createRenderer();
  const loader = engine.createAssetLoader();

  // The floor reflects a little at its surface too: what a black one reflects is taken off.
  const pictures = [];
  for (const grey of [0.5, 0]) {
    const asset = loader.createAsset(new TextEncoder().encode(floorGltf(grey)));
    await new Promise((done) => asset.loadResources(done, null, '', null));
    scene.addEntities(asset.getRenderableEntities());
    for (let frame = 0; frame < 4; frame++) {
      renderer.render(swapChain, view);
      engine.execute();
      await new Promise((done) => requestAnimationFrame(done));
    }
    const { gl, texture } = textures[0];
    const before = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const pixels = new Float32Array(4 * size * size);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.FLOAT, pixels);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before);
    pictures.push(pixels);
    for (const entity of asset.getRenderableEntities()) scene.remove(entity);
  }
  return pictures[0].map((value, i) => value - pictures[1][i]).filter((_, i) => i % 4 < 3);
}
