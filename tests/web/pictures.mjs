// pictures.mjs [WIDTHxHEIGHT] [SCENE,...] [TECHNIQUE,...]: FLIP between pictures of the page and of the native program, as a table.
// Exits with 1 if one is above its limit.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { ask, open, openPage, project } from './browser.mjs';

const native = process.env.MOMENTSCOPE ?? path.join(project, 'build/release/momentscope');
const run = (...options) => execFileSync(native, options, { encoding: 'utf8', maxBuffer: 1 << 28 });
const MOST_FLIP = 0.02, MOST_FLIP_HASHED = 0.06;   // docs/tolerances.md

export const mostFlip = technique => technique === 'hashed' ? MOST_FLIP_HASHED : MOST_FLIP;

/** FLIP of one picture. `tab` shows the page. */
export async function flipOf(tab, scene, technique, [width, height]) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'momentscope-pictures-'));
    try {
        const trouble = await ask(tab, 'render', scene, technique, width, height, '/picture.exr');
        if (trouble) throw new Error(`${scene} by ${technique}: ${trouble}`);
        const text = await tab.evaluate(() => {
            const bytes = globalThis.momentscope.program.FS.readFile('/picture.exr');
            let letters = '';
            for (let i = 0; i < bytes.length; i += 4096) letters += String.fromCharCode(...bytes.subarray(i, i + 4096));
            return btoa(letters);
        });
        const mine = path.join(folder, 'page.exr'), theirs = path.join(folder, 'native.exr');
        fs.writeFileSync(mine, Buffer.from(text, 'base64'));
        run('render', '--scene', scene, '--technique', technique, '--size', `${width}x${height}`, '-o', theirs);
        return Number(run('compare', '--metric', 'flip', theirs, mine).match(/\)\s+([-+.e\d]+)/i)[1]);
    } finally {
        fs.rmSync(folder, { recursive: true });
    }
}

async function main([size = '480x270', scenes = '', techniques = '']) {
    const session = await open();
    const tab = await openPage(session, '#scene=planes', { width: 320, height: 240 });
    const rows = (kind, chosen) => chosen && chosen !== 'all' ? chosen.split(',') : JSON.parse(run('list', kind, '--format', 'json')).map(row => row.id);
    const broken = [];
    for (const technique of rows('techniques', techniques)) {
        const why = await ask(tab, 'why_not', technique);
        if (why) {
            console.log(`| ${technique} | ${why} |`);
            continue;
        }
        const cells = [];
        for (const scene of rows('scenes', scenes)) {
            const flip = await flipOf(tab, scene, technique, size.split('x').map(Number));
            if (flip > mostFlip(technique)) broken.push(`${scene} by ${technique}`);
            cells.push(`${scene} ${flip.toFixed(4)}`);
        }
        console.log(`| ${technique} | ${cells.join(' | ')} |`);
    }
    await session.close();
    if (broken.length > 0) console.log(`too different: ${broken.join(', ')}`);
    process.exitCode = broken.length > 0 ? 1 : 0;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main(process.argv.slice(2));
