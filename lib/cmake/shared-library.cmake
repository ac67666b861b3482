# gonio-shared: the library as a shared object, from the objects of the archive. Its SONAME has the minor version, because
# a minor version may change the interface. It exports what the public headers declare, and nothing else: everything else
# is compiled hidden, and templates of other libraries stay out by name.
add_library(gonio-shared SHARED $<TARGET_OBJECTS:gonio>)
add_library(gonio::shared ALIAS gonio-shared)
set(gonio_exports "${CMAKE_CURRENT_LIST_DIR}/shared-library.map")
set_target_properties(gonio-shared PROPERTIES
    OUTPUT_NAME gonio EXPORT_NAME shared LINKER_LANGUAGE CXX LINK_DEPENDS "${gonio_exports}"
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_include_directories(gonio-shared PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
                                               $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(gonio-shared PUBLIC cxx_std_20)
# The archives that the tool links need not be position-independent; here the shared ones cost nothing.
find_library(GONIO_PUGIXML pugixml REQUIRED)
mark_as_advanced(GONIO_PUGIXML)
target_link_libraries(gonio-shared
    PUBLIC glm::glm tl::expected
    PRIVATE $<BUILD_INTERFACE:gonio-build-flags> Threads::Threads ${CMAKE_DL_LIBS}
            "${GONIO_PUGIXML}")
target_link_options(gonio-shared PRIVATE "LINKER:--version-script=${gonio_exports}" LINKER:--no-undefined
                                         LINKER:--as-needed)
