# The packages that cpack makes: Debian's, one for each component, and an archive with all of them.
#
#   cmake --preset package && cmake --build --preset package && cpack --preset package
#
# A component is added in one place: a line in gonio_packages and its block below, which names the package and what it
# depends on. Its files come from install(… COMPONENT …).
set(gonio_packages tool runtime development modules)
if(GONIO_PYTHON)
    list(APPEND gonio_packages python)
endif()

# Who publishes packages puts a name and an address here that answer.
set(GONIO_PACKAGE_CONTACT "gonio maintainers <gonio@example.org>" CACHE STRING "Maintainer of the packages")
mark_as_advanced(GONIO_PACKAGE_CONTACT)

set(CPACK_PACKAGE_NAME gonio)
set(CPACK_PACKAGE_VENDOR gonio)
set(CPACK_PACKAGE_CONTACT "${GONIO_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_COMPONENTS_ALL ${gonio_packages})
set(CPACK_GENERATOR DEB TXZ)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/generator.cmake")
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)

# Read by generator.cmake and debian/stage.cmake.
set(CPACK_GONIO_SOURCE "${PROJECT_SOURCE_DIR}")
set(CPACK_GONIO_VERSION_DATE "${gonio_version_date}")
set(CPACK_GONIO_PROCESSOR "${CMAKE_SYSTEM_PROCESSOR}")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/lib")

# The first line of a description is the package's synopsis.
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME gonio)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "gonio-media (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_TOOL_DESCRIPTION "photometric lights: units, measured profiles, textures
Converts between lumens, candela, lux and nits for the shape of a light.
Reads, checks, creates and converts measured IES, EULUMDAT and TM-33
profiles, bakes them into textures, exports them to engines and renderers,
and previews how a light falls on a stage.

Numbers, profiles and diagrams need this package alone. Pictures, PDF and
OpenColorIO configurations need gonio-media.")

set(library_package "libgonio${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "${library_package}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "gonio-media (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "photometric lights: shared library
A library for photometric units, measured profiles of luminaires, exact
illuminance of area lights, colour temperature, textures and previews.

This package contains the shared library that programs load.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgonio-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} (= ${PROJECT_VERSION}), libexpected-dev, libglm-dev, \
libpugixml-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "gonio, gonio-media")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "photometric lights: files for development
A library for photometric units, measured profiles of luminaires, exact
illuminance of area lights, colour temperature, textures and previews.

This package contains the headers, the static library, the CMake package,
the pkg-config file and the JSON schemas.")

set(CPACK_DEBIAN_MODULES_PACKAGE_NAME gonio-media)
set(CPACK_DEBIAN_MODULES_PACKAGE_SECTION graphics)
# Its letters are embedded in PDF files.
set(CPACK_DEBIAN_MODULES_PACKAGE_DEPENDS "fonts-dejavu-core")
set(CPACK_DEBIAN_MODULES_PACKAGE_ENHANCES "gonio, ${library_package}")
set(CPACK_COMPONENT_MODULES_DESCRIPTION "photometric lights: pictures, display transforms and PDF
Modules that gonio loads when it writes PNG or OpenEXR (libpng, OpenEXR,
libdeflate), reads a picture or writes other formats (OpenImageIO), applies
a display transform or a colour configuration (OpenColorIO), or writes a
data sheet as PDF (cairo).

gonio works without them where only numbers are wanted.")

# The module contains the library and works with the minor version of Python that it was built for alone.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gonio)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(GONIO_PYTHON)
    math(EXPR next_python "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), \
python3 (<< ${Python_VERSION_MAJOR}.${next_python}), python3-numpy")
endif()
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "photometric lights: module for Python
Photometric units, measured profiles of luminaires, exact illuminance of area
lights, colour temperature, materials, textures and previews over NumPy
arrays, with type stubs.")

include(CPack)
