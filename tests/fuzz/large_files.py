#!/usr/bin/env python3
"""Reads files of the greatest size that readers allow, and larger ones. Each is read or refused within 10 seconds and 1 GiB.

usage: large_files.py FUZZ_READERS"""

import pathlib
import subprocess
import sys
import tempfile

MIB = 1 << 20
FRAGMENT = '{"depth":0.25,"opacity":0.5,"color":[0.25,0.5,1],"seed":7,"threshold":0.5}'
SESSION = '{"momentscope_session":1,%s}'
SEEDS = pathlib.Path(__file__).parent / "seeds"
COLUMNS = next(line for line in (SEEDS / "table/chart.csv").read_text().splitlines() if line.startswith("scene,")) + "\n"
SETTINGS = "# momentscope: chart\n# schema: 2\n# rows: 1\n# shard: 1/1\n"


def filled(before, part, count, after):
    return before + (part + ",") * (count - 1) + part + after


def keys(count):
    return ",".join(f'"{i}":{{}}' for i in range(count))


def files():
    yield "ray/fragments.json", filled('{"fragments":[', FRAGMENT, 1_000_000, "]}")
    yield "ray/most-fragments.json", filled('{"fragments":[', FRAGMENT, 100_000, "]}")
    yield "ray/most-shares.json", filled('{"fragments":[],"shares":[', filled('{"weight":0.5,"fragments":[', FRAGMENT, 100_000, "]}"), 2, "]}")
    for name, part in [("lists", "[]"), ("objects", "{}"), ("texts", '""'), ("numbers", "0")]:
        yield f"ray/{name}.json", filled('{"fragments":[', part, 20_000_000, "]}")
        yield f"ray/most-{name}.json", filled('{"fragments":[', part, 990_000, "]}")
        yield f"session/{name}.json", SESSION % filled('"pins":[', part, 20_000_000, "]")
    yield "session/keys.json", SESSION % keys(999_000)
    yield "session/ray.json", SESSION % filled('"ray":{"fragments":[', FRAGMENT, 100_000, "]}")
    yield "session/fragments.json", SESSION % filled('"ray":{"fragments":[', FRAGMENT, 900_000, "]}")
    yield "session/text.json", SESSION % ('"card":"' + "x" * (60 * MIB) + '"')
    yield "table/rows.csv", SETTINGS + "a,b\n" + "\n" * 20_000_000
    yield "table/most-rows.csv", SETTINGS + "a,b\n" + ("x" * 600 + "\n") * 99_999
    yield "table/settings.csv", "# a: \n" * 10_000_000 + SETTINGS
    yield "table/words.csv", "# words: " + "a " * (30 * MIB) + "\n" + SETTINGS + "a,b\n=====\n" + SETTINGS + "a,b\n"
    yield "table/row.csv", SETTINGS + COLUMNS + "," * (60 * MIB) + "\n"
    yield "configuration/list.txt", "at:nodes=8," * 20_000 + "at"
    yield "events/words.events", "key a " + "b " * (8 * MIB - 10)
    yield "events/lists.events", "expect /scene " + "[" * (16 * MIB - 20)


def main():
    faults, count = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files():   # one at a time, because the driver keeps all its files in memory
            path = pathlib.Path(folder) / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
            faults += subprocess.run([sys.argv[1], "--replay", path]).returncode != 0
            count += 1
            path.unlink()
    print(f"{count} large files: {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
