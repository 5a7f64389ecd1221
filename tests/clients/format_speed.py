"""format_speed.py FOLDER: how fast Orb and one other program write and read each format, the same data on both sides.

Runs the formats' example `speed`, which leaves its files in FOLDER (a folder in memory keeps the disk out of it, such as
/dev/shm/speed), then the others on those files, each inside its own process: the start of a program and its compilation are
not counted. Medians of seven rounds, after one that does not count: from arrays in memory to a closed file, and back.
Prints the table of docs/formats.md.

pip install gsply zstandard numpy usd-core rasterio pyogrio OpenImageIO py3dtiles; @playcanvas/splat-transform and
@gltf-transform/core, /extensions, /functions and meshoptimizer by npm (NODE_PATH);
libopenscenegraph-dev and g++. What is missing is named and leaves its cells empty.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROUNDS = 7


def median(work):
    """Seconds of the middle round, and what the last one gave."""
    result, times = work(), []
    for _ in range(ROUNDS):
        result = None
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return sorted(times)[ROUNDS // 2], result


def splat_files(folder, out):
    import gsply
    import numpy as np

    def arrays(scene):
        # Every value out of the file, whatever the reader puts off.
        return [np.ascontiguousarray(a).copy() for a in (scene.means, scene.scales, scene.quats, scene.opacities, scene.sh0, scene.shN)]

    name = f"gsply {gsply.__version__}"
    read, _ = median(lambda: arrays(gsply.plyread(folder / "scene.ply")))
    scene = gsply.plyread(folder / "scene.ply")
    write, _ = median(lambda: gsply.plywrite(out / "a.ply", scene))
    yield "PLY", name, out / "a.ply", write, read
    for version in (2, 3, 4):
        read, _ = median(lambda: arrays(gsply.read_spz(folder / f"scene.v{version}.spz")))
        path = out / f"a.v{version}.spz"
        write = median(lambda: gsply.write_spz(path, scene, version=version))[0] if version > 2 else None
        yield f"SPZ {version}", name, path, write, read


def usd(folder, out):
    import numpy as np
    from pxr import Sdf, Usd, UsdGeom, Vt

    def load():
        stage = Usd.Stage.Open(str(folder / "field.usdz"))
        found = []
        for prim in stage.Traverse():
            if prim.IsA(UsdGeom.Mesh):
                mesh = UsdGeom.Mesh(prim)
                values = [mesh.GetPointsAttr(), mesh.GetNormalsAttr(), mesh.GetFaceVertexIndicesAttr(), mesh.GetFaceVertexCountsAttr()]
                values += [p.GetAttr() for p in UsdGeom.PrimvarsAPI(prim).GetPrimvars()]
                found += [np.array(v.Get()) for v in values if v.Get() is not None]
        return found

    read, arrays = median(load)
    points, indices = arrays[0], next(a for a in arrays if a.dtype == np.int32 and len(a) == 3 * 100352)
    uvs = next(a for a in arrays if a.ndim == 2 and a.shape[1] == 2)
    normals = next(a for a in arrays[1:] if a.ndim == 2 and a.shape[1] == 3)
    counts = np.full(100352, 3, np.int32)

    def save():
        layer = out / "a.usdc"
        layer.unlink(missing_ok=True)
        stage = Usd.Stage.CreateNew(str(layer))
        mesh = UsdGeom.Mesh.Define(stage, "/field")
        mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
        mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(normals))
        mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(indices))
        mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(counts))
        UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, "vertex").Set(Vt.Vec2fArray.FromNumpy(uvs))
        stage.GetRootLayer().Save()
        with Sdf.ZipFileWriter.CreateNew(str(out / "a.usdz")) as package:
            package.AddFile(str(layer), "a.usdc")

    write, _ = median(save)
    yield "USDZ", "usd-core " + ".".join(map(str, Usd.GetVersion()[1:])), out / "a.usdz", write, read


def rasters(folder, out):
    import rasterio

    name = f"GDAL {rasterio.__gdal_version__}"

    def load(path):
        with rasterio.open(path) as f:
            return f.read(), f.profile

    for format_, path, options in (
        ("GeoTIFF", "tile.tif", {"driver": "GTiff"}),
        ("JPEG 2000", "tile.jp2", {"driver": "JP2OpenJPEG", "QUALITY": "100", "REVERSIBLE": "YES", "YCBCR420": "NO"}),
    ):
        read, (pixels, profile) = median(lambda: load(folder / path))
        kept = {k: profile[k] for k in ("width", "height", "count", "dtype", "crs", "transform")}

        def save():
            with rasterio.open(out / path, "w", **kept, **options) as f:
                f.write(pixels)

        write, _ = median(save)
        if format_ == "JPEG 2000":
            assert (load(out / path)[0] == pixels).all(), "not without loss"
        yield format_, name, out / path, write, read if format_ == "GeoTIFF" else None


def shapes(folder, out):
    import pyogrio
    import pyogrio.raw

    read, (meta, _, geometry, fields) = median(lambda: pyogrio.raw.read(folder / "features.shp"))
    assert len(geometry) == 16384

    def save():
        pyogrio.raw.write(out / "features.shp", geometry, fields, meta["fields"], geometry_type="Point Z", crs="EPSG:4326")

    write, _ = median(save)
    yield "Shapefile", "GDAL " + pyogrio.__gdal_version_string__, None, write, read


def textures(folder, out):
    import OpenImageIO as oiio

    def load():
        return oiio.ImageBuf(str(folder / "texture.rgb")).get_pixels(oiio.UINT8)

    read, pixels = median(load)

    def save():
        f = oiio.ImageOutput.create(str(out / "a.rgb"))
        spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], oiio.UINT8)
        spec["compression"] = "rle"
        assert f.open(str(out / "a.rgb"), spec) and f.write_image(pixels) and f.close()

    write, _ = median(save)
    yield "SGI .rgb", f"OpenImageIO {oiio.VERSION_STRING}", out / "a.rgb", write, read


def tiles(folder, out):
    from importlib.metadata import version

    from py3dtiles.tileset import TileSet

    read, tileset = median(lambda: TileSet.from_file(folder / "tileset.json"))
    write, _ = median(lambda: tileset.write_as_json(out / "tileset.json"))
    yield "3D Tiles", f"py3dtiles {version('py3dtiles')}", out / "tileset.json", write, read


def outside(command):
    """Lines of another process: format, program, file, seconds to write and to read, between tabs."""
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    for line in printed.splitlines():
        format_, name, path, write, read = line.split("\t")
        yield format_, name, pathlib.Path(path), *(None if s == "-" else float(s) for s in (write, read))


def gltf(folder, out):
    yield from outside(["node", HERE / "gltf_speed.cjs", folder, out])


def openflight(folder, out):
    libraries = ["-losg", "-losgDB", "-losgUtil", "-lOpenThreads"]
    subprocess.run(["g++", "-O2", "-o", out / "flt", HERE / "osg_speed.cpp", *libraries], check=True)
    yield from outside([out / "flt", folder, out])


def cell(seconds, count, size):
    if seconds is None:
        return "–"
    rate = f"{count / seconds / 1e6:.2f} M/s"
    return f"{rate}, {size / seconds / 1e6:.0f} MB/s" if size else rate


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    cargo = [os.environ.get("CARGO", "cargo"), "run", "--quiet", "--locked", "--release", "-p", "orb-formats", "--example", "speed", "--"]
    printed = subprocess.run([*cargo, folder], check=True, capture_output=True, text=True, cwd=HERE.parent.parent).stdout
    ours = [line.split("\t") for line in printed.splitlines() if not line.startswith("#")]
    notes = [line for line in printed.splitlines() if line.startswith("#")]
    theirs = {}
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        for program in (splat_files, gltf, usd, openflight, textures, rasters, shapes, tiles):
            try:
                for format_, name, path, write, read in program(folder, pathlib.Path(scratch)):
                    size = path.stat().st_size if path and write is not None and path.exists() else None
                    theirs[format_] = (name, size, write, read)
            except (ImportError, OSError, subprocess.CalledProcessError) as why:
                print(f"left out, {program.__name__}: {why} {getattr(why, 'stderr', '') or ''}", file=sys.stderr)
    print("| File | Size | Orb writes | Orb reads | Other | its size | writes | reads |")
    print("|---|---|---|---|---|---|---|---|")
    for name, unit, count, size, write, read in ours:
        count, size = int(count), int(size)
        write, read = (None if s == "-" else float(s) for s in (write, read))
        other, other_size, other_write, other_read = theirs.get(name, ("–", None, None, None))
        cells = [f"{name}, {count:,} {unit}", f"{size / 1e6:.2f} MB", cell(write, count, size), cell(read, count, size), other]
        cells += [f"{other_size / 1e6:.2f} MB" if other_size else "–", cell(other_write, count, other_size), cell(other_read, count, size)]
        print("| " + " | ".join(cells) + " |")
    print("\n".join(notes))


if __name__ == "__main__":
    main()
