# The tool as a component: the program, its manual pages, and completion where each shell looks for it.
install(TARGETS gonio-tool RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tool)

# Where `gonio report` finds the page for browsers: one that cli/page/build.mjs has made.
set(GONIO_PAGE "" CACHE FILEPATH "The page gonio.html, to install for interactive reports; empty: reports have none")
if(GONIO_PAGE)
    install(FILES "${GONIO_PAGE}" DESTINATION "${CMAKE_INSTALL_DATADIR}/gonio" COMPONENT tool RENAME gonio.html)
endif()

# Debian's packages have it in share/zsh/vendor-completions.
set(GONIO_ZSH_COMPLETIONS "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" CACHE STRING
    "Folder of completion functions for zsh, below the prefix")
mark_as_advanced(GONIO_ZSH_COMPLETIONS)

# A tool for another machine can describe itself only in an emulator.
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    return()
endif()
set(pages "${CMAKE_CURRENT_BINARY_DIR}/pages")
set(run_tool ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:gonio-tool>)
add_custom_command(TARGET gonio-tool POST_BUILD
    COMMAND ${CMAKE_COMMAND} -D "TOOL=${run_tool}" -D "FOLDER=${pages}" -P "${CMAKE_CURRENT_SOURCE_DIR}/pages.cmake"
    VERBATIM)
install(DIRECTORY "${pages}/man/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tool)
install(FILES "${pages}/completion.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
        COMPONENT tool RENAME gonio)
install(FILES "${pages}/completion.zsh" DESTINATION "${GONIO_ZSH_COMPLETIONS}" COMPONENT tool RENAME _gonio)
install(FILES "${pages}/completion.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d"
        COMPONENT tool RENAME gonio.fish)
