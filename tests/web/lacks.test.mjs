// lacks.test.mjs -- browsers that lack something, and pages that embed a part of the window.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { open, openPage, project } from './browser.mjs';

let session;
before(async () => { session = await open(); });
after(() => session.close());

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

// The policy of docs/hosting.md.
test('a strict content security policy', async () => {
    const policy = fs.readFileSync(path.join(project, 'docs/hosting.md'), 'utf8').match(/`(default-src [^`]*)`/)[1];
    const tab = await openPage(session, '#scene=planes', {
        width: 320, height: 240, wait: false,   // waiting for the program evaluates a text, which the policy forbids
        prepare: tab => tab.route(address => address.pathname === '/', async route => {
            const reply = await route.fetch();
            await route.fulfill({ response: reply, headers: { ...reply.headers(), 'content-security-policy': policy } });
        }),
    });
    await tab.waitForSelector('#cover', { state: 'hidden', timeout: 60_000 });
    await tab.waitForTimeout(500);
    assert.deepEqual(tab.complaints, []);
    await tab.close();
});

test('an embedded page answers messages', async () => {
    const tab = await openPage(session, '', { file: 'embedding.html', wait: false });
    await tab.waitForFunction(() => document.getElementById('log')?.textContent.includes('ready'), null, { timeout: 120_000 });
    await tab.click('#ask');
    await tab.waitForFunction(() => document.getElementById('log').textContent.includes('curves'), null, { timeout: 60_000 });
    assert.deepEqual(tab.complaints, []);
    await tab.close();
});
