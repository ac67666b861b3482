#!/usr/bin/env bash
# clang-tidy on lib/ and cli/.
#
#   bash tests/tidy.sh            what has changed since the last landed state
#   bash tests/tidy.sh --all      every file (half an hour on two cores), with clang's analyzer, which takes two fifths of it
#   bash tests/tidy.sh FILE…      these
#
# The last landed state is $GONIO_TIDY_SINCE; else origin/main, if the checkout is ahead of it; else the newest commit
# that is three hours older than HEAD. A changed header is checked through its own source, or else through the first
# file that includes it, and a template of kernels as the file written for AVX2 or NEON. A file in which only comments
# changed, or whether its names are exported, is not checked again. Without history, every file is checked.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
build=build/tidy

# Without precompiled headers: they are g++'s, and would hide a missing #include.
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBUILD_TESTING=OFF \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON > /dev/null

checks='-clang-analyzer-*'
files=()
landed() {
    local base
    if [[ -n ${GONIO_TIDY_SINCE:-} ]]; then
        git rev-parse --verify "$GONIO_TIDY_SINCE^{commit}"
        return
    fi
    if base=$(git merge-base HEAD origin/main 2> /dev/null) && [[ $base != "$(git rev-parse HEAD)" ]]; then
        echo "$base"
        return
    fi
    base=$(git rev-list -1 --before=$(($(git show -s --format=%ct HEAD) - 3 * 3600)) HEAD)
    echo "$base"
}
# The file that CMake wrote from a template of kernels, for a set that every compiler for this kind of machine supports.
written() { # TEMPLATE
    local stem=$build/${1%.cpp.in} set
    for set in avx2 neon; do
        if [[ -f ${stem}_$set.cpp ]]; then echo "${stem}_$set.cpp"; return; fi
    done
}
# The source that includes a header: its own, or the first that includes it.
reader() { # HEADER
    local own=${1%.hpp}.cpp template
    if [[ -f $own ]]; then echo "$own"; return; fi
    template=$(git grep -lF "${1#lib/}" -- 'lib/*.cpp.in' | head -n 1 || true)
    if [[ -n $template ]]; then written "$template"; return; fi
    git grep -lF "${1#lib/}" -- 'lib/*.cpp' 'cli/*.cpp' | head -n 1 || true
}
# The code of a file without its comments, except those that clang-tidy reads, and without visibility.
code_of() { # on stdin
    local text
    text=$(grep -v '^#pragma GCC visibility' || true)
    printf '%s' "$text" | grep -c NOLINT || true
    printf '%s' "$text" | g++ -fpreprocessed -dD -E -P -x c++ - 2> /dev/null | tr -d '[:space:]'
}
only_comments_differ() { # FILE SINCE
    git cat-file -e "$2:$1" 2> /dev/null && cmp -s <(git show "$2:$1" | code_of) <(code_of < "$1")
}
every_file() {
    find lib cli -name '*.cpp'
    find "$build/lib" -name 'kernels*.cpp'
}

if [[ ${1:-} == --all ]]; then
    checks=''
    mapfile -t files < <(every_file)
elif (($#)); then
    files=("$@")
elif ! git rev-parse --verify --quiet HEAD > /dev/null || ! since=$(landed) || [[ -z $since ]]; then
    echo 'no history to compare with: every file is read'
    mapfile -t files < <(every_file)
else
    echo "changed since $(git show -s --format='%h %s' "$since"):"
    while IFS= read -r file; do
        if only_comments_differ "$file" "$since"; then continue; fi
        case $file in
        *.cpp) files+=("$file") ;;
        *.cpp.in) mapfile -t -O "${#files[@]}" files < <(written "$file") ;;
        *.hpp) mapfile -t -O "${#files[@]}" files < <(reader "$file") ;;
        esac
    done < <(git diff --name-only --diff-filter=d "$since" -- lib cli; git ls-files --others --exclude-standard -- lib cli)
fi

# Files of no target (another machine's kernels) have no compile flags.
known=()
while IFS= read -r file; do
    if grep -qF "\"file\": \"$root/$file\"" "$build/compile_commands.json"; then known+=("$file"); fi
done < <(((${#files[@]} == 0)) || printf '%s\n' "${files[@]}" | sort -u)
echo "${#known[@]} files"
((${#known[@]})) || exit 0

# The output of clang-tidy for one file is collected, and shown only if there is any.
tidy_one() { # FILE
    local said status=0
    said=$(clang-tidy-14 --quiet ${checks:+"--checks=$checks"} --extra-arg=-Wno-unknown-warning-option \
        --extra-arg=-Wno-unused-command-line-argument -p "$build" "$1" \
        2> /dev/null) || status=$?
    ((status == 0)) || printf '%s\n' "$said"
    return "$status"
}
export -f tidy_one
export checks build
# shellcheck disable=SC2016 # the inner shell expands it
printf '%s\0' "${known[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'tidy_one "$1"' _
