// The page of `orb serve`: sign in, submit a photo, watch its job, look at what came of it. Text from the server is set as
// text, never as HTML.

const $ = (id) => document.getElementById(id);
const api = "/api/v1";
let [session, open, source, listed, cells] = [null, null, null, [], []];

// ---- asking the server

class Refused extends Error {
  constructor(status, message) { super(message); this.status = status; }
}

async function ask(method, path, body) {
  const headers = {};
  if (session?.csrf && method !== "GET") headers["X-Orb-Csrf"] = session.csrf;
  if (body && !(body instanceof FormData)) {
    headers["Content-Type"] = "application/json";
    body = JSON.stringify(body);
  }
  let answer;
  try {
    answer = await fetch(api + path, { method, headers, body });
  } catch {
    throw new Refused(0, "No answer: the server may have ended.");
  }
  if (answer.status === 204) return null;
  const found = await answer.json().catch(() => ({ message: `The server answered ${answer.status}.` }));
  if (!answer.ok) throw new Refused(answer.status, found.message);
  return found;
}

function say(text, bad = false) {
  $("state").textContent = text;
  $("state").classList.toggle("bad", bad);
}

/** Does it, says what went wrong, and asks to sign in again where that is it. */
async function attempt(work) {
  try {
    return await work();
  } catch (e) {
    if (e instanceof Refused && e.status === 401 && session) signedOut("The session is over: sign in again.");
    else say(e.message, true);
  }
}

// ---- signing in and out

const may = (...roles) => session.roles.some((r) => roles.includes(r));

function signedIn(found) {
  session = found;
  $("signin").hidden = true;
  $("token").value = "";
  $("who").hidden = false;
  $("who").firstElementChild.textContent = `${session.account} (${session.roles.join(", ")}), up to ${session.ceiling}`;
  $("submit").hidden = !may("operator");
  $("classification").disabled = !may("marking-officer");
  $("authority").hidden = !may("marking-officer");
  $("work").hidden = !may("viewer", "operator", "marking-officer", "auditor");
  say("");
  if ($("work").hidden) return say("This account has no part in jobs: its work is done by the interface for programs.");
  attempt(async () => {
    await refresh();
    await map();
  });
}

function signedOut(words = "") {
  session = null;
  close();
  for (const id of ["who", "submit", "work", "places"]) $(id).hidden = true;
  $("jobs").replaceChildren();
  $("maps").replaceChildren();
  $("submit").reset();
  photo();
  $("signin").hidden = false;
  $("token").focus();
  say(words);
}

$("signin").onsubmit = (e) => {
  e.preventDefault();
  attempt(async () => {
    try {
      signedIn(await ask("POST", "/session", { token: $("token").value.trim() }));
    } catch (error) {
      $("token").select();
      throw error;
    }
  });
};
// There where this connection came with a client certificate.
if ($("by-certificate")) $("by-certificate").onclick = () => attempt(async () => {
  try {
    signedIn(await ask("POST", "/session", {}));
  } catch (error) {
    if (error.status !== 401) throw error;
    throw new Refused(401, "This certificate signs nobody in: it is bound to no account, or its account is locked or disabled.");
  }
});
$("out").onclick = () => attempt(async () => {
  await ask("DELETE", "/session");
  signedOut("Signed out.");
});

// ---- the photo and the point on it

const [stage, shown, cross] = [$("stage"), $("shown"), $("cross")];
let point = null;

/** Shows what was chosen: one photo to point at, or the first of several. */
function photo(files = []) {
  const several = files.length > 1;
  if (shown.src) URL.revokeObjectURL(shown.src);
  shown.removeAttribute("src");
  if (files.length) shown.src = URL.createObjectURL(files[0]);
  stage.hidden = !files.length;
  stage.tabIndex = several ? -1 : 0;
  $("pointing").hidden = !files.length || several;
  $("several").hidden = !several;
  $("pitched").hidden = $("lens").hidden = several;
  $("photos").textContent = several ? `${files.length} photos: ${[...files].slice(0, 6).map((f) => f.name).join(", ")}${files.length > 6 ? ", …" : ""}` : "";
  if (several) $("pitch").value = $("focal").value = "";
  else $("poses").value = $("gcp").value = "";
  put(null);
}

// TIFF and HEIC, which few browsers show.
shown.onerror = () => {
  stage.hidden = $("pointing").hidden = true;
};

/** A point in pixels of the photo, or none. */
function put(at) {
  point = at && { x: Math.min(shown.naturalWidth - 1, Math.max(0, Math.round(at.x))), y: Math.min(shown.naturalHeight - 1, Math.max(0, Math.round(at.y))) };
  cross.hidden = !point;
  $("point").value = point ? `${point.x},${point.y}` : "";
  if (!point) return;
  cross.style.left = `${(100 * (point.x + 0.5)) / shown.naturalWidth}%`;
  cross.style.top = `${(100 * (point.y + 0.5)) / shown.naturalHeight}%`;
}

$("photo").onchange = () => photo($("photo").files);
stage.onclick = (e) => {
  if (!$("several").hidden) return;
  const box = shown.getBoundingClientRect();
  put({ x: ((e.clientX - box.left) / box.width) * shown.naturalWidth - 0.5, y: ((e.clientY - box.top) / box.height) * shown.naturalHeight - 0.5 });
};
stage.onkeydown = (e) => {
  const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const move = moves[e.key];
  if (!$("several").hidden) return;
  if (e.key === "Delete" || e.key === "Backspace") put(null);
  else if (move) {
    const step = shown.naturalWidth / (e.shiftKey ? 200 : 40);
    const from = point ?? { x: shown.naturalWidth / 2, y: shown.naturalHeight / 2 };
    put(point ? { x: from.x + move[0] * step, y: from.y + move[1] * step } : from);
    say(`Point at ${point.x}, ${point.y}.`);
  } else return;
  e.preventDefault();
};
const drop = $("drop");
drop.ondragover = (e) => { e.preventDefault(); drop.classList.add("over"); };
drop.ondragleave = () => drop.classList.remove("over");
drop.ondrop = (e) => {
  e.preventDefault();
  drop.classList.remove("over");
  if (!e.dataTransfer.files.length) return;
  $("photo").files = e.dataTransfer.files;
  photo($("photo").files);
};

$("submit").onsubmit = (e) => {
  e.preventDefault();
  const all = new FormData($("submit"));
  const formats = all.getAll("format");
  all.delete("format");
  if (formats.length) all.set("format", formats.join(","));
  for (const [name, value] of [...all]) if (value === "" || (value instanceof File && !value.name)) all.delete(name);
  const button = e.submitter ?? $("submit").querySelector("button.main");
  button.disabled = true;
  say(all.getAll("photo").length > 1 ? "Sending the photos …" : "Sending the photo …");
  attempt(async () => {
    const job = await ask("POST", "/jobs", all);
    say(job.waiting_before ? `Submitted; ${job.waiting_before} jobs wait before it.` : "Submitted.");
    $("submit").reset();
    photo();
    await refresh();
    show(job.id);
  }).finally(() => { button.disabled = false; });
};

// ---- jobs

const colour = (banner) => ["TOP SECRET", "SECRET", "CONFIDENTIAL", "CUI", "CONTROLLED", "UNCLASSIFIED"].find((l) => banner.startsWith(l))?.toLowerCase().replace(" ", "-").replace("controlled", "cui");
const when = (utc) => (utc ? new Date(utc).toLocaleString() : "");

function row(job) {
  const button = document.createElement("button");
  const cell = (text, name = "") => Object.assign(document.createElement("span"), { textContent: text, className: name });
  button.type = "button";
  button.dataset.id = job.id;
  button.append(cell(`${job.number}. ${job.name ?? "model"}`), cell(job.state), cell(`${job.marking} · ${job.account} · ${when(job.submitted)}`, "soft"));
  button.setAttribute("aria-current", job.id === open);
  button.onclick = () => show(job.id);
  const item = document.createElement("li");
  item.append(button);
  return item;
}

function list() {
  $("jobs").replaceChildren(...listed.map(row));
}

async function refresh(before) {
  const { jobs } = await ask("GET", `/jobs?limit=20${before ? `&before=${before}` : ""}`);
  listed = before ? [...listed, ...jobs] : jobs;
  $("more").hidden = jobs.length < 20;
  list();
  if (!listed.length) say("No jobs yet.");
}
$("more").onclick = () => attempt(() => refresh(listed.at(-1).number));

function close() {
  source?.close();
  source = open = null;
  $("job").hidden = true;
}

function show(id) {
  close();
  open = id;
  $("job").hidden = false;
  for (const e of ["view", "zip", "record", "verify", "cancel", "delete", "preview", "files", "verdict", "bar", "job-error"]) $(e).hidden = true;
  $("job-title").textContent = "…";
  $("job-state").textContent = "";
  delete $("job").dataset.state;
  $("job-title").focus({ preventScroll: true });
  list();
  source = new EventSource(`${api}/jobs/${id}/events`);
  source.addEventListener("job", (e) => told(JSON.parse(e.data)));
  source.onerror = () => {
    // The browser tries again by itself, but not where it was refused.
    if (source?.readyState === EventSource.CLOSED && open === id) attempt(async () => told(await ask("GET", `/jobs/${id}`)));
  };
}

function told(job) {
  if (job.id !== open) return;
  const before = $("job").dataset.state;
  $("job").dataset.state = job.state;
  $("job-marking").textContent = job.marking;
  $("job-marking").dataset.marking = colour(job.marking) ?? "";
  $("job-title").textContent = `${job.number}. ${job.name ?? "model"}`;
  const { progress } = job;
  const left = progress?.seconds_left == null ? "" : `, ${Math.ceil(progress.seconds_left)} s left of it`;
  const state = {
    queued: () => (job.waiting_before ? `waits; ${job.waiting_before} before it` : "waits"),
    running: () => (job.cancelling ? "is being cancelled" : `runs${job.attempt > 1 ? ` (attempt ${job.attempt})` : ""}: ${progress ? progress.stage + left : "beginning"}`),
    done: () => `done ${when(job.ended)}${job.result ? `, ${Math.round(job.result.seconds)} s` : ""}`,
  }[job.state];
  $("job-state").textContent = state ? state() : `${job.state} ${when(job.ended)}`;
  const bar = $("bar");
  bar.hidden = job.state !== "running";
  if (progress?.fraction == null) bar.removeAttribute("value");
  else bar.value = progress.fraction;
  $("job-error").hidden = !job.error;
  $("job-error").textContent = job.error ?? "";
  const [own, ended] = [job.account === session.account && may("operator"), !["queued", "running"].includes(job.state)];
  $("cancel").hidden = !own || ended || job.cancelling;
  $("delete").hidden = !own || job.state === "running";
  if (before !== job.state) {
    const known = listed.find((j) => j.id === job.id);
    if (known) Object.assign(known, job);
    list();
    if (before) say(`${job.name}: ${job.state}.`);
    if (ended) source?.close();
    if (job.state === "done") results(job);
    if (job.state === "done" && before) attempt(() => map());
  }
}

async function results(job) {
  const at = `${api}/jobs/${job.id}`;
  const scenes = may("viewer", "operator", "marking-officer");
  Object.assign($("record"), { hidden: false, href: `${at}/record` });
  $("verify").hidden = false;
  if (!scenes) return;
  Object.assign($("view"), { hidden: false, href: `/view/${job.id}/` });
  Object.assign($("zip"), { hidden: false, href: `${at}/archive.zip` });
  await attempt(async () => {
    const { files } = await ask("GET", `/jobs/${job.id}/files`);
    const link = (f) => {
      const a = Object.assign(document.createElement("a"), { href: `${at}/files/${f.name.split("/").map(encodeURIComponent).join("/")}`, textContent: f.name });
      const item = document.createElement("li");
      item.append(a, ` ${(f.bytes / 1000).toLocaleString("en", { maximumFractionDigits: 1 })} kB`);
      return item;
    };
    $("files").hidden = false;
    $("files").querySelector("ul").replaceChildren(...files.map(link));
    if (files.some((f) => f.name === "preview.png")) {
      Object.assign($("preview"), { src: `${at}/files/preview.png`, hidden: false, alt: `Preview of ${job.name}: the photo, its mask and depth, six views, and the model from all sides` });
    }
  });
}

$("cancel").onclick = () => attempt(async () => { told(await ask("POST", `/jobs/${open}/cancel`)); });
$("delete").onclick = () => attempt(async () => {
  if (!confirm("Delete this job and everything that it published?")) return;
  await ask("DELETE", `/jobs/${open}`);
  close();
  await refresh();
  await map();
  say("Deleted.");
});
$("verify").onclick = () => attempt(async () => {
  $("verify").disabled = true;
  try {
    const report = await ask("POST", `/jobs/${open}/verify`);
    const wrong = report.findings.filter((f) => f.severity !== "note").map((f) => f.code);
    $("verdict").hidden = false;
    $("verdict").textContent = `Verification: ${report.verdict}; ${report.counts.outputs_verified} of ${report.counts.outputs_listed} files are what was sealed.${wrong.length ? ` ${wrong.join(", ")}` : ""}`;
    say($("verdict").textContent, report.verdict !== "pass");
  } finally {
    $("verify").disabled = false;
  }
});

// ---- what stands where: a square for each geocell, north up, an arrow for each model where its camera looked

const drawn = (name, attributes, text = "") => {
  const e = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
  e.textContent = text;
  return e;
};
const degrees = (v, [plus, minus]) => `${Math.abs(v)}° ${v < 0 ? minus : plus}`;

/** As wide as the cell is beside its height, at its middle; 100 units of height. */
function cellMap(cell) {
  const wide = Math.max(20, 100 * cell.width * Math.cos(((cell.south + 0.5) * Math.PI) / 180));
  const svg = drawn("svg", { viewBox: `0 0 ${wide} 100`, role: "img", "aria-label": `Map of ${cell.name}: ${cell.models.length} models` });
  for (let i = 1; i < 10; i++) {
    svg.append(drawn("line", { x1: 0, x2: wide, y1: 10 * i, y2: 10 * i }), drawn("line", { y1: 0, y2: 100, x1: (wide * i) / 10, x2: (wide * i) / 10 }));
  }
  svg.append(drawn("text", { x: 2, y: 98 }, `${degrees(cell.south, "NS")}, ${degrees(cell.west, "EW")}`));
  for (const m of cell.models) {
    const [x, y] = [((m.longitude - cell.west) / cell.width) * wide, 100 * (cell.south + 1 - m.latitude)];
    const arrow = drawn("path", { d: "M0,-4 L2.6,3.2 L0,1.6 L-2.6,3.2 Z", transform: `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${m.heading})` });
    arrow.append(drawn("title", {}, m.name ?? "model"));
    svg.append(arrow);
  }
  return svg;
}

function cellPart(cell) {
  const item = (m) => {
    const look = () => {
      show(m.id);
      $("job").scrollIntoView();
    };
    const button = Object.assign(document.createElement("button"), { type: "button", onclick: look });
    const about = Object.assign(document.createElement("span"), { className: "soft", textContent: ` ${m.latitude.toFixed(5)}, ${m.longitude.toFixed(5)}, heading ${Math.round(m.heading)}° · ${m.marking}` });
    button.append(`${m.number}. ${m.name ?? "model"}`, about);
    const li = document.createElement("li");
    li.append(button);
    return li;
  };
  const [part, title, all] = ["div", "h3", "ul"].map((e) => document.createElement(e));
  title.textContent = cell.name;
  all.append(...cell.models.map(item));
  part.append(title, cellMap(cell), all);
  return part;
}

async function map(before) {
  if (!may("viewer", "operator", "marking-officer")) return;
  const page = await ask("GET", `/geocells?limit=200${before ? `&before=${before}` : ""}`);
  for (const cell of before ? cells : []) {
    const more = page.geocells.find((c) => c.name === cell.name);
    if (more) more.models = [...cell.models, ...more.models];
    else page.geocells.push(cell);
  }
  cells = page.geocells;
  $("places").hidden = !cells.length;
  $("maps").replaceChildren(...cells.map(cellPart));
  $("farther").hidden = !page.before;
  $("farther").onclick = () => attempt(() => map(page.before));
}

// ---- begin

ask("GET", "/session").then(signedIn, () => signedOut());
// The list, when something else has come.
setInterval(() => { if (session && !$("work").hidden && !document.hidden && !document.activeElement?.closest("#jobs")) attempt(() => (listed.length <= 20 ? refresh() : null)); }, 10_000);
