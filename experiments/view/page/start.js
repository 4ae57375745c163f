// Controls, keys, and the first picture.
readColours();
const app = new App();
window.kinexState = kinexState;

function onClick(id, action) {
  document.getElementById(id).addEventListener("click", action);
}

function describePage() {
  const scene = DATA.scene;
  const count = LAST - BEFORE;
  document.getElementById("name").textContent = scene.name;
  const run = r => r.arithmetic + ", " + counted(r.u.length, "log record") +
    (r.stopped ? " (not all: " + r.stopped + ")" : "");
  let facts = counted(OBJECTS, "object") + " in " + AXES + "-D \u00b7 " + run(FIRST);
  if (OTHER !== null) facts += " \u00b7 " + run(OTHER);
  if (BEFORE > 0) facts += " \u00b7 from t = " + DATA.time.start[0] + ", log record " + (BEFORE + 1);
  if (AXES > 2) document.querySelector("#drawing option[value=plane]").textContent = "in space";
  // The commit in short; the pointer over it shows the whole.
  const program = make("span", DATA.program.replace(/\b([0-9a-f]{12})[0-9a-f]{28}\b/, "$1"));
  program.title = DATA.program;
  document.getElementById("facts").append(facts + " \u00b7 ", program);
  document.getElementById("of").textContent = "of " + LAST;
  const select = document.getElementById("structure");
  DATA.structures.forEach((structure, i) => {
    const option = make("option", structure.label);
    option.value = i;
    select.append(option);
  });
  if (BODIES) describePairs();
  document.getElementById("all-certificates").hidden = BODIES;
  document.getElementById("next-query").hidden = FIRST.queries.length === 0;
  for (const id of ["scrub", "number"]) {
    const input = document.getElementById(id);
    input.min = BEFORE;
    input.max = LAST;
  }
  if (OTHER === null) return;
  const box = document.getElementById("divergence");
  box.hidden = false;
  if (PARTED === 0) {
    box.append(make("h2", "Both runs have the same log records"));
    return;
  }
  box.append(make("h2", "The runs part at log record " + PARTED));
  const event = r => (PARTED > r.before && PARTED <= r.before + r.u.length
    ? kindOf(r, PARTED) + " " + listOf(r.ids[at(r, PARTED)]) : "no log record");
  const list = make("dl");
  for (const r of RUNS) list.append(make("dt", r.arithmetic), make("dd", event(r)));
  box.append(list);
  if (PARTED <= BEFORE) {
    box.append(make("p", "That is before what this page shows."));
    return;
  }
  const go = make("button", "Go there (D)");
  go.addEventListener("click", () => app.goToDivergence());
  box.append(go);
}

// Scenes of bodies have one drawing, and of more than two bodies a choice of the pair.
function describePairs() {
  document.getElementById("drawing-label").hidden = true;
  document.getElementById("whole").hidden = false;
  onClick("whole", () => app.drawing.chart.turnOver());
  const pairs = new Set(app.proofs.flatMap(own => [...own.groups.keys()]));
  if (pairs.size < 2) return;
  const select = document.getElementById("pair");
  document.getElementById("pair-label").hidden = false;
  const choice = (text, value) => {
    const option = make("option", text);
    option.value = value;
    select.append(option);
  };
  choice("of the log record", "");
  for (const pair of [...pairs].sort((a, b) => a - b)) choice(pairOf(pair).map(nameOf).join(", "), pair);
  select.addEventListener("change", () => {
    app.chosen = select.value === "" ? null : +select.value;
    app.changed();
  });
}

function listen() {
  onClick("first", () => app.setEvent(BEFORE));
  onClick("back", () => app.setEvent(app.k - 1));
  onClick("play", () => app.play(!app.playing));
  onClick("forward", () => app.setEvent(app.k + 1));
  onClick("last", () => app.setEvent(LAST));
  onClick("slower", () => app.setRate(0.5));
  onClick("faster", () => app.setRate(2));
  onClick("fit", () => { app.drawing.fit(); app.changed(); });
  onClick("zoom-in", () => app.zoom(1.25));
  onClick("zoom-out", () => app.zoom(0.8));
  onClick("next-failure", () => app.selectNext());
  onClick("all-certificates", () => app.turnAll());
  onClick("next-query", () => app.goToQuery());
  document.getElementById("scrub").addEventListener("input", e => app.setEvent(+e.target.value));
  document.getElementById("number").addEventListener("change", e => {
    if (e.target.value !== "") app.tell(app.goTo(String(Math.round(+e.target.value))));
  });
  document.getElementById("structure").addEventListener("change", e => {
    app.setStructure(+e.target.value);
  });
  document.getElementById("drawing").addEventListener("change", e => app.setMode(e.target.value));
  document.getElementById("window-axis").addEventListener("change", e => app.setAxis(e.target.value === "record"));
  onClick("save-png", savePng);
  onClick("save-svg", saveSvg);
  onClick("rows-up", () => turnList(-1));
  onClick("rows-down", () => turnList(1));
  onClick("show-records", () => showList(false));
  onClick("show-certificates", () => showList(true));
  const resized = new ResizeObserver(() => {
    app.panel.drawRows();
    app.certificates.drawRows();
    app.drawCanvases();  // at once: nothing else on the page depends on sizes
    if (app.panel.root !== null) app.panel.root.draw();
  });
  for (const id of ["list", "certificates", "picture", "window"]) resized.observe(document.getElementById(id));
  addEventListener("hashchange", fromHash);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    readColours();
    app.panel.shownEvent = null;
    app.changed();
  });
  addEventListener("keydown", pressed);
}

// The list in sight a page up or down.
function turnList(step) {
  if (!document.getElementById("list").hidden) return app.panel.turn(step);
  const box = app.certificates.box;
  box.scrollTop += step * Math.max(ROW, box.clientHeight - ROW);
  app.certificates.drawRows();
}

// The list of log records, or that of certificates.
function showList(certificates) {
  document.getElementById("list").hidden = certificates;
  document.getElementById("certificates").hidden = !certificates;
  document.getElementById("search-box").hidden = certificates;
  document.getElementById("show-records").setAttribute("aria-selected", !certificates);
  document.getElementById("show-certificates").setAttribute("aria-selected", certificates);
  app.certificates.known = null;
  app.changed();
}

function pressed(key) {
  const field = /^(INPUT|SELECT|TEXTAREA)$/.test(key.target.tagName) && key.target.id !== "scrub";
  if (field || key.ctrlKey || key.metaKey || key.altKey) return;
  if (key.key === " " && /^(BUTTON|SUMMARY)$/.test(key.target.tagName)) return;  // presses the button
  const actions = {
    " ": () => app.play(!app.playing),
    ArrowRight: () => (key.shiftKey ? app.nextExternal(1) : app.setEvent(app.k + 1)),
    ArrowLeft: () => (key.shiftKey ? app.nextExternal(-1) : app.setEvent(app.k - 1)),
    Home: () => app.setEvent(BEFORE), End: () => app.setEvent(LAST),
    "[": () => app.setRate(0.5), "]": () => app.setRate(2),
    "+": () => app.zoom(1.25), "=": () => app.zoom(1.25), "-": () => app.zoom(0.8),
    f: () => { app.drawing.fit(); app.changed(); },
    i: () => app.setAxis(!app.byRecord),
    j: () => app.filter.go(1), k: () => app.filter.go(-1),
    "/": () => {
      showList(false);
      document.getElementById("search").focus();
    },
    ",": () => app.setSpan(1.5), ".": () => app.setSpan(1 / 1.5),
    d: () => app.goToDivergence(),
    ...(app.drawing.camera ? turns(app.drawing.camera) : {}),
    q: () => app.goToQuery(),
    t: () => { if (BODIES) app.drawing.chart.turnOver(); },
    c: () => app.turnAll(),
    n: () => app.selectNext(),
    Escape: () => app.select(null),
  };
  const action = actions[key.key] || actions[key.key.toLowerCase()];
  if (!action) return;
  key.preventDefault();
  action();
}

// The keys that turn a picture of space: the digits as they lie on a block of numbers.
function turns(camera) {
  const turned = turn => () => { turn(); app.changed(); };
  return {
    4: turned(() => camera.turn(-15, 0)), 6: turned(() => camera.turn(15, 0)),
    8: turned(() => camera.turn(0, 15)), 2: turned(() => camera.turn(0, -15)),
    5: turned(() => camera.reset()),
    ...Object.fromEntries(Object.entries(Camera.VIEWS).map(([axis, view]) => [axis, turned(() => camera.look(...view))])),
  };
}

describePage();
listen();
listenToPicture();
listenToWindow();
fromHash();
app.draw();
