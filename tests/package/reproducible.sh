#!/usr/bin/env bash
# Builds the packages twice, in two folders with different paths, and compares every byte of the library, the tool, the
# modules and the packages.
#
#   tests/package/reproducible.sh                 builds both
#   tests/package/reproducible.sh build/package   compares this build of the same tree with one that it makes
#
# Takes the time of a build for each: a compiler cache would hide what is looked for, and is not used.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset CMAKE_CXX_COMPILER_LAUNCHER SOURCE_DATE_EPOCH

other="$work/two with a longer name/deeper"
places=("$other")
if (($#)); then
    first=$(realpath "$1")
    [[ -f $first/CMakeCache.txt ]] || { echo "reproducible.sh: $1 is not a build folder" >&2; exit 2; }
else
    first=$work/one/build/package
    places=("$work/one" "$other")
fi
for place in "${places[@]}"; do # both now, before anybody edits the tree
    mkdir -p "$place"
    git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents --target-directory "$place"
    [[ ! -e .git ]] || cp -a .git "$place" # the tool names its commit
done
for place in "${places[@]}"; do
    echo "building in $place"
    (
        cd "$place"
        # The second one in another zone and language. Not with another umask: cpack writes the one that it had into
        # the outermost layer of a Debian package.
        [[ $place == "$work/one" ]] || export TZ=Pacific/Auckland LC_ALL=C.UTF-8
        cmake --preset package > /dev/null
        cmake --build --preset package --parallel "$(nproc)" | tail -n 1
        cpack --preset package > cpack.log 2>&1 || { cat cpack.log; exit 1; }
    )
done

differ=0
compared=0
while IFS= read -r file; do
    compared=$((compared + 1))
    cmp "$first/$file" "$other/build/package/$file" || differ=$((differ + 1))
done < <(cd "$first" && {
    ls -- *.deb *.tar.xz
    find lib cli -type f \( -name '*.a' -o -name '*.so*' -o -name gonio -o -name '*.1' -o -name 'completion.*' \)
} | LC_ALL=C sort)
echo "$compared files compared, $differ differ"
((compared > 30 && differ == 0))
