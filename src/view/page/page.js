// Asks the server for pictures and steers the camera. One picture is on its way at a time; the next one asked for is of
// where the camera is then, so a slow line shows fewer pictures and never old ones.
import { add, axes, bearing, fitting, hidden, onGround, project } from "./camera.js";

const $ = (id) => document.getElementById(id);
const [stage, frame, marks, legend] = ["stage", "frame", "marks", "legend"].map($);
const dark = matchMedia("(prefers-color-scheme: dark)");
const still = matchMedia("(prefers-reduced-motion: reduce)");
// Milliseconds: without a change the camera rests; a picture on the way should take no longer.
const RESTS = 180, QUICK = 60;
// Until a scene that has come is drawn here.
const OPENS = 60_000;
const MOST_PIXELS = 1920 * 1200;

const scene = await (await fetch("scene.json")).json();
const unit = scene.metric ? "m" : "units";
const camera = { az: 30, el: 20, dist: 0, tx: 0, ty: 0, tz: 0 };
const look = { show: "colour", level: 0, grid: true };
const points = [];
// `version` counts what the user did; a picture knows the version that it is of.
let [version, drawn, drawnAtRest, moving, scale, sent] = [0, -1, false, false, 0.6, null];
let shown = { ...camera };
let [rest, measuring, turning, said] = [0, false, false, ""];
// Until the user moves or zooms, the whole scene stays in the picture, however the window changes.
let fitted = true;
// What draws in this browser instead of the server, while it does; whether it is to; the next paint; what is said of that.
let [here, wantedHere, painting, notice] = [null, null, 0, ""];

function say(text) {
  if (text !== said) $("state").textContent = said = text;
}

function changed() {
  version += 1;
  moving = true;
  notice = "";
  delete stage.dataset.settled;
  clearTimeout(rest);
  rest = setTimeout(() => { moving = false; ask(); }, RESTS);
  ask();
}

function wanted(atRest) {
  const { clientWidth: w, clientHeight: h } = stage;
  const sharp = Math.min(devicePixelRatio, Math.sqrt(MOST_PIXELS / (w * h)));
  const by = atRest ? sharp : Math.min(scale, sharp);
  const side = (v) => Math.max(16, Math.min(3840, Math.round(v * by)));
  return { ...camera, ...look, w: side(w), h: side(h), dark: dark.matches, rest: atRest };
}

async function ask() {
  if (!stage.clientWidth || !stage.clientHeight || document.hidden) return;
  if (here) {
    painting ||= requestAnimationFrame(paintHere);
    return;
  }
  if (sent) {
    // A sharp picture takes long, and nobody waits for it any more.
    if (sent.rest && sent.version !== version) sent.abort.abort();
    return;
  }
  const atRest = !moving;
  if (drawn === version && (drawnAtRest || !atRest)) return;
  const mine = { version, rest: atRest, abort: new AbortController(), camera: { ...camera } };
  sent = mine;
  const begin = performance.now();
  let again = 0;
  try {
    const answer = await fetch("frame?" + new URLSearchParams(wanted(atRest)), { signal: mine.abort.signal });
    if (answer.status === 503) again = 300;
    else if (!answer.ok) throw new Error(await answer.text());
    else if (!here) {
      await paint(await answer.blob());
      if (!atRest) scale = Math.min(1, Math.max(0.25, scale * Math.min(1.25, Math.max(0.7, Math.sqrt(QUICK / (performance.now() - begin))))));
      [drawn, drawnAtRest, shown] = [mine.version, atRest, mine.camera];
      stage.dataset.pictures = Number(stage.dataset.pictures || 0) + 1;
      if (atRest) stage.dataset.rested = `${stage.clientWidth}x${stage.clientHeight}`;
      overlay();
      if (atRest && drawn === version) settled("server");
    }
  } catch (e) {
    if (e.name !== "AbortError") {
      say(e instanceof TypeError ? "No answer: orb view may have ended. Start it again and open the address that it prints." : e.message);
      turntable(false);
      again = -1;
    }
  }
  sent = null;
  if (again >= 0) setTimeout(ask, again);
}

async function paint(blob) {
  const address = URL.createObjectURL(blob);
  const before = frame.src;
  frame.src = address;
  try { await frame.decode(); } finally { if (before) URL.revokeObjectURL(before); }
}

/** The picture of where the camera is now is there, and it rests. */
function settled(by) {
  stage.dataset.settled = by;
  describe();
}

// ---- drawing in this browser, where the server has the script for it

function paintHere() {
  painting = 0;
  if (!here) return;
  const { w, h } = wanted(true);
  const [mine, atRest] = [version, !moving];
  [drawn, drawnAtRest, shown] = [version, atRest, { ...camera }];
  const how = { width: w, height: h, grid: look.grid, dark: dark.matches };
  here.draw(axes(shown, scene), how).then(
    () => { if (here && atRest && mine === version) settled("browser"); },
    (e) => drawHere(false, e.message),
  );
  stage.dataset.pictures = Number(stage.dataset.pictures || 0) + 1;
  overlay();
}

/** Changes over, `why` in words where the user did not ask for it. */
async function drawHere(on, why = "") {
  if (on === Boolean(wantedHere)) return;
  const mine = (wantedHere = on ? {} : null);
  $("webgl").setAttribute("aria-pressed", on);
  if (!on) {
    here?.close();
    $("here")?.remove();
    [here, drawn, notice] = [null, -1, why && `${why}: the server draws.`];
    frame.hidden = false;
    delete stage.dataset.settled;
    return ask();
  }
  // What it does not draw.
  Object.assign(look, { show: "colour", level: 0 });
  $("show").value = "colour";
  $("level").value = 0;
  changed();
  notice = "Getting ready to draw in this browser.";
  const canvas = Object.assign(document.createElement("canvas"), { id: "here" });
  try {
    if (!document.createElement("canvas").getContext("webgl2")) throw new Error("This browser has no WebGL2");
    const [{ open }, answer] = await Promise.all([import("./webgl.js"), fetch("scene.ply")]);
    if (!answer.ok) throw new Error(await answer.text());
    const late = new Promise((_, refuse) => setTimeout(refuse, OPENS, new Error("WebGL did not begin in time")));
    const lost = () => drawHere(false, "The browser took WebGL's memory away");
    const opened = await Promise.race([open(canvas, scene, await answer.arrayBuffer(), lost), late]);
    // Changed over again meanwhile.
    if (wantedHere !== mine) return opened.close();
    here = opened;
    frame.after(canvas);
    frame.hidden = true;
    changed();
  } catch (e) {
    if (wantedHere === mine) drawHere(false, e.message);
  }
}

// ---- words

// Three digits, zeros and all.
const length = (v) => (v < 1000 ? v.toPrecision(3) : v.toFixed(0));
const number = (v, digits = 3) => Number(v.toPrecision(digits)).toLocaleString("en", { maximumFractionDigits: 4 });

function describe() {
  if (points.length === 2) return;
  const name = look.level ? `level ${look.level}` : scene.gaussians ? "Gaussians" : "level 1";
  const ofLevel1 = { provenance: "where the texture of level 1 comes from", error: "how far the network expected the colours of level 1 to be off" };
  const what = ofLevel1[look.show] ?? `${look.show} of ${name}`;
  const above = camera.el < 0 ? "below" : "above";
  const words = `Looking ${bearing(camera, scene).toFixed(0)}°${scene.place ? " from north" : ""}, ${Math.abs(camera.el).toFixed(0)}° from ${above}, ${number(camera.dist)} ${unit} away; ${what}${here ? ", drawn in this browser" : ""}.`;
  if (notice) say(`${notice} ${words}`);
  else say(measuring ? `${words} Measuring: point ${points.length + 1} of 2.` : words);
  stage.setAttribute("aria-label", `3D view of ${scene.name}. ${words}`);
  frame.alt = `Picture of ${scene.name}. ${words}`;
}

function placed() {
  const parts = [];
  if (scene.place) {
    const { latitude, longitude, height, heading, heading_source: source, heading_sigma: sigma } = scene.place;
    parts.push(`Origin ${latitude.toFixed(6)}, ${longitude.toFixed(6)}, ${number(height, 5)} m above the ellipsoid; heading ${number(heading, 4)}°${source ? ` ± ${Number(sigma).toFixed(0)} (${source})` : ""}.`);
  } else parts.push("Not placed on the Earth: the grid's north is where the photo's camera looked.");
  if (!scene.metric) parts.push("Not scaled: lengths are in the file's own units.");
  else if (scene.scale) parts.push(`Scale ± ${Number(scene.scale[1]).toFixed(0)} % (${scene.scale[0]}).`);
  parts.push(`Grid ${number(scene.grid_step)} ${unit}.`, ...scene.notes);
  $("place").textContent = parts.join(" ");
}

// ---- marks over the picture

function element(name, attributes, text) {
  const e = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  if (text) e.textContent = text;
  return e;
}

function overlay() {
  const { clientWidth: w, clientHeight: h } = stage;
  const at = (p) => project(p, shown, scene, w, h);
  const out = [];
  let pole = null;
  if (look.grid) {
    const far = 10.4 * scene.grid_step;
    for (const [name, east, north] of [["N", 0, far], ["E", far, 0], ["S", 0, -far], ["W", -far, 0]]) {
      const place = onGround(east, north, scene);
      const p = hidden(place, shown, scene) ? null : at(place);
      if (p) out.push(element("text", { x: p[0], y: p[1] + 4, class: name === "N" ? "north" : "" }, name));
      if (p && name === "N") pole = p;
    }
    const arrow = [0, 8.5 * scene.grid_step, 0];
    const tip = hidden(arrow, shown, scene) ? null : at(arrow);
    // One below the other where they would meet.
    const low = tip && pole && Math.hypot(tip[0] - pole[0], tip[1] - pole[1]) < 30 ? 20 : 0;
    if (tip) out.push(element("text", { x: tip[0], y: tip[1] + low }, "heading"));
  }
  const rose = element("g", { transform: `translate(${w - 34} 36) rotate(${-bearing(shown, scene)})` });
  rose.append(element("circle", { r: 18, class: "rose" }), element("path", { d: "M0 -16 L5 4 L0 1 L-5 4 Z", class: "needle" }), element("text", { y: -20, class: "north" }, "N"));
  out.push(rose);
  if (measuring && points.length < 2) out.push(element("path", { d: `M${w / 2 - 9} ${h / 2}h18M${w / 2} ${h / 2 - 9}v18`, class: "cross" }));
  const ends = points.map((p) => at(p.at)).filter(Boolean);
  if (ends.length === 2) {
    out.push(element("path", { d: `M${ends[0]}L${ends[1]}`, class: "rule" }));
    out.push(element("text", { x: (ends[0][0] + ends[1][0]) / 2, y: (ends[0][1] + ends[1][1]) / 2 - 8, class: "length" }, measured().short));
  }
  for (const [x, y] of ends) out.push(element("circle", { cx: x, cy: y, r: 4, class: "rule" }));
  marks.replaceChildren(...out);
  legend.hidden = look.show !== "depth" && look.show !== "error";
  $("sources").hidden = look.show !== "provenance";
  if (look.show === "error") {
    [...legend.children].forEach((e, i) => (e.textContent = i ? "0" : `${scene.largest_error} of 255 or more`));
  } else if (!legend.hidden) {
    const { eye, forward } = axes(shown, scene);
    const middle = add(scene.centre, eye, -1).reduce((sum, v, i) => sum + v * forward[i], 0);
    [...legend.children].forEach((e, i) => (e.textContent = `${number(Math.max(0, middle + (i ? 1 : -1) * scene.radius))} ${unit}`));
  }
}

// ---- measuring

function measured() {
  const d = add(points[1].at, points[0].at, -1);
  const [whole, across] = [Math.hypot(...d), Math.hypot(d[0], d[1])];
  const known = scene.metric && scene.scale ? ` ± ${number((whole * scene.scale[1]) / 100, 2)} ${unit} by the scale (${scene.scale[0]})` : "";
  return { short: `${length(whole)} ${unit}`, long: `Distance ${length(whole)} ${unit}${known}; ${length(across)} across, ${length(Math.abs(d[2]))} up.` };
}

async function pick(x, y) {
  const { clientWidth: w, clientHeight: h } = stage;
  const query = { ...wanted(true), ...shown };
  // As sharp as the picture is, and no sharper than is needed to point.
  Object.assign(query, { x: Math.floor((x / w) * query.w), y: Math.floor((y / h) * query.h) });
  try {
    const answer = await fetch("point?" + new URLSearchParams(query));
    if (!answer.ok) return say(await answer.text());
    const { point, place } = await answer.json();
    if (!point) return say("Nothing is there to measure: point at the model or the grid.");
    if (points.length === 2) points.length = 0;
    points.push(point);
    const where = place ? ` at ${place.latitude.toFixed(7)}, ${place.longitude.toFixed(7)}, ${place.height.toFixed(2)} m` : "";
    say(points.length === 2 ? measured().long : `First point ${point.ground ? "on the ground" : "on the model"}${where}. Point at the second.`);
    overlay();
  } catch { say("No answer: orb view may have ended."); }
}

function measure(on) {
  measuring = on;
  points.length = 0;
  $("measure").setAttribute("aria-pressed", on);
  stage.classList.toggle("measuring", on);
  overlay();
  if (on) say("Measuring: click the first point, or press Enter at the cross.");
  else describe();
}

// ---- steering

function turn(az, el) {
  camera.az = (camera.az + az) % 360;
  camera.el = Math.min(89.9, Math.max(-89.9, camera.el + el));
  changed();
}

function move(dx, dy) {
  fitted = false;
  const { right, down } = axes(camera, scene);
  const pixel = (2 * camera.dist * Math.tan((scene.field * Math.PI) / 360)) / stage.clientHeight;
  let t = [camera.tx, camera.ty, camera.tz];
  t = add(add(t, right, -dx * pixel), down, -dy * pixel);
  const most = 20 * scene.radius;
  [camera.tx, camera.ty, camera.tz] = t.map((v) => Math.min(most, Math.max(-most, v)));
  changed();
}

function zoom(by) {
  fitted = false;
  camera.dist = Math.min(50 * scene.radius, Math.max(0.05 * scene.radius, camera.dist * by));
  changed();
}

function fit() {
  fitted = true;
  Object.assign(camera, { dist: fitting(scene, stage.clientWidth, stage.clientHeight), tx: 0, ty: 0, tz: 0 });
  changed();
}

function side() {
  Object.assign(camera, { az: 0, el: scene.photo_elevation ?? 10 });
  fit();
}

function map() {
  Object.assign(camera, { az: scene.place ? scene.place.heading : 0, el: 89.9 });
  fit();
}

function turntable(on) {
  if (on === turning) return;
  turning = on;
  $("turn").setAttribute("aria-pressed", on);
  if (!on) return;
  let before = performance.now();
  const step = (now) => {
    if (!turning) return;
    if (!sent) turn((20 * Math.min(200, now - before)) / 1000, 0), (before = now);
    requestAnimationFrame(step);
  };
  // Who wants less motion gets steps.
  const jump = () => { if (turning) { turn(30, 0); setTimeout(jump, 2000); } };
  if (still.matches) jump(); else requestAnimationFrame(step);
}

function toggle(name, value) {
  look[name] = value;
  if (look.show !== "colour" || look.level) drawHere(false);
  changed();
}

function grid() {
  $("grid").setAttribute("aria-pressed", !look.grid);
  toggle("grid", !look.grid);
}

function compare() {
  if (!scene.photo) return;
  const photo = $("photo");
  photo.hidden = !photo.hidden;
  $("compare").setAttribute("aria-pressed", !photo.hidden);
  if (!photo.hidden) { photo.querySelector("img").src = "photo"; side(); }
}

function show(value) {
  $("show").value = value;
  toggle("show", value);
}

function level(value) {
  $("level").value = value;
  toggle("level", Number(value));
}

const keys = {
  ArrowLeft: () => turn(-5, 0), ArrowRight: () => turn(5, 0), ArrowUp: () => turn(0, 5), ArrowDown: () => turn(0, -5),
  "+": () => zoom(0.9), "=": () => zoom(0.9), "-": () => zoom(1 / 0.9),
  f: fit, p: side, n: map, t: () => turntable(!turning), m: () => measure(!measuring), g: grid, c: compare,
  1: () => show("colour"), 2: () => show("depth"), 3: () => show("normals"),
  4: () => { if (scene.provenance) show("provenance"); },
  5: () => { if (scene.error) show("error"); },
  l: () => { const all = $("level").options; if (all.length) level(all[($("level").selectedIndex + 1) % all.length].value); },
  Escape: () => { turntable(false); if (measuring) measure(false); },
  w: () => { if ($("webgl")) drawHere(!wantedHere); },
  Enter: () => { if (measuring) pick(stage.clientWidth / 2, stage.clientHeight / 2); },
};
const moves = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] };

stage.addEventListener("keydown", (e) => {
  if (e.ctrlKey || e.metaKey || e.altKey) return;
  const key = e.key.length === 1 ? e.key.toLowerCase() : e.key;
  if (e.shiftKey && moves[key]) move(...moves[key]);
  else if (keys[key]) keys[key]();
  else return;
  e.preventDefault();
});

// One pointer turns (or moves, with shift or another button), two move and zoom.
const down = new Map();
let went = 0;
stage.addEventListener("pointerdown", (e) => {
  stage.focus({ preventScroll: true });
  stage.setPointerCapture(e.pointerId);
  if (!down.size) went = 0;
  down.set(e.pointerId, [e.clientX, e.clientY]);
  turntable(false);
});
stage.addEventListener("pointermove", (e) => {
  const before = down.get(e.pointerId);
  if (!before) return;
  const [dx, dy] = [e.clientX - before[0], e.clientY - before[1]];
  went += Math.abs(dx) + Math.abs(dy);
  if (down.size === 2) {
    const other = [...down].find(([id]) => id !== e.pointerId)[1];
    const apart = (p) => Math.max(8, Math.hypot(p[0] - other[0], p[1] - other[1]));
    const by = apart(before) / apart([e.clientX, e.clientY]);
    down.set(e.pointerId, [e.clientX, e.clientY]);
    move(dx / 2, dy / 2);
    zoom(by);
    return;
  }
  down.set(e.pointerId, [e.clientX, e.clientY]);
  if (went < 4) return;
  if (e.shiftKey || e.buttons & 6) move(dx, dy);
  else turn(-0.4 * dx, 0.3 * dy);
});
const up = (e) => {
  const was = down.delete(e.pointerId);
  if (was && e.type === "pointerup" && measuring && went < 4 && e.button === 0) {
    const box = stage.getBoundingClientRect();
    pick(e.clientX - box.left, e.clientY - box.top);
  }
};
stage.addEventListener("pointerup", up);
stage.addEventListener("pointercancel", up);
stage.addEventListener("contextmenu", (e) => e.preventDefault());
stage.addEventListener("wheel", (e) => {
  e.preventDefault();
  zoom(Math.exp(0.0015 * (e.deltaMode ? 30 * e.deltaY : e.deltaY)));
}, { passive: false });

$("fit").onclick = fit;
$("side").onclick = side;
$("map").onclick = map;
$("turn").onclick = () => turntable(!turning);
$("measure").onclick = () => measure(!measuring);
$("grid").onclick = grid;
$("compare").onclick = compare;
if ($("webgl")) $("webgl").onclick = () => drawHere(!wantedHere);
$("show").onchange = (e) => show(e.target.value);
$("level").onchange = (e) => level(e.target.value);
dark.onchange = changed;
document.onvisibilitychange = () => (document.hidden ? turntable(false) : ask());

if (scene.levels.length) {
  const options = scene.levels.map((l, i) => new Option(`Level ${i + 1}: ${l.vertices} vertices`, i + 1));
  if (scene.gaussians) options.unshift(new Option("Gaussians", 0));
  $("level").replaceChildren(...options);
  $("levels").hidden = options.length < 2;
}
$("compare").hidden = !scene.photo;
if (scene.assumed) document.querySelector("#sources .mirrored").textContent = "the photo mirrored, symmetry assumed";
Object.assign($("provenance"), { hidden: !scene.provenance, disabled: !scene.provenance });
Object.assign($("error"), { hidden: !scene.error, disabled: !scene.error });
placed();
new ResizeObserver(() => {
  if (fitted) camera.dist = fitting(scene, stage.clientWidth, stage.clientHeight);
  changed();
}).observe(stage);
