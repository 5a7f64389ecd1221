#!/bin/sh
# `orb train` and gsplat on the same posed sets, one after the other on one GPU; a table at the end.
#
# usage: run.sh ORB OUT SET...
#   ORB   the program;  OUT   a new folder for what is measured
#   ITERATIONS (30000), CAP (1000000), STRATEGIES ("default mcmc") and PYTHON (python3) may be set.
set -eu
orb=$1 out=$2
shift 2
here=$(dirname "$0")
python=${PYTHON:-python3} iterations=${ITERATIONS:-30000} cap=${CAP:-1000000}
mkdir -p "$out"
# Keys and ledger of measurements are nobody's.
export ORB_DATA_DIR="$out/data"
for set in "$@"; do
    name=$(basename "$set")
    for strategy in ${STRATEGIES:-default mcmc}; do
        at="$out/${name}_$strategy"
        "$orb" train "$set" -o "$at" --strategy "$strategy" --iterations "$iterations" --max-gaussians "$cap" \
            --sky off --device gpu --json --quiet > "$at.orb.json"
        "$python" "$here/gsplat_scene.py" "$set" --like "$at.orb.json" --strategy "$strategy" --iterations "$iterations" \
            --cap "$cap" --check "$at/scene.ply" -o "$at.gsplat.json" > /dev/null
    done
done
"$python" "$here/table.py" "$out"
