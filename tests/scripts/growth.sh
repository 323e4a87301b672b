#!/usr/bin/env bash
# How cost grows, as tools/growth measures it, fits it and shows it.
# growth.sh PROJECT PROGRAM TEST
set -euo pipefail
project=$1 programs=$(dirname "$2")
source "$project/tests/scripts/lib.sh"
tarn=$project/tools/growth

# What was measured before, made up: times that grow with the square root of the size, memory with its cube root.
made_up() {
    mkdir -p "$1"
    python3 - "$1/growth.json" <<'EOF'
import json, sys
points = [{"axis": axis, "camera": "<b>shore</b>", "setting": "own", "value": size, "size": size, "triangles": 10,
           "wall_ms": [4 * size ** 0.5, 5 * size ** 0.5, 900], "cpu_ms": [1], "passes": {"scene": [1, 2]},
           "memory": {"resident_bytes": 1, "peak_bytes": round(1e9 * size ** (1 / 3)), "geometry_bytes": 7}}
          for axis in ("geometry", "screen") for size in (64, 1, 4, 16)]
json.dump({"machine": {"renderer": "none"}, "points": points}, open(sys.argv[1], "w"))
EOF
}

# json PYTHON-EXPRESSION   of `data`, which growth.json holds; true or the test fails
json() {
    python3 -c "import json, sys; data = json.load(open(sys.argv[1])); sys.exit(0 if ($1) else 1)" "$folder/growth.json" ||
        fail "growth.json is not so that $1"
}

test_fits_exponents() {
    folder="$work/out/a growth"
    made_up "$folder"
    call 0 --out "$folder" --page
    json 'len(data["curves"]) == 2'
    json 'all(abs(c["exponent"] - 0.5) < 1e-9 and abs(c["memory_exponent"] - 1 / 3) < 1e-6 for c in data["curves"])'
    json 'all(c["sizes"] == [1, 4, 16, 64] and c["wall_ms"] == [5, 10, 20, 40] and c["factor"] == 8 for c in data["curves"])'
    grep -Eq '^geometry .* 8\.00 +0\.50 ' "$work/stdout" || fail "the table does not tell the exponent"
}

test_page_is_drawn() {
    local browser
    browser=$(command -v chromium || command -v chromium-browser) || {
        echo "skipped: there is no chromium to open the page with"
        exit 77
    }
    folder="$work/out/a growth"
    made_up "$folder"
    call 0 --out "$folder" --page
    ! grep -Eo '(src|href)="(https?:)?//[^"]*' "$folder/growth.html" || fail "the page refers to another place"
    HOME=$work timeout 100 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage \
        --user-data-dir="$work/profile" --virtual-time-budget=10000 --dump-dom "file://$folder/growth.html" \
        >"$work/page.html" 2>"$work/stderr" || fail "the browser failed"
    ! grep -o 'data-error="[^"]*"' "$work/page.html" || fail "the page's script failed"
    grep -q 'data-plots="4"' "$work/page.html" || fail "not a plot of time and one of memory for each axis"
    grep -q '&lt;b&gt;shore&lt;/b&gt;' "$work/page.html" || fail "a name was taken for HTML"
}

test_refuses_what_it_cannot_do() {
    call 2 --out "$work/out/x" --axis colour
    call 2 --out "$work/out/x" --size large
    call 1 --out "$work/out/x" --page
    grep -q '^growth: error: .*nothing was measured' "$work/stderr" || fail "it does not say that there is nothing to show"
    call 1 --out "$work/out/x" --programs "$work"
    grep -q '^growth: error: .*tarn-osmesa.*build' "$work/stderr" || fail "it does not say that programs are missing"
}

test_measures_every_axis() {
    folder="$work/out/a growth"
    call 0 --out "$folder" --quick --programs "$programs"
    json '{c["axis"] for c in data["curves"]} == {"geometry", "grid", "refraction", "reflection", "screen", "waves"}'
    json 'all(len(c["wall_ms"]) == 2 and min(c["wall_ms"]) > 0 and min(c["peak_bytes"]) > 0 for c in data["curves"])'
    json 'all(isinstance(c["exponent"], float) for c in data["curves"])'
    # Four times the triangles, and all of them drawn where there are no levels of detail.
    json 'all(c["triangles"][1] > 3 * c["triangles"][0] for c in data["curves"] if c["setting"] == "full detail")'
    cp "$folder/growth.json" "$work/before.json"
    call 0 --out "$folder" --quick --programs "$programs"
    cmp "$folder/growth.json" "$work/before.json" || fail "what was measured is measured again"
}

run_test "$3"
