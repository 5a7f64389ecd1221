// The map grid as src/view/ground.rs draws it, under everything else.
import { DoubleSide, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector3 } from "three";

// Lines either side of the origin, and steps to the arrow's tip.
const HALF = 10;
const ARROW = 8;
const COLOURS = {
  light: { lines: [0.62, 0.62, 0.62], arrow: [0.8, 0.42, 0], north: [0, 0.35, 0.75] },
  dark: { lines: [0.45, 0.45, 0.45], arrow: [0.95, 0.65, 0.15], north: [0.35, 0.65, 1] },
};

const vertex = `
varying vec3 at;
void main() {
  at = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragment = `
uniform float steps, pixel;
uniform vec2 heading;
uniform vec3 lines, arrow, north;
varying vec3 at;

float thin(float distance, float half_width, float width) { return clamp(half_width + 0.5 - distance / width, 0.0, 1.0); }

void main() {
  // East and north of the origin, in steps.
  vec2 p = vec2(at.x * heading.y + at.y * heading.x, at.y * heading.y - at.x * heading.x) / steps;
  vec3 ray = at - cameraPosition;
  float depth = -(viewMatrix * vec4(at, 1.0)).z;
  float slant = max(abs(ray.z) / length(ray), 1e-3);
  float width = depth * pixel / sqrt(slant) / steps;
  float edge = max(abs(p.x), abs(p.y));
  if (edge > ${HALF.toFixed(1)} + 0.5 * width) discard;
  float fade = clamp(2.0 - 4.0 * width, 0.0, 1.0) * clamp(1.5 - edge / ${HALF.toFixed(1)}, 0.0, 1.0);
  vec2 off = abs(p - floor(p + 0.5));
  float share = 0.6 * fade * thin(min(off.x, off.y), 0.5, width);
  vec3 color = lines * share;
  float alpha = share;
  if (abs(p.x) < 0.5 && p.y >= 0.0 && p.y <= ${HALF.toFixed(1)}) {
    share = thin(abs(p.x), 1.0, width);
    color = mix(color, north, share);
    alpha = mix(alpha, 1.0, share);
  }
  vec2 q = at.xy / steps;
  float shaft = max(max(abs(q.x) - 0.06, -q.y), q.y - ${(ARROW - 0.6).toFixed(1)});
  float head = max(${(ARROW - 0.7).toFixed(1)} - q.y, (abs(q.x) - (${ARROW.toFixed(1)} - q.y) * 0.5) * 0.894);
  share = clamp(0.5 - min(shaft, head) / width, 0.0, 1.0);
  color = mix(color, arrow, share);
  alpha = mix(alpha, 1.0, share);
  gl_FragColor = vec4(color, alpha);
}`;

export class Ground {
  /** `scene` is what `scene.json` says. */
  constructor(scene) {
    const radians = ((scene.place ? scene.place.heading : 0) * Math.PI) / 180;
    this.material = new ShaderMaterial({
      vertexShader: vertex,
      fragmentShader: fragment,
      uniforms: {
        steps: { value: scene.grid_step },
        pixel: { value: 0 },
        heading: { value: new Vector2(Math.sin(radians), Math.cos(radians)) },
        lines: { value: new Vector3() },
        arrow: { value: new Vector3() },
        north: { value: new Vector3() },
      },
      // Colours come times their alpha. Under everything, wherever it stands: the server draws it so too.
      premultipliedAlpha: true,
      side: DoubleSide,
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    // The grid turns with the heading: so far its corners reach, and a little more.
    const side = 2 * 1.5 * HALF * scene.grid_step;
    this.mesh = new Mesh(new PlaneGeometry(side, side), this.material);
    this.mesh.renderOrder = -1;
    this.mesh.frustumCulled = false;
  }

  /** `pixel` is a pixel's size at a distance of one. */
  look({ grid, dark, pixel }) {
    this.mesh.visible = grid;
    const { uniforms } = this.material;
    uniforms.pixel.value = pixel;
    for (const [name, value] of Object.entries(COLOURS[dark ? "dark" : "light"])) uniforms[name].value.set(...value);
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
