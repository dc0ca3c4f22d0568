// link.js -- states in the fragment of an address: #s=… holds a compressed session; other words set single values, such as
// #scene=ship&technique=sharp4&beta=0.3. `panel` and `controls` choose what an embedded page shows.

const through = async (bytes, stream) =>
    new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

const MOST_BYTES = 70_000_000;   // of a session; a longer one is refused by the program anyway

/** The text of a session for an address: deflated, in letters that addresses keep. */
export async function packed(text) {
    const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
    let letters = '';
    for (const byte of bytes) letters += String.fromCharCode(byte);
    return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The text of packed(). Throws a sentence if it is broken. */
export async function unpacked(letters) {
    try {
        const bytes = Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), letter => letter.charCodeAt(0));
        const text = await through(bytes, new DecompressionStream('deflate-raw'));
        if (text.length > MOST_BYTES) throw new Error();
        return new TextDecoder('utf-8', { fatal: true }).decode(text);
    } catch {
        throw new Error('The link is damaged: a part of it is missing or was changed. Copy it again, as a whole.');
    }
}

/** What a fragment says: the session (JSON or ''), words over it, and the embedded part with its controls. */
export async function parseFragment(fragment) {
    const link = { session: '', words: '', part: '', controls: '' };
    const words = [];
    for (const word of fragment.replace(/^#/, '').split('&')) {
        if (word === '') continue;
        let decoded = word;
        try {
            decoded = decodeURIComponent(word);
        } catch {
            throw new Error('The link is damaged: it has a % that stands for nothing. Copy it again, as a whole.');
        }
        const [key, value] = [decoded.split('=', 1)[0], decoded.slice(decoded.indexOf('=') + 1)];
        if (key === 's') link.session = await unpacked(value);
        else if (key === 'panel') link.part = value;
        else if (key === 'controls') link.controls = value;
        else words.push(decoded);
    }
    link.words = words.join('&');
    return link;
}

/** The fragment of a session, with the part of the window that an embedded page keeps. */
export async function makeFragment(session, { part = '', controls = '' } = {}) {
    let fragment = `#s=${await packed(session)}`;
    if (part) fragment += `&panel=${part}`;
    if (controls) fragment += `&controls=${controls}`;
    return fragment;
}
