// links.test.mjs -- links that are broken, foreign or of a newer version, and states that survive a link.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { ask, idle, open, openPage, project, state } from './browser.mjs';

let session;
before(async () => { session = await open(); });
after(() => session.close());

// Opens an address in a tab that shows the page already.
async function follow(tab, fragment) {
    await tab.evaluate(fragment => { location.hash = fragment; }, fragment);
    await tab.waitForTimeout(100);
    await idle(tab);
}

describe('wrong links', () => {
    const AT_THE_START = {
        '#s=abc': /damaged/,
        '#panel=cellar': /part 'cellar'/,
        '#panel=plot&controls=volume': /no such parameter/,
    };
    for (const [fragment, sentence] of Object.entries(AT_THE_START))
        test(fragment, async () => {
            const tab = await openPage(session, fragment, { width: 320, height: 240 });
            assert.match(await ask(tab, 'message'), sentence);
            assert.equal(await tab.isVisible('#cover'), false);
            await tab.close();
        });

    const LATER = {
        '#s=%%%': /damaged/,
        '#s=AAAA': /damaged/,
        '#scene=moon': /not one of the built-in scenes/,
        '#technique=magic': /magic/,
        '#beta=2': /beta|β/,
        '#beta=': /beta|β/,
        '#gamma=1': /neither scene, technique, lesson nor a parameter/,
        '#nonsense': /equals sign/,
    };
    let tab;
    before(async () => { tab = await openPage(session, '#scene=planes&technique=power4-32', { width: 320, height: 240 }); });
    after(() => tab.close());
    for (const [fragment, sentence] of Object.entries(LATER))
        test(fragment, async () => {
            await follow(tab, fragment);
            assert.match(await ask(tab, 'message'), sentence);
            assert.equal((await state(tab)).scene, 'planes');
        });

    const SESSIONS = {
        'of a newer version': ['{"momentscope_session": 99}', /version 99/],
        'of another program': ['{"a": 1}', /not a session of Momentscope/],
        'that is no JSON': ['moments', /JSON|line/],
        'of a mesh that is not here': ['{"momentscope_session": 1, "scene": "/files/bunny.obj"}', /mesh 'bunny.obj'/],
    };
    for (const [name, [text, sentence]] of Object.entries(SESSIONS))
        test(`a session ${name}`, async () => {
            await follow(tab, await tab.evaluate(async text => `#s=${await (await import('./link.js')).packed(text)}`, text));
            assert.match(await ask(tab, 'message'), sentence);
        });
});

// Addresses that say a state in words, as documents have them.
test('a link in words', async () => {
    const tab = await openPage(session, '#scene=spheres&technique=trig2-32&theta=0.5', { width: 320, height: 240 });
    const { scene, technique, parameters } = await state(tab);
    assert.deepEqual([scene, technique, parameters.theta], ['spheres', 'trig2-32', 0.5]);
    await tab.close();
});

// Every address in the documents and in the page that embeds a plot.
test('links of documents', async () => {
    const texts = [...fs.readdirSync(path.join(project, 'docs')).filter(name => name.endsWith('.md')).map(name => `docs/${name}`),
                   'page/site/embedding.html'].map(name => fs.readFileSync(path.join(project, name), 'utf8').replaceAll('&amp;', '&'));
    const links = new Set(texts.flatMap(text => [...text.matchAll(/index\.html(#[-\w=&,.]+)/g)].map(match => match[1])));
    assert.ok(links.size >= 2);
    for (const link of links) {
        const tab = await openPage(session, link, { width: 320, height: 240 });
        assert.equal(await ask(tab, 'message'), '', link);
        await tab.close();
    }
});

// Random states, made by opening words and pressing keys, and each through its link to a fresh state and back.
test('states survive their links', async () => {
    const tab = await openPage(session, '#scene=planes', { width: 320, height: 240 });
    const count = await tab.evaluate(async () => {
        const { packed, unpacked } = await import('./link.js');
        const { texts } = globalThis.momentscope;
        let word = 7;
        const random = below => { word = (Math.imul(word, 1664525) + 1013904223) >>> 0; return Math.floor((word / 2 ** 32) * below); };
        const TECHNIQUES = ['power4-32', 'trig3-32', 'sharp6', 'certain8', 'sorted', 'mt'];
        const SCENES = ['planes', 'spheres', 'teapots', 'ties', 'cloud', 'foliage', 'ship', 'smoke'];
        for (let i = 0; i < 50; ++i) {
            const session = {
                momentscope_session: 1, scene: SCENES[random(8)], technique: TECHNIQUES[random(6)],
                parameters: { beta: random(100) / 100, opacity: random(90) / 100 },
                picked: [random(100) / 100, random(100) / 100], lens: random(2) === 1, failures: random(2) === 1,
                compare: { mode: ['off', 'wipe', 'difference'][random(3)], gain: 1 + random(60) },
                plot: { quantity: ['absorbance', 'transmittance'][random(2)], query: random(200) / 100 - 1 },
                theme: ['dark', 'light'][random(2)],
            };
            const trouble = texts('open', JSON.stringify(session), '');
            if (trouble) throw new Error(trouble);
            const link = texts('link');
            const through = await unpacked(await packed(link));
            texts('open', '', '');   // a fresh state
            texts('open', through, '');
            if (texts('link') !== link) throw new Error(`${link} became ${texts('link')}`);
        }
        return 50;
    });
    assert.equal(count, 50);
    await tab.close();
});
