// How long the loaders of three.js and Babylon.js take for a file: node read_ies.mjs FILE…
// Both parse the text and lay the light out as a texture; after 200 files to warm up, the least mean of ten rounds.
import fs from 'node:fs';
import { IESLoader } from 'three/addons/loaders/IESLoader.js';
import { LoadIESData } from '@babylonjs/core/Lights/IES/iesLoader.js';

function microseconds(work) {
    for (let i = 0; i < 200; ++i) work();
    let least = Infinity;
    for (let round = 0; round < 10; ++round) {
        const start = performance.now();
        for (let i = 0; i < 20; ++i) work();
        least = Math.min(least, (performance.now() - start) / 20);
    }
    return least * 1e3;
}

for (const file of process.argv.slice(2)) {
    const bytes = fs.readFileSync(file);
    const text = bytes.toString('latin1');
    const rows = {
        'three.js 0.187 IESLoader.parse': () => new IESLoader().parse(text),
        'Babylon.js 9.34 LoadIESData': () => LoadIESData(new Uint8Array(bytes)),
    };
    for (const [name, work] of Object.entries(rows)) {
        try {
            console.log(`| ${file} | ${bytes.length} | ${name} | ${microseconds(work).toFixed(1)} |`);
        } catch (error) {
            console.log(`| ${file} | ${bytes.length} | ${name} | refused: ${error.message} |`);
        }
    }
}
