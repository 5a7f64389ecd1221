"""Writes `phone.heic`: a photo as phones write it, of a known picture.

A grid of four tiles of 128 × 128 pixels, cut to 240 × 200 and turned a quarter clockwise to be seen 200 wide and 240 high; colours of
Display P3 by an ICC profile, full range by the stream alone, no `nclx`; EXIF that says the turn once more. The tiles are encoded by x265
(`pip install pillow-heif numpy`), the profile is the first argument, as `moxcms::ColorProfile::new_display_p3().encode()` writes it; the
container around them is written here, box by box (ISO/IEC 23008-12).
"""

import io
import struct
import sys
from pathlib import Path

import numpy as np
import pillow_heif
from PIL import Image

TILE, WIDTH, HEIGHT = 128, 240, 200


def box(kind, *parts):
    body = b"".join(parts)
    return struct.pack(">I", 8 + len(body)) + kind + body


def full(kind, version, *parts, flags=0):
    return box(kind, struct.pack(">I", version << 24 | flags), *parts)


def boxes(data):
    at = 0
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        yield kind, data[at + 8 : at + size]
        at += size


def inside(data, kind):
    return next(body for k, body in boxes(data) if k == kind)


def upright():
    """Red to the right, green downwards, blue away from there; 0 to 255 in Display P3."""
    y, x = np.mgrid[0:WIDTH, 0:HEIGHT].astype(np.float64)
    return np.stack([90 + 0.4 * x, 80 + 0.4 * y, 170 - 0.3 * x - 0.2 * y], axis=-1)


def coded(tile):
    """The decoder's configuration and the coded picture of a tile."""
    out = io.BytesIO()
    image = Image.fromarray(np.round(tile).astype(np.uint8))
    pillow_heif.from_pillow(image).save(out, quality=95, chroma="420", save_nclx_profile=False)
    meta = inside(out.getvalue(), b"meta")[4:]
    config = inside(inside(inside(meta, b"iprp"), b"ipco"), b"hvcC")
    return config, inside(out.getvalue(), b"mdat")


def exif():
    entry = lambda tag, kind, value: struct.pack(">HHI", tag, kind, 1) + value
    short = lambda value: struct.pack(">HH", value, 0)
    within = struct.pack(">H", 3) + entry(0xA002, 4, struct.pack(">I", WIDTH)) + entry(0xA003, 4, struct.pack(">I", HEIGHT))
    within += entry(0xA405, 3, short(26)) + bytes(4)
    first = struct.pack(">H", 2) + entry(0x0112, 3, short(6)) + entry(0x8769, 4, struct.pack(">I", 8 + 30)) + bytes(4)
    return struct.pack(">I", 6) + b"Exif\0\0" + b"MM\0*\0\0\0\x08" + first + within


def main(profile, to):
    stored = np.rot90(upright(), 1)  # The file's turn clockwise makes it upright again.
    assert stored.shape[:2] == (HEIGHT, WIDTH)
    padded = np.pad(stored, ((0, 2 * TILE - HEIGHT), (0, 2 * TILE - WIDTH), (0, 0)), mode="edge")
    tiles = [coded(padded[r : r + TILE, c : c + TILE]) for r in (0, TILE) for c in (0, TILE)]
    configs = [config for config, _ in tiles]
    assert all(config == configs[0] for config in configs)
    grid = struct.pack(">BBBBHH", 0, 0, 1, 1, WIDTH, HEIGHT)
    # Items: 1 to 4 the tiles, 5 the grid, 6 the EXIF.
    payloads = [picture for _, picture in tiles] + [grid, exif()]
    kinds = [b"hvc1"] * 4 + [b"grid", b"Exif"]
    infe = b"".join(full(b"infe", 2, struct.pack(">HH", i + 1, 0), kind, b"\0", flags=int(i < 4)) for i, kind in enumerate(kinds))
    ipco = box(
        b"ipco",
        box(b"hvcC", configs[0]),
        full(b"ispe", 0, struct.pack(">II", TILE, TILE)),
        full(b"ispe", 0, struct.pack(">II", WIDTH, HEIGHT)),
        box(b"colr", b"prof", profile),
        box(b"irot", b"\x03"),
    )
    owned = [(i, [0x81, 0x02]) for i in range(1, 5)] + [(5, [0x03, 0x04, 0x85])]
    ipma = struct.pack(">I", len(owned)) + b"".join(struct.pack(">HB", i, len(p)) + bytes(p) for i, p in owned)
    iref = box(b"dimg", struct.pack(">HH", 5, 4), struct.pack(">4H", 1, 2, 3, 4)) + box(b"cdsc", struct.pack(">HHH", 6, 1, 5))

    def meta(start):
        iloc, at = struct.pack(">HH", 0x4400, len(payloads)), start
        for i, payload in enumerate(payloads):
            iloc += struct.pack(">HHHII", i + 1, 0, 1, at, len(payload))
            at += len(payload)
        return full(
            b"meta",
            0,
            full(b"hdlr", 0, bytes(4), b"pict", bytes(13)),
            full(b"pitm", 0, struct.pack(">H", 5)),
            full(b"iinf", 0, struct.pack(">H", len(kinds)), infe),
            full(b"iref", 0, iref),
            box(b"iprp", ipco, full(b"ipma", 0, ipma)),
            full(b"iloc", 0, iloc),
        )

    head = box(b"ftyp", b"heic", bytes(4), b"mif1", b"heic")
    start = len(head) + len(meta(0)) + 8
    to.write_bytes(head + meta(start) + box(b"mdat", *payloads))
    # libheif reads it as the picture that went in.
    seen = np.asarray(Image.open(to).convert("RGB")).astype(float)
    print("bytes", to.stat().st_size, "differs by", np.abs(seen - upright()).max(), "at most")


if __name__ == "__main__":
    pillow_heif.register_heif_opener()
    main(Path(sys.argv[1]).read_bytes(), Path(sys.argv[2]))
