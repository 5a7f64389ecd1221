// node gltf_unfold.cjs IN.glb OUT.glb: glTF-Transform (npm @gltf-transform/core, @gltf-transform/extensions) reads a GLB whose
// triangles are compressed by EXT_meshopt_compression, with meshoptimizer's own decoder (npm meshoptimizer), and writes it
// without compression. NODE_PATH says where they are.
const { NodeIO } = require("@gltf-transform/core");
const { EXTMeshoptCompression, KHRMeshQuantization } = require("@gltf-transform/extensions");
const { MeshoptDecoder } = require("meshoptimizer");

async function main() {
  const [from, to] = process.argv.slice(2);
  await MeshoptDecoder.ready;
  const io = new NodeIO()
    .registerExtensions([EXTMeshoptCompression, KHRMeshQuantization])
    .registerDependencies({ "meshopt.decoder": MeshoptDecoder });
  const document = await io.read(from);
  const root = document.getRoot();
  const extensions = root.listExtensionsUsed();
  console.log(`read ${extensions.map((e) => e.extensionName).sort().join(" ")}`);
  for (const extension of extensions) {
    if (extension.extensionName === "EXT_meshopt_compression") extension.dispose();
  }
  for (const mesh of root.listMeshes()) {
    for (const p of mesh.listPrimitives()) console.log(`triangles ${p.getIndices().getCount() / 3} vertices ${p.getAttribute("POSITION").getCount()}`);
  }
  await io.write(to, document);
}

main().catch((why) => {
  console.error(why);
  process.exit(1);
});
