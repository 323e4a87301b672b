#!/usr/bin/env bash
# The man page and the completions that tools/shell_files makes of the program's own description.
# shell_files.sh PROJECT PROGRAM TEST
set -euo pipefail
project=$1 program=$2
source "$project/tests/scripts/lib.sh"

# A shell that is not there cannot be asked.
need() {
    command -v "$1" >/dev/null || {
        echo "skipped: there is no $1"
        exit 77
    }
}

make_files() {
    tarn=$project/tools/shell_files
    call 0 --out "$work/share" --program "$program"
}

test_man_page_has_every_flag() {
    need groff
    make_files
    gunzip "$work/share/man/man1/"*.gz
    grep -qx '\.so man1/tarn\.1' "$work/share/man/man1/tarn-osmesa.1" || fail "tarn-osmesa has no page"
    groff -man -Tutf8 -K utf8 -wall "$work/share/man/man1/tarn.1" >"$work/stdout" 2>"$work/stderr"
    [[ ! -s $work/stderr ]] || fail "groff warns"
    local page=$work/page command flag
    groff -man -Tascii -P-c -K utf8 "$work/share/man/man1/tarn.1" 2>/dev/null | sed 's/.\x08//g' >"$page"
    for command in view render compare options; do
        grep -q "^ *tarn $command" "$page" || fail "the page does not have tarn $command"
        for flag in $("$program" "$command" --help | grep -o '^  --[a-z-]*'); do
            grep -q -- "$flag" "$page" || fail "the page does not have $flag of $command"
        done
    done
}

# completes LINE EXPECTED...   what bash offers for a line holds these words, and nothing but these after the word "only"
completes() {
    local line=$1 only=no word
    shift
    COMP_LINE=$line COMP_POINT=${#line} COMPREPLY=()
    _tarn || true # compopt works in completions only
    if [[ $1 == only ]]; then
        only=yes
        shift
    fi
    for word in "$@"; do
        printf '%s\n' "${COMPREPLY[@]}" | grep -qxF -- "$word" || fail "'$line' does not complete to $word but to: ${COMPREPLY[*]}"
    done
    [[ $only == no || ${#COMPREPLY[@]} == "$#" ]] || fail "'$line' completes to more: ${COMPREPLY[*]}"
}

test_bash_completes() {
    make_files
    complete() { :; }
    source "$work/share/bash-completion/completions/tarn-osmesa"
    unset -f complete
    : >"my scene.toml"
    completes 'tarn rend' only render
    completes 'tarn ' view render reference options 'my scene.toml'
    completes 'tarn render --all' only --all-cameras
    completes 'tarn compare --max' only --max-flip
    completes 'tarn --full' only --fullscreen
    completes 'tarn --vers' only --version
    completes 'tarn render --preset th' only thesis
    completes 'tarn render --set refraction.st' only refraction.steps=
    completes 'tarn bench --vary caustics.method=f' only fetch
    completes 'tarn render --set plan.exact=' only true false
    completes 'tarn render my' only 'my scene.toml'
}

test_zsh_reads_it() {
    need zsh
    make_files
    zsh -n "$work/share/zsh/site-functions/_tarn" 2>"$work/stderr" || fail "zsh does not read it"
    # Loaded by its own completion system, which knows which commands it is for.
    ZDOTDIR=$work zsh -f -c "fpath=($work/share/zsh/site-functions \$fpath); autoload -Uz compinit; compinit -D -u; \
        print \$_comps[tarn] \$_comps[tarn-osmesa]" >"$work/stdout" 2>"$work/stderr" </dev/null
    [[ $(cat "$work/stdout") == "_tarn _tarn" ]] || fail "zsh completes tarn with something else"
}

test_fish_completes() {
    need fish
    make_files
    local file=$work/share/fish/vendor_completions.d/tarn.fish
    fish_offers() { HOME=$work fish --no-config -c "source '$file'; complete -C '$1'" >"$work/stdout" 2>"$work/stderr"; }
    fish_offers 'tarn rend'
    grep -q '^render' "$work/stdout" || fail "it does not complete a subcommand"
    fish_offers 'tarn compare --max'
    grep -q '^--max-flip' "$work/stdout" || fail "it does not complete a flag"
    fish_offers 'tarn render --set caustics.method=f'
    grep -q '^caustics.method=fetch' "$work/stdout" || fail "it does not complete a value"
    [[ ! -s $work/stderr ]] || fail "fish complains"
}

test_usage() {
    tarn=$project/tools/shell_files
    refuse 2 '--out'
    refuse 2 'usage' --prefix x
    refuse 1 'nowhere/tarn.*--program' --out "$work/share" --program nowhere/tarn
    [[ ! -e $work/share ]] || fail "a refused run left something"
}

run_test "$3"
