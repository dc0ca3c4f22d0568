// serve.mjs [FOLDER] [PORT]: serves a folder to this machine alone. Any other server of static files does the same.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const TYPES = {
    '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm',
    '.json': 'application/json', '.svg': 'image/svg+xml', '.png': 'image/png', '.obj': 'text/plain',
};

/** Serves `folder` on `port` (0: any free one). Returns the server, which listens already. */
export async function serve(folder, port) {
    const root = path.resolve(folder);
    const server = http.createServer((request, reply) => {
        const name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
        let file = path.join(root, name);
        if (file.endsWith(path.sep)) file = path.join(file, 'index.html');
        const stat = file.startsWith(root + path.sep) && fs.statSync(file, { throwIfNoEntry: false });
        if (!stat || !stat.isFile()) {
            reply.writeHead(404, { 'Content-Type': 'text/plain' });
            return reply.end('There is no such file.');
        }
        reply.writeHead(200, {
            'Content-Type': TYPES[path.extname(file)] ?? 'application/octet-stream',
            'Content-Length': stat.size,
            'Cache-Control': 'no-cache',
        });
        fs.createReadStream(file).pipe(reply);
    });
    await new Promise((done, failed) => {
        server.once('error', failed);
        server.listen(port, '127.0.0.1', done);
    });
    return server;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
    const [folder = 'build/web', port = '8000'] = process.argv.slice(2);
    try {
        await serve(folder, Number(port));
        console.log(`Momentscope is at http://localhost:${port}/ until you press Ctrl+C.`);
    } catch (error) {
        console.error(error.code === 'EADDRINUSE' ? `Port ${port} is taken; give another one: ./web --port 8001` : error.message);
        process.exit(1);
    }
}
