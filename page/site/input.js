// input.js -- mouse, touch and keyboard for the program. It takes only the keys that the program knows; all others stay with the
// browser.
import { makeTypingField } from './typing.js';

const NAMED_KEYS = {
    Space: 32, Escape: 256, Enter: 257, NumpadEnter: 257, Tab: 258, Backspace: 259, Insert: 260, Delete: 261, ArrowRight: 262,
    ArrowLeft: 263, ArrowDown: 264, ArrowUp: 265, PageUp: 266, PageDown: 267, Home: 268, End: 269, F1: 290, F9: 298, ShiftLeft: 340,
    ControlLeft: 341, AltLeft: 342, MetaLeft: 343, ShiftRight: 344, ControlRight: 345, AltRight: 346, MetaRight: 347,
};

/** The program's number of a key (that of GLFW), or 0. Letters and digits go by what they type, not by their place. */
export function keyNumber(event) {
    if (NAMED_KEYS[event.code]) return NAMED_KEYS[event.code];
    return /^[a-z0-9]$/i.test(event.key) ? event.key.toUpperCase().charCodeAt(0) : 0;
}

// With Ctrl: what the program does with them does not replace what people need of the browser.
const WITH_CTRL = /^[osmjezyg]$/i;
const WHILE_TYPING = /^[acxz]$/i;

/** Does the program take this key? `types`: a text is being edited. */
export function isOurs(event, types) {
    if (event.altKey || event.metaKey) return false;
    if (event.key === 'Control' || event.key === 'Shift') return true;
    if (event.ctrlKey) return WITH_CTRL.test(event.key) || (types && WHILE_TYPING.test(event.key)) || (event.shiftKey && /^p$/i.test(event.key));
    if (event.key === 'Tab') return types;
    return event.key.length === 1 || keyNumber(event) !== 0;
}

const CURSORS = ['default', 'text', 'move', 'ns-resize', 'ew-resize', 'nesw-resize', 'nwse-resize', 'pointer', 'not-allowed'];

/**
 * Sends the events of the canvas to the program. `wake()` is called after each. `drawNow()`: draws the frames that these events need
 * at once. Returns a function to call after each frame.
 */
export function listen(canvas, program, { wake, drawNow }) {
    const place = event => {
        const scale = canvas.width / canvas.clientWidth;
        return [event.clientX * scale, event.clientY * scale];
    };
    const send = (name, ...values) => {
        program[`_page_${name}`](...values);
        wake();
    };

    const typing = makeTypingField(canvas, program, send);

    // The mouse.
    const BUTTONS = [0, 2, 1];   // of the DOM, as ImGui numbers them
    const held = new Set();
    const onMouse = event => event.pointerType !== 'touch';
    canvas.addEventListener('pointermove', event => {
        if (onMouse(event)) send('move', ...place(event));
        canvas.style.cursor = CURSORS[program._page_cursor()] ?? 'none';
    });
    canvas.addEventListener('pointerdown', event => {
        canvas.focus();
        if (!onMouse(event)) return;
        canvas.setPointerCapture(event.pointerId);
        send('move', ...place(event));
        held.add(event.button);
        send('button', BUTTONS[event.button] ?? 0, true);
    });
    canvas.addEventListener('pointerup', event => {
        if (!onMouse(event)) return;
        held.delete(event.button);
        send('button', BUTTONS[event.button] ?? 0, false);
    });
    canvas.addEventListener('pointerleave', event => {
        if (onMouse(event) && held.size === 0) send('leave');
    });
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => {
        event.preventDefault();
        const notch = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : 3;
        send('wheel', -event.deltaX / notch, -event.deltaY / notch);
    }, { passive: false });

    // Touch: one finger is the left button, which is pressed as soon as the finger moves or is lifted, because a second one may come.
    // Two fingers are the right button, which orbits, and the wheel.
    const LEFT = 0, RIGHT = 1, STILL = 6;   // pixels of the page
    const fingers = new Map();
    let pressed = null;   // the button that fingers hold
    let began = [0, 0];   // place of the first finger
    let pinch = 0;        // distance of two fingers
    const press = (button, at) => {
        send('move', ...at);
        send('button', button, true);
        pressed = button;
    };
    const release = () => {
        if (pressed !== null) send('button', pressed, false);
        pressed = null;
    };
    const spread = () => {
        const [a, b] = [...fingers.values()];
        return { distance: Math.hypot(a[0] - b[0], a[1] - b[1]), middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] };
    };
    canvas.addEventListener('pointerdown', event => {
        if (onMouse(event)) return;
        fingers.set(event.pointerId, place(event));
        if (fingers.size === 1) {
            began = place(event);
            pinch = 0;
        } else if (fingers.size === 2) {
            const { distance, middle } = spread();
            pinch = distance;
            release();
            press(RIGHT, middle);
        }
    });
    canvas.addEventListener('pointermove', event => {
        if (!fingers.has(event.pointerId)) return;
        const now = place(event);
        fingers.set(event.pointerId, now);
        if (fingers.size === 1 && pinch === 0) {
            const scale = canvas.width / canvas.clientWidth;
            if (pressed === null && Math.hypot(now[0] - began[0], now[1] - began[1]) > STILL * scale) press(LEFT, began);
            if (pressed === LEFT) send('move', ...now);
        } else if (fingers.size === 2) {
            const { distance, middle } = spread();
            send('move', ...middle);
            const notches = Math.log(distance / pinch) / Math.log(1.1);
            if (Math.abs(notches) < 0.2) return;
            pinch = distance;
            send('wheel', 0, notches);
        }
    });
    const lift = event => {
        if (!fingers.delete(event.pointerId) || fingers.size > 0) return;
        if (pressed === null && pinch === 0 && event.type === 'pointerup') press(LEFT, began);   // a tap
        release();
        send('leave');
        if (event.type !== 'pointerup') return;
        drawNow();   // a browser shows its keyboard only while the event of the tap is handled
        typing.show();
    };
    canvas.addEventListener('pointerup', lift);
    canvas.addEventListener('pointercancel', lift);
    // Otherwise the click that a browser makes of a tap takes the focus back to the canvas.
    canvas.addEventListener('touchend', event => event.preventDefault(), { passive: false });

    // The keyboard.
    for (const target of [canvas, typing.element]) {
        target.addEventListener('keydown', event => {
            const types = program._page_types() !== 0;
            if (event.isComposing || !isOurs(event, types)) return;
            event.preventDefault();
            const number = keyNumber(event);
            if (number && !event.repeat) send('key', number, true);
            if (event.key.length === 1 && !event.ctrlKey) send('character', event.key.codePointAt(0));
            wake();
        });
        target.addEventListener('keyup', event => {
            const number = keyNumber(event);
            if (number) send('key', number, false);
        });
        target.addEventListener('focus', () => send('focus', true));
        target.addEventListener('blur', () => send('focus', false));
    }
    document.addEventListener('paste', event => {
        if (!program._page_types()) return;
        for (const letter of event.clipboardData.getData('text')) send('character', letter.codePointAt(0));
    });
    return typing.follow;
}
