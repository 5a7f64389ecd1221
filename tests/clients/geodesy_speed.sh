#!/bin/bash
# Conversions of Orb beside GeographicLib and PROJ, on the same points, one after the other, in one run:
#   apt-get install g++ libgeographiclib-dev libproj-dev
#   tests/clients/geodesy_speed.sh [POINTS]
set -euo pipefail
cd "$(dirname "$0")/../.."
points=${1:-200000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
g++ -O3 -o "$work/speed" tests/clients/geodesy_speed.cpp -lGeographicLib -lproj
cargo bench --quiet --bench geodesy -- "$points"
"$work/speed" "$points"
