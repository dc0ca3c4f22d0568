// shaders.test.mjs -- WebGL 2 compiles every shader that the browser edition may use. MOMENTSCOPE_SHADERS is the program that writes
// them; glslangValidator accepts some that browsers do not.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { open } from './browser.mjs';

test('all shaders compile', async () => {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'momentscope-shaders-'));
    const { browser, close } = await open();
    try {
        execFileSync(process.env.MOMENTSCOPE_SHADERS, [folder]);
        const names = fs.readdirSync(folder, { recursive: true }).filter(name => name.includes('.300es.'));
        assert.ok(names.length > 300);
        const tab = await browser.newPage();
        const faults = await tab.evaluate(shaders => {
            const gl = document.createElement('canvas').getContext('webgl2');
            return shaders.flatMap(({ name, text }) => {
                const shader = gl.createShader(name.endsWith('.vert') ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
                gl.shaderSource(shader, text);
                gl.compileShader(shader);
                const log = gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? [] : [`${name}: ${gl.getShaderInfoLog(shader)}`];
                gl.deleteShader(shader);
                return log;
            });
        }, names.map(name => ({ name, text: fs.readFileSync(path.join(folder, name), 'utf8') })));
        assert.deepEqual(faults, []);
    } finally {
        await close();
        fs.rmSync(folder, { recursive: true });
    }
});
