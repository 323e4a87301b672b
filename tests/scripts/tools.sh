#!/usr/bin/env bash
# The shell tools, as far as that is possible without installing or building anything.
# tools.sh PROJECT PROGRAM TEST
set -euo pipefail
project=$1 tarn=$2 program=$2
source "$project/tests/scripts/lib.sh"

# A copy of the tools in a folder with a space; cmake, ninja and the programs only note how they were called.
fake_project() {
    root="$work/a lake/tarn"
    mkdir -p "$root" "$work/bin"
    cp -r "$project/tools" "$root/tools"
    cat >"$work/bin/cmake" <<'EOF'
#!/bin/sh
echo "cmake $*" >>"$NOTES"
mkdir -p build/release/bin && : >build/release/build.ninja
EOF
    cat >"$work/bin/ninja" <<'EOF'
#!/bin/sh
[ ! -e "$NOTES.broken" ] || { echo "FAILED: some.o"; exit 1; }
for program in tarn tarn-osmesa; do
    printf '#!/bin/sh\nprintf "%%s" "$(basename "$0")" >>"$NOTES"\nfor a in "$@"; do printf " <%%s>" "$a" >>"$NOTES"; done\necho >>"$NOTES"\n' >"$2/bin/$program"
    chmod +x "$2/bin/$program"
done
EOF
    chmod +x "$work/bin/"*
    export NOTES=$work/notes PATH="$work/bin:$PATH" TARN_SKIP_SETUP=1
    unset DISPLAY WAYLAND_DISPLAY
    tarn="$root/tools/run"
}

noted() {
    grep -qxF -- "$1" "$NOTES" || fail "'$1' was not run; what was run: $(cat "$NOTES")"
}

test_run_passes_arguments_on() {
    fake_project
    call 0 render "my scene.toml" --out "a b.png"
    noted "tarn <render> <my scene.toml> <--out> <a b.png>"
    call 0 bench --frames 3 --headless
    noted "tarn-osmesa <bench> <--frames> <3>"
    DISPLAY=:7 call 0 view x.toml
    noted "tarn <view> <x.toml>"
    DISPLAY=:7 call 0
    noted "tarn"
    [[ $(grep -c ^cmake "$NOTES") == 1 ]] || fail "it was configured more than once"
}

# Whatever the program calls a subcommand is one for tools/run too, with and without a display.
test_run_knows_every_subcommand() {
    fake_project
    "$program" --describe >"$work/description.json" || fail "the program does not describe itself"
    local command commands
    commands=$(sed -n 's/^      "name": "\([a-z]*\)",$/\1/p' "$work/description.json")
    [[ $(wc -w <<<"$commands") -ge 13 ]] || fail "the description has the subcommands '$commands'"
    for command in $commands; do
        [[ $command != view ]] || continue
        call 0 "$command" x
        noted "tarn <$command> <x>"
        call 0 --headless "$command" x
        noted "tarn-osmesa <$command> <x>"
    done
}

test_run_without_display_renders_a_gallery() {
    fake_project
    call 0
    noted "tarn-osmesa <render> <--all-cameras> <--size> <960x540> <--out> <$root/gallery>"
    grep -q "$root/gallery" "$work/stderr" || fail "it does not say where the gallery is"
    DISPLAY=:7 call 0 --headless "a scene.toml" --size 64x64 --out "$work/out/my pictures"
    noted "tarn-osmesa <render> <--all-cameras> <a scene.toml> <--size> <64x64> <--out> <$work/out/my pictures>"
    [[ -d $work/out/my\ pictures ]] || fail "the folder was not made"
}

test_run_shows_a_failed_build() {
    fake_project
    : >"$NOTES.broken"
    call 1 render --out a.png
    grep -q "FAILED: some.o" "$work/stderr" || fail "the log is not shown"
    grep -q "^tarn: error: the build failed" "$work/stderr" || fail "no line says that the build failed"
}

test_setup_refuses_what_it_does_not_know() {
    tarn=$project/tools/setup
    refuse 2 '--tset' --tset
}

test_setup_without_apt_says_what_to_do() {
    mkdir "$work/bin"
    ln -s "$(command -v bash)" "$work/bin/bash"
    tarn=$project/tools/setup
    PATH=$work/bin refuse_without_apt
}

refuse_without_apt() {
    local status=0
    bash "$tarn" >"$work/stdout" 2>"$work/stderr" || status=$?
    PATH=/usr/bin:/bin
    [[ $status == 1 ]] || fail "ended with $status"
    grep -q '^tarn: error: .*apt-get.*TARN_SKIP_SETUP=1' "$work/stderr" || fail "it does not say what to do"
}

test_golden_usage() {
    tarn=$project/tools/golden
    refuse 2 'review|bless'
    refuse 2 'review|bless' burn
}

test_intervals_usage() {
    tarn=$project/tools/intervals
    refuse 2 'intervals N'
    refuse 2 '2 to 16 frames' 1
    refuse 2 '2 to 16 frames' pool.toml
}

test_format() {
    local status=0
    "$project/tools/format" --check >"$work/stdout" 2>"$work/stderr" || status=$?
    [[ $status != 77 ]] || exit 77
    [[ $status == 0 ]] || fail "files are not as tools/format writes them"
}

run_test "$3"
