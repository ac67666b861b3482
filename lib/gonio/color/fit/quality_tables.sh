#!/usr/bin/env bash
# Prints lib/gonio/color/quality_tables.cpp from the tables in data/, number by number as they stand there.
#
#   bash lib/gonio/color/fit/quality_tables.sh > lib/gonio/color/quality_tables.cpp
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../data"

rows() { # FILE: the numbers of each row behind the wavelength, a row of the array in as many lines as it needs
    awk -F, 'NR > 2 {
        line = "    {"
        for (i = 2; i <= NF; ++i) {
            word = $i (i < NF ? "," : "},")
            if (length(line) + length(word) > 118) { print line; line = "     " }
            line = line (i == 2 || line == "     " ? "" : " ") word
        }
        print line
    }' "$1"
}
table() { # NAME TYPE ROWS FILE
    local columns
    columns=$(awk -F, 'NR == 2 { print NF - 1 }' "$4")
    printf '\nconst std::array<std::array<%s, %s>, %s> %s{{\n' "$2" "$columns" "$3" "$1"
    rows "$4"
    printf '}};\n'
}
cat << 'END'
// Printed by fit/quality_tables.sh from data/*.csv, whose first lines and NOTICE say where the numbers come from.
#include <gonio/color/detail/quality_tables.hpp>

// clang-format off
namespace gonio::detail {
END
table observer_10deg double 401 cie_1964_10deg_cmf_1nm.csv
table alpha_opic_spectra double 401 cie_s026_alpha_opic_1nm.csv
table rendering_samples std::uint16_t 81 cie_13_3_samples.csv
table fidelity_samples std::uint32_t 81 cie_224_samples.csv
printf '\n} // namespace gonio::detail\n'
