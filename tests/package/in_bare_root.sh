#!/usr/bin/env bash
# The part of run.sh that runs in the bare root: installs the tool alone, then with the modules, and runs the README's
# examples each time; then the module for Python. Writes what it measured into /tmp/figures.txt.
set -euo pipefail

export DEBIAN_FRONTEND=noninteractive
cd /tmp
mkdir examples
tar --extract --file examples.tar --directory examples --no-same-owner
installed() { dpkg-query --show --showformat '${Installed-Size}\n' | awk '{ sum += $1 } END { print sum }'; }

before=$(installed)
begin=$(date +%s%N)
apt-get -qq install -y --no-install-recommends ./tool.deb < /dev/null
ms=$((($(date +%s%N) - begin) / 1000000))
kib=$(($(installed) - before))
echo "the tool alone: installed in $ms ms, $kib KiB with its dependencies" | tee figures.txt
((ms < 15000 && kib < 20000))

# Blocks of the README in which no command writes a picture.
awk '/^```console$/ { block = $0; inside = 1; next }
     inside { block = block "\n" $0
              if ($0 ~ /^\$ gonio (bake|preview)/) pictures = 1
              if ($0 == "```") { if (!pictures) print block; inside = 0; pictures = 0 }
              next }
     { print }' examples/README.md > examples/numbers.md
grep -c '^\$ ' examples/numbers.md | sed 's/$/ commands of the README ran without gonio-media/' | tee -a figures.txt
bash examples/tests/golden/run.sh /usr/bin/gonio examples/numbers.md

status=0
gonio preview examples/profiles/downlight.ies --stage floor -o picture.png 2> said || status=$?
tee -a figures.txt < said
((status == 5))
grep -q 'install the package gonio-media' said

begin=$(date +%s%N)
apt-get -qq install -y --no-install-recommends ./media.deb < /dev/null
echo "gonio-media: installed in $((($(date +%s%N) - begin) / 1000000)) ms, $(($(installed) - before - kib)) KiB with its \
dependencies" | tee -a figures.txt
grep -c '^\$ ' examples/README.md | sed 's/$/ commands of the README ran with it/' | tee -a figures.txt
bash examples/tests/golden/run.sh /usr/bin/gonio examples/README.md

begin=$(date +%s%N)
apt-get -qq install -y --no-install-recommends ./python.deb < /dev/null
echo "python3-gonio: installed in $((($(date +%s%N) - begin) / 1000000)) ms" | tee -a figures.txt
(cd examples && python3 /tmp/in_bare_root.py) | tee -a figures.txt
