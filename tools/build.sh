# Sourced by tools/run and tools/test: configures and builds quietly, and shows the whole log when that fails.
# Needs: root (the project's folder). With with_tests=no a fresh build folder is configured without the tests, which then need not
# have their libraries; with with_tests=yes they are added to one that has none.

say() { echo "tarn: $*" >&2; }

# build_preset PRESET [TARGET...]   build/PRESET as CMakePresets.json describes it
build_preset() {
    local preset=$1
    shift
    local folder=$root/build/$preset log=$root/build/$preset.log options=()
    mkdir -p "$root/build"

    # CMakeCache.txt remembers where it was made. A moved or copied tree starts afresh.
    if [[ -f $folder/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
        rm -rf "$folder"
    fi
    case "${with_tests-}" in
        no) options=(-DTARN_TESTS=OFF) ;;
        yes)
            if grep -qs '^TARN_TESTS:BOOL=OFF' "$folder/CMakeCache.txt"; then
                options=(-DTARN_TESTS=ON)
                rm -f "$folder/build.ninja"
            fi
            ;;
    esac
    # Once configured, ninja itself runs CMake again when a CMakeLists.txt has changed.
    if [[ ! -f $folder/build.ninja ]]; then
        say "configuring in build/$preset"
        if ! (cd "$root" && cmake --preset "$preset" "${options[@]+"${options[@]}"}") >"$log" 2>&1 </dev/null; then
            cat "$log" >&2
            rm -f "$folder/CMakeCache.txt"
            say "error: configuring failed (the log above is also in build/$preset.log)"
            return 1
        fi
    fi

    local steps
    steps=$(ninja -C "$folder" -n "$@" 2>/dev/null | sed -n 's/^\[[0-9]*\/\([0-9]*\)\].*/\1/p' | tail -n 1) || steps=""
    [[ -n $steps ]] || steps=0
    ((steps == 0)) || say "building in build/$preset"
    if [[ -t 2 ]] && ((steps > 0)); then
        # ninja's one status line on the terminal; the log keeps everything.
        ninja -C "$folder" "$@" </dev/null 2>&1 | tee "$log" | show_status
    else
        ninja -C "$folder" "$@" >"$log" 2>&1 </dev/null
    fi || {
        grep -v '^\[[0-9]*/[0-9]*\] ' "$log" >&2 || true
        say "error: the build failed (the log above is also in build/$preset.log)"
        return 1
    }
}

# "[12/80] 15 %" on one line of the terminal, cleared at the end.
show_status() {
    local line
    while IFS= read -r line; do
        [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
        printf '\r\033[Ktarn: compiling %s of %s' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
    done
    printf '\r\033[K' >&2
}
