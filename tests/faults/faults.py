"""Code that the scripts of this folder share: the program as a server, and checks whether a file is complete."""

import os
import pathlib
import subprocess
import zlib

RAY = '{"fragments": [{"depth": -0.2, "opacity": 0.5}, {"depth": 0.4, "opacity": %s}]}'


class Server:
    """Runs command lines in a folder (tests/fuzz/command_line_server.cpp). `output` is a file or a device; "" closes it."""

    def __init__(self, server, folder, output="/dev/null", name="server"):
        self.errors = pathlib.Path(folder) / f".stderr-{name}"
        self.process = subprocess.Popen([pathlib.Path(server).resolve(), output, self.errors], cwd=folder,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env={**os.environ, "DISPLAY": "", "WAYLAND_DISPLAY": ""})

    def run(self, words):
        """Returns the exit code, or minus the signal that ended the program, and the text on standard error."""
        text = b"%d\n" % len(words) + b"".join(os.fsencode(word) + b"\0" for word in words)
        self.process.stdin.write(text)
        self.process.stdin.flush()
        code = int(self.process.stdout.readline())
        return code, self.errors.read_text()

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def unfinished(folder):
    """Files that write_file began and a kill left behind."""
    return sorted(pathlib.Path(folder).glob(".momentscope-*.partial"))


def is_whole_png(data):
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        return False
    at, kind = 8, b""
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind, body, check = data[at + 4:at + 8], data[at + 8:at + 8 + length], data[at + 8 + length:at + 12 + length]
        if len(check) < 4 or zlib.crc32(kind + body) != int.from_bytes(check, "big"):
            return False
        at += 12 + length
    return kind == b"IEND"
