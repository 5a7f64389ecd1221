"""splat_speed.py FOLDER: how fast gsply (pip install gsply zstandard) reads and writes what the formats' example `speed` wrote.

The best of five rounds in one process, its just-in-time compilation done before.
"""
import pathlib
import sys
import tempfile
import time

import gsply

folder = pathlib.Path(sys.argv[1])


def best(work):
    times = []
    for _ in range(6):
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return min(times[1:]), result


with tempfile.TemporaryDirectory() as scratch:
    seconds, scene = best(lambda: gsply.plyread(folder / "scene.ply"))
    count = len(scene.means)
    print(f"ply    read  {seconds:.3f} s {count / seconds / 1e6:.2f} M/s")
    seconds, _ = best(lambda: gsply.plywrite(pathlib.Path(scratch) / "a.ply", scene))
    print(f"ply    write {seconds:.3f} s {count / seconds / 1e6:.2f} M/s")
    for version in (3, 4):
        path = pathlib.Path(scratch) / f"a.v{version}.spz"
        seconds, _ = best(lambda: gsply.write_spz(path, scene, version=version))
        size = path.stat().st_size / 1e6
        print(f"spz {version}  write {seconds:.3f} s {count / seconds / 1e6:.2f} M/s, {size:.2f} MB")
    for version in (2, 3, 4):
        seconds, _ = best(lambda: gsply.read_spz(folder / f"scene.v{version}.spz"))
        print(f"spz {version}  read  {seconds:.3f} s {count / seconds / 1e6:.2f} M/s")
