// page.js -- loads the program, starts it on the canvas, and draws a frame whenever one is due.
import { answerMessages } from './embed.js';
import { makeHost, store } from './host.js';
import { listen } from './input.js';
import { makeFragment, parseFragment } from './link.js';

const canvas = document.getElementById('canvas');
const cover = document.getElementById('cover');
const said = document.getElementById('said');
const bar = document.getElementById('progress');
const embedded = window.parent !== window;

/** Covers the page with a sentence for good. */
function fail(sentence) {
    said.textContent = sentence;
    cover.classList.add('failed');
    cover.hidden = false;
}

/** The bytes of a file, while the bar shows how many have come. */
async function fetchWithProgress(url) {
    const reply = await fetch(url);
    if (!reply.ok) throw new Error(`The server has no ${url} (${reply.status}); the page is not installed as a whole.`);
    const all = Number(reply.headers.get('Content-Length'))   // too small if the server compresses; then the bar stays open;
    const parts = [];
    let have = 0;
    for (const reader = reply.body.getReader(); ;) {
        const { done, value } = await reader.read();
        if (done) break;
        parts.push(value);
        have += value.length;
        if (all >= have) bar.value = have / all;
    }
    return new Blob(parts, { type: 'application/wasm' }).arrayBuffer();
}

async function load() {
    if (typeof WebAssembly !== 'object' || !WebAssembly.validate(SIMD))
        throw new Error('This browser cannot run the program, which needs WebAssembly with SIMD; use a current browser.');
    const [{ default: create }, wasmBinary] = await Promise.all([import('./momentscope.js'), fetchWithProgress('momentscope.wasm')]);
    said.textContent = 'starting…';
    return create({ canvas, wasmBinary });
}
// The smallest program that uses SIMD.
const SIMD = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]);

function canvasSize() {
    const scale = window.devicePixelRatio || 1;
    canvas.width = Math.max(Math.round(canvas.clientWidth * scale), 1);
    canvas.height = Math.max(Math.round(canvas.clientHeight * scale), 1);
    return [canvas.width, canvas.height, scale];
}

async function run() {
    let link = { session: '', words: '', part: '', controls: '' };
    let damage = '';
    const reading = parseFragment(location.hash).then(parsed => { link = parsed; }, error => { damage = error.message; });
    const program = await load();
    await reading;
    const texts = (name, ...values) =>
        program.ccall(`page_${name}`, 'string', values.map(value => typeof value), values);
    const say = sentence => { texts('say', sentence); wake(); };
    const fragmentOf = session => makeFragment(session, link);

    program.host = makeHost(program, {
        opened: path => { texts('file', path, false); wake(); },
        say,
        linkOf: async session => new URL(await fragmentOf(session), location.href).href,
    });
    for (const name of ['settings', 'progress']) texts('kept', name, program.host.kept(name));
    const problem = texts('start', ...canvasSize(), link.session, link.words, link.part, link.controls);
    if (problem) return fail(problem);
    cover.hidden = true;

    // Frames are drawn only while something changes.
    let waiting = false, lost = false, last = performance.now(), afterFrame = () => {};
    function wake() {
        if (waiting || lost) return;
        waiting = true;
        requestAnimationFrame(draw);
    }
    function draw(now) {
        waiting = false;
        if (lost) return;
        const trouble = texts('frame', (now - last) / 1000);
        last = now;
        if (trouble) {
            lost = true;
            return fail(trouble);
        }
        keepStep();
        afterFrame();
        if (program._page_due()) wake();
    }
    // A button takes a frame to go down and another to come up; a text that it opens takes the focus some frames later.
    function drawNow() {
        for (let i = 0; i < 8 && program._page_due() && !program._page_types(); ++i) draw(performance.now());
    }

    // Each step of the user gets an entry in the history of the browser. An embedded page leaves that of the page around it alone.
    let address = Promise.resolve();
    function keepStep() {
        const session = texts('step');
        if (!session) return;
        address = address.then(async () => {
            const fragment = await fragmentOf(session);
            if (embedded) {
                messages.changed(fragment);
                history.replaceState(null, '', fragment);
            } else {
                history.pushState(null, '', fragment);
            }
        });
    }
    async function open(fragment) {
        const wanted = await parseFragment(fragment);
        const trouble = texts('open', wanted.session, wanted.words);
        if (trouble) throw new Error(trouble);
        wake();
    }
    const openAddress = () => open(location.hash).catch(error => say(error.message));
    window.addEventListener('popstate', openAddress);

    const messages = answerMessages({
        open,
        link: () => fragmentOf(texts('link')),
        curves: () => texts('curves'),
    });

    new ResizeObserver(() => { program._page_resize(...canvasSize()); wake(); }).observe(canvas);
    afterFrame = listen(canvas, program, { wake, drawNow });

    // Files that are dropped on the page.
    window.addEventListener('dragover', event => event.preventDefault());
    window.addEventListener('drop', async event => {
        event.preventDefault();
        const [file] = event.dataTransfer.files;
        if (!file) return say('Drop a file: a mesh, a view ray or a session.');
        try {
            texts('file', await store(program, file), true);
            wake();
        } catch {
            say(`'${file.name}' could not be read; it may be too large for this browser.`);
        }
    });

    // The browser may take the graphics away and give them back.
    canvas.addEventListener('webglcontextlost', event => {
        event.preventDefault();
        lost = true;
        fail('The browser has taken the graphics away; the page goes on as soon as it gives them back. If it does not, reload the page.');
    });
    canvas.addEventListener('webglcontextrestored', () => {
        const trouble = texts('restore', ...canvasSize());
        if (trouble) return fail(trouble);
        lost = false;
        cover.hidden = true;
        cover.classList.remove('failed');
        wake();
    });

    globalThis.momentscope = { program, texts, wake, idle: () => !waiting && !program._page_due() };
    canvas.focus({ preventScroll: true });
    wake();
    if (damage) say(damage);
    if (embedded) messages.ready();
}

run().catch(error => fail(error.message));
