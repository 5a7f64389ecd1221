// Draws the scene's Gaussians in this browser, by Spark and three.js, as the server's renderer draws them: the same camera,
// the same Gaussians in the same frame (metres, Z up), the same low-pass and cut-offs, the same ground.
import { SparkRenderer, SplatFileType, SplatMesh } from "@sparkjsdev/spark";
import { Color, PerspectiveCamera, Scene, SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import { Ground } from "./ground.js";

// As in src/splat/render/projection.rs: pixel² added to the covariance of what is projected, the alpha below which nothing
// is drawn, and so how many standard deviations are.
const LOW_PASS = 0.3;
const MIN_ALPHA = 1 / 255;
const REACH = Math.sqrt(2 * Math.log(255));
// As in src/view/draw.rs.
const PAPER = { light: 0.97, dark: 0.09 };

/**
 * Opens a canvas for a scene.
 *
 * `canvas` has no context yet. `scene` is what `scene.json` says. `file` is the scene as PLY, an ArrayBuffer in the scene's own
 * axes. `lost` is called when the browser takes the canvas's memory away.
 * Throws an error, in words for the user, without WebGL2 or for a file that is no scene.
 */
export async function open(canvas, scene, file, lost) {
  const context = canvas.getContext("webgl2", { antialias: false, alpha: false, powerPreference: "high-performance" });
  if (!context) throw new Error("This browser has no WebGL2");
  const renderer = new WebGLRenderer({ canvas, context, antialias: false });
  canvas.addEventListener("webglcontextlost", lost, { once: true });
  const spark = new SparkRenderer({
    renderer,
    // It is told when to sort, so that it is known which picture is the right one.
    autoUpdate: false,
    enableLod: false,
    enableDriveLod: false,
    accumExtSplats: true,
    sortRadial: false,
    preBlurAmount: LOW_PASS,
    blurAmount: 0,
    minAlpha: MIN_ALPHA,
    maxStdDev: REACH,
    maxPixelRadius: 8192,
  });
  const splats = new SplatMesh({ fileBytes: file, fileType: SplatFileType.PLY, extSplats: true });
  const ground = new Ground(scene);
  const world = new Scene();
  world.add(ground.mesh, spark, splats);
  const close = () => {
    canvas.removeEventListener("webglcontextlost", lost);
    splats.dispose();
    spark.dispose();
    ground.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
  };
  try {
    await splats.initialized;
  } catch (e) {
    close();
    throw e;
  }
  const camera = new PerspectiveCamera(scene.field, 1, 0.002 * scene.radius, 200 * scene.radius);
  camera.matrixAutoUpdate = false;
  const paper = new Color();
  let [wanted, sorted, sorting] = [0, -1, null];

  const paint = () => renderer.render(world, camera);

  /** Sorts until the order is that of the last camera. */
  async function settle() {
    while (sorted !== wanted) {
      const now = wanted;
      await spark.update({ scene: world, camera });
      sorted = now;
      paint();
    }
    sorting = null;
  }

  return {
    /**
     * Paints at once, in the order of the picture before, and again when the Gaussians are sorted. `view` is `axes` of
     * camera.js, `look` { width, height, grid, dark }, pixels. The promise is kept when the picture is the right one.
     */
    draw(view, { width, height, grid, dark }) {
      if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      // three.js looks along its own −z with y up in the picture.
      const [right, down, forward, eye] = [view.right, view.down, view.forward, view.eye].map((v) => new Vector3(...v));
      camera.matrix.makeBasis(right, down.negate(), forward.negate()).setPosition(eye);
      camera.updateMatrixWorld(true);
      const grey = dark ? PAPER.dark : PAPER.light;
      renderer.setClearColor(paper.setRGB(grey, grey, grey, SRGBColorSpace));
      ground.look({ grid, dark, pixel: (2 * Math.tan((scene.field * Math.PI) / 360)) / height });
      wanted += 1;
      paint();
      sorting ??= settle();
      return sorting;
    },
    close,
  };
}
