#!/usr/bin/env bash
# The check of headers has to find faults: headers that need another one, that warn, or that are not there.
set -euo pipefail

compiler=${1:?"usage: headers_alone_self_test.sh COMPILER"}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

printf '#pragma once\n#include <string>\ninline std::string name() { return {}; }\n' > whole.hpp
printf '#pragma once\ninline std::string name() { return {}; }\n' > needs_string.hpp
printf '#pragma once\ninline int sign(unsigned x) { if (x < 0) return -1; int unused; return 1; }\n' > warns.hpp

printf 'whole.hpp\n' > list
bash "$here/headers_alone.sh" . list "$compiler" > /dev/null || { echo 'a whole header is refused'; exit 1; }
for faulty in needs_string.hpp warns.hpp missing.hpp; do
    printf 'whole.hpp\n%s\n' "$faulty" > list
    if said=$(bash "$here/headers_alone.sh" . list "$compiler"); then
        echo "$faulty passes"
        exit 1
    fi
    if [[ $said != *"$faulty does not compile by itself"* || $said == *'whole.hpp does not'* ]]; then
        echo "$faulty is not named: $said"
        exit 1
    fi
done
: > list
if bash "$here/headers_alone.sh" . list "$compiler" 2> /dev/null; then echo 'an empty list passes'; exit 1; fi
