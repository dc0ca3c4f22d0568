#!/usr/bin/env python3
"""Eight processes write one file repeatedly while it is read. The file must always be a complete version of one of the eight.

usage: writers.py COMMAND_LINE_SERVER [--seconds S]
"""

import argparse
import pathlib
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True
from faults import RAY, Server, unfinished  # noqa: E402

WRITERS = 8


def words_of(writer, output):
    return ["inspect", "--ray", f"ray-{writer}.json", "--samples", "500", "-o", output]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("server")
    parser.add_argument("--seconds", type=float, default=60)
    options = parser.parse_args()
    faults, writes = [], [0] * WRITERS
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        servers = [Server(options.server, folder, name=str(i)) for i in range(WRITERS)]
        contents = {}
        for i, server in enumerate(servers):
            (path / f"ray-{i}.json").write_text(RAY % (0.1 * (i + 1)))
            server.run(words_of(i, f"whole-{i}.json"))
            contents[(path / f"whole-{i}.json").read_bytes()] = i
        assert len(contents) == WRITERS
        servers[0].run(words_of(0, "shared.json"))
        end = time.monotonic() + options.seconds

        def write(i):
            while time.monotonic() < end:
                code, said = servers[i].run(words_of(i, "shared.json"))
                writes[i] += 1
                if code != 0:
                    faults.append(f"writer {i}: exit code {code}, {said}")

        threads = [threading.Thread(target=write, args=[i]) for i in range(WRITERS)]
        for thread in threads:
            thread.start()
        reads, seen = 0, set()
        while any(thread.is_alive() for thread in threads):
            data = (path / "shared.json").read_bytes()
            reads += 1
            if data in contents:
                seen.add(contents[data])
            else:
                faults.append(f"read {reads}: {len(data)} bytes that nobody wrote")
            time.sleep(0.001)
        faults += [f"{file.name} was left behind" for file in unfinished(path)]
        for server in servers:
            server.close()
    for fault in faults[:10]:
        print(fault)
    print(f"{sum(writes)} writes by {WRITERS} processes, {reads} reads, which saw {len(seen)} of them: {len(faults)} faults")
    return 1 if faults or min(writes) == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
