#!/bin/bash
# Conversions of Orb beside GeographicLib and PROJ on the same points in one run: five turns each, one after the other, the
# best of each. Prints nanoseconds a point as a table; exit code 1 if Orb is not the fastest anywhere.
#   apt-get install g++ libgeographiclib-dev libproj-dev
#   tests/clients/geodesy_speed.sh [POINTS]
set -euo pipefail
cd "$(dirname "$0")/../.."
points=${1:-100000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
g++ -O3 -o "$work/speed" tests/clients/geodesy_speed.cpp -lGeographicLib -lproj
for _ in 1 2 3 4 5; do
    cargo bench --quiet --bench geodesy -- "$points"
    "$work/speed" "$points"
done >"$work/all"
awk '
    {
        way = $2 " → " $4
        if (!((way, $1) in best) || $5 + 0 < best[way, $1]) best[way, $1] = $5 + 0
        if (!(way in seen)) { seen[way] = 1; order[++n] = way }
    }
    END {
        print "| | Orb | GeographicLib | PROJ |\n|---|---|---|---|"
        for (i = 1; i <= n; i++) {
            way = order[i]
            proj = (way, "PROJ") in best ? best[way, "PROJ"] : "–"
            printf "| %s | %s | %s | %s |\n", way, best[way, "Orb"], best[way, "GeographicLib"], proj
            slow += best[way, "Orb"] >= best[way, "GeographicLib"] || (proj != "–" && best[way, "Orb"] >= proj)
        }
        exit slow > 0
    }' "$work/all"
