// The camera of the server's pictures, so that marks can be drawn over them: an orbit around a target, Z up.

const RADIANS = Math.PI / 180;
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const add = (a, b, times = 1) => a.map((v, i) => v + times * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((v) => v / Math.hypot(...a));

/** Where the camera stands, and its axes: right, down, forward. */
export function axes(camera, scene) {
  const [a, e] = [camera.az * RADIANS, Math.min(89.9, Math.max(-89.9, camera.el)) * RADIANS];
  const out = [Math.cos(e) * Math.sin(a), -Math.cos(e) * Math.cos(a), Math.sin(e)];
  const target = add(scene.centre, [camera.tx, camera.ty, camera.tz]);
  const forward = out.map((v) => -v);
  const right = unit(cross(forward, [0, 0, 1]));
  return { eye: add(target, out, camera.dist), right, down: cross(forward, right), forward };
}

/** A point of the scene in a picture of this size; null behind the camera. */
export function project(point, camera, scene, width, height) {
  const { eye, right, down, forward } = axes(camera, scene);
  const from = add(point, eye, -1);
  const z = dot(from, forward);
  if (z < 1e-6) return null;
  const focal = height / 2 / Math.tan((scene.field / 2) * RADIANS);
  return [width / 2 + (focal * dot(from, right)) / z, height / 2 + (focal * dot(from, down)) / z];
}

/** Whether the scene's middle stands before a point. */
export function hidden(point, camera, scene) {
  const { eye } = axes(camera, scene);
  const [to, middle] = [add(point, eye, -1), add(scene.centre, eye, -1)];
  const along = dot(to, middle) / dot(to, to);
  return along > 0 && along < 1 && Math.hypot(...add(middle, to, -along)) < 0.6 * scene.radius;
}

/** From how far the whole scene is in the picture. */
export function fitting(scene, width, height) {
  const up = (scene.field / 2) * RADIANS;
  const across = Math.atan((Math.tan(up) * width) / height);
  return (1.05 * scene.radius) / Math.sin(Math.min(up, across));
}

/** Degrees clockwise from true north that the camera looks in. */
export function bearing(camera, scene) {
  const heading = scene.place ? scene.place.heading : 0;
  return (((heading - camera.az) % 360) + 360) % 360;
}

/** A point given in metres east and north of the origin, on the ground, in the scene's own axes. */
export function onGround(east, north, scene) {
  const h = (scene.place ? scene.place.heading : 0) * RADIANS;
  return [east * Math.cos(h) - north * Math.sin(h), east * Math.sin(h) + north * Math.cos(h), 0];
}
