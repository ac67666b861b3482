#!/usr/bin/env bash
# Makes the luminaires of a folder from their formulas with the tool's own commands.
#
#   profiles/make.sh GONIO FOLDER
#
# The bytes are the same on every run: a test compares them with the committed files.
set -euo pipefail
if (($# != 2)); then
    echo "usage: profiles/make.sh GONIO FOLDER" >&2
    exit 2
fi
gonio=$1
cd -- "$2"

texts=(--keyword "TEST=computed, see README.md" --keyword TESTLAB=none --keyword ISSUEDATE=2026-11-20
       --keyword "MANUFAC=gonio project")
made=("${texts[@]}" --keyword "OTHER=written by gonio make, Apache-2.0")

# The same light as LM-63 and as EULUMDAT, which has no place for some of the texts.
both() { # NAME DIALECT SHAPE OPTIONS…
    local name=$1 dialect=$2 shape=$3
    shift 3
    "$gonio" make "$shape" -q --number "$name" "${made[@]}" "$@" --dialect "$dialect" -o "$name.ies"
    "$gonio" make "$shape" -q --number "$name" "${texts[@]}" "$@" -o "$name.ldt"
}

both downlight lm-63-2002 downlight --gammas 1deg --lumens 1200lm --watts 12W --opening disk:d=15cm \
    --name "Recessed LED downlight, 30 degree beam" --lamp "LED module" --keyword _CCT=3000 --keyword _CRI=90
both wall-washer lm-63-2002 wall-washer --lumens 2500lm --watts 24W --opening rect:w=30cm,l=10cm \
    --name "LED wall-washer, the wall towards C0" --lamp "LED module" --keyword _CCT=3500 --keyword _CRI=90
both bare-tube lm-63-2019 tube --gammas 2deg --lumens 3350lm --watts 36W --opening tube:d=26mm,l=1.226m \
    --name "Bare T8 fluorescent tube, its axis along C0" --lamp "T8 36 W" --keyword _CCT=4000 --keyword _CRI=80
both batwing portable batwing:reach=50deg,across=30deg --planes 15deg --lumens 4000lm --watts 32W \
    --opening rect:w=10cm,l=120cm --name "Aisle light, even on the floor" --lamp "LED module"
both street lm-63-1995 street --planes 10deg --lumens 6000lm --watts 45W --opening rect:w=20cm,l=40cm \
    --name "Street light, the street towards C90" --lamp "LED module"
both pendant lm-63-1995 cosine:power=1.5,up=0.5 --gammas 5deg --lumens 2000lm --watts 18W --opening disk:d=40cm \
    --name "Pendant, a third of its light upwards" --lamp "LED module" --absolute

# A type B table, measured as floodlights are; what holds type C alone has it resampled.
"$gonio" make batwing:reach=30deg,across=15deg,edge=1 -q --type B --planes 5deg --gammas 5deg --lumens 12000lm --watts 95W \
    --opening rect:w=30cm,l=20cm --name "Floodlight, wide and low" --lamp "LED module" --number flood "${made[@]}" \
    -o flood.ies
"$gonio" edit flood.ies -q --resample 7.5deg,2.5deg -o flood.ldt

# No symmetry: a wall-washer that was not hung straight.
"$gonio" make wall-washer -q --planes 15deg --gammas 5deg --lumens 1500lm --watts 15W --opening disk:d=10cm \
    --name "Accent light, turned by 30 degrees" --lamp "LED module" --number accent "${texts[@]}" -o straight.ies
for name in accent.ies accent.ldt; do
    "$gonio" edit straight.ies -q --rotate 30deg -o "$name"
done
rm straight.ies

# Every one of them as TM-33, and in each edition and dialect of LM-63.
luminaires=(*.ies)
for file in "${luminaires[@]}"; do
    "$gonio" convert "$file" -q -o "${file%.ies}.xml"
done
for dialect in lm-63-1995 lm-63-2002 lm-63-2019 portable; do
    mkdir -p "$dialect"
    for file in "${luminaires[@]}"; do
        if [[ $dialect/$file == portable/flood.ies ]]; then
            "$gonio" edit "$file" -q --resample 7.5deg,2.5deg --dialect portable -o portable/flood.ies
        else
            "$gonio" convert "$file" -q --dialect "$dialect" -o "$dialect/$file"
        fi
    done
done
