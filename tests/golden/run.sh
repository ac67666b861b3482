#!/usr/bin/env bash
# Runs the commands of a transcript and compares their output with the output in the transcript.
#
#   tests/golden/run.sh GONIO FILE            fails and shows the difference
#   tests/golden/run.sh GONIO FILE --update   rewrites FILE with what is printed now
#
# FILE is a transcript, or Markdown in which blocks fenced with ```console are transcripts. In a transcript a line
# "$ COMMAND" is a command for bash; below it are the lines of its stdout, then those of its stderr after "! ", then
# "[exit N]" if N is not 0. A line "% …" is a comment. In Markdown a block fenced with ```json room.json, or another
# language and name, is that file, and the commands below it find it in their folder. The commands run one after the other in one new folder that
# contains a copy of profiles/ (a link would lead rigs out of their folder), with the tool as `gonio`; the real path of
# the folder never appears.
set -euo pipefail

gonio=$(realpath "$1")
file=$(realpath "$2")
update=${3:-}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/here"
ln -s "$gonio" "$work/bin/gonio"
cp -R "$root/profiles" "$work/here/profiles"
export PATH="$work/bin:$PATH" NO_COLOR=1 LC_ALL=C.UTF-8
unset OCIO

inside=0
markdown=0
[[ $file == *.md ]] && markdown=1
written='' # the file that the lines of a block are written to
named_block='^```[a-z]+ ([A-Za-z0-9._-]+)$'
skipping=0 # skips the old output of a command that was run
run() {
    local status=0
    (cd "$work/here" && bash -c "$1") > "$work/out" 2> "$work/err" < /dev/null || status=$?
    cat "$work/out"
    # Without this, a last line without a newline would absorb the next line.
    [[ -s $work/out && $(tail -c 1 "$work/out" | wc -l) -eq 0 ]] && echo
    sed 's/^/! /' "$work/err"
    ((status == 0)) || echo "[exit $status]"
}

while IFS= read -r line || [[ -n $line ]]; do
    if ((markdown)); then
        if [[ $written == '' && $line =~ $named_block ]]; then
            written=$work/here/${BASH_REMATCH[1]}
            : > "$written"
            printf '%s\n' "$line"
            continue
        elif [[ $written != '' ]]; then
            if [[ $line == '```' ]]; then written=''; else printf '%s\n' "$line" >> "$written"; fi
            printf '%s\n' "$line"
            continue
        fi
        if [[ $line == '```console' ]]; then
            inside=1 skipping=0
        elif [[ $line == '```'* ]]; then
            inside=0 skipping=0
        fi
        ((inside)) || { printf '%s\n' "$line"; continue; }
        [[ $line == '```console' ]] && { printf '%s\n' "$line"; continue; }
    fi
    if [[ $line == '$ '* ]]; then
        printf '%s\n' "$line"
        run "${line#'$ '}"
        skipping=1
    elif [[ $line == '% '* && $markdown == 0 ]]; then
        printf '%s\n' "$line" # a comment between commands
        skipping=0
    elif ((!skipping)); then
        printf '%s\n' "$line"
    fi
done < "$file" > "$work/now"

if [[ $update == --update ]]; then
    cp "$work/now" "$file"
    exit 0
fi
diff -u --label expected --label printed "$file" "$work/now" || {
    echo "the output differs from $(basename "$file"); where the new one is right: $0 GONIO FILE --update" >&2
    exit 1
}
