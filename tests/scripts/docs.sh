#!/usr/bin/env bash
# The documents, and the tool that checks them.
# docs.sh PROJECT PROGRAM TEST
set -euo pipefail
project=$1 program=$2
source "$project/tests/scripts/lib.sh"

# Everything that README.md and docs/ print.
test_documents_are_right() {
    tarn=$project/tools/docs
    call 0 --check --program "$program"
    grep -Eq '^[0-9]+ pages' "$work/stdout" || fail "it does not say what was checked"
}

test_readme_is_short() {
    [[ $(wc -l <"$project/README.md") -le 120 ]] || fail "README.md has more than 120 lines: docs/ is the place for more"
}

# A project of two pages, and nothing wrong with them.
small_project() {
    mkdir -p tools docs assets/presets
    cp "$project/tools/docs" tools/docs
    : >assets/presets/low.toml
    tarn=$work/out/tools/docs
    "$tarn" --update --program "$program"
    printf '# Small\n\n    tarn render --set refraction.steps=3 --out a.png   a picture\n\n[all](docs/index.md)\n' >README.md
    printf '# All\n\n[README](../README.md), [options](options.md), [guide](guide.md#setting-options)\n' >docs/index.md
    printf '# Guide\n\n## Setting options\n\nAs `tarn` [says](options.md#refraction).\n' >docs/guide.md
    call 0 --check --program "$program"
}

# finds PATTERN LINE   this line in the guide (its seventh) is complained of, and nothing else is
finds() {
    printf '# Guide\n\n## Setting options\n\nAs `tarn` [says](options.md#refraction).\n\n%s\n' "$2" >docs/guide.md
    refuse 1 "docs/guide\.md:7: .*$1" --check --program "$program"
}

test_check_finds_what_is_wrong() {
    small_project
    finds 'rendr: no such subcommand' '    tarn rendr --out a.png'
    finds 'render has no flag --sise' '    tarn render --sise 8x8 --out a.png    a small picture'
    finds 'compare has no flag --set' '    $ tarn-osmesa compare a.png b.png --set frame.scale=1'
    finds 'one argument too many' '    tarn compare a.png b.png c.png'
    finds '--camera needs a value' '    tarn render --camera --out a.png'
    finds 'no option refraction\.stpes' 'So does `tarn render --set refraction.stpes=3`.'
    finds 'no option caustics\.methd' '    LC_ALL=C tarn bench --vary caustics.methd=cpu'
    finds 'refraction\.steps is 1 to 64, not 65' 'Take `refraction.steps=65`.'
    finds 'refraction\.method is one of .*, not magic' 'Take `refraction.enabled=true refraction.method=magic`.'
    finds 'no preset middle' '    tarn view --preset middle'
    finds 'no tools/rnu' '    tools/rnu'
    finds 'no flag --chekc' '    tools/docs --chekc'
    finds 'no src/nowhere\.cpp' 'See `src/nowhere.cpp`.'
    finds 'link nowhere\.md leads nowhere' 'See [there](nowhere.md).'
    finds 'no such heading' 'See [there](options.md#refractoin).'
}

test_check_finds_pages_that_are_stale_or_not_listed() {
    small_project
    echo 'more' >>docs/options.md
    refuse 1 'docs/options\.md: .*tools/docs --update' --check --program "$program"
    call 0 --update --program "$program"
    call 0 --check --program "$program"
    echo '# New' >docs/new.md
    refuse 1 'docs/index\.md: does not list docs/new\.md' --check --program "$program"
}

test_docs_usage() {
    tarn=$project/tools/docs
    refuse 2 '--chekc.*usage' --chekc
    refuse 2 '--check or --update' --check --update
    refuse 1 'nowhere/tarn.*--program' --check --program nowhere/tarn
}

test_site_is_built() {
    command -v pandoc >/dev/null || exit 77
    small_project
    cp "$project/tools/setup" tools/setup
    mkdir assets/pictures
    echo picture >assets/pictures/lake.png
    echo '# Changelog' >CHANGELOG.md
    printf '\n## The lake\n\n![The lake](../assets/pictures/lake.png)\n' >>docs/index.md
    TARN_SKIP_SETUP=1 call 0
    local site=$work/out/build/docs
    [[ $(cat "$work/stdout") == "$site/index.html" ]] || fail "it does not say where the site begins"
    grep -q 'href="options.html#refraction"' "$site/docs/guide.html" || fail "a link does not lead to a page of the site"
    grep -q 'href="docs/index.html"' "$site/README.html" || fail "README.md does not lead to the list of pages"
    grep -q '<td><code>refraction.steps' "$site/docs/options.html" || fail "the options are no table"
    cmp assets/pictures/lake.png "$site/assets/pictures/lake.png" || fail "a picture is missing"
}

# A page of figures with date, machine, commit and the commands that made it.
test_measurements_write_their_page() {
    tarn=$project/tools/measurements
    refuse 2 'usage' --cmaeras above
    refuse 1 'no such folder' --out nowhere/m.md
    refuse 1 'nowhere/tarn.*--program' --out m.md --program nowhere/tarn
    local small=(--scene "$project/tests/image/scenes/checkered_bed.toml" --size 16x12 --frames 1 --program "$program" --out m.md)
    call 1 "${small[@]}" --cameras nowhere
    [[ ! -e m.md ]] || fail "a failed measurement left a page"
    call 0 "${small[@]}" --cameras above --presets fast
    local pattern
    for pattern in '^| date | [0-9-]* |' '^| commit | ' '^| machine | .*threads' '^## above' '^| the same without water | [0-9]' \
        '^| `--preset fast` | [0-9]' '^| water | [0-9.e+]* | [0-9.e+]* | 4032 |' '^    tarn bench .* --preset fast$'; do
        grep -q -- "$pattern" m.md || fail "the page has no line $pattern"
    done
    only_in_out m.md
}

run_test "$3"
