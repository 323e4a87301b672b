# Sourced by the tests of the programs. A test is a function test_NAME; `run_test NAME` calls it in a folder of its own.
# Needs: project (the source folder), tarn (the program under test).

export LC_ALL=C

fail() {
    echo "FAILED: $*"
    echo "--- standard output"
    cat "$work/stdout" 2>/dev/null
    echo "--- standard error"
    cat "$work/stderr" 2>/dev/null
    exit 1
}

# call EXPECTED_STATUS ARGUMENTS...   runs the program; output is in $work/stdout and $work/stderr
call() {
    local expected=$1 status=0
    shift
    "$tarn" "$@" >"$work/stdout" 2>"$work/stderr" </dev/null || status=$?
    [[ $status == "$expected" ]] || fail "'$*' ended with $status, not $expected"
}

# refuse STATUS PATTERN ARGUMENTS...   the program must fail with one line that matches
refuse() {
    local expected=$1 pattern=$2
    shift 2
    call "$expected" "$@"
    [[ $(grep -c '' "$work/stderr") == 1 ]] || fail "'$*' printed more or less than one line of error"
    [[ $(cat "$work/stderr") == "tarn: error: "* ]] || fail "'$*' did not print 'tarn: error: …'"
    grep -Eq -- "$pattern" "$work/stderr" || fail "'$*': the error does not say /$pattern/"
    [[ ! -s $work/stdout ]] || fail "'$*' failed and yet printed a result"
}

# Nothing but the named files may be in the folder $work/out: no piece of a file, no temporary.
only_in_out() {
    local found wanted
    found=$(cd "$work/out" && find . -type f | sort)
    wanted=$(printf './%s\n' "$@" | sort)
    [[ $# -gt 0 ]] || wanted=""
    [[ $found == "$wanted" ]] || fail "in the output folder are '$found', not '$wanted'"
}

run_test() {
    work=$(mktemp -d)
    trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
    mkdir "$work/out"
    cd "$work/out"
    declare -F "test_$1" >/dev/null || fail "there is no test '$1'"
    "test_$1"
    echo "good"
}
