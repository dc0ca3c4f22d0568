// typing.js -- on a screen without keys the browser shows its keyboard only for a field of its own. So an invisible field takes the
// focus while the program edits a text, and what is typed there goes on to the program.
const BACKSPACE = 259, ENTER = 257;
const HELD = ' ';   // there must be something that backspace can delete

/** The field. `program`: the module. `send(name, ...values)`: calls a function of the program and asks for a frame. */
export function makeTypingField(canvas, program, send) {
    const field = document.createElement('textarea');
    field.id = 'typing';
    field.rows = 1;
    field.setAttribute('aria-label', 'The text that is edited in the window');
    for (const [name, value] of Object.entries({ autocapitalize: 'off', autocomplete: 'off', autocorrect: 'off', spellcheck: 'false' }))
        field.setAttribute(name, value);
    field.tabIndex = -1;
    field.value = HELD;
    document.body.append(field);

    const press = key => {
        send('key', key, true);
        send('key', key, false);
    };
    field.addEventListener('input', event => {
        if (event.isComposing) return;
        const typed = field.value;
        if (!typed.startsWith(HELD)) press(BACKSPACE);
        for (const letter of typed.slice(typed.startsWith(HELD) ? HELD.length : 0)) {
            if (letter === '\n') press(ENTER);
            else send('character', letter.codePointAt(0));
        }
        field.value = HELD;
        field.setSelectionRange(HELD.length, HELD.length);
    });
    field.addEventListener('compositionend', () => field.dispatchEvent(new InputEvent('input')));

    return {
        element: field,
        /** After a tap: shows the keyboard if it began to edit a text. */
        show() {
            if (program._page_types()) field.focus({ preventScroll: true });
        },
        /** After each frame: gives the focus back when no text is edited any more. */
        follow() {
            if (document.activeElement === field && !program._page_types()) canvas.focus({ preventScroll: true });
        },
    };
}
