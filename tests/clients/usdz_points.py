"""usdz_points.py FILE.usdz: the place that the package names and every point of its meshes, by OpenUSD.

One line `place LATITUDE LONGITUDE HEIGHT HEADING`, then a line `point X Y Z` each, in the stage's own axes and units.
"""
import sys

from pxr import Usd, UsdGeom

stage = Usd.Stage.Open(sys.argv[1])
assert UsdGeom.GetStageUpAxis(stage) == "Y" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
data = stage.GetRootLayer().customLayerData
print("place", *(repr(data[f"orb:{name}"]) for name in ("latitude", "longitude", "height", "heading")))
cache = UsdGeom.XformCache()
for prim in stage.Traverse():
    if prim.IsA(UsdGeom.Mesh):
        world = cache.GetLocalToWorldTransform(prim)
        for point in UsdGeom.Mesh(prim).GetPointsAttr().Get():
            print("point", *world.Transform(point))
