# What a source file needs for a fuzzer to see its way through it: the parts of -fsanitize=fuzzer-no-link by name, since
# that option itself cannot be used with the precompiled headers of files without it.
set(gonio_fuzz_flags
    -fsanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table,stack-depth
    -fno-builtin-bcmp -fno-builtin-memcmp -fno-builtin-memmem -fno-builtin-strcasecmp -fno-builtin-strcasestr
    -fno-builtin-strcmp -fno-builtin-strncasecmp -fno-builtin-strncmp -fno-builtin-strstr)
