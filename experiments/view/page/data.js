"use strict";
// What the page shows; its form is described in page_data.h.
const DATA = JSON.parse(window.kinexData || document.getElementById("data").textContent);
delete window.kinexData;  // of a long run a long text
for (const run of DATA.runs) unpackRun(run);
const OBJECTS = DATA.ids.length;
const RUNS = DATA.runs;
const FIRST = RUNS[0];
const OTHER = RUNS.length > 1 ? RUNS[1] : null;
const BEFORE = FIRST.before;              // events before those that the page has
const LAST = BEFORE + FIRST.u.length;     // the number of the last event
const PARTED = DATA.divergence;           // the first event at which the runs part; 0: none

// Log records (events, and changes of the scene) have numbers from 1 in the whole run; the state "after
// log record k" goes with number k. An "event" in this code is a log record.
const at = (run, k) => k - run.before - 1;
const timeOf = (run, k) => (k <= run.before ? 0 : run.u[at(run, k)]);
const instantOf = (run, k) => run.instants[run.i[at(run, k)]];
const kindOf = (run, k) => DATA.structures[run.s[at(run, k)]].kinds[run.k[at(run, k)]];
const nameOf = object =>
  (object < OBJECTS ? DATA.ids[object] : DATA.things[object - OBJECTS][0]);
const listOf = objects => objects.map(nameOf).join(", ");

// The number of events at times <= u, counted in the whole run.
function eventsUntil(run, u) {
  let low = 0, high = run.u.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (run.u[middle] <= u) low = middle + 1; else high = middle;
  }
  return run.before + low;
}

// u is in units of the span that is shown.
const timeNumber = u => DATA.time.start[1] + u * DATA.time.span;
// A long integer or fraction, cut in the middle.
function shortText(text, most = 34) {
  if (text.length <= most) return text;
  const half = (most - 2) >> 1;
  if (DATA.polygons) return text.slice(0, 6) + "\u2026" + text.slice(-4);  // there are many of them
  return text.slice(0, half) + "\u2026" + text.slice(-half) + " (" + text.length + " characters)";
}
// A number with its noun.
const counted = (number, noun) => number + " " + noun + (number === 1 ? "" : "s");
// An element with a text and a class.
function make(tag, text, name) {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  if (name) element.className = name;
  return element;
}

// Ids are packed as places in a certificate, indices as differences, coefficients in one text.
function unpackRun(run) {
  const places = (ids, certificate) =>
    (typeof ids === "string" ? Array.from(ids, digit => certificate[1][+digit]) : ids);
  run.ids = run.ids.map((ids, e) => places(ids, run.certificates[e]));
  for (const state of run.states) {
    for (const change of state.changes) {
      const certificate = run.certificates[change[0] - run.before - 1];
      change[2] = places(change[2], certificate);
      change[3] = places(change[3], certificate);
    }
  }
  let last = 0;
  run.i = run.i.map(step => (last += step));
  for (const instant of run.instants) if (instant.length > 1) instant[1] = instant[1].split(" ");
}
