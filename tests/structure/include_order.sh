#!/usr/bin/env bash
# Reads every #include of a tree's lib/ and cli/ and reports those that break the architecture.
#
#   include_order.sh ROOT        prints "file:line: what is wrong" for each, and fails when there is one
#
# A room includes itself and the rooms before it in `order`, and no other room's detail/; shading uses only base and
# simd. Public headers name no library but GLM and tl::expected; only one module each uses OpenImageIO and OpenColorIO;
# only one file uses dlopen; no file includes <iostream>, because its static constructors would cost time at every start
# of the tool.
set -euo pipefail

root=${1:?"usage: include_order.sh ROOT"}
cd "$root"
[[ -d lib/gonio ]] || { echo "$root has no lib/gonio" >&2; exit 2; }

folders=(lib)
[[ -d cli ]] && folders+=(cli)
mapfile -d '' files < <(find "${folders[@]}" -type f \
    \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.cc' -o -name '*.inc' -o -name '*.ipp' \) -print0 |
    LC_ALL=C sort -z)
((${#files[@]})) || { echo "$root has no source file" >&2; exit 2; }

# The public headers; if a tree has no list, all headers outside detail/.
public_headers=
[[ -f lib/cmake/public-headers.txt ]] && public_headers=$(tr '\n' ' ' < lib/cmake/public-headers.txt)

awk -v public_headers="$public_headers" -v order='base simd profile web color shading shader light sky ibl table scene transport figures bake preview plot asset interchange measure media' '
    BEGIN {
        count = split(order, names, " ")
        for (i = 1; i <= count; ++i) rank[names[i]] = i
        listed = split(public_headers, headers, " ")
        for (i = 1; i <= listed; ++i) is_listed["lib/" headers[i]] = 1
    }
    function complain(what) {
        printf "%s:%d: %s\n", FILENAME, FNR, what
        bad = 1
    }
    FNR == 1 {
        part_count = split(FILENAME, part, "/")
        in_lib = part[1] == "lib" && part[2] != "python" && part[2] != "wasm" # no rooms: they use all of them, as the tool does
        room = in_lib && part[2] == "gonio" && part_count > 3 ? part[3] : ""
        public = listed ? FILENAME in is_listed : in_lib && FILENAME ~ /\.hpp$/ && FILENAME !~ /\/(detail|fit)\// &&
                 FILENAME !~ /^lib\/gonio\/media\/(image|color|pdf)\//
        ++files
        if (in_lib && !(room in rank) && FILENAME != "lib/gonio/gonio.hpp") complain("lies in no known room")
    }
    /^[ \t]*#[ \t]*include[ \t]*[<"]/ {
        ++includes
        target = $0
        sub(/^[ \t]*#[ \t]*include[ \t]*[<"]/, "", target)
        sub(/[>"].*/, "", target)
        if (in_lib && target ~ /(^|\/)\.\.(\/|$)/) complain("includes " target ": no path goes upwards")
        if (target ~ /\.\.\/lib\//) complain("includes " target ": the include root is lib/")
        if (target ~ /^(iostream|fstream)$/) complain("includes <" target ">")
        if (target ~ /^OpenImageIO\// && FILENAME !~ /^lib\/gonio\/media\/image\//)
            complain("includes " target ": OpenImageIO belongs to lib/gonio/media/image")
        if (target ~ /^OpenColorIO\// && FILENAME !~ /^lib\/gonio\/media\/color\//)
            complain("includes " target ": OpenColorIO belongs to lib/gonio/media/color")
        if (target ~ /^(cairo|ft2build|freetype)/ && FILENAME !~ /^lib\/gonio\/media\/pdf\//)
            complain("includes " target ": cairo and FreeType belong to lib/gonio/media/pdf")
        if (target == "dlfcn.h" && FILENAME != "lib/gonio/media/module.cpp")
            complain("includes dlfcn.h: dlopen stands in lib/gonio/media/module.cpp")
        if (!in_lib && target ~ /^gonio\/[a-z]+\/detail\//) complain("includes " target ": it belongs to its room alone")
        if (!in_lib) next
        if (target ~ /^(gonio\/)?cli\//) complain("includes " target ": the library knows nothing of the tool")
        if (target ~ /^CLI\//) complain("includes " target ": CLI11 belongs to the tool")
        if (public && target ~ /^(fmt|nlohmann|fast_float|pugixml)[.\/]|^pugixml|^(gtest|gmock|benchmark)\//)
            complain("includes " target ": a public header names std, GLM and tl::expected only")
        if (target ~ /^gonio\//) {
            split(target, to, "/")
            if (!(to[2] in rank))
                complain("includes " target ": there is no room " to[2])
            else if (to[3] == "detail" && to[2] != room)
                complain("includes " target ": what is in detail/ belongs to the room " to[2] " alone")
            else if (room != "" && rank[to[2]] > rank[room])
                complain("includes " target ": the room " room " stands before " to[2])
            else if (room == "shading" && to[2] !~ /^(base|simd|shading)$/)
                complain("includes " target ": shading is built on base and simd alone")
        }
    }
    END {
        if (!bad) printf "%d includes of %d files keep the order\n", includes, files
        exit bad
    }' "${files[@]}"
