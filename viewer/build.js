// Bundles src/webgl.js with all that it needs into dist/webgl.js, and the licences of what is in it into dist/NOTICE.txt.
import { readdir, readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const { metafile } = await build({
  entryPoints: ["src/webgl.js"],
  outfile: "dist/webgl.js",
  bundle: true,
  format: "esm",
  target: "es2022",
  minify: true,
  // They stand in NOTICE.txt, whole.
  legalComments: "none",
  banner: { js: "// Licences of what is in this file: NOTICE.txt beside it." },
  metafile: true,
  logLevel: "warning",
});

/** The packages that files of these names are of, and those that they say they need: a package may hold another's code. */
async function packagesOf(files) {
  const found = new Map();
  const add = async (name) => {
    if (found.has(name)) return;
    const about = JSON.parse(await readFile(`node_modules/${name}/package.json`, "utf8"));
    found.set(name, about);
    for (const other of Object.keys(about.dependencies ?? {})) await add(other);
  };
  for (const file of files) {
    const inside = file.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//);
    if (inside) await add(inside[1]);
  }
  return [...found.values()].sort((a, b) => a.name.localeCompare(b.name));
}

async function licenceOf(name) {
  const files = await readdir(`node_modules/${name}`);
  const file = files.find((f) => /^licen[cs]e(\.(md|txt))?$/i.test(f));
  if (!file) throw new Error(`${name}: expected a file with its licence, found none`);
  return (await readFile(`node_modules/${name}/${file}`, "utf8")).trim();
}

/** Rust packages whose names the WebAssembly in these texts still holds, with their versions. */
async function cratesIn(files) {
  const found = new Set();
  for (const file of files) {
    for (const [, base64] of (await readFile(file, "utf8")).matchAll(/"(AGFzbQ[A-Za-z0-9+/=]{1000,})"/g)) {
      const module = Buffer.from(base64, "base64").toString("latin1");
      for (const [, name, version] of module.matchAll(/[/\\]([a-z][a-z0-9_-]*)-(\d+\.\d+\.\d+)[/\\]src[/\\]/g)) found.add(`${name} ${version}`);
    }
  }
  return [...found].sort();
}

const inputs = Object.keys(metafile.inputs);
const packages = await packagesOf(inputs);
const licences = JSON.parse(await readFile("crates.json", "utf8"));
const crates = (await cratesIn(inputs)).map((crate) => {
  const licence = licences[crate.split(" ")[0]];
  if (!licence) throw new Error(`${crate}: expected its licence in crates.json, found none: look it up and add it`);
  return `  ${crate} (${licence})`;
});
const parts = await Promise.all(packages.map(async (p) => `${p.name} ${p.version} (${p.license})\n\n${await licenceOf(p.name)}`));
const rule = `\n\n${"-".repeat(80)}\n\n`;
const notice = [
  "webgl.js holds Orb's own code (MIT) and these packages:",
  ...parts,
  `The WebAssembly that @sparkjsdev/spark brings was built by its authors from Rust packages. These name themselves in it; their
licences are as they state them, and the package brings no notices of theirs:

${crates.join("\n")}`,
].join(rule);
await writeFile("dist/NOTICE.txt", `${notice}\n`);
const [bytes] = Object.values(metafile.outputs).map((o) => o.bytes);
console.log(`dist/webgl.js: ${bytes} bytes; ${packages.map((p) => `${p.name} ${p.version}`).join(", ")}`);
