"""egm96.bin from the 15-minute EGM96 geoid grid of Debian's package proj-data (NGA's WW15MGH, public domain).

    apt-get install proj-data; pip install numpy
    python3 make_egm96.py /usr/share/proj/egm96_15.gtx egm96.bin

EGM96 is a model of degree 360, so spherical harmonics to degree 360 hold all of the grid: one least-squares problem for
each order m, over fully normalised Legendre functions (Holmes and Featherstone 2002, eq. 11-13) of the sine of the
geodetic latitude. Coefficients are rounded to STEP metres and written as zigzag LEB128, order by order, cosine then sine
of each degree. Prints what the rounding and the fit cost against the grid.
"""
import struct
import sys

import numpy as np

DEGREE = 360
STEP = 5e-5  # metres


def legendre(m, sin, cos):
    """Rows for degrees m..DEGREE, fully normalised."""
    p = np.ones_like(sin)
    for k in range(1, m + 1):
        p = p * cos * np.sqrt((2 * k + 1) / (2 * k)) * (np.sqrt(2.0) if k == 1 else 1.0)
    rows = [p]
    if m < DEGREE:
        rows.append(np.sqrt(2 * m + 3) * sin * p)
    for n in range(m + 2, DEGREE + 1):
        a = np.sqrt((2 * n - 1) * (2 * n + 1) / ((n - m) * (n + m)))
        b = np.sqrt((2 * n + 1) * (n + m - 1) * (n - m - 1) / ((n - m) * (n + m) * (2 * n - 3)))
        rows.append(a * sin * rows[-1] - b * rows[-2])
    return np.array(rows)


def leb128(value):
    value = 2 * value if value >= 0 else -2 * value - 1
    out = bytearray()
    while True:
        byte, value = value & 127, value >> 7
        out.append(byte | (128 if value else 0))
        if not value:
            return bytes(out)


def main(source, target):
    raw = open(source, "rb").read()
    south, west, _, _, rows, columns = struct.unpack(">ddddii", raw[:40])
    assert (south, west, rows, columns) == (-90.0, -180.0, 721, 1440)
    grid = np.frombuffer(raw[40:], ">f4").reshape(rows, columns).astype(float)
    latitude = np.radians(np.linspace(-90, 90, rows))
    sin, cos = np.sin(latitude), np.cos(latitude)
    cos[0] = cos[-1] = 0.0
    # Columns begin at -180 degrees: e^(-im(lambda + pi)).
    spectrum = np.fft.rfft(grid, axis=1) / columns
    weight = np.sqrt(np.maximum(cos, 0.02))
    out, back = bytearray(), np.zeros_like(spectrum)
    for m in range(DEGREE + 1):
        p = legendre(m, sin, cos).T
        f = spectrum[:, m] * (-1) ** m * (1 if m == 0 else 2)
        fitted = np.linalg.lstsq(p * weight[:, None], np.stack([f.real, -f.imag], 1) * weight[:, None], rcond=1e-12)[0]
        whole = np.rint(fitted / STEP).astype(int)
        for c, s in whole:
            out += leb128(int(c))
            if m:
                out += leb128(int(s))
        c, s = (p @ (whole * STEP)).T
        back[:, m] = (c - 1j * s) * (-1) ** m / (1 if m == 0 else 2)
    error = np.fft.irfft(back * columns, n=columns, axis=1) - grid
    share = np.maximum(cos, 0)[:, None] * np.ones_like(grid)
    print(f"{len(out)} bytes; at the grid's {grid.size} nodes: rms {1000 * np.sqrt((share * error**2).sum() / share.sum()):.1f} mm, "
          f"largest {np.abs(error).max():.3f} m")
    open(target, "wb").write(out)


main(*sys.argv[1:])
