"""usdz_check.py FILE.usdz...: OpenUSD opens each file and checks it under ARKit's rules.

With usd-core up to 25.x it runs the class behind `usdchecker --arkit`, with later ones the UsdValidation framework that
replaced it. Prints what the stage holds; exit code 1 on any failure.
"""
import sys

from pxr import Usd, UsdGeom, UsdUtils


def arkit_failures(path):
    checker = UsdUtils.ComplianceChecker(
        arkit=True, skipARKitRootLayerCheck=False, rootPackageOnly=False, skipVariants=False, verbose=False
    )
    checker.CheckCompliance(path)
    failed = list(checker.GetErrors()) + list(checker.GetFailedChecks())
    # Wheels lack OpenUSD's folder of shader definitions, so no shader is known to them.
    return [f for f in failed if "has invalid shader node" not in f] + [f"warning: {w}" for w in checker.GetWarnings()]


def validation_errors(stage):
    from pxr import UsdValidation

    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    return [f"{e.GetName()}: {e.GetMessage()}" for e in context.Validate(stage) if "Error" in str(e.GetType())]


try:
    from pxr import Sdr

    Sdr.Registry()
except Exception:  # the missing shader definitions, once
    pass

failed = False
for path in sys.argv[1:]:
    stage = Usd.Stage.Open(path)
    meshes = [UsdGeom.Mesh(p) for p in stage.Traverse() if p.IsA(UsdGeom.Mesh)]
    triangles = sum(len(m.GetFaceVertexCountsAttr().Get()) for m in meshes)
    print(
        path,
        f"up {UsdGeom.GetStageUpAxis(stage)} mpu {UsdGeom.GetStageMetersPerUnit(stage)}",
        f"default {stage.GetDefaultPrim().GetPath()} meshes {len(meshes)} triangles {triangles}",
        f"data {dict(stage.GetRootLayer().customLayerData)}",
    )
    fields = [p for p in stage.Traverse() if p.GetTypeName() == "ParticleField3DGaussianSplat"]
    for prim in fields:
        # The schema came with 26.03; earlier readers know the values all the same.
        names = ("positions", "scales", "orientations", "opacities", "radiance:sphericalHarmonicsCoefficients")
        positions, scales, orientations, opacities, harmonics = (prim.GetAttribute(n).Get() for n in names)
        degree = prim.GetAttribute("radiance:sphericalHarmonicsDegree").Get()
        turn = orientations[-1]
        last = [*positions[-1], *scales[-1], turn.GetReal(), *turn.GetImaginary(), opacities[-1], *harmonics[-1]]
        known = prim.IsDefined() and prim.GetPrimTypeInfo().GetSchemaType().typeName
        print(f"{prim.GetPath()} schema {known} splats {len(positions)} degree {degree} coefficients {len(harmonics)} last", *last)
    if fields and hasattr(UsdUtils, "ComplianceChecker"):
        print(path, "is for OpenUSD 26.03 and later: ARKit knows no fields of Gaussians")
    checks = arkit_failures(path) if hasattr(UsdUtils, "ComplianceChecker") else validation_errors(stage)
    for line in checks:
        print("  ", line)
    failed = failed or bool(checks)
    print(path, "FAILED" if checks else "OK")
sys.exit(failed)
