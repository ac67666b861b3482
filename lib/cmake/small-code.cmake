# Options for what runs once: reading options, reading and writing the text of scenes, diagrams and reports. -O3 takes a
# third longer to compile, and a third more room for what it inlines, and gains nothing here. g++ inlines less where it
# is told to; with -Os it warns of what is well.
set(gonio_small_code "$<$<CONFIG:Release>:-O1;$<$<CXX_COMPILER_ID:GNU>:--param=max-inline-insns-single=5>>")
