"""Values that options must refuse."""

NO_NUMBERS = ["nan", "inf", "-inf", "x", "1e999", "-1e999", "0x10", "1,5", " 1", "1 ", "1..2", "--", "٣", "1e", "+-1", "",
              "9" * 400, "1;2", "\t1", "1\n", "%d", "$(1)", "None", "1f", "\u202e1", "\x1b[31m1", b"\xff\xfe"]
NO_WORDS = ["", " ", "nosuch", "POWER4-32", "0.5.1", "../x", "x" * 300, "a,b,,c", ":", "=", "x\ny", "\x1b[2J", b"\xff"]
NO_FILES = ["", "missing/file", "x" * 300, "x" * 5000, ".", "/", "\x1b[2J", b"\xff.json", "ray.json/x"]

# Wrong values for options that are not parameters. Options that accept any text are not listed.
WRONG = {
    "--scene": ["", "nosuch", "missing/file.obj", "x" * 300, "ray.json", ".", "one.csv"],
    "--size": NO_NUMBERS + ["8", "8x", "x8", "0x0", "8x8x8", "-1x5", "1e1x8", "99999x8", "8X8", "8 x 8", "8*8"],
    "--pixel": NO_NUMBERS + ["1", "1,", "1,2,3", "-1,0", "99999,0", "0.5,1", "1;2", "8x8"],
    "--ray": NO_FILES + ["one.png", "one.csv"],
    "--technique": NO_WORDS + ["power4", "power4-32:", "power4-32:beta", "power4-32:beta=2", "power4-32:nodes=4", "at:nodes=1",
                               "at:nodes=", "at:nodes=4:nodes=5", "sorted:beta=1"],
    "--samples": NO_NUMBERS + ["0", "1", "-5", "1000001", "2.5"],
    "--depths": NO_NUMBERS + ["2", "-1.5", "0,,1", "0,", ",0", "0 1"],
    "--format": NO_WORDS + ["JSON", "pdf", "json,csv"],
    "--receiver": NO_WORDS + ["0", "-1", "1.5", "Surface", "99999999"],
    "--metric": NO_WORDS + ["RMSE", "mse", "rmse,flip"],
    "--region": NO_NUMBERS + ["0,0,0,0", "0,0,9,9", "1,2,3", "-1,0,2,2", "0,0,1.5,1", "99999,0,1,1"],
    "--rays": NO_NUMBERS + ["0", "-1", "1.5", "1000001"],
    "--seed": NO_NUMBERS + ["-1", "1.5", "2000000001"],
    "--random": NO_NUMBERS + ["0", "-1", "1.5", "1000001"],
    "--repeat": NO_NUMBERS + ["0", "-1", "1.5", "1001"],
    "--shard": NO_NUMBERS + ["0/1", "2/1", "1", "1/0", "-1/2", "1/2/3", "1/99999", "a/b"],
    "--condition": NO_WORDS,
    "--basis": NO_WORDS + ["trigonometric", "Power"],
    "--max-failures": NO_NUMBERS + ["-0.1", "1.1"],
    "--max-error": NO_NUMBERS + ["0", "-1"],
    "--max-bits": NO_NUMBERS + ["0", "-1", "1.5"],
    "--max-ms": NO_NUMBERS + ["0", "-1"],
    "--chart": NO_FILES + ["one.png", "ray.json"],
    "--compare": NO_WORDS + ["power4"],
    "--session": NO_FILES + ["one.png", "ray.json"],
    "--events": NO_FILES + ["one.png"],
    "--screenshot": ["", "x.jpg", "x", "missing/x.png", "x" * 300 + ".png", "x.png/y.png"],
    "--ui-scale": NO_NUMBERS + ["0", "0.4", "4.1", "-1"],
    "--theme": NO_WORDS + ["Dark", "blue"],
    "--output": ["", "missing/x", "x" * 300, ".", "ray.json/x"],
    "--log": ["", "missing/x", ".", "x" * 300],
}
OTHER_POSITIONALS = {"compare": [["one.png"], ["one.png", "one.png", "one.png"], ["one.png", "missing.png"], ["ray.json", "one.png"],
                                 ["", "one.png"], [b"\xff", "one.png"], ["one.png", "x" * 300]],
                     "figure": [["nosuch"], [""], ["fig1", "fig4"], [b"\xff"]],
                     "merge": [["missing.csv"], ["one.png"], ["ray.json"], [""]],
                     "list": [["nosuch"], [""], ["scenes", "techniques"], ["Scenes"]]}


def wrong_values(row):
    """Wrong values of a parameter."""
    values = list(NO_NUMBERS)
    if row["choices"]:
        return [*NO_WORDS, *(f"{choice}x" for choice in row["choices"]), *(choice.upper() + "!" for choice in row["choices"])]
    below, above = row["minimum"] - 1, row["maximum"] * 2 + 1
    values += [str(below), str(above), "1e30", "-1e30"]
    if row["default"] != "auto":
        values.append("auto")
    if row.get("whole"):
        values += [str(row["minimum"] + 0.5)]
    return values
