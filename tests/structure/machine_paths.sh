#!/usr/bin/env bash
# Whether a file under version control names a folder of somebody's machine.   machine_paths.sh ROOT
set -euo pipefail
cd "${1:?"usage: machine_paths.sh ROOT"}"
# Outside a checkout (a source archive) there is nothing to ask git about.
if ! git rev-parse --is-inside-work-tree > /dev/null 2>&1; then
    echo 'skipped: no git checkout here'
    exit 77
fi
# A folder right below the root, as people and build machines have them; the class keeps this file from finding itself.
if git grep -nIE '(^|[^A-Za-z0-9_./-])/(wor[k]|roo[t]|hom[e]|User[s])/[A-Za-z0-9_.-]+' -- .; then
    echo 'the lines above name a folder of one machine'
    exit 1
fi
echo 'no file names a folder of one machine'
