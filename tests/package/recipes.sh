#!/usr/bin/env bash
# Checks the vcpkg port and the Conan recipe as far as that is possible without vcpkg and Conan: both run against
# stand-ins for the functions that they call, with Debian's libraries. The stand-ins configure what the recipe asks for,
# from the files that it exports; the port is also installed from a build that exists, and a consumer is built with it.
#
#   tests/package/recipes.sh
#
# Takes minutes when nothing is compiled yet.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo '== the version is gonio'\''s'
version=$(sed -nE 's/.*GONIO_VERSION_STRING "([0-9.]+)".*/\1/p' lib/gonio/base/version.hpp)
[[ $(jq -r .version .packaging/vcpkg/gonio/vcpkg.json) == "$version" ]]

echo '== vcpkg'
cat > "$work/port.cmake" << 'CMAKE'
cmake_minimum_required(VERSION 3.25)
set(PORT gonio)
get_filename_component(CURRENT_PORT_DIR "${PORTFILE}" DIRECTORY)
set(CURRENT_PACKAGES_DIR "${WORK}/packages/gonio")
set(CURRENT_INSTALLED_DIR "${WORK}/installed")
function(vcpkg_check_features)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "OUT_FEATURE_OPTIONS" "FEATURES")
    list(GET arg_FEATURES 1 option)
    set(${arg_OUT_FEATURE_OPTIONS} "-D${option}=OFF" PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
    execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S "${arg_SOURCE_PATH}" -B "${BUILD}" -DCMAKE_BUILD_TYPE=Release
                            "-DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}" ${arg_OPTIONS}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_install)
    execute_process(COMMAND ${CMAKE_COMMAND} --build "${BUILD}" --target install OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "CONFIG_PATH" "")
    if(NOT EXISTS "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/gonio-config.cmake")
        message(FATAL_ERROR "CONFIG_PATH ${arg_CONFIG_PATH} has no gonio-config.cmake")
    endif()
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
    file(INSTALL ${arg_FILE_LIST} DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
endfunction()
include("${PORTFILE}")
CMAKE
cmake -D "PORTFILE=$root/.packaging/vcpkg/gonio/portfile.cmake" -D "WORK=$work" -D "BUILD=$root/build/recipes" \
    -D VCPKG_LIBRARY_LINKAGE=dynamic -P "$work/port.cmake"
packages=$work/packages/gonio
[[ -f $packages/share/gonio/NOTICE && -f $packages/lib/libgonio.a && -f $packages/lib/libgonio.so && ! -e $packages/bin/gonio ]]
cat > "$work/CMakeLists.txt" << 'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(recipes LANGUAGES CXX)
find_package(gonio CONFIG REQUIRED COMPONENTS static shared)
foreach(of gonio shared)
    add_executable(${of}-program "${PROGRAM}")
    target_link_libraries(${of}-program PRIVATE gonio::${of})
endforeach()
CMAKE
cmake -S "$work" -B "$work/consumer" "-DCMAKE_PREFIX_PATH=$packages" -DPROGRAM="$root/tests/consumer/installed/read_profile.cpp" > /dev/null
cmake --build "$work/consumer" > /dev/null
for of in gonio shared; do "$work/consumer/$of-program" profiles/downlight.ies; done

echo '== Conan'
mkdir -p "$work/stubs/conan/tools" "$work/exported"
cat > "$work/stubs/conan/__init__.py" << 'PYTHON'
class ConanFile:
    pass
PYTHON
cat > "$work/stubs/conan/tools/build.py" << 'PYTHON'
def check_min_cppstd(recipe, standard):
    assert standard == 20
PYTHON
cat > "$work/stubs/conan/tools/cmake.py" << 'PYTHON'
CMake = CMakeDeps = cmake_layout = None


class CMakeToolchain:
    def __init__(self, recipe):
        self.cache_variables = recipe.variables = {}

    def generate(self):
        pass


def CMakeDeps(recipe):
    return CMakeToolchain(type("ignored", (), {}))
PYTHON
cat > "$work/stubs/conan/tools/files.py" << 'PYTHON'
import fnmatch, os, shutil

rmdir = None


def load(recipe, path):
    with open(path, encoding="utf-8") as file:
        return file.read()


# As Conan's: the pattern is compared with the path relative to the source folder, and '*' matches slashes too.
def copy(recipe, pattern, src, dst):
    src = os.path.normpath(src)
    for folder, folders, files in os.walk(src):
        if folder == src:
            folders[:] = [name for name in folders if name not in ("build", ".git")]
        for name in files:
            path = os.path.relpath(os.path.join(folder, name), src)
            if fnmatch.fnmatch(path, pattern):
                os.makedirs(os.path.dirname(os.path.join(dst, path)), exist_ok=True)
                shutil.copy2(os.path.join(src, path), os.path.join(dst, path))
PYTHON
cat > "$work/recipe.py" << 'PYTHON'
import importlib.util, sys, types

spec = importlib.util.spec_from_file_location("conanfile", sys.argv[1] + "/conanfile.py")
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
recipe = module.GonioConan()
recipe.recipe_folder, recipe.export_sources_folder = sys.argv[1:3]
recipe.options = types.SimpleNamespace(**recipe.default_options)
recipe.required = []
recipe.requires = lambda reference, **_: recipe.required.append(reference.split("/")[0])
recipe.set_version()
recipe.export_sources()
recipe.requirements()
recipe.validate()
recipe.generate()
print(recipe.version)
print(" ".join(recipe.required))
print(" ".join(f"-D{name}={'ON' if value else 'OFF'}" for name, value in recipe.variables.items()))
PYTHON
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$work/stubs /usr/bin/python3 "$work/recipe.py" "$root/.packaging/conan" "$work/exported" > "$work/recipe"
{ read -r recipe_version; read -r recipe_requires; read -ra recipe_options; } < "$work/recipe"
[[ $recipe_version == "$version" ]]
# The same libraries as the port's, under Conan's names.
diff <(tr ' ' '\n' <<< "${recipe_requires//_/-}" | sort) \
    <(jq -r '.dependencies[] | strings' .packaging/vcpkg/gonio/vcpkg.json | sort)
# CMake fails if a source that it names was not exported.
cmake -G Ninja -S "$work/exported" -B "$work/conan" -DCMAKE_BUILD_TYPE=Release "${recipe_options[@]}" > /dev/null
# Not -q, which leaves early: ninja would fail at the closed pipe.
ninja -C "$work/conan" -t targets all | grep -x 'lib/libgonio.a: CXX_STATIC_LIBRARY_LINKER__gonio_Release' > /dev/null
echo "$(find "$work/exported" -type f | wc -l) files are exported and are enough to configure the library"
