// Pointers on the canvases: one moves the picture, or chooses what is under it; two zoom it; wheels zoom, too.
const placeOf = (element, event) => {
  const box = element.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};

function listenToPicture() {
  const { canvas } = app.picture, held = new Map();  // the places of the pointers that are down, by their ids
  let pressedAt = null;  // of the first one, while there is no second one
  const move = (from, to, shifted) => {
    const sideways = app.drawing.move(to[0] - from[0], to[1] - from[1], ...from, shifted);
    if (sideways) app.setTime(app.u - (to[0] - from[0]) / canvas.clientWidth * app.span);
  };
  // What is under two pointers stays under them.
  const pinch = (from, to) => {
    const [length, now] = [from, to].map(([p, q]) => Math.hypot(...minus(q, p)));
    const [middle, other] = [from, to].map(middleOf);
    if (length > 1 && now > 1) app.drawing.scaleAbout(now / length, ...middle, app.picture);
    move(middle, other, true);
  };
  canvas.addEventListener("pointerdown", e => {
    if (held.size === 2) return;
    held.set(e.pointerId, placeOf(canvas, e));
    pressedAt = held.size === 1 ? placeOf(canvas, e) : null;
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener("pointermove", e => {
    const at = placeOf(canvas, e);
    if (held.has(e.pointerId)) {
      const before = [...held.values()];
      held.set(e.pointerId, at);
      if (held.size === 1) move(before[0], at, e.shiftKey); else pinch(before, [...held.values()]);
      app.changed();
      return;
    }
    const nearest = held.size > 0 ? app.hovered : app.drawing.nearest(...at);
    if (nearest !== app.hovered) {
      app.hovered = nearest;
      app.changed();
    }
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
    canvas.addEventListener(end, e => {
      if (!held.delete(e.pointerId)) return;
      const at = placeOf(canvas, e);
      const stays = pressedAt !== null && Math.hypot(...minus(at, pressedAt)) < 3;
      pressedAt = null;
      if (stays && end === "pointerup" && app.drawing.certificateAt) {
        app.chosenGroup = null;
        app.select(app.drawing.certificateAt(...at));
      }
    });
  }
  canvas.addEventListener("wheel", e => {
    e.preventDefault();
    app.drawing.scaleAbout(Math.exp(-e.deltaY / 500), ...placeOf(canvas, e), app.picture);
    app.changed();
  }, { passive: false });
}

function listenToWindow() {
  const bars = app.window.picture.canvas, whole = app.window.overview.canvas;
  bars.addEventListener("click", e => app.window.go(...placeOf(bars, e)));
  bars.addEventListener("wheel", e => {
    e.preventDefault();
    app.setSpan(Math.exp(e.deltaY / 500));
  }, { passive: false });
  const go = e => { if (e.buttons & 1) app.setTime(placeOf(whole, e)[0] / whole.clientWidth); };
  whole.addEventListener("pointerdown", go);
  whole.addEventListener("pointermove", go);
}
