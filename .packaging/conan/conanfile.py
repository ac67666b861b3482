"""Builds the checkout that it is in: conan create .packaging/conan"""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir

required_conan_version = ">=2.0"


class GonioConan(ConanFile):
    name = "gonio"
    description = "Photometric lights: units, IES and EULUMDAT profiles, textures and previews"
    license = "Apache-2.0"
    topics = ("photometry", "ies", "eulumdat", "lighting", "rendering")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "modules": [True, False]}
    default_options = {"shared": False, "modules": False}

    # What a build of the library needs of the checkout.
    sources = ("CMakeLists.txt", "LICENSE", "lib/*", ".packaging/*.cmake")

    @property
    def _checkout(self):
        return os.path.join(self.recipe_folder, os.pardir, os.pardir)

    def set_version(self):
        header = load(self, os.path.join(self._checkout, "lib", "gonio", "base", "version.hpp"))
        self.version = re.search(r'GONIO_VERSION_STRING "([0-9.]+)"', header).group(1)

    def export_sources(self):
        for pattern in self.sources:
            copy(self, pattern, self._checkout, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("glm/[>=0.9.9.8 <2]", transitive_headers=True)
        self.requires("tl-expected/[>=1.0 <2]", transitive_headers=True)
        self.requires("fmt/[>=9 <12]")
        self.requires("nlohmann_json/[>=3.11 <4]")
        self.requires("pugixml/[>=1.13 <2]")
        if self.options.modules:
            self.requires("openimageio/[>=2.4 <3]")
            self.requires("opencolorio/[>=2.1 <3]")
            self.requires("openexr/[>=3.1 <4]")
            self.requires("libpng/[>=1.6 <2]")
            self.requires("libdeflate/[>=1.14 <2]")
            self.requires("cairo/[>=1.16 <2]")
            self.requires("freetype/[>=2.12 <3]")

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BUILD_TESTING"] = False
        toolchain.cache_variables["GONIO_TOOL"] = False
        toolchain.cache_variables["GONIO_MODULES"] = bool(self.options.modules)
        toolchain.cache_variables["GONIO_SHARED"] = bool(self.options.shared)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "NOTICE", os.path.join(self.source_folder, "lib", "gonio", "color", "data"),
             os.path.join(self.package_folder, "licenses"))
        # Conan writes its own.
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))

    def package_info(self):
        self.cpp_info.libs = ["gonio"]
        self.cpp_info.system_libs = ["dl", "m", "pthread"]
        self.cpp_info.set_property("cmake_file_name", "gonio")
        self.cpp_info.set_property("cmake_target_name", "gonio::shared" if self.options.shared else "gonio::gonio")
        self.cpp_info.set_property("pkg_config_name", "gonio")
