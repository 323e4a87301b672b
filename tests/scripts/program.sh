#!/usr/bin/env bash
# The command line from outside: exit status, the one line of an error, and files that are whole or not there.
# program.sh PROJECT PROGRAM TEST
set -euo pipefail
project=$1 tarn=$2
source "$project/tests/scripts/lib.sh"

pool=$project/tests/image/scenes/checkered_bed.toml

# The first camera of a scene file.
camera_of() { sed -n '/^\[\[cameras\]\]/,$ s/^name = "\(.*\)"/\1/p' "$1" | head -n 1; }

test_help() {
    call 0 --help
    local command
    for command in view render reference compare disparity bench trade tune budget explain maps options info; do
        grep -qw "$command" "$work/stdout" || fail "--help does not name $command"
    done
    call 0 render --help
    grep -q -- --camera "$work/stdout" || fail "render --help does not name --camera"
}

test_device() {
    call 0 info --device soft "$pool"
    grep -Eq 'device +software' "$work/stdout" || fail "info does not say on what it draws"
    refuse 1 "there is no device 'abacus' to draw on; there (is|are) .*software" render --device abacus "$pool" --out a.png
    refuse 2 'without a window' view --device soft "$pool"
}

test_version() {
    call 0 --version
    grep -Eq '[0-9]+\.[0-9]+\.[0-9]+' "$work/stdout" || fail "--version prints no version"
}

test_wrong_usage() {
    refuse 2 'rendr.*render' rendr
    refuse 2 '--sise.*--size' render "$pool" --sise 8x8 --out a.png
    refuse 2 'out' render "$pool"
    refuse 2 'size' render "$pool" --size 8 --out a.png
    refuse 2 'size' render "$pool" --size 0x8 --out a.png
    refuse 2 'size' render "$pool" --size 8x-8 --out a.png
    refuse 2 'size' render "$pool" --size 99999x99999 --out a.png
    refuse 2 'time' render "$pool" --time soon --out a.png
    refuse 2 'time' render "$pool" --time nan --out a.png
    refuse 2 'fov' render "$pool" --fov 200 --out a.png
    refuse 2 'eye' render "$pool" --eye 1,2 --out a.png
    refuse 2 'eye' render "$pool" --eye 1,2,inf --out a.png
    refuse 2 'same point' render "$pool" --eye 1,2,3 --target 1,2,3 --out a.png
    refuse 2 'frensel.*' render "$pool" --view frensel --out a.png
    refuse 2 'frames' render "$pool" --frames 0 --out a_%04d.png
    refuse 2 '%' render "$pool" --frames 3 --out a.png
    refuse 2 'table 4.*2.*3' bench "$pool" --table 4
    refuse 2 'table.*vary' bench "$pool" --table 2 --vary refraction.steps=1
    refuse 2 'table.*flight' bench "$pool" --table 2 --flight
    refuse 2 'error.*tarn reference' render "$pool" --error path --out a.png
    refuse 2 'fresnel' render "$pool" --error colour --reference a.exr --out a.png
    refuse 2 'out' trade "$pool"
    refuse 2 'refraction\.stpes.*refraction\.steps' trade "$pool" --out a --sweep refraction.stpes=1:8
    refuse 2 'refraction\.steps.*64' trade "$pool" --out a --sweep refraction.steps=1:65
    refuse 2 'method.*planar, iterative' trade "$pool" --out a --sweep refraction.method=planar,magic
    refuse 2 'grid.*sweep' trade "$pool" --out a --grid
    refuse 2 'presets-only.*sweep' trade "$pool" --out a --presets-only --sweep refraction.steps=1:2
    refuse 2 'write-ladder.*plan of its own' trade "$pool" --out a --write-ladder b.toml --sweep refraction.steps=1:2
    refuse 2 'write-ladder.*presets-only' trade "$pool" --out a --write-ladder b.toml --presets-only
    refuse 2 'shard.*write-ladder' trade "$pool" --out a --write-ladder b.toml --shard 1/2
    refuse 2 'shard.*1/4' trade "$pool" --out a --shard 3/2
    refuse 2 'abvoe.*above' trade "$pool" --out a --views abvoe
    refuse 2 'method.*planar, iterative' trade "$pool" --out a --sweep heights.march=classic@refraction.method=magic
    refuse 2 'maps.*--out DIR' maps "$pool"
    refuse 2 'max-error.*budget-ms' tune "$pool"
    refuse 2 'abvoe.*above' tune "$pool" --max-error 0.1 --camera abvoe
    refuse 2 'samples' budget "$pool" --samples 0
    refuse 2 'abvoe.*above' budget "$pool" --camera abvoe
    refuse 2 'reference.*stereo.output=pair' disparity "$pool"
    refuse 2 'of colour.*refraction, reflection' disparity "$pool" --reference a.exr --of colour
    refuse 2 'stereo\.output.*side_by_side' render "$pool" --set stereo.output=beside --out a.png
    refuse 2 'sweep stereo' trade "$pool" --out a --sweep stereo.output=off,pair
    refuse 2 'hihg.*high' render "$pool" --preset hihg --out a.png
    refuse 2 'png' render "$pool" --out a.bmp
    refuse 2 'png' render "$pool" --out picture
    only_in_out
}

test_unknown_option_key() {
    refuse 2 'refraction\.stpes.*refraction\.steps' render "$pool" --set refraction.stpes=3 --out a.png
    refuse 2 'refraction\.steps' render "$pool" --set refraction.steps=many --out a.png
    refuse 2 'refraction\.steps.*64' render "$pool" --set refraction.steps=65 --out a.png
    refuse 2 'refraction\.method.*iterative' render "$pool" --set refraction.method=magic --out a.png
    refuse 2 'refraction\.steps' render "$pool" --set refraction.steps --out a.png
    only_in_out
}

test_error_map() {
    local truth=$work/truth.exr
    call 0 reference "$pool" --size 40x30 --samples 1 --photons 10000 --time 0.5 --out "$truth"
    call 0 render "$pool" --error refraction --reference "$truth" --out "$work/map.png"
    grep -q 'full colour at 0.5 m' "$work/stdout" || fail "the map's scale is not stated"
    grep -q 'refraction.median' "$work/stdout" || fail "the figures are not printed"
    call 0 render "$pool" --error fresnel --reference "$truth" --error-scale 0.2 --out "$work/map.exr" --json -
    grep -q '"time": 0.5' "$work/stdout" || fail "the reference's time is not taken"
    grep -q '"scale": 0.2' "$work/stdout" || fail "the scale is not in the JSON"
    [[ -s $work/map.png && -s $work/map.exr ]] || fail "a map is missing"
    refuse 1 'size 8x8.*40x30' render "$pool" --error path --reference "$truth" --size 8x8 --out a.png
    refuse 1 'map\.exr' render "$pool" --error path --reference "$work/map.exr" --out a.png
    refuse 1 'nowhere\.exr' render "$pool" --error path --reference nowhere.exr --out a.png
    # The truth of another scene, or of other water, is none.
    sed 's/^ior = .*//; s/^\[water\]/[water]\nior = 1.2/' "$pool" >other.toml
    cp "${pool%/*}/checker.png" .
    refuse 1 'truth\.exr: shows another scene than .*other\.toml: .*the water differ' \
        render other.toml --error path --reference "$truth" --out a.png
}

# Two eyes: one picture twice as wide, one anaglyph, or two files; the reference's pair, and the disparity between both.
test_stereo() {
    local beside=(--set stereo.output=side_by_side) pair=(--set stereo.output=pair)
    call 0 render "$pool" --size 40x30 "${beside[@]}" --out a.png
    [[ $(od -An -tx1 -j16 -N8 a.png | tr -d ' \n') == 000000500000001e ]] || fail "both eyes beside each other are not 80x30"
    call 0 render "$pool" --size 40x30 --set stereo.output=anaglyph --view normals --out b.png
    [[ $(od -An -tx1 -j16 -N8 b.png | tr -d ' \n') == 000000280000001e ]] || fail "the anaglyph is not 40x30"
    call 0 render "$pool" --size 40x30 --frames 2 "${pair[@]}" --out 'c_%d.png'
    [[ $(grep -c '' "$work/stdout") == 4 ]] || fail "not one line for each of two eyes at two times"
    call 0 render "$pool" --size 40x30 "${pair[@]}" --check --json d.json --out d.exr
    grep -q '"d-right.exr"' d.json || fail "the JSON does not name the right eye's file"
    only_in_out a.png b.png c_0-left.png c_0-right.png c_1-left.png c_1-right.png d-left.exr d-right.exr d.json
    ! cmp -s c_0-left.png c_0-right.png || fail "both eyes see the same"
    refuse 1 'a\.exr.*anaglyph.*pair' render "$pool" --size 40x30 --set stereo.output=anaglyph --out a.exr

    local truth=$work/truth.exr few=(--size 40x30 --samples 1 --photons 10000)
    refuse 1 'truth\.exr.*one eye.*pair' reference "$pool" "${few[@]}" "${beside[@]}" --out "$truth"
    call 0 reference "$pool" "${few[@]}" "${pair[@]}" --out "$truth"
    [[ -s $work/truth-left.exr && -s $work/truth-right.exr && ! -e $truth ]] || fail "not one reference for each eye"
    call 0 disparity "$pool" --reference "$truth" --out "$work/map.png" --json "$work/e.json"
    grep -Eq 'median +[0-9.e-]+ px' "$work/stdout" || fail "the disparity error is not printed"
    grep -q '"reflection"' "$work/e.json" || fail "the JSON does not tell of what is mirrored"
    [[ -s $work/map.png ]] || fail "there is no map"
    call 0 render "$pool" --error refraction --reference "$work/truth-right.exr" --out "$work/map.png"
    [[ ! -s $work/stderr ]] || fail "the right eye's reference is not taken as it is"
    refuse 1 'stereo.output.*reference' disparity "$pool" "${pair[@]}" --reference "$truth"
    refuse 1 'one eye' render "$pool" "${beside[@]}" --error refraction --reference "$work/truth-left.exr" --out a.png
    refuse 1 'one eye' budget "$pool" "${pair[@]}"
    cp "$work/truth-left.exr" "$work/truth-right.exr"
    refuse 1 'truth-right.*not the right eye' disparity "$pool" --reference "$truth"
}

test_unknown_camera() {
    refuse 2 'abvoe.*above' render "$pool" --camera abvoe --out a.png
    only_in_out
}

test_missing_scene() {
    refuse 1 'nowhere\.toml' render nowhere.toml --out a.png
    refuse 1 'nowhere\.obj' info nowhere.obj
    mkdir "$work/folder.toml"
    refuse 1 'folder\.toml' render "$work/folder.toml" --out a.png
    only_in_out
}

test_bad_scene() {
    printf '[water]\nlevle = 1.0\n' >"$work/scene.toml"
    refuse 1 'scene\.toml:2.*levle.*level' render "$work/scene.toml" --out a.png
    printf '[water\n' >"$work/scene.toml"
    refuse 1 'scene\.toml:1' render "$work/scene.toml" --out a.png
    printf '[options]\nrefraction.stpes = 1\n[[primitives]]\nname = "a"\nkind = "box"\n' >"$work/scene.toml"
    refuse 1 'scene\.toml:2.*refraction\.stpes.*refraction\.steps' render "$work/scene.toml" --out a.png
    head -c 4096 /dev/urandom >"$work/scene.obj"
    refuse 1 'scene\.obj' render "$work/scene.obj" --out a.png
    only_in_out
}

test_missing_output_folder() {
    refuse 1 'no/such/folder' render "$pool" --out no/such/folder/a.png
    refuse 1 'no/such/folder' render "$pool" --all-cameras --out no/such/folder
    refuse 1 'no/such/folder' info "$pool" --json no/such/folder/a.json
    mkdir a.png
    refuse 1 'a\.png' render "$pool" --out a.png
    only_in_out
}

# Root may write where it likes: there only a folder of the kernel's refuses.
test_unwritable_output() {
    local folder=$work/closed
    mkdir "$folder"
    chmod a-w "$folder"
    [[ $(id -u) -ne 0 ]] || folder=/proc
    refuse 1 "$folder" render "$pool" --size 16x16 --out "$folder/a.png"
    refuse 1 "$folder" info "$pool" --json "$folder/a.json"
    [[ $(id -u) -eq 0 || -z $(ls -A "$folder") ]] || fail "something was left in $folder"
}

# A frame that is drawn smaller or larger gives a picture of its size, and the old name of the option still works.
test_scale() {
    for scale in 0.5 0.67 1.5; do
        call 0 render "$pool" --camera above --size 41x31 --set frame.scale=$scale --check --out a.png
        [[ ! -s $work/stderr ]] || fail "scale $scale says something on standard error"
        [[ $(od -An -tu1 -j16 -N8 a.png | tr -s ' ') == " 0 0 0 41 0 0 0 31" ]] || fail "scale $scale gives another size"
        call 0 render "$pool" --camera above --size 41x31 --set frame.scale=$scale --out a.exr
    done
    call 0 render "$pool" --camera above --size 41x31 --set frame.supersampling=2 --out old.png
    grep -q 'frame.supersampling is now called frame.scale' "$work/stderr" || fail "nothing is said of the old name"
    call 0 render "$pool" --camera above --size 41x31 --set frame.scale=2 --out new.png
    call 0 compare old.png new.png --max-flip 0
    refuse 2 'frame.scale must be 0.25 to 8' render "$pool" --set frame.scale=0.2 --out b.png
    only_in_out a.png a.exr old.png new.png
}

# The error in time of targets that are not drawn in every frame, by tools/intervals.
test_intervals() {
    FRAMES=3 PROGRAM=$tarn "$project/tools/intervals" 2 "$project/tests/image/scenes/waves.toml" --size 40x30 \
        >"$work/stdout" 2>"$work/stderr" || fail "tools/intervals ended with $?"
    for row in refraction reflection caustics all; do
        grep -Eq "^$row +[0-9]\.[0-9]{5} +[0-9]\.[0-9]{5}$" "$work/stdout" || fail "there is no row '$row'"
    done
    only_in_out
}

# A picture that does not fit on the disk is not there at all, and the one it would replace is still whole.
test_full_disk() {
    call 0 render "$pool" --size 16x16 --out a.png
    local before status=0
    before=$(cksum <a.png)
    (
        ulimit -f 8
        trap '' XFSZ
        "$tarn" render "$pool" --size 640x480 --set frame.msaa=1 --out a.png >"$work/stdout" 2>"$work/stderr" </dev/null
    ) || status=$?
    [[ $status == 1 ]] || fail "a picture that cannot be written whole ended with $status"
    [[ $(grep -c '' "$work/stderr") == 1 ]] || fail "the error is not one line"
    [[ $(cksum <a.png) == "$before" ]] || fail "the old picture is damaged"
    only_in_out a.png
}

test_standard_output_closed() {
    [[ -w /dev/full ]] || fail "this system has no /dev/full"
    local status=0
    "$tarn" options >/dev/full 2>"$work/stderr" </dev/null || status=$?
    [[ $status == 1 ]] || fail "results that cannot be written ended with $status"
    [[ $(grep -c '' "$work/stderr") == 1 ]] || fail "the error is not one line"
}

test_picture() {
    call 0 render "$pool" --camera above --size 64x48 --check --out a.png
    [[ $(cat "$work/stdout") == *a.png ]] || fail "the picture's name is not printed"
    [[ ! -s $work/stderr ]] || fail "a good run says something on standard error"
    # The PNG header: width 64, height 48.
    [[ $(od -An -tx1 -j16 -N8 a.png | tr -d ' \n') == 0000004000000030 ]] || fail "a.png is not 64x48"
    call 0 render "$pool" --eye 0,5,1 --target 0,0,0 --fov 40 --size 32x32 --out b.exr
    [[ $(od -An -tx1 -N4 b.exr | tr -d ' \n') == 762f3101 ]] || fail "b.exr is no OpenEXR file"
    only_in_out a.png b.exr
}

test_repeats_itself() {
    local i
    for i in 1 2; do
        call 0 render "$project/tests/image/scenes/waves.toml" --time 1.25 --size 64x48 --out "$i.png"
    done
    cmp 1.png 2.png || fail "two runs made two pictures"
}

# The governor is the viewer's alone: no picture and no figure depends on the time that a frame takes.
test_no_governor() {
    call 0 render "$pool" --size 64x48 --out a.exr
    call 0 render "$pool" --size 64x48 --set frame.target_ms=0.01 --out b.exr
    call 0 render "$pool" --size 64x48 --frames 3 --set frame.target_ms=0.01 --out 'c_%d.png'
    call 0 render "$pool" --size 64x48 --frames 3 --set frame.target_ms=0 --out 'd_%d.png'
    local i
    for i in 0 1 2; do call 0 compare "c_$i.png" "d_$i.png" --max-flip 0; done # their headers name the settings
    call 0 compare a.exr b.exr --max-flip 0
    call 0 bench "$pool" --size 64x48 --frames 3 --warm-up 0 --vary frame.target_ms=0.01 --json "$work/bench.json"
    local found half
    mapfile -t found < <(grep -o '"triangles": [0-9]*' "$work/bench.json")
    half=$(((${#found[@]} - 3) / 2)) # after both stand the frame and the two passes of the dry scene
    [[ $half -gt 3 && ${found[*]:0:half} == "${found[*]:half:half}" ]] || fail "bench draws something else with a target: ${found[*]}"
}

test_sequence() {
    local waves=$project/tests/image/scenes/waves.toml
    call 0 render "$waves" --size 32x24 --time 1 --frames 3 --fps 4 --out 'wave_%04d.png'
    only_in_out wave_0000.png wave_0001.png wave_0002.png
    call 0 render "$waves" --size 32x24 --time 1.25 --out one.png
    ! cmp -s wave_0000.png wave_0001.png || fail "the waves do not move"
    cmp wave_0001.png one.png || fail "the second picture is not that of 1.25 s"
}

test_all_cameras() {
    call 0 render "$pool" --size 32x24 --all-cameras --out .
    [[ $(grep -c '' "$work/stdout") == 4 ]] || fail "not one line for each of the four cameras"
    [[ $(find . -name '*.png' | grep -c '') == 4 ]] || fail "not four pictures"
}

test_json() {
    call 0 info "$pool" --json -
    grep -q '"cameras"' "$work/stdout" || fail "info does not tell the cameras"
    call 0 render "$pool" --size 32x24 --json a.json --out a.png
    grep -q '"triangles"' a.json || fail "render's JSON does not count triangles"
    call 0 bench "$pool" --size 32x24 --frames 3 --json b.json
    grep -q '"renderer"' b.json && grep -q '"median' b.json || fail "bench's JSON lacks the machine or the median"
    grep -q '"leaves_out"' b.json || fail "bench's JSON lacks the plan"
    call 0 bench "$pool" --size 32x24 --frames 3 --flight --rules --json d.json
    grep -q '^full costs .* x planned' "$work/stdout" || fail "bench --rules does not compare the full frame"
    grep -q 'cull_chunks  *3 of 3' "$work/stdout" || fail "bench --rules does not tell how often a rule applied"
    grep -q '"total_wall"' d.json || fail "bench's JSON lacks the ratio of the whole flight"
    grep -q '"geometry_bytes": [1-9]' b.json && grep -q '"resident_bytes": [1-9]' b.json &&
        grep -q '"file_bytes": [1-9]' b.json ||
        fail "bench's JSON does not tell the memory"
    call 0 bench "$pool" --size 32x24 --frames 2 --yardstick --json y.json
    grep -q '^dry: .* x yardstick' "$work/stdout" || fail "bench --yardstick does not tell the frame in yardsticks"
    grep -q '^  calls .* draw calls' "$work/stdout" || fail "bench does not tell how often a frame calls OpenGL"
    grep -q '"yardsticks"' y.json || fail "bench's JSON lacks the yardsticks"
    call 0 bench "$pool" --size 32x24 --interactive --seconds 0.3 --json i.json
    grep -q '^input to picture, ms' "$work/stdout" || fail "bench --interactive does not tell the delay of inputs"
    grep -q '"input_to_picture_ms"' i.json || fail "bench --interactive's JSON lacks the delay of inputs"
    call 0 bench "$pool" --size 32x24 --frames 2 --table 2 --json c.json
    grep -q '^| caustics off ' "$work/stdout" || fail "bench --table 2 has no row without caustics"
    grep -q '"ours_over_thesis"' c.json || fail "the table's JSON does not compare with the thesis"
    only_in_out a.json a.png b.json c.json d.json i.json y.json
}

test_budget() {
    call 0 budget "$project/tests/image/scenes/waves.toml" --size 16x12 --samples 1 --photons 10000 --preset thesis \
        --json a.json
    local row
    for row in 'tessellation' "moved camera's coverage" 'intersection' 'reflection lookup' "Schlick's Fresnel" \
        'caustics map' 'shadow map' 'clip planes' 'refraction texture' 'sum of the parts' 'all at once' 'unexplained'; do
        grep -Eq "^  $row +" "$work/stdout" || fail "the budget has no row '$row'"
        [[ $row == *' of the parts' || $row == 'all at once' || $row == unexplained ]] || grep -q "\"$row\"" a.json ||
            fail "the budget's JSON has no row '$row'"
    done
    refuse 1 'checkered_bed.*no water' budget "$pool" --set water.enabled=false
    refuse 1 'no/such/folder' budget "$pool" --json no/such/folder/a.json
    only_in_out a.json
}

# Maps of heights written, given back, and marched through instead of those that would be drawn.
test_maps() {
    local scenes=$project/tests/image/scenes marched=(--set refraction.method=raycast --set reflection.method=raycast)
    call 0 maps "$scenes/post.toml" --set heights.map_size=128 --out m --json j.json
    only_in_out m/bed.exr m/above_water.exr j.json
    [[ $(cat "$work/stdout") == $'m/bed.exr\nm/above_water.exr' ]] || fail "the files are not named"
    grep -q '"resolution": 128' j.json || fail "the JSON does not tell the maps' size"
    { cat "$scenes/post.toml"; printf '[maps.bed]\nfile = "m/bed.exr"\n[maps.above_water]\nfile = "m/above_water.exr"\n'; } >given.toml
    call 0 explain given.toml "${marched[@]}"
    grep -Eq "heights .*bed\.exr gives the map 'bed'; above_water\.exr gives" "$work/stdout" || fail "explain does not name the maps"
    call 0 render "$scenes/post.toml" --size 80x60 "${marched[@]}" --set heights.map_size=128 --out a.png
    call 0 render given.toml --size 80x60 "${marched[@]}" --check --out b.png
    [[ ! -s $work/stderr ]] || fail "something was said of maps of the same light"
    call 0 compare a.png b.png --max-flip 0.0001
    call 0 render given.toml --size 80x60 "${marched[@]}" --set water.absorption=3 --out c.png
    grep -q 'bed.exr: the water changed' "$work/stderr" || fail "nothing was said of maps of another light"

    head -c 500 m/bed.exr >broken.exr
    sed 's:m/bed:broken:' given.toml >broken.toml
    refuse 1 'broken\.toml:[0-9]+: broken\.exr: .*(damaged|not a readable)' render broken.toml --out d.png
    sed 's:m/bed:m/above_water:' given.toml >other.toml
    refuse 1 'other\.toml:[0-9]+: m/above_water\.exr: has no channel height' render other.toml --out d.png
    sed 's:m/bed:none:' given.toml >missing.toml
    refuse 1 'none\.exr: no such picture' render missing.toml --out d.png
    refuse 1 'has no water' maps "$scenes/materials.toml" --out n
    [[ ! -e d.png ]] || fail "a refused picture is there"
}

# A small trade of a scene with waves, sun and caustics: measured, told, and not measured twice.
test_trade() {
    local waves=$project/tests/image/scenes/waves.toml march='heights.march=classic,pyramid@refraction.method=raycast'
    call 0 trade "$waves" --out t --size 48x36 --samples 2 --frames 2 --times 0.5 --sweep water.surface_steps=0,1 \
        --sweep refraction.steps=1,4 --sweep "$march"
    local name
    for name in results.csv results.json report.html; do
        [[ -s t/$name ]] || fail "there is no t/$name"
    done
    grep -q 'surface_steps=0' t/results.csv || fail "the table does not have the swept option"
    grep -Eq '"flip": 0\.[0-9]+' t/results.json || fail "no mean FLIP between 0 and 1 was measured"
    grep -Eq '"median_ms": [0-9.]+' t/results.json || fail "no cost was measured"
    cp t/results.csv first.csv
    local column
    column=$(head -1 t/results.csv | tr ',' '\n' | grep -nx 'refraction.missed' | cut -d: -f1)
    grep '^[0-9a-f]*,"heights.march=classic, refraction.method=raycast",sweep,mean' t/results.csv | cut -d, -f$((column + 1)) |
        grep -Eq '^0\.[0-9]*[1-9]' || fail "what the classic march steps over is not counted"
    grep '^[0-9a-f]*,refraction.method=raycast,sweep,mean' t/results.csv | cut -d, -f"$column" | grep -qx 0 ||
        fail "the pyramid march stepped over something"
    grep -q 'heights.march (refraction.method=raycast)' t/report.html || fail "the report does not show the marches"
    grep -q 'refraction.missed' t/report.html || fail "the report does not show what is stepped over"
    call 0 trade "$waves" --out t --size 48x36 --samples 2 --frames 2 --times 0.5 --sweep water.surface_steps=0,1 \
        --sweep refraction.steps=1,4 --sweep "$march"
    cmp -s first.csv t/results.csv || fail "a second run did not take up the first one's results"
    refuse 1 'fresh' trade "$waves" --out t --size 40x30 --samples 2 --frames 2 --times 0.5
    cmp -s first.csv t/results.csv || fail "a refused run changed the results"
}

test_compare() {
    call 0 render "$pool" --size 64x48 --out a.png
    call 0 render "$pool" --size 64x48 --set water.enabled=false --out b.png
    call 0 compare a.png a.png --max-flip 0
    grep -Eq 'mean FLIP +0\.000000' "$work/stdout" || fail "a picture differs from itself"
    call 0 compare a.png b.png --out heat.png --json c.json
    grep -Eq 'mean FLIP +0\.[0-9]*[1-9]' "$work/stdout" || fail "a pool without water looks the same"
    grep -q 'RMSE' "$work/stdout" && grep -q '"rmse"' c.json || fail "there is no RMSE"
    call 1 compare a.png b.png --max-flip 0
    grep -q 'max-flip' "$work/stderr" && grep -q 'mean FLIP' "$work/stdout" || fail "the limit was passed unsaid"
    only_in_out a.png b.png heat.png c.json
}

# The exposure comes from the header: as linear files, two renderings look as they do as PNG.
test_compare_linear() {
    local extension set
    for extension in png exr; do
        for set in true false; do
            call 0 render "$pool" --size 64x48 --set frame.exposure=0.5 --set "water.enabled=$set" \
                --set glow.enabled=false --set frame.tone_curve=reinhard --out "$set.$extension"
        done
        call 0 compare "true.$extension" "false.$extension"
        grep -o 'mean FLIP  *[0-9.]\{6\}' "$work/stdout" >"$work/$extension"
    done
    grep -Eq 'exposure +0\.5 +from true\.exr' "$work/stdout" || fail "the header's exposure was not used"
    grep -q 'reinhard' "$work/stdout" || fail "the header's tone curve was not used"
    cmp "$work/png" "$work/exr" || fail "FLIP of linear files is $(cat "$work/exr"), of shown ones $(cat "$work/png")"
}

test_compare_bad_input() {
    call 0 render "$pool" --size 16x16 --out a.png
    call 0 render "$pool" --size 16x12 --out b.png
    refuse 2 'two pictures' compare a.png
    refuse 2 'tone-curve' compare a.png a.png --tone-curve film
    refuse 2 'png' compare a.png a.png --out heat.bmp
    refuse 1 'nowhere\.png' compare a.png nowhere.png
    refuse 1 'b\.png.*16x12.*a\.png.*16x16' compare a.png b.png --out heat.png
    refuse 1 'no/such/folder' compare a.png a.png --out no/such/folder/heat.png
    refuse 1 'no/such/folder' compare a.png a.png --json no/such/folder/c.json
    only_in_out a.png b.png
}

# Two folders of pictures, as continuous integration compares them.
test_compare_folders() {
    local picture
    mkdir -p "goldens & <co>/sub" new/sub
    for picture in a sub/b; do
        call 0 render "$pool" --size 64x48 --out "new/$picture.png"
        cp "new/$picture.png" "goldens & <co>/$picture.png"
    done
    call 0 compare "goldens & <co>" new --junit "$work/good.xml" --report "$work/report"
    grep -q '^2 pictures: 2 good$' "$work/stdout" || fail "it does not say that both are good"
    call 0 render "$pool" --size 64x48 --set water.enabled=false --out new/a.png
    mv new/sub/b.png "new/b'\"<&>.png"
    call 1 compare "goldens & <co>/" new/ --junit "$work/bad.xml" --report "$work/report/" --json "$work/bad.json" --max-flip 0.5
    grep -q '^3 pictures: 1 different, 1 missing, 1 extra$' "$work/stdout" || fail "it does not count what is wrong"
    grep -q '3 of 3 pictures fail.*report/index\.html' "$work/stderr" || fail "it does not say where the report is"
    [[ $(ls "$work/report/pictures" | wc -l) == 5 ]] || fail "the report has $(ls "$work/report/pictures")"
    only_in_out "goldens & <co>/a.png" "goldens & <co>/sub/b.png" new/a.png "new/b'\"<&>.png"
    command -v python3 >/dev/null || return 0
    python3 - "$work/good.xml" "$work/bad.xml" <<'END' || fail "the results are not those of two folders"
import sys, xml.etree.ElementTree as xml
good, bad = (xml.parse(file).getroot().find("testsuite") for file in sys.argv[1:])
assert good.get("failures") == "0" and [case.get("name") for case in good] == ["a.png", "sub/b.png"]
assert bad.get("name") == "goldens & <co>/" and bad.get("tests") == bad.get("failures") == "3"
found = {case.get("name"): case.find("failure").get("type") for case in bad}
assert found == {"a.png": "different", "sub/b.png": "missing", "b'\"<&>.png": "extra"}, found
END
}

test_compare_folders_bad_input() {
    mkdir a b
    refuse 1 'a: holds no pictures' compare a b --report r
    call 0 render "$pool" --size 16x16 --out a/p.png
    cp a/p.png b/p.png
    refuse 2 'a/p\.png: is no folder' compare a/p.png b
    refuse 2 'the same folder' compare a ./b/../a/
    refuse 2 '--report a/r: ' compare a b --report a/r
    refuse 2 '--report \.: ' compare a b --report .
    refuse 2 'b/p\.png.*picture' compare a b --junit b/p.png
    refuse 2 '--out' compare a b --out map.png
    refuse 2 '--tolerance is for two folders' compare a/p.png b/p.png --tolerance 3
    refuse 2 '--fraction 2' compare a b --fraction 2
    refuse 1 'no/such' compare a b --junit no/such/junit.xml
    refuse 1 'no/such' compare a b --report no/such/report
    only_in_out a/p.png b/p.png
}

test_options() {
    call 0 options
    grep -q 'refraction.steps' "$work/stdout" || fail "options does not list refraction.steps"
    grep -Eq '^path-length +water +m +' "$work/stdout" || fail "options does not list the debug views"
    call 0 options --json
    [[ $(head -c 1 "$work/stdout") =~ [[{] ]] || fail "options --json prints no JSON"
    local count
    count=$(grep -c '"key"' "$work/stdout")
    call 0 options --markdown
    [[ $(grep -c '^| `[a-z]*\.[a-z_]*` | ' "$work/stdout") == "$count" ]] || fail "options --markdown has not all $count options"
    # A cell more or less would break its table.
    ! sed '/^## Debug views/,$d' "$work/stdout" | grep '^|' | sed 's/\\|//g' | grep -v '^|\([^|]*|\)\{6\}$' ||
        fail "a row has not six cells"
    ! sed '1,/^## Debug views/d' "$work/stdout" | grep '^|' | sed 's/\\|//g' | grep -v '^|\([^|]*|\)\{4\}$' ||
        fail "a debug view has not four cells"
    refuse 2 'markdown' options --markdown --json
}

# A ladder is measured, written and read; a broken one is refused before a window opens.
test_ladder() {
    local waves=$project/tests/image/scenes/waves.toml
    call 0 trade "$waves" --out t --size 32x24 --samples 1 --frames 1 --views "$(camera_of "$waves")" --write-ladder l.toml
    grep -q '^\[\[rungs\]\]' l.toml || fail "the ladder has no rungs"
    cp l.toml first.toml
    call 0 trade "$waves" --out t --size 32x24 --samples 1 --frames 1 --views "$(camera_of "$waves")" --write-ladder l.toml
    cmp l.toml first.toml || fail "what was measured once was measured again"
}

test_presets() {
    local preset
    for preset in fast low medium high best thesis; do
        call 0 render "$pool" --size 32x24 --preset "$preset" --out "$preset.png"
    done
    call 0 render "$pool" --size 32x24 --preset auto --out auto.png
    [[ $(grep -c 'preset auto: .* draws on the processor, so the preset is fast' "$work/stderr") == 1 ]] ||
        fail "--preset auto does not say what it chose"
    cmp auto.png fast.png || fail "on the processor --preset auto is not fast"
    call 0 explain "$pool" --preset thesis --set refraction.target_size=128
    grep -q '^refraction .*128x128' "$work/stdout" || fail "--set does not win over --preset"
}

test_explain() {
    call 0 explain "$project/tests/image/scenes/furnace.toml"
    grep -qi refraction "$work/stdout" || fail "explain does not speak of refraction"
}

test_no_window() {
    refuse 1 'window' view "$pool"
}

test_scene_with_spaces() {
    mkdir "$work/a folder"
    cp "$project/tests/image/scenes/"*.{toml,png} "$work/a folder/"
    call 0 render "$work/a folder/checkered_bed.toml" --size 16x16 --out "$work/out/a picture.png"
    only_in_out "a picture.png"
}

run_test "$3"
