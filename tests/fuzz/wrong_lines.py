"""Makes wrong command lines from right ones."""

from wrong_values import OTHER_POSITIONALS, WRONG, wrong_values

# A cheap valid command line for each command. OUT is the file that it writes.
BASES = {
    "explore": ["--headless", "--screenshot", "OUT.png", "--scene", "planes", "--size", "640x400"],
    "render": ["--scene", "planes", "--size", "8x8", "-o", "OUT.png"],
    "inspect": ["--ray", "ray.json"],
    "compare": ["one.png", "one.png"],
    "needed": ["--scene", "planes", "--size", "8x8"],
    "figure": ["fig1", "-o", "OUT"],
    "stress": ["--rays", "1", "--technique", "power4-32", "--condition", "CONDITION", "-o", "OUT.csv"],
    "tune": ["--ray", "ray.json", "--technique", "power4-32"],
    "chart": ["--scene", "planes", "--size", "8x8", "--repeat", "1", "--technique", "hashed", "-o", "OUT.csv"],
    "advise": ["--scene", "planes", "--size", "8x8", "--repeat", "1", "--technique", "hashed", "--max-error", "2"],
    "merge": ["one.csv", "-o", "OUT.csv"],
    "list": ["scenes"],
}
NOT_RUN = {"explore", "figure", "advise", "merge"}  # slow, or lacking input files, so only their faults are tried


def replaced(base, option, value):
    """The base command with this value of the option, instead of its own value."""
    short = {"--output": "-o"}
    line, skip = [], False
    for word in base:
        if skip:
            skip = False
        elif word in (option, short.get(option)):
            skip = True
        else:
            line.append(word)
    value = value if isinstance(value, bytes) else value.encode()
    return [*line, option.encode() + b"=" + value if value.startswith(b"-") else option, *([] if value.startswith(b"-") else [value])]


def wrong_lines(program, rng):
    """Yields wrong command lines without an end, each with what is wrong with it."""
    parameters = {"--" + row["key"]: row for row in program.json("list", "parameters")}
    techniques = program.json("list", "techniques")
    condition = program.json("list", "conditions")[0]["id"]
    commands = {command: [condition if word == "CONDITION" else word for word in base] for command, base in BASES.items()}
    options = {command: program.options(command) for command in commands}
    every = sorted({option for known in options.values() for option in known})
    picture = {"opacity", "order", "order-seed", "tone-map", "shadows"}

    def a_wrong_value(command):
        option = rng.choice([name for name, value in options[command].items() if value])
        if option in parameters:
            return replaced(commands[command], option, rng.choice(wrong_values(parameters[option]))), option
        if option not in WRONG:
            return None
        base = commands[command]
        if option == "--pixel":
            base = ["--scene", "planes", "--size", "8x8"]
        if option in ("--scene", "--size") and command in ("inspect", "tune"):
            base = [word for word in base if word not in ("--ray", "ray.json")]
        if option == "--random":
            base = ["--technique", "power4-32"]
        if option == "--seed" and command == "tune":
            base = ["--random", "5", "--technique", "power4-32"]
        if option == "--receiver":
            base = ["--scene", "planes", "--size", "8x8", "--light", "--shadows"]
        if option in ("--scene", "--size") and command == "compare":
            base = ["one.png", "wboit"]
        if option == "--session":
            base = ["--headless", "--screenshot", "OUT.png"]
        return replaced(base, option, rng.choice(WRONG[option])), option

    def an_unknown_option(command):
        option = rng.choice([name for name in every if len(name) > 4])
        place = rng.randrange(3, len(option))
        wrong = option[:place] + rng.choice("xyz") + option[place + rng.randrange(2):]
        if any(known.startswith(wrong) for known in options[command]):
            return None
        return [*commands[command], wrong, "1"], wrong

    def another_commands_option(command):
        option = rng.choice([name for name in every if name not in options[command]])
        return [*commands[command], option, "1"], option

    def an_option_before_the_command(command):
        if command == "explore":
            return None
        option = rng.choice(list(parameters))
        value = parameters[option]["choices"][0] if parameters[option]["choices"] else str(parameters[option]["maximum"])
        return [option, value, command, *commands[command]], option

    def a_missing_value(command):
        option = rng.choice([name for name, value in options[command].items()
                             if value and (name not in parameters or name not in ("--lanczos", "--renormalize", "--shadows"))])
        return [*commands[command], option], option

    def an_option_twice(command):
        option = rng.choice([name for name in options[command] if name in parameters and name != "--shadows"] or ["-x"])
        if option == "-x":
            return None
        row = parameters[option]
        value = row["choices"][0] if row["choices"] else str(row["maximum"])
        return [*commands[command], option, value, option, value], option

    def an_ignored_parameter(command):
        if command not in ("render", "inspect", "stress", "tune"):
            return None
        technique = rng.choice(techniques)
        ignored = [option for option in parameters
                   if option[2:] not in technique["parameters"] and option[2:] not in picture
                   and not option.startswith(("--shadow", "--light", "--opaque"))]
        if not ignored:
            return None
        option = rng.choice(ignored)
        row = parameters[option]
        value = row["choices"][-1] if row["choices"] else str(row["maximum"])
        if command in ("stress", "tune") and "alpha" not in technique["parameters"]:
            return None
        return [*replaced(commands[command], "--technique", technique["id"]), option, value], option

    def wrong_positionals(command):
        if command not in OTHER_POSITIONALS:
            return None
        rest = commands[command][{"compare": 2}.get(command, 1):]
        return [*rng.choice(OTHER_POSITIONALS[command]), *rest], "the arguments"

    kinds = [a_wrong_value] * 5 + [an_unknown_option, another_commands_option, an_option_before_the_command, a_missing_value,
                                   an_option_twice, an_ignored_parameter, an_ignored_parameter, wrong_positionals]
    while True:
        command = rng.choice(list(commands))
        made = rng.choice(kinds)(command)
        if made is None:
            continue
        line, fault = made
        yield line if command in line else [command, *line], fault
