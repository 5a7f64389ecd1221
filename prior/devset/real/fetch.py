"""Fetch the real photographs that real/masks belong to, from Debian packages and the samples.

    python fetch.py SRC_DIR PHOTO_DIR

photos.json names package, file, author and licence of each. Longer side at most 768 pixels, as the masks.
"""

import io
import json
import struct
import subprocess
import sys
import zlib
from pathlib import Path

from PIL import Image

HERE = Path(__file__).parent
LONGER_SIDE = 768


def resources(data):
    """Files of a Qt resource archive (rcc): {path: bytes}."""
    version, tree, payload, names = struct.unpack(">4I", data[4:20])
    node = 14 if version < 2 else 22
    files = {}

    def walk(index, prefix):
        at = tree + index * node
        name, flags = struct.unpack(">IH", data[at : at + 6])
        length = struct.unpack(">H", data[names + name : names + name + 2])[0]
        text = data[names + name + 6 : names + name + 6 + 2 * length].decode("utf-16-be") if index else ""
        path = f"{prefix}/{text}"
        if flags & 2:
            count, first = struct.unpack(">II", data[at + 6 : at + 14])
            for child in range(first, first + count):
                walk(child, path)
            return
        start = payload + struct.unpack(">I", data[at + 10 : at + 14])[0]
        size = struct.unpack(">I", data[start : start + 4])[0]
        body = data[start + 4 : start + 4 + size]
        files[path] = zlib.decompress(body[4:]) if flags & 1 else body

    walk(0, "")
    return files


def unpacked(package, src):
    if package == "repo":
        return HERE.parents[2]
    if not (src / package).exists():
        subprocess.run(["apt-get", "download", package], cwd=src, check=True)
        (archive,) = src.glob(f"{package}_*.deb")
        subprocess.run(["dpkg", "-x", archive.name, package], cwd=src, check=True)
    return src / package


def main():
    src, out = Path(sys.argv[1]), Path(sys.argv[2])
    src.mkdir(parents=True, exist_ok=True)
    out.mkdir(parents=True, exist_ok=True)
    for name, about in json.loads((HERE / "photos.json").read_text()).items():
        data = (unpacked(about["package"], src) / about["file"]).read_bytes()
        if "member" in about:
            (data,) = (b for p, b in resources(data).items() if p.endswith("/" + about["member"]))
        image = Image.open(io.BytesIO(data)).convert("RGB")
        image.thumbnail((LONGER_SIDE, LONGER_SIDE))
        mask = Image.open(HERE / "masks" / f"{name}.png")
        if image.size != mask.size:
            raise SystemExit(
                f"{name}: the photo has {image.size} pixels, its mask {mask.size}: another package version?"
            )
        image.save(out / f"{name}.jpg", quality=95)


if __name__ == "__main__":
    main()
