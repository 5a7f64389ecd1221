#!/bin/sh
# Poses that are off, put right in training (`orb train --refine-poses`) or before it by COLMAP's bundle adjustment: what each
# leaves in pixels, in degrees, and in photos held out. A table at the end.
#
# usage: poses.sh ORB OUT
#   ORB   the program;  OUT   a new folder for what is measured;  colmap and a Python with numpy must be there
#   PHOTOS (40) and PIXELS (800: their longer side as made), SIZE (200: in training), ITERATIONS (1500), CAP (30000), DEVICE (cpu), DEGREES (0.3) and SHIFT
#   (0.005 of the distance) of the disturbance, ROWS and PYTHON (python3) may be set.
#
# The scene is made, photos whose poses are known. Features and matches are COLMAP's, from the photos; what
# belongs together is decided under the true poses, so that all rows have the same observations, which favours bundle
# adjustment: with poses that are off some of them would not have been found. Points are placed anew under the poses that
# are off. Held-out photos are off like the others; the first figure is of their poses fitted to the finished Gaussians, in
# every row alike. Bundle adjustment sees their features, training never sees them.
set -eu
orb=$1 out=$2
here=$(dirname "$0")
python=${PYTHON:-python3} rows=${ROWS:-"off off_untracked_refined off_refined off_adjusted off_adjusted_refined true true_refined"}
export ORB_DATA_DIR="$out/data" QT_QPA_PLATFORM=offscreen
set="$out/sets/00_site"
quietly() { "$@" > "$out/last.log" 2>&1 || { cat "$out/last.log" >&2; exit 1; }; }
if [ ! -d "$out/true.model" ]; then
    mkdir -p "$out/off_adjusted.model" "$out/true.model"
    "$orb" bench make -o "$out/sets" --site --photos "${PHOTOS:-40}" --size "${PIXELS:-800}" --seed 5 --scenes 1 --quiet
    inside=$(awk 'NR == 1 {print $5 "," $6 "," $7 "," $8}' "$set/sparse/0/cameras.txt")
    quietly colmap feature_extractor --database_path "$out/db" --image_path "$set/images" --SiftExtraction.use_gpu 0 \
        --SiftExtraction.max_num_features 2500 --ImageReader.single_camera 1 --ImageReader.camera_model PINHOLE \
        --ImageReader.camera_params "$inside"
    quietly colmap exhaustive_matcher --database_path "$out/db" --SiftMatching.use_gpu 0
    "$python" "$here/poses.py" known "$set" "$out/known" --database "$out/db"
    quietly colmap point_triangulator --database_path "$out/db" --image_path "$set/images" --input_path "$out/known" \
        --output_path "$out/true.model" --Mapper.ba_refine_focal_length 0 --Mapper.ba_refine_extra_params 0
    quietly colmap model_converter --input_path "$out/true.model" --output_path "$out/true.model" --output_type TXT
    rm "$out"/true.model/*.bin
    "$python" "$here/poses.py" disturb "$out/true.model" "$out/off.model" --degrees "${DEGREES:-0.3}" --shift "${SHIFT:-0.005}"
    quietly colmap bundle_adjuster --input_path "$out/off.model" --output_path "$out/off_adjusted.model" \
        --BundleAdjustment.refine_focal_length 0 --BundleAdjustment.refine_extra_params 0
    quietly colmap model_converter --input_path "$out/off_adjusted.model" --output_path "$out/off_adjusted.model" --output_type TXT
    rm "$out"/off_adjusted.model/*.bin
    # Nothing but poses and points: what training does alone.
    mkdir "$out/off_untracked.model"
    cp "$out/off.model/cameras.txt" "$out/off_untracked.model"
    awk 'NR % 2 {print; next} {print ""}' "$out/off.model/images.txt" > "$out/off_untracked.model/images.txt"
    cut -d' ' -f1-8 "$out/off.model/points3D.txt" > "$out/off_untracked.model/points3D.txt"
fi
for row in $rows; do
    from=${row%_refined} refine=
    [ "$from" = "$row" ] || refine=--refine-poses
    [ -d "$out/$row.model" ] || cp -r "$out/$from.model" "$out/$row.model"
    # shellcheck disable=SC2086 # the option is there or is not
    "$orb" train "$set" --poses "$out/$row.model" -o "$out/$row" $refine --fit-held-out --iterations "${ITERATIONS:-1500}" \
        --size "${SIZE:-200}" --max-gaussians "${CAP:-30000}" --device "${DEVICE:-cpu}" --json --quiet > "$out/$row.json"
done
"$python" "$here/poses.py" table "$set" "$out" $rows
