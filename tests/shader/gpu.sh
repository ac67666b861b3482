#!/usr/bin/env bash
# Runs what `gonio shader` prints on this machine's GPU, by OpenGL ES without a window, and prints errors and times
# (gpu.cpp). On a machine without a GPU Mesa runs it on the processor, and there are no times.
#
#   bash tests/shader/gpu.sh [BUILD] [--no-times]
#   bash tests/shader/gpu.sh [BUILD] --pack FOLDER
#
# BUILD is a configured build folder (build/release). --pack puts into FOLDER what another machine with a GPU needs, which
# has neither compilers nor packages: both programs, their libraries, and `run.sh` that runs them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build/release
pack=
options=()
while (($#)); do
    case $1 in
    --no-times) options+=("$1") ;;
    --pack)
        pack=${2:?--pack needs a folder}
        shift
        ;;
    -*)
        echo "gpu.sh: unknown option '$1' (there are: --no-times, --pack FOLDER)" >&2
        exit 2
        ;;
    *) build=$(realpath "$1") ;;
    esac
    shift
done
[[ -z $pack || ${#options[@]} -eq 0 ]] || { echo 'gpu.sh: --no-times is for run.sh in the packed folder' >&2; exit 2; }
work=$build/shader
mkdir -p "$work"

missing=()
[[ -e /usr/include/EGL/egl.h ]] || missing+=(libegl-dev)
[[ -e /usr/include/GLES3/gl31.h ]] || missing+=(libgles-dev)
if ((${#missing[@]} > 0)); then
    sudo=()
    [[ $(id -u) -eq 0 ]] || sudo=(sudo)
    "${sudo[@]}" apt-get update -qq
    "${sudo[@]}" apt-get install -y --no-install-recommends "${missing[@]}" libegl-mesa0 libgl1-mesa-dri > /dev/null
fi

cmake --build "$build" --target gonio-shader-cases
"${CXX:-g++}" -std=c++20 -O2 "$root/tests/shader/gpu.cpp" -o "$work/gonio-shader-gpu" -lEGL -lGLESv2

if [[ -z $pack ]]; then
    rm -rf "$work/made"
    "$build/tests/gonio-shader-cases" "$work/made" "$root/tests/shader/by_hand"
    exec "$work/gonio-shader-gpu" "$work/made" "${options[@]}"
fi

mkdir -p "$pack/lib"
cp -r "$build/tests/gonio-shader-cases" "$work/gonio-shader-gpu" "$root/tests/shader/by_hand" "$pack"
# All libraries except the C library and the loaders of OpenGL, which belong to the other machine's driver.
ldd "$build/tests/gonio-shader-cases" "$work/gonio-shader-gpu" | awk '/=> \// { print $3 }' | sort -u |
    grep -vE '/(libc|libm|libpthread|libdl|librt|ld-linux[^/]*|libEGL|libGLESv2|libGLdispatch)\.so' | xargs -r cp -t "$pack/lib"
cat > "$pack/run.sh" << 'END'
#!/usr/bin/env bash
# Arguments go to gonio-shader-gpu.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
export LD_LIBRARY_PATH=$PWD/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
./gonio-shader-cases "$made" by_hand
./gonio-shader-gpu "$made" "$@"
END
chmod +x "$pack/run.sh"
