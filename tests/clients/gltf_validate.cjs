// node gltf_validate.cjs FILE...: the Khronos glTF validator (npm gltf-validator, found through NODE_PATH).
// Prints what it counted and found in each file; exit code 1 when it found an error or could not read one.
// It says of KHR_xmp_json_ld, KHR_gaussian_splatting and EXT_meshopt_compression that it does not know them: that is no finding about the file.
const fs = require('fs');
const validator = require('gltf-validator');
const UNKNOWN = ['KHR_xmp_json_ld', 'KHR_gaussian_splatting', 'EXT_meshopt_compression'];
(async () => {
    for (const file of process.argv.slice(2)) {
        try {
            const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 0 });
            const messages = report.issues.messages.filter(
                (m) => !(m.code === 'UNSUPPORTED_EXTENSION' && UNKNOWN.some((name) => m.message.includes(name))));
            const count = (severity) => messages.filter((m) => m.severity === severity).length;
            console.log(`${file}: errors ${count(0)} warnings ${count(1)} infos ${count(2)} hints ${count(3)}; ` +
                `triangles ${report.info.totalTriangleCount} vertices ${report.info.totalVertexCount}; ` +
                `not known to it: ${(report.info.extensionsUsed || []).filter((e) => UNKNOWN.includes(e)).join(', ')}`);
            for (const m of messages) console.log(`  ${m.severity} ${m.code} ${m.pointer || m.offset}: ${m.message}`);
            if (count(0) > 0) process.exitCode = 1;
        } catch (e) {
            console.log(`${file}: not readable: ${e}`);
            process.exitCode = 1;
        }
    }
})();
