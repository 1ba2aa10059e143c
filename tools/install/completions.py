#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the completions of bash, zsh and fish: completions.py COMMAND OUTPUT

COMMAND is the program tdsp, which tells its commands and options. Where a file is meant, files with the ending that is its custom come first; any other
will do where there is none.
"""
import pathlib
import shlex
import sys

import described

MADE = "# SPDX-License-Identifier: MIT\n# Completion of tdsp {version} for {shell}, made from `tdsp help --json`.\n"


def words_of(values):
    return [word for value in values for word in value.words]


def endings_of(values):
    """The endings of the files that may stand here; None where none may, [] where any file may."""
    files = [value for value in values if value.is_file]
    if not files:
        return None
    return [] if any(value.ending == "" for value in files) else sorted({value.ending for value in files})


# ------------------------------------------------------------------------------------------------------------------ bash

BASH = r"""
# Files with one of these endings and directories; any file where there is none.
_tdsp_files() {
    local -a found=()
    local ending
    for ending in "$@"; do
        mapfile -t -O "${#found[@]}" found < <(compgen -f -X "!*.$ending" -- "$cur")
    done
    [ ${#found[@]} -gt 0 ] || mapfile -t found < <(compgen -f -- "$cur")
    mapfile -t -O "${#found[@]}" found < <(compgen -d -- "$cur")
    mapfile -t COMPREPLY < <(printf '%s\n' "${found[@]}" | sort -u | sed '/^$/d')
    compopt -o filenames 2>/dev/null
}

_tdsp_words() {
    mapfile -t COMPREPLY < <(compgen -W "$*" -- "$cur")
}

# What completes the value of a command's option, in the array action; fails when the option takes none.
_tdsp_value() {
    case "$1 $2" in
@VALUES@
    *) return 1 ;;
    esac
}

# The same for a command's argument of this number, from 1.
_tdsp_argument() {
    case "$1 $2" in
@ARGUMENTS@
    *) action=(:) ;;
    esac
}

_tdsp_options() {
    case $1 in
@OPTIONS@
    *) _tdsp_words --help --version ;;
    esac
}

_tdsp() {
    local cur=${COMP_WORDS[COMP_CWORD]} command="" word previous="" count=0 i
    local -a action=(:)
    # Bash makes three words of --option=value.
    for ((i = 1; i < COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        if [ "$word" = "=" ]; then
            continue
        elif [ -z "$command" ]; then
            [[ $word == -* ]] || command=$word
        elif [[ $word == -?* ]]; then
            previous=$word
            continue
        elif [ -z "$previous" ] || ! _tdsp_value "$command" "$previous"; then
            count=$((count + 1))
        fi
        previous=""
    done
    COMPREPLY=()
    [ "$cur" = "=" ] && cur=""
    if [ -z "$command" ]; then
        if [[ $cur == -* ]]; then _tdsp_options ""; else _tdsp_words @COMMANDS@ help; fi
    elif [ -n "$previous" ] && _tdsp_value "$command" "$previous"; then
        "${action[@]}"
    elif [[ $cur == -* ]]; then
        _tdsp_options "$command"
    else
        _tdsp_argument "$command" "$((count + 1))"
        "${action[@]}"
    fi
}
complete -F _tdsp tdsp
"""


def bash_action(values):
    words, endings = words_of(values), endings_of(values)
    if words:
        return "_tdsp_words " + " ".join(words)
    return ":" if endings is None else " ".join(["_tdsp_files", *endings])


def bash_pattern(command, position):
    """The last of an argument that may be given often stands for all behind it."""
    number, positional = position
    return f'"{command.name} "*' if positional.many else f'"{command.name} {number}"'


def bash(version, commands):
    values, arguments, options = [], [], []
    for command in commands:
        for option in command.options:
            if option.values and not option.may_lack:
                patterns = " | ".join(f'"{command.name} {flag}"' for flag in option.flags)
                values.append(f"    {patterns}) action=({bash_action(option.values)}) ;;")
        for position in enumerate(command.positionals, 1):
            arguments.append(f"    {bash_pattern(command, position)}) action=({bash_action(position[1].values)}) ;;")
        flags = " ".join(flag for option in command.options for flag in option.flags)
        options.append(f"    {command.name}) _tdsp_words {flags} ;;")
    names = " ".join(command.name for command in commands)
    arguments.append(f'    "help 1") action=(_tdsp_words {names}) ;;')
    options.append("    help) _tdsp_words --json ;;")
    text = BASH
    for mark, lines in [("VALUES", values), ("ARGUMENTS", arguments), ("OPTIONS", options), ("COMMANDS", [names])]:
        text = text.replace(f"@{mark}@", "\n".join(lines))
    return MADE.format(version=version, shell="bash") + text


# ------------------------------------------------------------------------------------------------------------------- zsh

ZSH = """
_tdsp() {
    local context state state_descr line
    typeset -A opt_args
    _arguments -C '(- *)'{-h,--help}'[List the commands]' '(- *)--version[Print the version]' '1:command:->command' '*::argument:->argument'
    case $state in
    command)
        local -a commands=(
@COMMANDS@
        )
        _describe -t commands command commands
        ;;
    argument)
        case $line[1] in
@ARGUMENTS@
        help) _arguments '--json[Print JSON]' '1:command:(@NAMES@)' ;;
        esac
        ;;
    esac
}
"""


def zsh_text(text):
    """For the inside of a specification, where brackets and colons mean something."""
    return text.replace("\\", "\\\\").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def zsh_action(values):
    words, endings = words_of(values), endings_of(values)
    if words:
        return f"({' '.join(words)})"
    if endings is None:
        return " "
    pattern = endings[0] if len(endings) == 1 else f"({'|'.join(endings)})"
    return f'_files -g "*.{pattern}(-.)"' if endings else "_files"


def zsh_option(option):
    text = f"[{zsh_text(option.text)}]"
    takes = f":{zsh_text(option.name)}:{zsh_action(option.values)}" if option.values else ""
    if option.may_lack:
        takes = ""
    if not option.short:
        return shlex.quote(f"--{option.long}{'=' if takes else ''}{text}{takes}")
    both = f"(-{option.short} --{option.long})"
    return " ".join(shlex.quote(f"{both}{flag}{text}{takes}") for flag in [f"-{option.short}{'+' * bool(takes)}", f"--{option.long}{'=' * bool(takes)}"])


def zsh_positional(number, positional):
    return shlex.quote(f"{'*' if positional.many else number}:{zsh_text(positional.name)}:{zsh_action(positional.values)}")


def zsh(version, commands):
    described_commands = [f"        {shlex.quote(zsh_text(command.name) + ':' + command.summary)}" for command in commands]
    arguments = []
    for command in commands:
        given = [zsh_option(option) for option in command.options] + [zsh_positional(*position) for position in enumerate(command.positionals, 1)]
        arguments.append(f"        {command.name})\n            _arguments -s -S \\\n                " + " \\\n                ".join(given) + "\n            ;;")
    text = ZSH.replace("@COMMANDS@", "\n".join(described_commands)).replace("@ARGUMENTS@", "\n".join(arguments))
    text = text.replace("@NAMES@", " ".join(command.name for command in commands))
    return "#compdef tdsp\n" + MADE.format(version=version, shell="zsh") + text + '\n_tdsp "$@"\n'


# ------------------------------------------------------------------------------------------------------------------ fish

FISH = """
# Files with one of these endings, and directories; any file where there is none.
function __tdsp_files
    set -l all (__fish_complete_path (string replace -r -- '^--[a-z-]+=' '' (commandline -ct)))
    set -l fitting (string match -r -- '^[^\t]*\\.(?:'(string join '|' $argv)')(?:\t.*)?$' $all)
    if test (count $argv) -gt 0 -a (count $fitting) -gt 0
        printf '%s\\n' $fitting (string match -r -- '^[^\t]*/(?:\t.*)?$' $all)
    else
        printf '%s\\n' $all
    end
end

# Is the argument of this number, from 1, of this command the next? Behind the number: the options that take a value.
function __tdsp_at
    set -l words (commandline -opc)
    contains -- $argv[1] $words[2]; or return 1
    set -l count 1
    set -l value_of_option 0
    for word in $words[3..-1]
        if test $value_of_option = 1
            set value_of_option 0
        else if contains -- $word $argv[3..-1]
            set value_of_option 1
        else if not string match -q -- '-?*' $word
            set count (math $count + 1)
        end
    end
    test $count = $argv[2]
end
"""


def fish_quote(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_action(values):
    """-x: no files, the value is needed."""
    words, endings = words_of(values), endings_of(values)
    if words:
        return f"-x -a {fish_quote(' '.join(words))}"
    if endings is None:
        return "-x"
    return f"-x -k -a {fish_quote('(__tdsp_files ' + ' '.join(endings) + ')')}"


def fish_option(command, option):
    short = f" -s {option.short}" if option.short else ""
    takes = f" {fish_action(option.values)}" if option.values and not option.may_lack else ""
    return f"complete -c tdsp -n '__fish_seen_subcommand_from {command.name}' -l {option.long}{short}{takes} -d {fish_quote(option.text)}"


def fish_positional(command, number, positional):
    """An argument that may be given often is never a file here, so there is nothing to say of those behind the first."""
    if not words_of(positional.values) and endings_of(positional.values) is None:
        return None
    taking = " ".join(flag for option in command.options if option.values and not option.may_lack for flag in option.flags)
    return f"complete -c tdsp -n '__tdsp_at {command.name} {number} {taking}' {fish_action(positional.values)}"


def fish(version, commands):
    lines = ["complete -c tdsp -f", "complete -c tdsp -n __fish_use_subcommand -s h -l help -d 'List the commands'",
             "complete -c tdsp -n __fish_use_subcommand -l version -d 'Print the version'"]
    for command in commands:
        lines.append(f"complete -c tdsp -n __fish_use_subcommand -a {command.name} -d {fish_quote(command.summary)}")
    lines.append("complete -c tdsp -n __fish_use_subcommand -a help -d 'Help on a command'")
    lines.append(f"complete -c tdsp -n '__tdsp_at help 1' -a {fish_quote(' '.join(command.name for command in commands))}")
    lines.append("complete -c tdsp -n '__fish_seen_subcommand_from help' -l json -d 'Print JSON'")
    for command in commands:
        lines += [fish_option(command, option) for option in command.options]
        lines += filter(None, (fish_positional(command, *position) for position in enumerate(command.positionals, 1)))
    return MADE.format(version=version, shell="fish") + FISH + "\n" + "\n".join(lines) + "\n"


def main(program, output):
    version, commands = described.ask(program)
    output = pathlib.Path(output)
    output.mkdir(parents=True, exist_ok=True)
    for name, text in [("tdsp", bash(version, commands)), ("_tdsp", zsh(version, commands)), ("tdsp.fish", fish(version, commands))]:
        (output / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
