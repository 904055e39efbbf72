#!/bin/sh
# completions.sh bash|zsh|fish NAME: prints the completions of a command, whose options table (what
# NAME --options-table prints) stands on standard input. The styles, palettes and styles of solid textures that
# are installed with the command are looked up when they are asked for.
set -eu
tail -n +2 | LC_ALL=C awk -F '\t' -v shell="$1" -v command="$2" '
    function quoted(text) { gsub(/\047/, "\047\\\047\047", text); return "\047" text "\047" }
    # zsh reads brackets and colons in a description as its own
    function described(text,    i, c, out) {
        for (i = 1; i <= length(text); i++) {
            c = substr(text, i, 1)
            out = out (index("[]:\\", c) ? "\\" : "") c
        }
        return out
    }
    # commands that print the names of the installed files of a kind, such as STYLE: share/hatch/styles/*.style
    function installed(kind) {
        return (shell == "fish" ? "ls (dirname (command -v " command "))" : "ls \"$(dirname \"$(command -v " command ")\")\"") \
            "/../share/hatch/styles 2>/dev/null | sed -n \"s/[.]" tolower(kind) "\\$//p\""
    }
    function is_installed(i) { return variable[i] == "STYLE" || variable[i] == "PALETTE" || variable[i] == "SOLID" }
    # one of the choices, and nothing else: a text with choices is no file
    function is_word(i) { return choices[i] != "" }
    $3 == "operand" { operand = $6; operands = $7; gsub(/,/, " ", operands) }
    $2 != "options-table" && $3 != "operand" {
        count++
        letter[count] = $1; name[count] = $2; type[count] = $3; variable[count] = $6
        choices[count] = $7; help[count] = $9
        gsub(/,/, " ", choices[count])
    }
    function bash_words(i) { return "--" name[i] (letter[i] == "" ? "" : " -" letter[i]) }
    function print_bash_words(pattern, words, files) {
        print "    " pattern ")\n        mapfile -t COMPREPLY < <(compgen " files "-W " words " -- \"$current\")\n" \
            "        return ;;"
    }
    function print_bash(    i, all, pattern, names) {
        print "_hatch_" command "()\n{"
        print "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}"
        print "    if [[ $current == = ]]; then current=; fi"
        print "    if [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD - 2]}; fi"
        print "    COMPREPLY=()\n    case $before in"
        for (i = 1; i <= count; i++) {
            all = all (i > 1 ? " " : "") bash_words(i)
            pattern = bash_words(i); sub(/ /, " | ", pattern)
            if (is_word(i))
                print_bash_words(pattern, quoted(choices[i]), "")
            else if (is_installed(i))
                print_bash_words(pattern, "\"$(" installed(variable[i]) ")\"", "-f ")
            else if (type[i] != "flag" && type[i] != "text")
                print "    " pattern ") return ;;"
            else if (type[i] == "text")
                print "    " pattern ")\n        mapfile -t COMPREPLY < <(compgen -f -- " \
                    "\"$current\")\n        return ;;"
        }
        print "    esac\n    if [[ $current == -* ]]; then"
        print "        mapfile -t COMPREPLY < <(compgen -W " quoted(all) " -- \"$current\")"
        if (operands != "") {
            names = operands
            gsub(/ /, "|", names)
            print "    elif [[ ! \" ${COMP_WORDS[*]:1:COMP_CWORD-1} \" =~ \\ (" names ")\\  ]]; then"
            print "        mapfile -t COMPREPLY < <(compgen -W " quoted(operands) " -- \"$current\")"
        }
        print "    else\n        mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n    fi\n}"
        print "complete -o filenames -F _hatch_" command " " command
    }
    function print_zsh(    i, what, names, before) {
        print "#compdef " command "\n_arguments -s -S \\"
        for (i = 1; i <= count; i++) {
            what = ""
            if (type[i] != "flag") {
                what = ":" variable[i] ":"
                if (is_word(i)) what = what "(" choices[i] ")"
                else if (is_installed(i)) what = what "{compadd -- $(" installed(variable[i]) "); _files}"
                else if (type[i] == "text") what = what "_files"
            }
            what = "[" described(help[i]) "]" what
            names = "--" name[i] (type[i] == "flag" ? "" : "=")
            before = type[i] == "texts" ? "*" : letter[i] == "" ? "" : "(-" letter[i] " --" name[i] ")"
            if (letter[i] != "")
                print "    " quoted(before) "{-" letter[i] (type[i] == "flag" ? "" : "+") "," names "}" quoted(what) " \\"
            else
                print "    " quoted(before names what) " \\"
        }
        if (operands != "")
            print "    " quoted("1:" operand ":(" operands ")") " \\"
        print "    \047*:file:_files\047"
    }
    function print_fish(    i, line) {
        for (i = 1; i <= count; i++) {
            line = "complete -c " command (letter[i] == "" ? "" : " -s " letter[i]) " -l " name[i]
            if (is_word(i)) line = line " -x -a " quoted(choices[i])
            else if (is_installed(i)) line = line " -r -F -a " quoted("(" installed(variable[i]) ")")
            else if (type[i] == "text") line = line " -r -F"
            else if (type[i] != "flag") line = line " -x"
            print line " -d " quoted(help[i])
        }
        if (operands != "")
            print "complete -c " command " -n " quoted("not __fish_seen_subcommand_from " operands) " -f -a " \
                quoted(operands)
    }
    END {
        if (shell == "bash") print_bash()
        else if (shell == "zsh") print_zsh()
        else print_fish()
    }'
