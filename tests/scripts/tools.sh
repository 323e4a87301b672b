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
echo "ninja $*" >>"$NOTES"
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

# A fresh clone is built without tests, and of the two programs only the one that runs.
test_run_builds_what_it_needs() {
    fake_project
    call 0 render --out a.png
    noted "cmake --preset release -DTARN_TESTS=OFF"
    noted "ninja -C $root/build/release tarn"
    ! grep -q 'ninja.*tarn-osmesa' "$NOTES" || fail "the other program was built too"
    call 0 --headless render --out a.png
    noted "ninja -C $root/build/release tarn-osmesa"
}

# What tools/run has configured without tests gets them.
test_test_adds_the_tests() {
    fake_project
    printf '#!/bin/sh\necho "ctest $*" >>"$NOTES"\necho "100%% tests passed, 0 tests failed out of 1"\n' >"$work/bin/ctest"
    chmod +x "$work/bin/ctest"
    call 0 render --out a.png
    printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nTARN_TESTS:BOOL=OFF\n' "$root" >"$root/build/release/CMakeCache.txt"
    tarn=$root/tools/test
    call 0 -R x
    noted "cmake --preset release -DTARN_TESTS=ON"
    noted "ninja -C $root/build/release"
    grep -q '^ctest ' "$NOTES" || fail "no test was run"
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

# A project of two sources and a header on a branch, and a clang-tidy that complains of what holds "mistake".
small_branch() {
    root="$work/a lake/tarn"
    mkdir -p "$root/src/base" "$root/tools" "$root/build/dev" "$work/bin"
    cp "$project/tools/build.sh" "$project/tools/tidy" "$root/tools"
    cd "$root"
    printf '/build*/\n' >.gitignore
    echo '#include "base/a.h"' >src/base/a.cpp
    echo '#include "base/a.h"' >src/base/b.cpp
    : >src/base/a.h
    export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a
    git init -q -b main
    git add .
    git commit -qm main
    git checkout -qb branch
    cat >"$work/bin/clang-tidy-14" <<'END'
#!/bin/sh
for file; do :; done
echo "$*" >>"$NOTES"
! grep -H mistake "$file"
END
    printf '#!/bin/sh\n' >"$work/bin/ninja"
    chmod +x "$work/bin/"*
    echo '[]' >build/dev/compile_commands.json
    export NOTES=$work/notes PATH="$work/bin:$PATH"
    tarn=$root/tools/tidy
}

# tidied FILE...   the last call checked these sources, and no others
tidied() {
    local found
    found=$(sed 's/.* //' "$NOTES" 2>/dev/null | sort | paste -sd ' ') || true
    [[ $found == "$*" ]] || fail "checked were '$found', not '$*'"
    rm -f "$NOTES"
}

test_tidy_takes_what_has_changed() {
    command -v git >/dev/null || exit 77
    small_branch
    call 0
    tidied
    echo '// mistake' >>src/base/b.cpp
    refuse_with_complaint 'src/base/b\.cpp' 1
    tidied src/base/b.cpp
    git commit -qam 'a mistake'
    refuse_with_complaint 'src/base/b\.cpp' 1
    tidied src/base/b.cpp
    call 0 HEAD
    tidied
    : >src/base/new.cpp # untracked
    call 0 HEAD
    tidied src/base/new.cpp
    rm src/base/new.cpp
    echo '// changed' >>src/base/a.h # a header with a source of its name
    call 0 HEAD
    grep -q -- '--header-filter=/base/a\\.h\$' "$NOTES" || fail "the header's own lines are not asked for: $(cat "$NOTES")"
    tidied src/base/a.cpp
    refuse_with_complaint 'src/base/b\.cpp' 2 --all
    tidied src/base/a.cpp src/base/b.cpp
    cd src
    call 0 base/a.cpp
    tidied src/base/a.cpp
}

# refuse_with_complaint PATTERN SOURCES ARGUMENTS...
refuse_with_complaint() {
    local pattern=$1 count=$2
    shift 2
    call 1 "$@"
    grep -q 'mistake' "$work/stdout" || fail "the complaint is not shown"
    grep -Eq "^tarn: error: clang-tidy complains of 1 of $count: $pattern" "$work/stderr" || fail "no line names the source"
}

test_tidy_bad_input() {
    command -v git >/dev/null || exit 77
    small_branch
    refuse 2 'usage: tools/tidy' --alll
    refuse 2 'stands alone' --all HEAD
    refuse 2 'needs a folder' --build
    refuse 1 'nowhere: no such commit or file' nowhere
    refuse 1 'no C\+\+ file' .gitignore
    refuse 1 "$work/none/compile_commands.json is missing; cmake --preset dev" --build "$work/none"
    rm "$work/bin/clang-tidy-14"
    mkdir "$work/bare"
    local program
    for program in bash git sed sort grep realpath readlink dirname; do ln -s "$(command -v $program)" "$work/bare/$program"; done
    PATH=$work/bare call 77
    grep -q '^tarn: error: clang-tidy is not installed; tools/setup --tidy' "$work/stderr" || fail "it does not say what is missing"
}

test_format() {
    local status=0
    "$project/tools/format" --check >"$work/stdout" 2>"$work/stderr" || status=$?
    [[ $status != 77 ]] || exit 77
    [[ $status == 0 ]] || fail "files are not as tools/format writes them"
}

run_test "$3"
