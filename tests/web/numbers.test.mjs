// numbers.test.mjs -- numbers and pictures of the page against the native program, whose path is in MOMENTSCOPE.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { ask, open, openPage, project } from './browser.mjs';
import { flipOf, mostFlip } from './pictures.mjs';

const native = process.env.MOMENTSCOPE ?? path.join(project, 'build/release/momentscope');
const run = (...options) => execFileSync(native, options, { encoding: 'utf8', maxBuffer: 1 << 28 });
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'momentscope-page-'));

let session;
before(async () => { session = await open(); });
after(async () => {
    await session.close();
    fs.rmSync(folder, { recursive: true });
});

describe('numbers', () => {
    let tab;
    before(async () => { tab = await openPage(session, '#scene=planes', { width: 320, height: 240 }); });
    after(() => tab.close());

    // Random rays as the native program makes them would hide a common fault of both, so these come from here.
    function randomRay(seed) {
        let word = seed;
        const random = () => { word = (Math.imul(word, 1664525) + 1013904223) >>> 0; return word / 2 ** 32; };
        const count = 1 + Math.floor(12 * random());
        const fragments = Array.from({ length: count }, () => ({
            depth: Math.fround(2 * random() - 1), opacity: Math.fround(0.05 + 0.9 * random()), color: [random(), random(), random()],
        }));
        return { fragments, warp: { kind: 'none' } };
    }

    const rays = process.env.MOMENTSCOPE_THOROUGH === '1' ? 40 : 4;
    test(`curves of ${rays} rays have the bits of the native program`, async () => {
        const techniques = JSON.parse(run('list', 'techniques', '--format', 'json'));
        let compared = 0;
        for (let i = 1; i <= rays; ++i) {
            const file = path.join(folder, 'ray.json');
            const text = JSON.stringify(randomRay(i));
            fs.writeFileSync(file, text);
            const ids = techniques.map(row => row.id);
            const expected = JSON.parse(run('inspect', '--ray', file, '--technique', ids.join(','), '--samples', '257', '--format', 'json'));
            for (const [k, id] of ids.entries()) {
                const [curve] = JSON.parse(await ask(tab, 'inspect', text, id, 257)).curves;
                assert.deepEqual(curve, expected.curves[k], `${id} on ray ${i}`);
                ++compared;
            }
        }
        assert.ok(compared >= 20 * rays);
    });

    for (const [scene, technique] of [['planes', 'power4-32'], ['teapots', 'sharp4'], ['foliage', 'sorted'], ['cloud', 'trig2-32'], ['planes', 'hashed']])
        test(`${scene} by ${technique} looks as it does natively`, async () => {
            const flip = await flipOf(tab, scene, technique, [160, 90]);
            assert.ok(flip <= mostFlip(technique), `FLIP ${flip}`);
        });
});
