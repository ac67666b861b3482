# Writes the commit that the sources are at, at build time: cmake -D SOURCE=… -D OUTPUT=… -P revision.cmake
# The file is touched only when what it says changes, so that a commit costs one small object and the tool's link.
# Sources without a repository of their own (a tarball, or one unpacked inside of another repository) say nothing.
set(commit "")
find_program(git git)
if(git AND EXISTS "${SOURCE}/.git")
    execute_process(COMMAND "${git}" -C "${SOURCE}" describe --always --dirty=+changes --abbrev=12 --exclude=*
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
    if(failed)
        set(commit "")
    endif()
endif()
if(commit STREQUAL "")
    set(commit "unknown")
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT [[
#include "revision.hpp"

namespace gonio::cli {

const char* const commit = "@commit@";

} // namespace gonio::cli
]] @ONLY)
