"""The table of run.sh: usage: table.py OUT"""
import glob
import json
import os
import sys

rows = ["| set | strategy | by | seconds | Gaussians | held out: PSNR dB | SSIM | trained on: PSNR dB | SSIM | GPU memory MiB |", "|---|---|---|---|---|---|---|---|---|---|"]
line = lambda *v: rows.append("| " + " | ".join(v) + " |")


def scores(group):
    return [f"{group['psnr_db']:.2f}", f"{group['ssim']:.4f}"] if group else ["–", "–"]


for path in sorted(glob.glob(os.path.join(sys.argv[1], "*.orb.json"))):
    stem = os.path.basename(path)[: -len(".orb.json")]
    name, strategy = stem.rsplit("_", 1)
    orb, gsplat = json.load(open(path)), json.load(open(path.replace(".orb.", ".gsplat.")))
    line(name, strategy, "orb", f"{orb['train_seconds']:.1f}", f"{orb['gaussians']['end']:,}", *scores(orb["held_out"]), *scores(orb["trained_on"]), f"{orb['peak_gpu_memory_bytes'] / 2**20:,.0f}")
    line(name, strategy, "gsplat", f"{gsplat['train_seconds']:.1f} (SSIM {gsplat['ssim_seconds']:.1f})", f"{gsplat['gaussians_end']:,}", *scores(gsplat["held_out"]), *scores(gsplat["trained_on"]), f"{gsplat['peak_gpu_memory_mib']:,.0f}")
    check = gsplat.get("orbs_gaussians_by_gsplat")
    if check:
        line(name, strategy, "orb's Gaussians, drawn by gsplat", "", "", *scores(check["held_out"]), *scores(check["trained_on"]), "")
print("\n".join(rows))
