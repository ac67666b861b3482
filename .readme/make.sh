#!/usr/bin/env bash
# Makes the pictures of the README and its gallery again.
#
#   .readme/make.sh GONIO
#
# page.png is the screenshot of the stage that tests/page/run.sh takes, 800 pixels wide and in 256 colours, dithered.
# Every picture must stay below 120 kB: a checkout carries them for ever. Dither does not compress.
set -euo pipefail

gonio=$(realpath "${1:?"usage: make.sh GONIO"}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
here=.readme
unset OCIO

"$gonio" plot profiles/wall-washer.ies profiles/downlight.ies --per-klm -s 560x420 -o $here/polar.svg
"$gonio" cct FL2 --quality -o $here/color-vectors.svg -s 480x480
"$gonio" cct 1000K:10000K:20K --versus krystek,materialx,usd,helland -s 900x144 -o $here/strip.png
"$gonio" preview profiles/wall-washer.ies --rotate 90deg -s 320x260 --look falsecolour -o $here/falsecolour.png
"$gonio" preview profiles/downlight.ies -s 320x260 --look isolux -o $here/isolux.png
"$gonio" preview profiles/downlight.ies -s 320x260 --look luminance -o $here/luminance.png
"$gonio" plot --diagram falloff --shape sphere:r=5cm --shape disk:r=30cm --shape rect:w=1.2m,h=30cm \
    --intensity 800lm --range 12m --distance 0.05m:15m -s 480x400 -o $here/falloff.png
"$gonio" preview profiles/downlight.ies -s 480x360 -o $here/floor.png
# The stages, each under a light that suits it.
stage() { # STAGE LIGHT...
    local name=$1
    shift
    "$gonio" preview "$@" --stage "$name" -s 240x180 -o "$here/stage-$name.png"
}
stage wall profiles/accent.ies
stage corridor profiles/pendant.ies
stage street profiles/street.ldt --color 3000K
stage spheres --shape rect:w=1.2m,h=30cm --intensity 3000lm
stage card profiles/flood.ies
stage room --shape tube:r=2cm,l=1.2m --intensity 2500lm --color 4000K
day=daylight:place=52.52/13.405,time=2026-06-21T10:00+02:00
"$gonio" preview --sky $day --stage street --show-sky -s 320x240 -o $here/day.png
"$gonio" preview --sky $day,weather=overcast --stage spheres -s 320x240 -o $here/overcast.png
"$gonio" preview --sky cie:12,sun=120/25,horizontal=20klx --stage spheres --camera 0,-3,1.4 --target 0,0,0.3 \
    --material ue4:base=0.9,metallic=1,roughness=0.4 --compare exact,split-sum -s 220x165 -o $here/sky-methods.png > /dev/null
"$gonio" preview --stage room --emits sphere=800lm,color=2700K --material 'box=lambert:albedo=rgb(0.4,0.03,0.03),coat=1' \
    -s 320x240 -o $here/globe.png
"$gonio" preview profiles/bare-tube.ies --position 0,0,1.2 --stage room -s 320x240 -o $here/luminaire.png
"$gonio" preview --sheet profiles/{accent,batwing,pendant}.ies --columns 3 -s 110x132 \
    -o $here/sheet.png
"$gonio" preview --shape tube:r=2cm,l=1.2m --intensity 2500lm --fov 26deg --target 0.2,0,0.6 \
    --compare exact,frostbite -s 220x165 -o $here/methods.png > /dev/null
"$gonio" preview --shape sphere:r=8cm --intensity 900lm --material ue4:base='rgb(0.9,0.6,0.3)' \
    --fov 14deg --target 0.42,-0.28,0.36 \
    --sweep roughness=0.15:0.75:4 --sweep metallic=0,1 -s 130x110 -o $here/sweep.png
"$gonio" sheet profiles/batwing.ldt -o $here/data-sheet.svg

for picture in "$here"/*.png "$here"/*.svg; do
    bytes=$(stat -c %s "$picture")
    ((bytes < 120000)) || { echo "$picture has $bytes bytes, more than 120 kB" >&2; exit 1; }
done
