#!/usr/bin/env bash
# Installs the Debian packages that gonio is built with; only those that are missing, and nothing when none is.
#
#   cli/install-dependencies.sh           what building the library and the tool needs
#   cli/install-dependencies.sh --tests   … and running tests/run.sh
#   cli/install-dependencies.sh --bench   … and the benchmark programs (-DGONIO_BENCH=ON)
#   cli/install-dependencies.sh --ci      … and running .ci/run (those, Python, clang, its sanitizers, clang-tidy, ccache)
#   cli/install-dependencies.sh --python  … and the module for Python with its tests (-DGONIO_PYTHON=ON)
#   cli/install-dependencies.sh --handbook   what building the handbook needs (.handbook/build.sh), and nothing else
#   cli/install-dependencies.sh --wasm       what building the library for WebAssembly and its tests need (lib/wasm/build.sh),
#                                            and nothing else
#   cli/install-dependencies.sh --packages   what building the packages and trying them needs (tests/package/run.sh)
#
# Needs root or sudo, and only when something is missing.
set -euo pipefail

packages=(
    g++ cmake ninja-build pkg-config
    libopenimageio-dev libopencolorio-dev libpng-dev libopenexr-dev libdeflate-dev libcairo2-dev fonts-dejavu-core
    libcli11-dev libfmt-dev libexpected-dev libglm-dev nlohmann-json3-dev libpugixml-dev
)
test_packages=(libgtest-dev python3-openimageio jq man-db mandoc bash-completion zsh fish)
bench_packages=(libbenchmark-dev libfast-float-dev)
package_packages=(dpkg-dev lintian mmdebstrap)
python_packages=(pybind11-dev python3-dev python3-numpy python3-pytest mypy)
handbook_packages=(mkdocs doxygen python3-pygments)
ci_packages=(ccache clang clang-format-14 clang-tidy-14 libclang-rt-14-dev llvm-14 shellcheck)

wasm_packages=(cmake ninja-build emscripten nodejs libfmt-dev libexpected-dev libglm-dev nlohmann-json3-dev googletest)

# The handbook is made of text alone, and Emscripten has its own C++ library.
[[ $* == --handbook || $* == --wasm ]] && packages=()

for argument in "$@"; do
    case $argument in
    --tests) packages+=("${test_packages[@]}") ;;
    --bench) packages+=("${test_packages[@]}" "${bench_packages[@]}") ;;
    --ci) packages+=("${test_packages[@]}" "${bench_packages[@]}" "${python_packages[@]}" "${ci_packages[@]}"
        "${handbook_packages[@]}") ;;
    --python) packages+=("${test_packages[@]}" "${python_packages[@]}") ;;
    --handbook) packages+=("${handbook_packages[@]}") ;;
    --wasm) packages+=("${wasm_packages[@]}") ;;
    --packages) packages+=("${package_packages[@]}" "${python_packages[@]}") ;;
    -h | --help)
        sed -n '2,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
        exit 0
        ;;
    *)
        echo "install-dependencies.sh: unknown option '$argument' (there are: --tests, --bench, --ci, --python, --handbook," \
            '--wasm, --packages)' >&2
        exit 2
        ;;
    esac
done

if ! command -v dpkg-query > /dev/null; then
    echo "install-dependencies.sh: this is not Debian; install the equivalents of: ${packages[*]}" >&2
    exit 5
fi

missing=()
for package in "${packages[@]}"; do
    state=$(dpkg-query --show --showformat '${db:Status-Abbrev}' "$package" 2> /dev/null || true)
    [[ $state == ii* ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo > /dev/null; then
        echo "install-dependencies.sh: run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 3
    fi
    as_root=(sudo)
fi
echo "installing: ${missing[*]}" >&2
# apt's report goes to stderr; the variables reach apt through sudo only on its own command line.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=120 -o Acquire::Retries=3)
"${apt[@]}" update >&2
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" < /dev/null >&2
