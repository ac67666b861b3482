#!/usr/bin/env bash
# Checks that no file under version control names a folder of a particular machine.   machine_paths.sh ROOT
set -euo pipefail
cd "${1:?"usage: machine_paths.sh ROOT"}"
# Outside a checkout (a source archive) there are no files to list with git.
if ! git rev-parse --is-inside-work-tree > /dev/null 2>&1; then
    echo 'skipped: no git checkout here'
    exit 77
fi
# A folder directly below the root, as on people's and build machines; the character class prevents a match in this
# file.
if git grep -nIE '(^|[^A-Za-z0-9_./-])/(wor[k]|roo[t]|hom[e]|User[s])/[A-Za-z0-9_.-]+' -- .; then
    echo 'the lines above name a folder of one machine'
    exit 1
fi
echo 'no file names a folder of one machine'
