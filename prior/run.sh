#!/bin/bash
# Train both networks on one host, side by side on several GPUs or one after the other on a single one.
#
#   run.sh SECONDS TOTAL_SECONDS SCENE_GPUS OUT_DIR [INIT_DIR]
#
# SceneNet gets SCENE_GPUS of the GPUs, SplatNet the others. A second call with the same OUT_DIR goes on; TOTAL_SECONDS
# is the length of the whole schedule. INIT_DIR: where to start from (scene.onnx, splat.onnx of this or an older
# version). SEED, LR and OPTIONS (more of train.py's) may be set in the environment.
# Then: python export.py scene OUT_DIR/scene_weights.pt scene.onnx, and so for splat; DetailNet after SceneNet (README.md).
set -euo pipefail
if [ $# -lt 4 ]; then
    sed -n '2,10s/^# \{0,1\}//p' "$0"
    exit 2
fi
seconds=$1 total=$2 scene_gpus=$3 out=$(realpath -m "$4") init=${5:+$(realpath "$5")}
cd "$(dirname "$0")"
mkdir -p "$out"
gpus=$(nvidia-smi -L | wc -l)
export PYTHONUNBUFFERED=1 OMP_NUM_THREADS=4

# train NET FIRST_GPU LAST_GPU PORT BATCH
train() {
    local count=$(($3 - $2 + 1))
    # shellcheck disable=SC2086
    CUDA_VISIBLE_DEVICES=$(seq -s, "$2" "$3") torchrun --nproc_per_node="$count" --master_port="$4" \
        train.py "$1" --seconds "$seconds" --total "$total" --batch "$5" --lr "${LR:-6e-4}" --seed "${SEED:-0}" \
        --dir "$out" ${init:+--init "$init/$1.onnx"} ${OPTIONS:-} >"$out/$1.log" 2>&1
}

if [ "$gpus" -le "$scene_gpus" ]; then
    train scene 0 $((gpus - 1)) 29511 64
    train splat 0 $((gpus - 1)) 29512 64
else
    train scene $((gpus - scene_gpus)) $((gpus - 1)) 29511 64 &
    scene=$!
    train splat 0 $((gpus - scene_gpus - 1)) 29512 64 &
    splat=$!
    wait "$scene"
    wait "$splat"
fi
tail -n 3 "$out/scene.log" "$out/splat.log"
