// page.test.mjs -- the browser edition as a user meets it, and its numbers against the native program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { ask, click, idle, open, openPage, placeOf, project, state } from './browser.mjs';

const native = process.env.MOMENTSCOPE ?? path.join(project, 'build/release/momentscope');
const run = (...options) => execFileSync(native, options, { encoding: 'utf8', maxBuffer: 1 << 28 });
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'momentscope-page-'));
const RAY = { fragments: [0.2, 0.4, 0.5, 0.7].map((depth, i) => ({ depth, opacity: 0.3 + 0.1 * i, color: [1, 0.5, 0.2] })), near: 0.1, far: 1 };
const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0.2\nf 1 2 3\n';

let session;
before(async () => { session = await open(); });
after(async () => {
    await session.close();
    fs.rmSync(folder, { recursive: true });
});

/** Drops a file on the page. */
async function drop(tab, name, content) {
    await tab.evaluate(([name, content]) => {
        const data = new DataTransfer();
        data.items.add(new File([content], name));
        window.dispatchEvent(new DragEvent('drop', { dataTransfer: data }));
    }, [name, content]);
    await tab.waitForTimeout(200);
    await idle(tab);
}

describe('the page', () => {
    let tab;
    before(async () => { tab = await openPage(session, '#scene=planes&technique=power4-32', { width: 1000, height: 760 }); });
    after(() => tab.close());

    test('opens without complaints', async () => {
        assert.deepEqual(tab.complaints, []);
        assert.equal(await ask(tab, 'message'), '');
        assert.equal((await state(tab)).scene, 'planes');
        assert.equal(await tab.isVisible('#cover'), false);
    });

    test('picks a pixel', async () => {
        await click(tab, 'scene', 0.3, 0.4);
        assert.ok((await state(tab)).picked);
    });

    test('drags β', async () => {
        const before = JSON.parse(await ask(tab, 'curves'));
        await tab.mouse.move(...(await placeOf(tab, 'parameter.beta', 0.25)));
        await tab.mouse.down();
        await tab.waitForTimeout(100);
        await tab.mouse.move(...(await placeOf(tab, 'parameter.beta', 0.8)), { steps: 4 });
        await tab.mouse.up();
        await tab.waitForTimeout(100);
        await idle(tab);
        assert.ok((await state(tab)).parameters.beta > 0.6);
        assert.notDeepEqual(JSON.parse(await ask(tab, 'curves')), before);
    });

    test('goes back and forward through the steps', async () => {
        const now = await state(tab);
        await tab.goBack();
        await idle(tab);
        assert.equal((await state(tab)).parameters?.beta, undefined);
        await tab.goForward();
        await idle(tab);
        assert.deepEqual(await state(tab), now);
    });

    test('opens a ray that is dropped, and edits it', async () => {
        await drop(tab, 'ray.json', JSON.stringify(RAY));
        assert.equal((await state(tab)).ray.fragments.length, 4);
        await tab.keyboard.press('n');
        await idle(tab);
        await tab.keyboard.press('Delete');
        await idle(tab);
        assert.equal((await state(tab)).ray.fragments.length, 3);
        await tab.keyboard.press('Control+z');
        await idle(tab);
        assert.equal((await state(tab)).ray.fragments.length, 4);
    });

    test('copies a link that opens the same state', async () => {
        const address = tab.url();
        const text = await state(tab);
        const other = await openPage(session, new URL(address).hash);
        assert.deepEqual(await state(other), text);
        assert.equal(await ask(other, 'curves'), await ask(tab, 'curves'));
        await other.close();
    });

    test('shows a mesh that is dropped', async () => {
        await drop(tab, 'triangle.obj', TRIANGLE);
        assert.match((await state(tab)).scene, /triangle\.obj$/);
        assert.deepEqual(tab.complaints, []);
    });

    test('refuses a broken mesh with a sentence and keeps the scene', async () => {
        await drop(tab, 'broken.obj', 'v 0 0\nf 1 2 3\n');
        assert.match(await ask(tab, 'message'), /broken\.obj.*\.$/);
        assert.match((await state(tab)).scene, /triangle\.obj$/);
    });

    test('goes on after the graphics were taken away', async () => {
        const before = await state(tab);
        await tab.evaluate(() => {
            globalThis.thief = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
            globalThis.thief.loseContext();
        });
        await tab.waitForSelector('#cover.failed');
        assert.match(await tab.textContent('#said'), /taken the graphics away/);
        await tab.evaluate(() => globalThis.thief.restoreContext());
        await tab.waitForSelector('#cover', { state: 'hidden' });
        await idle(tab);
        assert.deepEqual(await state(tab), before);
    });
});

describe('wrong links', () => {
    const WRONG = {
        '#s=abc': /damaged/,
        '#s=%%%': /damaged/,
        '#scene=moon': /no|not one of the built-in scenes/,
        '#technique=magic': /magic/,
        '#beta=2': /beta|β/,
        '#gamma=1': /neither scene, technique nor a parameter/,
        '#panel=cellar': /part 'cellar'/,
        '#panel=plot&controls=volume': /no such parameter/,
        '#nonsense': /equals sign/,
    };
    for (const [fragment, sentence] of Object.entries(WRONG))
        test(fragment, async () => {
            const tab = await openPage(session, fragment, { width: 320, height: 240 });
            assert.match(await ask(tab, 'message'), sentence);
            assert.equal(await tab.isVisible('#cover'), false);
            await tab.close();
        });

    test('a link of a newer version', async () => {
        const tab = await openPage(session, '#scene=planes', { width: 320, height: 240 });
        const fragment = await tab.evaluate(async () => {
            const { packed } = await import('./link.js');
            return `#s=${await packed('{"momentscope_session": 99}')}`;
        });
        const other = await openPage(session, fragment, { width: 320, height: 240 });
        assert.match(await ask(other, 'message'), /version 99/);
        await other.close();
        await tab.close();
    });
});

describe('browsers that lack something', () => {
    const LACKS = [
        ['WebGL 2', () => { HTMLCanvasElement.prototype.getContext = () => null; }, /has no WebGL 2/],
        ['SIMD', () => { WebAssembly.validate = () => false; }, /SIMD/],
        ['float blending', () => {
            const get = WebGL2RenderingContext.prototype.getSupportedExtensions;
            WebGL2RenderingContext.prototype.getSupportedExtensions = function () {
                return get.call(this).filter(name => name !== 'EXT_float_blend');
            };
        }, /EXT_float_blend/],
    ];
    for (const [name, remove, sentence] of LACKS)
        test(name, async () => {
            const tab = await openPage(session, '', { width: 320, height: 240, before: remove, wait: false });
            await tab.waitForSelector('#cover.failed', { timeout: 60_000 });
            assert.match(await tab.textContent('#said'), sentence);
            await tab.close();
        });
});

test('an embedded page answers messages', async () => {
    const tab = await openPage(session, '', { file: 'embedding.html', wait: false });
    await tab.waitForFunction(() => document.getElementById('log')?.textContent.includes('ready'), null, { timeout: 120_000 });
    await tab.click('#ask');
    await tab.waitForFunction(() => document.getElementById('log').textContent.includes('curves'), null, { timeout: 60_000 });
    assert.deepEqual(tab.complaints, []);
    await tab.close();
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
});
