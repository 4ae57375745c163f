// The address of the page: #event=K is the state after event K; &structure=LABEL chooses what is shown, &view=YAW,PITCH how a picture of
// space is turned. What is left out is as the page begins: the first structure that the scene asks for, the first view. The page says so
// if it does not have what is asked for.

// The first structure that the scene asks for; those that it reads are parts of it, and are listed before it.
function firstAskedFor() {
  const isPart = label => DATA.structures.some(other => label.startsWith(other.label + "."));
  return Math.max(0, DATA.structures.findIndex(structure => !isPart(structure.label)));
}

function addressOf(app) {
  const { camera } = app.plane || {};
  const structure = app.index === firstAskedFor() ? "" : "&structure=" + encodeURIComponent(DATA.structures[app.index].label);
  const view = !camera || camera.isAtStart() ? "" : "&view=" + [camera.yaw, camera.pitch].map(x => +x.toFixed(1));
  return "#event=" + app.k + structure + view;
}

function fromHash() {
  const wanted = new URLSearchParams(location.hash.slice(1)), faults = [];
  const label = wanted.get("structure"), view = wanted.get("view"), k = wanted.get("event");
  const found = label === null ? firstAskedFor() : DATA.structures.findIndex(structure => structure.label === label);
  const index = found >= 0 ? found : app.mode ? app.index : firstAskedFor();
  if (!app.mode || index !== app.index) app.setStructure(index);
  if (found < 0) faults.push(noStructure(label, index));
  const { camera } = app.plane || {}, angles = view === null ? Camera.START : anglesOf(view);
  if (camera && angles !== null) camera.look(...angles);
  if (view !== null && (!camera || angles === null)) faults.push(noView(view, camera));
  if (k && k !== String(app.k)) faults.push(...app.goTo(k));
  app.tell(faults);
}
function anglesOf(text) {
  const parts = text.split(","), angles = parts.map(Number);
  return parts.length === 2 && parts.every(part => part.trim() !== "") && angles.every(isFinite) ? angles : null;
}

// What is wrong with what was asked for, and the remedy.
function noRecord(text, shown) {
  const there = BEFORE > 0 ? "this page has those from " + (BEFORE + 1) + " to " + LAST
    : (FIRST.stopped ? "this page has " : "the run has ") + counted(LAST, "log record");
  return "There is no log record " + shortText(text) + ": " + there + ". Shown is " +
    (shown === BEFORE ? "what is before the first" : "log record " + shown) + "; write #event= and a number from " + BEFORE + " to " +
    LAST + ".";
}
function noStructure(label, shown) {
  const labels = DATA.structures.map(structure => structure.label), most = 8;
  const there = labels.slice(0, most).join(", ") + (labels.length > most ? ", \u2026" : "");
  return "There is no structure " + shortText(label) + ": this page has " + there + ". Shown is " + labels[shown] +
    "; write structure= and one of these.";
}
function noView(text, camera) {
  return "There is no view " + shortText(text) + (camera ? ": write view= and two numbers of degrees, as in view=90,0."
    : ": only pictures of space are turned; leave view= out.");
}
