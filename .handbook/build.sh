#!/usr/bin/env bash
# Builds the handbook from the pages of the tree and the comments of the public headers, checks it, and leaves it in
# build/handbook/site: open index.html there, no server is needed. Fails on any warning of MkDocs or Doxygen, a public
# type, function, constant or macro without a comment, a link or an anchor that leads nowhere, and anything that a page
# would load from elsewhere. The same tree gives the same bytes.
#
#   bash .handbook/build.sh           with build/release/cli/gonio, which is compiled if it is not there
#   bash .handbook/build.sh GONIO     with this tool, which prints the page of options
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
bash cli/install-dependencies.sh --handbook

gonio=${1:-build/release/cli/gonio}
if [[ ! -x $gonio && $# -eq 0 ]]; then
    bash cli/install-dependencies.sh
    cmake --preset release > /dev/null
    cmake --build --preset release --parallel "$(nproc)" --target gonio-tool
fi

work=$root/build/handbook
rm -rf "$work"
mkdir -p "$work/pages"
# Debian's Python has MkDocs; another one may come first in PATH.
export PATH=/usr/bin:$PATH PYTHONDONTWRITEBYTECODE=1 LC_ALL=C.UTF-8
# MkDocs writes the time of the build into its pages otherwise.
export SOURCE_DATE_EPOCH=0

version=$(sed -n 's/^#define GONIO_VERSION_STRING "\(.*\)"/\1/p' lib/gonio/base/version.hpp)
{
    cat .handbook/api/Doxyfile
    echo "PROJECT_NUMBER = $version"
    echo "INPUT = .handbook/api/pages.dox $(sed 's#^#lib/#' lib/cmake/public-headers.txt | tr '\n' ' ')"
    echo "FILTER_PATTERNS = *.dox=cat"
    echo "OUTPUT_DIRECTORY = $work/pages"
    echo "GENERATE_TAGFILE = $work/api.tags"
    echo "WARN_LOGFILE = $work/doxygen.log"
} > "$work/Doxyfile"
doxygen "$work/Doxyfile"
# The name of a member and the sentence of its type may say everything.
if grep -vE 'Member .* of (class|struct) .* is not documented\.$' "$work/doxygen.log"; then
    echo 'build.sh: the comments of these public headers are wrong or missing' >&2
    exit 1
fi

python3 .handbook/api/name_folders.py "$work/pages/api"
python3 .handbook/gather.py "$root" "$work/api.tags" "$work/pages"
python3 .handbook/options.py "$gonio" > "$work/pages/options.md"
cp -R .handbook/theme "$work/theme"
cp .handbook/mkdocs.yml "$work/mkdocs.yml"
mkdocs build --quiet --strict --config-file "$work/mkdocs.yml"
rm -f "$work"/site/sitemap.xml "$work"/site/sitemap.xml.gz
python3 .handbook/search_index.py "$work/site" "$work/api.tags"
python3 .handbook/check_site.py "$work/site"
if grep -rlF "$root" "$work/site"; then
    echo 'build.sh: these pages name the folder of this checkout' >&2
    exit 1
fi
echo "The handbook: $work/site/index.html"
