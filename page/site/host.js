// host.js -- files and the clipboard for the program.
const FOLDER = '/files';

/** Writes the bytes of a File of the browser to a file of the program and returns its path. */
export async function store(program, file) {
    try {
        program.FS.mkdir(FOLDER);
    } catch {
        // it exists
    }
    const path = `${FOLDER}/${file.name.replaceAll('/', '_')}`;
    program.FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    return path;
}

/**
 * The functions that the program calls. `program`: the module. `opened(path)`: called with a chosen file. `say(sentence)`: shows
 * a sentence to the user. `linkOf(text)`: the whole address of a state.
 */
export function makeHost(program, { opened, say, linkOf }) {
    const input = document.createElement('input');
    input.type = 'file';
    input.hidden = true;
    input.id = 'file';
    document.body.append(input);
    input.addEventListener('change', async () => {
        const [file] = input.files;
        input.value = '';
        if (!file) return;
        try {
            opened(await store(program, file));
        } catch {
            say(`'${file.name}' could not be read; it may be too large for this browser.`);
        }
    });

    const copy = (text, done) => {
        const refused = () => say('The browser does not let the page copy; copy the address from the address bar.');
        if (!navigator.clipboard) return refused();
        navigator.clipboard.writeText(text).then(done, refused);
    };

    return {
        keep(name, text) {
            try {
                localStorage.setItem(`momentscope.${name}`, text);
                return true;
            } catch {
                return false;
            }
        },
        kept(name) {
            try {
                return localStorage.getItem(`momentscope.${name}`) ?? '';
            } catch {
                return '';   // a browser that stores nothing says so when something is kept
            }
        },
        toggleFullscreen() {
            if (document.fullscreenElement) document.exitFullscreen();
            else document.documentElement.requestFullscreen?.().catch(() => say('The browser does not allow full screen here.'));
        },
        chooseFile(extension) {
            input.accept = extension;
            input.click();
        },
        deliver(path) {
            const bytes = program.FS.readFile(path);
            program.FS.unlink(path);
            const link = document.createElement('a');
            link.href = URL.createObjectURL(new Blob([bytes]));
            link.download = path.split('/').at(-1);
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
        },
        async copyLink(text) {
            copy(await linkOf(text), () => say('The link to this state was copied.'));
        },
        copyText(text) {
            copy(text, () => {});
        },
    };
}
