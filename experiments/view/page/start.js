// Controls, keys, pointers, and the first picture.
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
  document.getElementById("scrub").addEventListener("input", e => app.setEvent(+e.target.value));
  document.getElementById("number").addEventListener("change", e => {
    if (e.target.value !== "") app.goTo(String(Math.round(+e.target.value)));
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
  if (key.key === " " && key.target.tagName === "BUTTON") return;  // presses the button
  const picture = app.picture;
  const zoom = factor => {
    app.drawing.scaleAbout(factor, picture.width / 2, picture.height / 2, picture);
    app.changed();
  };
  const actions = {
    " ": () => app.play(!app.playing),
    ArrowRight: () => (key.shiftKey ? app.nextExternal(1) : app.setEvent(app.k + 1)),
    ArrowLeft: () => (key.shiftKey ? app.nextExternal(-1) : app.setEvent(app.k - 1)),
    Home: () => app.setEvent(BEFORE), End: () => app.setEvent(LAST),
    "[": () => app.setRate(0.5), "]": () => app.setRate(2),
    "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8),
    f: () => { app.drawing.fit(); app.changed(); },
    i: () => app.setAxis(!app.byRecord),
    j: () => app.filter.go(1), k: () => app.filter.go(-1),
    "/": () => document.getElementById("search").focus(),
    ",": () => app.setSpan(1.5), ".": () => app.setSpan(1 / 1.5),
    d: () => app.goToDivergence(),
    ...(app.drawing.camera ? turns(app.drawing.camera) : {}),
    q: () => { if (FIRST.queries.length > 0) app.setTime(nextQuery(app).u); },
    t: () => { if (BODIES) app.drawing.chart.turnOver(); },
    c: () => {
      if (BODIES || app.proof === null) return;
      app.all = !app.showsAll();
      app.changed();
    },
    n: () => {
      const next = app.proof === null ? null : app.proof.next(app.k);
      if (next !== null) app.select(next[0]);
    },
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

function listenToPointers() {
  const place = (element, event) => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const canvas = app.picture.canvas;
  let dragged = null, pressedAt = null;
  canvas.addEventListener("pointerdown", e => {
    dragged = pressedAt = place(canvas, e);
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener("pointermove", e => {
    const [x, y] = place(canvas, e);
    if (dragged !== null) {
      const sideways = app.drawing.move(x - dragged[0], y - dragged[1], ...dragged, e.shiftKey);
      if (sideways) app.setTime(app.u - (x - dragged[0]) / canvas.clientWidth * app.span);
      dragged = [x, y];
      app.changed();
      return;
    }
    const nearest = app.drawing.nearest(x, y);
    if (nearest !== app.hovered) {
      app.hovered = nearest;
      app.changed();
    }
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, e => {
      const [x, y] = place(canvas, e);
      const stays = pressedAt !== null && Math.hypot(x - pressedAt[0], y - pressedAt[1]) < 3;
      dragged = pressedAt = null;
      if (stays && end === "pointerup" && app.drawing.certificateAt) {
        app.chosenGroup = null;
        app.select(app.drawing.certificateAt(x, y));
      }
    });
  }
  canvas.addEventListener("wheel", e => {
    e.preventDefault();
    const [x, y] = place(canvas, e);
    app.drawing.scaleAbout(Math.exp(-e.deltaY / 500), x, y, app.picture);
    app.changed();
  }, { passive: false });
  const bars = app.window.picture.canvas;
  bars.addEventListener("click", e => {
    const [x, y] = place(bars, e);
    const k = app.window.eventAt(x, y);
    if (k !== null) app.setEvent(k); else app.setTime(app.window.axis.place(x));
  });
  bars.addEventListener("wheel", e => {
    e.preventDefault();
    app.setSpan(Math.exp(e.deltaY / 500));
  }, { passive: false });
  const whole = app.window.overview.canvas;
  const go = e => { if (e.buttons & 1) app.setTime(place(whole, e)[0] / whole.clientWidth); };
  whole.addEventListener("pointerdown", go);
  whole.addEventListener("pointermove", go);
}

// #event=K opens the page at the state after event K; &structure=LABEL chooses what is shown, &view=YAW,PITCH
// how a picture of space is turned. The page says so if no log record has the number.
function fromHash() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  const structure = DATA.structures.findIndex(s => s.label === wanted.get("structure"));
  const index = structure >= 0 ? structure : app.mode ? app.index : firstAskedFor();
  if (!app.mode || index !== app.index) {
    document.getElementById("structure").value = index;
    app.setStructure(index);
  }
  const view = (wanted.get("view") || "").split(",").map(Number), { camera } = app.plane || {};
  if (camera && view.length === 2 && view.every(isFinite)) {
    camera.look(...view);
    app.changed();
  }
  const k = wanted.get("event");
  if (k === String(app.k)) app.askedFor = null; else if (k) app.goTo(k);
}

describePage();
listen();
listenToPointers();
fromHash();
app.draw();
