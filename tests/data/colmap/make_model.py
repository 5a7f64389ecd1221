"""Writes a COLMAP model with one image a camera model, as text and as binary, and where COLMAP itself projects points.

    pip install pycolmap numpy
    python make_model.py          # writes text/, binary/ and projections.json beside itself
"""
import json
import pathlib

import numpy as np
import pycolmap

here = pathlib.Path(__file__).parent
LENSES = {
    "SIMPLE_PINHOLE": [500, 320, 240],
    "PINHOLE": [500, 510, 321, 239],
    "SIMPLE_RADIAL": [500, 320, 240, 0.05],
    "RADIAL": [500, 320, 240, 0.05, -0.02],
    "OPENCV": [500, 510, 321, 239, 0.05, -0.02, 0.003, -0.002],
    "OPENCV_FISHEYE": [500, 510, 321, 239, 0.05, -0.02, 0.003, -0.002],
    "FULL_OPENCV": [500, 510, 321, 239, 0.05, -0.02, 0.003, -0.002, 0.01, 0.02, -0.01, 0.004],
    "FOV": [500, 510, 321, 239, 0.9],
    "SIMPLE_RADIAL_FISHEYE": [500, 320, 240, 0.05],
    "RADIAL_FISHEYE": [500, 320, 240, 0.05, -0.02],
    "THIN_PRISM_FISHEYE": [500, 510, 321, 239, 0.05, -0.02, 0.003, -0.002, 0.01, 0.02, -0.01, 0.004],
    "RAD_TAN_THIN_PRISM_FISHEYE": [500, 510, 321, 239, 0.05, -0.02, 0.003, -0.002, 0.01, 0.02, 0.001, -0.002, 0.004, 0.003, -0.001, 0.002],
}
rays = [[0.0, 0.0], [0.1, -0.2], [-0.45, 0.3], [0.6, 0.4], [0.001, 0.002]]
model = pycolmap.Reconstruction()
projections = {}
for number, (name, parameters) in enumerate(LENSES.items(), 1):
    camera = pycolmap.Camera(camera_id=number, model=name, width=640, height=480, params=parameters)
    model.add_camera_with_trivial_rig(camera)
    points = np.array([[u, v, 1.0] for u, v in rays])
    projections[name] = np.asarray(camera.img_from_cam(points)).tolist()
    angle = 0.3 * number
    rotation = pycolmap.Rotation3d(np.array([0.0, np.sin(angle / 2), 0.0, np.cos(angle / 2)]))
    pose = pycolmap.Rigid3d(rotation, np.array([0.1 * number, -0.2, 2.0]))
    image = pycolmap.Image(name=f"shots/{name.lower()} {number}.jpg", camera_id=number, image_id=number)
    image.points2D = pycolmap.Point2DList([pycolmap.Point2D(np.array([10.5, 20.25])), pycolmap.Point2D(np.array([30.0, 40.0]))])
    model.add_image_with_trivial_frame(image, pose)
track = pycolmap.Track()
track.add_element(1, 0)
track.add_element(3, 1)
model.add_point3D(np.array([0.5, -1.5, 4.0]), track, np.array([10, 20, 255], dtype=np.uint8))
for folder, write in [("text", model.write_text), ("binary", model.write_binary)]:
    (here / folder).mkdir(exist_ok=True)
    write(str(here / folder))
(here / "projections.json").write_text(json.dumps({"pycolmap": pycolmap.__version__, "rays": rays, "pixels": projections}, indent=1) + "\n")
