// Khronos' validator on .gltf and .glb files: node gltf_check.mjs FILE…. Exits with 1 where it finds an error or a
// warning.
import fs from 'node:fs';
import path from 'node:path';
import { validateBytes } from 'gltf-validator';

let bad = 0;
for (const file of process.argv.slice(2)) {
    const beside = (uri) => Promise.resolve(new Uint8Array(fs.readFileSync(path.join(path.dirname(file), uri))));
    const report = await validateBytes(new Uint8Array(fs.readFileSync(file)),
        { uri: file, externalResourceFunction: beside });
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(`${path.basename(file)}: ${numErrors} errors, ${numWarnings} warnings`);
    for (const message of messages.filter((one) => one.severity < 2)) console.log(`  ${message.code} ${message.message}`);
    bad += numErrors + numWarnings;
}
process.exit(bad === 0 ? 0 : 1);
