"""Fetch the packages that the development set's models come from (Debian), and unpack what is needed.

    python fetch.py SRC_DIR

Nothing of this may be used for training. DATA.md names every model with its author and licence.
"""

import json
import subprocess
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
GAME = "usr/share/games"
# From 0 A.D.'s archive of 3 GB: the meshes and textures that the scenes use.
ZERO_AD = ("art/meshes/gaia/", "art/meshes/structural/ptol_", "art/textures/skins/gaia/", "art/textures/skins/structural/ptol_",
           "art/textures/terrain/types/aegean_anatolia/", "art/textures/terrain/types/alpine_")  # fmt: skip


def unpack(archive, target, wanted=()):
    if target.exists():
        return
    with zipfile.ZipFile(archive) as z:
        names = [n for n in z.namelist() if not wanted or n.startswith(wanted)]
        z.extractall(target, names)


def main():
    src = Path(sys.argv[1])
    src.mkdir(parents=True, exist_ok=True)
    for package in json.loads((HERE / "objects.json").read_text())["packages"]:
        if (src / package).exists():
            continue
        subprocess.run(["apt-get", "download", package], cwd=src, check=True)
        (archive,) = src.glob(f"{package}_*.deb")
        subprocess.run(["dpkg", "-x", archive.name, package], cwd=src, check=True)
    for archive in (src / "sweethome3d-furniture/usr/share/sweethome3d/furniture").glob("*.sh3f"):
        unpack(archive, src / "sh3d" / archive.stem)
    unpack(src / "0ad-data" / GAME / "0ad/mods/public/public.zip", src / "0ad", ZERO_AD)


def resolve(name, src):
    """The file that "root:path" of objects.json means."""
    root, path = name.split(":", 1)
    roots = {
        "repo": HERE.parent.parent,
        "sh3d": src / "sh3d",
        "fg": src / "flightgear-data-models" / GAME / "flightgear/Models",
        "fgai": src / "flightgear-data-ai" / GAME / "flightgear/AI",
        "sar": src / "searchandrescue-data" / GAME / "searchandrescue",
        "0ad": src / "0ad",
    }
    return roots[root] / path


if __name__ == "__main__":
    main()
