#!/usr/bin/env bash
# The viewer in a real window on a display of its own: opened, every key pressed, resized, photographed, closed.
# viewer.sh PROJECT TARN TARN_OSMESA COMPARE [viewer|building|governor]
set -euo pipefail
project=$1 tarn=$2 osmesa=$3 compare=$4
source "$project/tests/scripts/lib.sh"

scene=$project/tests/image/scenes/post.toml

# Waits until the command succeeds; six hundred attempts are two minutes.
until_true() {
    local what=$1 i
    shift
    for ((i = 0; i < 600; i++)); do
        if "$@" >/dev/null 2>&1; then return 0; fi
        kill -0 "$viewer" 2>/dev/null || fail "the viewer ended while the test waited for $what"
        sleep 0.2
    done
    fail "waited in vain for $what"
}

start_display() {
    Xvfb -displayfd 4 -screen 0 1280x1024x24 -nolisten tcp 4>"$work/display" >"$work/xvfb.log" 2>&1 &
    server=$!
    local i
    for ((i = 0; i < 100; i++)); do
        [[ ! -s $work/display ]] || break
        sleep 0.1
    done
    [[ -s $work/display ]] || fail "Xvfb did not start: $(cat "$work/xvfb.log")"
    DISPLAY=:$(cat "$work/display")
    export DISPLAY
}

stop_all() {
    [[ -z ${viewer-} ]] || kill "$viewer" 2>/dev/null || true
    [[ -z ${server-} ]] || kill "$server" 2>/dev/null || true
}

press() {
    local key
    for key in "$@"; do
        xdotool key --window "$window" "$key"
        sleep 0.1
        kill -0 "$viewer" 2>/dev/null || fail "the viewer ended when '$key' was pressed"
    done
}

# The title says what is shown. Programs are built meanwhile, and keys are obeyed.
shows_picture() {
    local title
    title=$(xdotool getwindowname "$window")
    [[ $title == *fps* && $title != *"(draft)"* ]]
}
shows_draft() { [[ $(xdotool getwindowname "$window") == *"(draft)"* ]]; }

picture_there() { [[ -n $(find "$work/out" -name 'tarn-*.png' -size +1k) ]]; }

test_viewer() {
    start_display
    trap 'stop_all; rm -rf "$work"' EXIT
    # With its own settings, whatever they take: that is what tarn-osmesa draws.
    "$tarn" view "$scene" --camera shore --size 640x480 --time 0 --fps 0 >"$work/stdout" 2>"$work/stderr" </dev/null &
    viewer=$!
    until_true "the window" xdotool search --onlyvisible --name '[Tt]arn'
    window=$(xdotool search --onlyvisible --name '[Tt]arn' | head -n 1)
    xdotool windowfocus "$window"
    until_true "the picture with all settings" shows_picture

    # The scene is still, so the picture is the one that tarn-osmesa draws, whatever the time.
    press p 1
    sleep 0.5
    press F12
    until_true "the screenshot" picture_there
    photo=$(find "$work/out" -name 'tarn-*.png' | head -n 1)
    "$osmesa" render "$scene" --camera shore --size 640x480 --time 0 --out "$work/reference.png" >/dev/null
    "$compare" "$work/reference.png" "$photo" || fail "the screenshot is not like the headless picture"

    # Two eyes share the window: each sees what tarn-osmesa draws for it in half of the width.
    rm "$photo"
    press o
    sleep 0.5
    press F12
    until_true "the screenshot of both eyes" picture_there
    "$osmesa" render "$scene" --camera shore --size 320x480 --time 0 --set stereo.output=side_by_side \
        --out "$work/both.png" >/dev/null
    "$compare" "$work/both.png" "$photo" || fail "the screenshot of both eyes is not like the headless picture"
    press o o

    # Everything the help names, twice where it switches something.
    press c c u u g g r r f f p p v v v v v v v v v v v v v o o o t t b bracketleft bracketright h h Tab Tab 1 2 3 9 w a s d Up Down Left Right shift q e
    xdotool mousemove --window "$window" 200 200 mousedown 1 mousemove_relative 40 10 mouseup 1 click 4 click 5
    local size
    for size in "800 300" "200 700" "640 480"; do
        # shellcheck disable=SC2086
        xdotool windowsize "$window" $size
        sleep 0.4
        kill -0 "$viewer" 2>/dev/null || fail "the viewer ended when it was resized to $size"
    done
    xdotool windowminimize "$window" windowmap "$window"
    sleep 0.4
    xdotool windowfocus "$window" || true
    xdotool key --window "$window" Escape # it may be gone before press would look

    local status=0
    wait "$viewer" || status=$?
    viewer=""
    [[ $status == 0 ]] || fail "the viewer ended with $status"
    ! grep -Ei 'error' "$work/stderr" || fail "the viewer printed an error"
}

# The settings of the newest screenshot; all others go.
settings_now() {
    rm -f "$work"/out/tarn-*.png
    press F12
    until_true "the screenshot" picture_there
    photo=$(find "$work/out" -name 'tarn-*.png' | head -n 1)
    grep -ao '"msaa":[0-9]*' "$photo"
}
draws_own_settings() { [[ $(settings_now) == '"msaa":4' ]]; }

# A rate that no settings reach makes it draw with the cheapest while a key is held; what is left alone rises to its own
# settings and is averaged.
test_governor() {
    cat >"$work/ladder.toml" <<END
scene = "another"
size = "1x1"
machine = "none"
[base]
frame.msaa = 4
[[rungs]]
cost = 1.0
milliseconds = 2
flip = 0.1
wrong_hits = 0
[[rungs]]
cost = 0.5
milliseconds = 1
flip = 0.2
wrong_hits = 0
[rungs.settings]
frame.msaa = 1
END
    start_display
    trap 'stop_all; rm -rf "$work"' EXIT
    "$tarn" view "$scene" --camera shore --size 640x480 --time 0 --fps 1000 --ladder "$work/ladder.toml" \
        >"$work/stdout" 2>"$work/stderr" </dev/null &
    viewer=$!
    until_true "the window" xdotool search --onlyvisible --name '[Tt]arn'
    window=$(xdotool search --onlyvisible --name '[Tt]arn' | head -n 1)
    xdotool windowfocus "$window"
    until_true "the picture" shows_picture
    xdotool keydown --window "$window" e
    sleep 0.5
    ! draws_own_settings || fail "a thousand frames a second, with the scene's own settings"
    xdotool keyup --window "$window" e
    press 1
    until_true "the scene's own settings at rest" draws_own_settings
    sleep 3 # sixteen samples
    settings_now >/dev/null
    "$osmesa" render "$scene" --camera shore --size 640x480 --time 0 --set frame.scale=4 --out "$work/mean.png" >/dev/null
    "$compare" "$work/mean.png" "$photo" || fail "the refined picture is not like the supersampled one"
    press t
    xdotool key --window "$window" Escape
    local status=0
    wait "$viewer" || status=$?
    viewer=""
    [[ $status == 0 ]] || fail "the viewer ended with $status"
    ! grep -Ei 'error' "$work/stderr" || fail "the viewer printed an error"
}

# With no program in any cache: the window shows a draft, obeys, and is gone when it is closed.
test_building() {
    start_display
    trap 'stop_all; rm -rf "$work"' EXIT
    mkdir "$work/cache"
    MESA_SHADER_CACHE_DIR=$work/cache XDG_CACHE_HOME=$work/cache \
        "$tarn" view --size 320x240 >"$work/stdout" 2>"$work/stderr" </dev/null &
    viewer=$!
    until_true "the window" xdotool search --onlyvisible --name '[Tt]arn'
    window=$(xdotool search --onlyvisible --name '[Tt]arn' | head -n 1)
    xdotool windowfocus "$window"
    until_true "the draft" shows_draft
    press 2 w c r Tab Tab
    xdotool windowsize "$window" 400 200
    press h h Escape
    local i
    for ((i = 0; i < 100; i++)); do # ten seconds, for machines with much else to do
        xdotool search --onlyvisible --name '[Tt]arn' >/dev/null 2>&1 || break
        sleep 0.1
    done
    [[ $i -lt 100 ]] || fail "the window was still there ten seconds after it was closed"
    local status=0
    wait "$viewer" || status=$?
    viewer=""
    [[ $status == 0 ]] || fail "the viewer ended with $status when it was closed while programs were built"
    [[ ! -s $work/stderr ]] || fail "the viewer had something to say"
}

run_test "${5-viewer}"
