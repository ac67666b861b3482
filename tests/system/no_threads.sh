#!/usr/bin/env bash
# If no thread can be created, numbers are the same as ever, and a picture is made or the tool reports at once why not.
#
#   tests/system/no_threads.sh GONIO MODULE…
#
# Needs root, which switches to another user: process limits do not apply to root itself.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [[ $(id -u) != 0 ]] || ! command -v setpriv > /dev/null; then
    echo "skipped: needs root and setpriv"
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/here"
cp -L "$@" "$work" # modules are found beside the tool
cp -rL "$root/profiles" "$work/here"
chmod -R a+rX "$work"
gonio=$work/$(basename "$1")
user=$((60000 + $$ % 5000)) # a user without processes, since those would count
chown "$user" "$work/here"
cd "$work/here"

# limited N COMMAND…: with at most N threads and processes; 124 if it takes longer than ten seconds.
limited() {
    local most=$1
    shift
    # shellcheck disable=SC2016 # the inner shell expands them
    timeout 10 setpriv --reuid="$user" --regid="$user" --clear-groups \
        bash -c 'ulimit -u "$1"; shift; exec "$@"' limited "$most" "$@"
}
fail() {
    echo "FAILED: $*" >&2
    exit 1
}
if limited 1 bash -c 'true & wait $!' 2> /dev/null; then
    echo "skipped: a limit on processes is not kept here"
    exit 77
fi

for arguments in "info --json profiles/*.ies" "check profiles/*.ldt" \
    "probe --shape sphere:r=10cm --intensity 800lm --grid -2,-2,0:4,0,0:0,4,0:60x60 --csv --position 0,0,2"; do
    status=0 limited_status=0
    # shellcheck disable=SC2086
    "$gonio" $arguments -j 8 > "$work/expected" 2>&1 || status=$?
    # shellcheck disable=SC2086
    limited 1 "$gonio" $arguments -j 8 > "$work/printed" 2>&1 || limited_status=$?
    ((status < 2)) || fail "gonio $arguments: exit $status"
    ((status == limited_status)) || fail "gonio $arguments: exit $limited_status with one thread, $status with many"
    cmp "$work/expected" "$work/printed" || fail "gonio $arguments prints something else with one thread"
done

"$gonio" preview profiles/downlight.ies -s 32x32 -o "$work/expected.png"
for most in 1 2 3 4 5 6 7 8 9 12 64; do
    for threads in 1 8; do
        rm -f out.png
        status=0
        limited $most "$gonio" preview profiles/downlight.ies -s 32x32 -j $threads -o out.png > "$work/said" 2>&1 ||
            status=$?
        what="preview -j $threads with at most $most threads: exit $status: $(cat "$work/said")"
        case $status in
        0)
            cmp out.png "$work/expected.png" || fail "$what: another picture"
            ((most > 4)) || fail "$what: OpenImageIO starts four"
            ;;
        3)
            grep -q '^error\[FIL0106\]: no threads can be started' "$work/said" || fail "$what"
            grep -q '^hint: .*ulimit -u' "$work/said" || fail "$what"
            [[ $(wc -l < "$work/said") == 2 ]] || fail "$what"
            [[ ! -e out.png ]] || fail "$what: there is a file"
            ((most < 64)) || fail "$what"
            ;;
        *) fail "$what" ;;
        esac
    done
done
# Workers of a batch that load the module while other workers are still being started.
mkdir out
chown "$user" out
for most in 2 5 6 7 8 9 10 11 12 13 14 16 20; do
    status=0
    limited $most "$gonio" bake profiles/*.ies -s 16x8 --overwrite -j 8 -O out > "$work/said" 2>&1 || status=$?
    ((status == 0 || status == 3)) || fail "bake -j 8 with at most $most threads: exit $status: $(cat "$work/said")"
done
echo "passed"
