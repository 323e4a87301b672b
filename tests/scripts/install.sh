#!/usr/bin/env bash
# What cmake --install puts into a prefix, and that it runs from there.
# install.sh PROJECT BUILD TEST
set -euo pipefail
project=$1 build=$2
tarn=""
source "$project/tests/scripts/lib.sh"

test_runs_from_its_prefix() {
    cmake --install "$build" --prefix "$work/prefix" >/dev/null
    local file
    for file in bin/tarn bin/tarn-osmesa share/tarn/shaders/passes/water.frag share/tarn/assets/lake/lake.toml \
        share/applications/tarn.desktop share/icons/hicolor/scalable/apps/tarn.svg share/doc/tarn/copyright; do
        [[ -f $work/prefix/$file ]] || fail "$file is not installed"
    done
    if command -v python3 >/dev/null; then
        [[ -s $work/prefix/share/man/man1/tarn.1.gz && -s $work/prefix/share/bash-completion/completions/tarn ]] ||
            fail "no man page or no completions"
    fi
    [[ ! -e $work/prefix/share/tarn/assets/desktop ]] || fail "the desktop file is installed twice"
    mkdir "$work/elsewhere"
    cd "$work/elsewhere"
    tarn=$work/prefix/bin/tarn-osmesa
    call 0 info
    grep -qF "$work/prefix/share/tarn/assets/lake/lake.toml" "$work/stdout" || fail "the data is not that of the prefix"
    call 0 render "$work/prefix/share/tarn/assets/bench/terrain.toml" --size 32x24 --out picture.png
    [[ -s picture.png ]] || fail "no picture"
    # Data that somebody names wins over what stands beside the program; the old name says what it is called now.
    TARN_DATA=$project call 0 info
    grep -qF "$project/assets/lake/lake.toml" "$work/stdout" || fail "TARN_DATA is not heard"
    TARN_ROOT=$project call 0 info
    grep -q 'TARN_ROOT is now called TARN_DATA' "$work/stderr" || fail "TARN_ROOT is taken without a word"
    TARN_DATA=$work/elsewhere refuse 1 'TARN_DATA=.*does not hold' info
}

run_test "$3"
