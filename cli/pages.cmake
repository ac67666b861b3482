# Writes what the tool says about itself, at build time: its manual pages and its completion for each shell.
#   cmake -D TOOL=PROGRAM[;ARGUMENT…] -D FOLDER=DIR -P pages.cmake
file(REMOVE_RECURSE "${FOLDER}/man") # a command that is gone has no page
file(MAKE_DIRECTORY "${FOLDER}/man")
execute_process(COMMAND ${TOOL} help --man -O "${FOLDER}/man" COMMAND_ERROR_IS_FATAL ANY)
foreach(shell bash zsh fish)
    execute_process(COMMAND ${TOOL} completion ${shell} OUTPUT_FILE "${FOLDER}/completion.${shell}"
                    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
