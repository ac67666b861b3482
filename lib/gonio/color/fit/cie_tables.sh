#!/usr/bin/env bash
# Prints lib/gonio/color/cie_tables.cpp from the tables in data/, number by number as they stand there.
#
#   bash lib/gonio/color/fit/cie_tables.sh > lib/gonio/color/cie_tables.cpp
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../data"

cat << 'END'
// Printed by fit/cie_tables.sh from data/*.csv, whose first lines and NOTICE say where the numbers come from.
#include <gonio/color/detail/cie_tables.hpp>

// clang-format off
namespace gonio::detail {

END
rows() { # FILE: the numbers of each row behind the wavelength
    awk -F, 'NR > 2 { line = "    {"; for (i = 2; i <= NF; ++i) line = line (i > 2 ? ", " : "") $i; print line "}," }' "$1"
}
echo 'const std::array<std::array<double, 3>, 471> observer{{'
rows cie_1931_2deg_cmf_1nm.csv
printf '}};\n\nconst std::array<std::array<double, 3>, 107> daylight_components{{\n'
rows cie_daylight_components.csv
printf '}};\n\nnamespace {\n\n'
awk -F, '
    NR == 2 { for (i = 2; i <= NF; ++i) name[i] = $i; columns = NF }
    NR > 2 {
        for (i = 2; i <= NF; ++i) {
            if ($i == "") continue
            if (!(i in first)) first[i] = $1
            text[i] = text[i] (count[i] ? (count[i] % 12 ? ", " : ",\n    ") : "    ") $i
            ++count[i]
            if ($1 != first[i] + 5 * (count[i] - 1)) { print name[i] " has a gap" > "/dev/stderr"; exit 1 }
        }
    }
    END {
        for (i = 2; i <= columns; ++i)
            printf "constexpr std::array<double, %d> power_%d{ // %s\n%s};\n", count[i], i - 2, name[i], text[i]
        printf "\n} // namespace\n\nconst std::array<IlluminantTable, %d> illuminant_tables{{\n", columns - 1
        for (i = 2; i <= columns; ++i) printf "    {\"%s\", %d, power_%d},\n", name[i], first[i], i - 2
        print "}};\n\n} // namespace gonio::detail"
    }' cie_illuminants.csv
