// node gltf_speed.cjs FOLDER OUT: how fast glTF-Transform writes and reads a GLB of triangles and reads one of splats, and
// splat-transform writes one of splats: in one process, after rounds that warm it up. Prints for each, between tabs: format,
// program, file, seconds to write and to read (medians of seven).
const fs = require("fs");
const path = require("path");
const { performance } = require("perf_hooks");

const ROUNDS = 7;

async function median(work) {
  for (let i = 0; i < 2; i++) await work();
  const times = [];
  for (let i = 0; i < ROUNDS; i++) {
    const start = performance.now();
    await work();
    times.push((performance.now() - start) / 1000);
  }
  return times.sort((a, b) => a - b)[ROUNDS >> 1];
}

async function main() {
  const [folder, out] = process.argv.slice(2);
  // Its CommonJS build does not find its engine's classes.
  const st = await import(require.resolve("@playcanvas/splat-transform").replace("index.cjs", "index.mjs"));
  const files = new st.MemoryReadFileSystem();
  files.set("scene.ply", fs.readFileSync(path.join(folder, "scene.ply")));
  const [table] = await st.readFile({ filename: "scene.ply", inputFormat: "ply", options: {}, params: [], fileSystem: files });
  const target = path.join(out, "a_splats.glb");
  const write = await median(async () => {
    const memory = new st.MemoryFileSystem();
    await st.writeGlb({ filename: "a.glb", dataTable: table }, memory);
    fs.writeFileSync(target, memory.results.get("a.glb"));
  });
  const { NodeIO, VERSION } = require("@gltf-transform/core");
  const io = new NodeIO();
  // Each value once, into arrays of their own.
  const load = async (name) => {
    const document = await io.readBinary(new Uint8Array(fs.readFileSync(path.join(folder, name))));
    for (const accessor of document.getRoot().listAccessors()) accessor.getArray().slice();
    return document;
  };
  const splats = await median(() => load("scene.glb"));
  const programs = `splat-transform ${st.version} writes, glTF-Transform ${VERSION.slice(1)} reads`;
  console.log(["splat GLB", programs, target, write, splats].join("\t"));
  const read = await median(() => load("field.glb"));
  const document = await load("field.glb");
  const made = path.join(out, "a.glb");
  const written = await median(async () => fs.writeFileSync(made, await io.writeBinary(document)));
  console.log(["GLB", `glTF-Transform ${VERSION.slice(1)}`, made, written, read].join("\t"));
  // Compressed: with meshoptimizer's own codecs, in WebAssembly, at glTF-Transform's own settings.
  const { EXTMeshoptCompression, KHRMeshQuantization } = require("@gltf-transform/extensions");
  const { Logger } = require("@gltf-transform/core");
  const { cloneDocument, meshopt } = require("@gltf-transform/functions");
  const { MeshoptDecoder, MeshoptEncoder } = require("meshoptimizer");
  await MeshoptDecoder.ready;
  await MeshoptEncoder.ready;
  io.registerExtensions([EXTMeshoptCompression, KHRMeshQuantization]);
  io.registerDependencies({ "meshopt.decoder": MeshoptDecoder, "meshopt.encoder": MeshoptEncoder });
  const unpacked = await median(() => load("packed.glb"));
  const small = path.join(out, "packed.glb");
  const packed = await median(async () => {
    const copy = cloneDocument(document).setLogger(new Logger(Logger.Verbosity.ERROR));
    await copy.transform(meshopt({ encoder: MeshoptEncoder, level: "medium" }));
    fs.writeFileSync(small, await io.writeBinary(copy));
  });
  console.log(["GLB, meshopt", `glTF-Transform ${VERSION.slice(1)}`, small, packed, unpacked].join("\t"));
}

main().catch((why) => {
  console.error(why);
  process.exit(1);
});
