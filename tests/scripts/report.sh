#!/usr/bin/env bash
# The report of tarn trade in a browser: everything is drawn, nothing comes from elsewhere, text stays text.
# report.sh PROJECT SYNTHETIC_REPORT TEST
set -euo pipefail
project=$1 tarn=$2
source "$project/tests/scripts/lib.sh"

# CTest takes 77 for "skipped".
find_browser() {
    local name
    for name in chromium chromium-browser; do
        browser=$(command -v "$name") && return
    done
    echo "skipped: there is no chromium to open the report with"
    exit 77
}

# The page as it stands once its script has run, in $work/page.html.
open_report() {
    HOME=$work timeout 100 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage \
        --user-data-dir="$work/profile" --virtual-time-budget=10000 --window-size="$1" \
        --dump-dom "file://$work/out/a trade/report.html" >"$work/page.html" 2>"$work/stderr" ||
        fail "the browser failed"
}

write_report() {
    local goldens=$project/tests/image/goldens
    call 0 "$work/out/a trade" "$goldens/lake-bed.png" "$goldens/lake-bed-later.png" "$goldens/lake-mirror.png"
    sweeps=$(sed -n 's/ sweeps$//p' "$work/stdout")
}

test_is_drawn() {
    find_browser
    write_report
    open_report 1200,4000
    ! grep -o 'data-error="[^"]*"' "$work/page.html" || fail "the page's script failed"
    # One plot of everything, one of the passes, and one for each option.
    grep -q "data-plots=\"$((sweeps + 2))\"" "$work/page.html" ||
        fail "not $((sweeps + 2)) plots were drawn: $(grep -o 'data-plots="[0-9]*"' "$work/page.html")"
    grep -q 'A lake &lt;i&gt;of&lt;/i&gt; formulas' "$work/page.html" || fail "the title is not the scene's name"
    ! grep -q '<b>shallows</b></option>' "$work/page.html" || fail "a name was taken for HTML"
    grep -q 'Unexplained' "$work/page.html" || fail "the error budget is missing"
    [[ $(grep -o '<figure class="triple">' "$work/page.html" | grep -c '') == 2 ]] || fail "not a picture for each view"
}

test_fits_its_window() {
    find_browser
    write_report
    local size
    for size in 1200,4000 500,900; do # a window of chromium is at least 500 wide
        open_report "$size"
        grep -q 'data-overflow="0"' "$work/page.html" || fail "the page is wider than its window of $size"
    done
}

test_needs_nothing_else() {
    write_report
    local page="$work/out/a trade/report.html"
    ! grep -Eo '(src|href)="(https?:)?//[^"]*' "$page" || fail "the page refers to another place"
    ! grep -Eo '@import[^;]*|url\([^)]*\)' "$page" || fail "the style refers to another file"
    # Its three scripts and no more: text did not open or close one.
    [[ $(grep -o '<script' "$page" | grep -c '') == 3 ]] || fail "not three scripts are opened"
    [[ $(grep -o '</script>' "$page" | grep -c '') == 3 ]] || fail "not three scripts are closed"
}

run_test "$3"
