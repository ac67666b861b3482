#!/usr/bin/env bash
# Builds the packages from nothing and installs them into a bare Debian 12.
#
#   tests/package/run.sh           in an empty build folder
#   tests/package/run.sh --keep    in the build folder as it is
#
# 1. lintian finds no error, and the dependencies are those that are listed here.
# 2. The tool alone is installed into a bare root within 15 s and 20 MB, and runs the examples of the README that need no
#    picture. A picture names the package that is missing.
# 3. With gonio-media it runs all examples of the README. The module for Python computes, and makes a picture.
# 4. The archive runs them too, from a folder with an odd name; the development package serves a consumer.
#
# Needs root (for the bare root) and Debian's archive. Installs lintian and mmdebstrap. Takes about ten minutes, most of
# them for compiling.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/tests/package
build=$root/build/package
cd "$root"
bash cli/install-dependencies.sh --packages
((EUID == 0)) || { echo 'run.sh: run as root: a root folder is made' >&2; exit 3; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
say() { printf '\n== %s\n' "$*"; }

say 'build'
[[ ${1:-} == --keep ]] || rm -rf "$build"
cmake --preset package > /dev/null
cmake --build --preset package --parallel "$(nproc)" | tail -n 1
rm -f "$build"/*.deb "$build"/*.tar.xz
cpack --preset package > "$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }
debs=("$build"/*.deb)
archives=("$build"/*.tar.xz)
((${#debs[@]} == 5 && ${#archives[@]} == 1)) || { printf 'not the packages that were expected:\n%s\n' "${debs[@]}" "${archives[@]}"; exit 1; }
(cd "$build" && ls -l -- *.deb *.tar.xz)

say 'lintian'
lintian --allow-root --fail-on error "${debs[@]}"

say 'dependencies'
for deb in "${debs[@]}"; do
    echo "$(dpkg-deb --field "$deb" Package): $(dpkg-deb --field "$deb" Depends)"
done | sed -E 's/ \([^)]*\)//g' | LC_ALL=C sort | tee "$work/depends"
diff "$here/depends.txt" "$work/depends"

# What the examples need: the pages, the profiles, and the script that compares.
tar --create --file "$work/examples.tar" README.md profiles tests/golden/run.sh
cp "$build"/gonio_*.deb "$work/tool.deb"
cp "$build"/gonio-media_*.deb "$work/media.deb"
cp "$build"/python3-gonio_*.deb "$work/python.deb"

say 'a bare root'
# shellcheck disable=SC2016 # mmdebstrap expands it
mmdebstrap --quiet --variant=minbase \
    --customize-hook="copy-in '$work/examples.tar' '$work/tool.deb' '$work/media.deb' '$work/python.deb' '$here/in_bare_root.sh' '$here/in_bare_root.py' /tmp" \
    --customize-hook='chroot "$1" bash /tmp/in_bare_root.sh' \
    --customize-hook='copy-out /tmp/figures.txt '"'$work'" \
    bookworm "$work/root" > "$work/mmdebstrap.log" 2>&1 || { tail -n 60 "$work/mmdebstrap.log"; exit 1; }
cat "$work/figures.txt"

say 'the archive'
odd="$work/an odd folder, (moved)"
mkdir "$odd"
tar --extract --file "${archives[0]}" --directory "$odd"
mv "$odd"/gonio-* "$odd/here it is"
bash tests/golden/run.sh "$odd/here it is/bin/gonio" README.md
echo 'the archive runs the examples of the README'

say 'the development package'
for deb in "${debs[@]}"; do dpkg-deb --extract "$deb" "$work/unpacked"; done
cmake -S tests/consumer/installed -B "$work/consumer" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=$work/unpacked/usr" \
    -DCMAKE_LIBRARY_ARCHITECTURE="$(dpkg-architecture --query DEB_HOST_MULTIARCH)" "-DPROFILE=$root/profiles/downlight.ies" > /dev/null
cmake --build "$work/consumer" --parallel "$(nproc)" | tail -n 1
ctest --test-dir "$work/consumer" --output-on-failure --no-tests=error | tail -n 4
