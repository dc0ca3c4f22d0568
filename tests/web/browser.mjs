// browser.mjs -- headless Chromium with the browser edition, for tests. WebGL 2 is drawn in software (SwiftShader), so canvases
// are small.
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../../scripts/web/serve.mjs';

const project = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
// scripts/web/install-test-tools puts it there.
const { chromium } = createRequire(path.join(project, 'build/web-tests/'))('playwright-core');

export { project };

/** The browser and the address of a folder of the project. */
export async function open(folder = 'build/web', flags = []) {
    const server = await serve(path.join(project, folder), 0);
    const browser = await chromium.launch({
        executablePath: '/usr/bin/chromium',
        args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', ...flags],
    });
    const address = `http://127.0.0.1:${server.address().port}/`;
    return { browser, address, close: async () => { await browser.close(); server.close(); } };
}

/** A tab that shows the page with this fragment, or another page. It collects what the browser complains of. */
export async function openPage({ browser, address }, fragment = '', { width = 640, height = 480, before, prepare, wait = true, file = '' } = {}) {
    const tab = await browser.newPage({ viewport: { width, height } });
    tab.complaints = [];
    tab.on('pageerror', error => tab.complaints.push(String(error)));
    tab.on('console', message => {
        if (message.type() === 'error' && !message.text().includes('favicon')) tab.complaints.push(message.text());
    });
    if (before) await tab.addInitScript(before);
    if (prepare) await prepare(tab);
    await tab.goto(address + file + fragment);
    if (wait) await idle(tab);
    return tab;
}

/** Waits until the program has started and has nothing to draw. */
export async function idle(tab) {
    await tab.waitForFunction(() => globalThis.momentscope?.idle(), null, { timeout: 120_000, polling: 100 });
}

/** Calls a function page_… of page/main.cpp. */
export const ask = (tab, name, ...values) =>
    tab.evaluate(([name, values]) => globalThis.momentscope.texts(name, ...values), [name, values]);

/** The middle of a widget, in pixels of the page. */
export async function placeOf(tab, id, x = 0.5, y = 0.5) {
    const rect = JSON.parse(await ask(tab, 'widgets'))[id];
    if (!rect) throw new Error(`There is no widget '${id}'.`);
    const scale = await tab.evaluate(() => window.devicePixelRatio);
    return [(rect[0] + x * (rect[2] - rect[0])) / scale, (rect[1] + y * (rect[3] - rect[1])) / scale];
}

export async function click(tab, id, x, y) {
    await tab.mouse.click(...(await placeOf(tab, id, x, y)));
    await tab.waitForTimeout(50);
    await idle(tab);
}

/** The state as the object that a link holds. */
export const state = async tab => JSON.parse(await ask(tab, 'link'));
