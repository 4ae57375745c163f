// SPDX-License-Identifier: GPL-3.0-or-later
// Style and script of the pages of results. Without the script everything is there: tables are whole,
// and details unfold by themselves.
#include "experiments/lab/html_style.h"

namespace kinex::lab {

const char* const kPageStyle = R"(
:root { color-scheme: light dark; --back: #fff; --text: #1a1a1a; --quiet: #565b62; --line: #d9dce0;
  --strong: #b4b8be; --panel: #f4f5f7; --link: #0b5394; --good: #00583f; --bad: #a33a00; --open: #6b5500;
  --mark: #fff3c9; }
@media (prefers-color-scheme: dark) {
  :root { --back: #14161a; --text: #e7e9ec; --quiet: #a2a8b1; --line: #33383f; --strong: #565d67;
    --panel: #1e2126; --link: #7db7f0; --good: #5fc795; --bad: #ff9a63; --open: #e0bb4e; --mark: #3f3710; }
  figure img { filter: invert(.9) hue-rotate(180deg) brightness(1.25); }
}
* { box-sizing: border-box; }
body { font: 15px/1.45 system-ui, "Helvetica Neue", Arial, sans-serif; color: var(--text);
  background: var(--back); margin: 1.2rem auto; padding: 0 1.2rem; max-width: 1360px; }
a { color: var(--link); } h1 { font-size: 1.3rem; margin: 0; font-weight: 600; color: var(--quiet); }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .5rem; } h3 { font-size: 1rem; margin: 1.4rem 0 .3rem; }
h2 a, h3 a { color: inherit; text-decoration: none; }
h2 a:hover::after, h3 a:hover::after { content: " #"; color: var(--quiet); }
:target { scroll-margin-top: 1rem; } h2:target, h3:target, tr:target td { background: var(--mark); }
p.verdict { font-size: clamp(1.35rem, 4.5vw, 2.1rem); line-height: 1.2; font-weight: 600; margin: .3rem 0; }
p.facts { color: var(--quiet); margin: .2rem 0; overflow-wrap: anywhere; }
nav { margin: .8rem 0; padding: .5rem .8rem; background: var(--panel); border-radius: 6px; }
nav details { display: inline-block; margin-right: 1.1em; vertical-align: top; }
nav details[open] { display: block; margin: .3rem 0; }
nav a { margin-right: 1.1em; display: inline-block; }
.v { font-weight: 600; white-space: nowrap; } .text { white-space: normal; }
.PASS, .AGREES { color: var(--good); } .FAIL { color: var(--bad); } .INCONCLUSIVE, .GAVE { color: var(--open); }
.grid { display: grid; gap: 1.2rem; align-items: start;
  grid-template-columns: repeat(auto-fill, minmax(min(560px, 100%), 1fr)); }
figure { margin: 0; border: 1px solid var(--line); border-radius: 6px; padding: .6rem; min-width: 0; }
figure img { width: 100%; height: auto; display: block; }
figure.row { grid-column: 1 / -1; }
figure.row div { display: grid; gap: .6rem;
  grid-template-columns: repeat(auto-fit, minmax(min(380px, 100%), 1fr)); }
figcaption b { display: block; } figcaption { font-size: .87rem; margin-top: .4rem; }
/* A table that is wider than the page scrolls; a shadow is at the edge beyond which there is more. */
.wide { overflow-x: auto; background-repeat: no-repeat; background-attachment: local, local, scroll, scroll;
  background-image: linear-gradient(to right, var(--back), var(--back)), linear-gradient(to left, var(--back), var(--back)),
    linear-gradient(to right, var(--strong), transparent), linear-gradient(to left, var(--strong), transparent);
  background-position: left, right, left, right; background-size: 1rem 100%, 1rem 100%, .7rem 100%, .7rem 100%; }
.wide table { min-width: 100%; }
table { border-collapse: collapse; font-size: .84rem; }
th, td { padding: .22rem .42rem; text-align: left; border-bottom: 1px solid var(--line);
  vertical-align: top; }
th { vertical-align: bottom; background: var(--panel); border-bottom: 2px solid var(--strong); }
th button { all: unset; font: inherit; cursor: pointer; }
th button:focus-visible, .open:focus-visible { outline: 2px solid var(--link); }
th[aria-sort=ascending] button::after { content: " \25B2"; }
th[aria-sort=descending] button::after { content: " \25BC"; }
td.r, th.r { text-align: right; font-variant-numeric: tabular-nums; } td.r { white-space: nowrap; }
@media (min-width: 1300px) { td > a { white-space: nowrap; } }
td:last-child:not([class]):not([colspan]):not(:has(.v)) { min-width: 14em; }
details { min-width: 0; } summary { cursor: pointer; overflow-wrap: anywhere; padding: .15rem 0; }
details.row { grid-column: 1 / -1; } details.row figure > div { display: grid; gap: .6rem;
  grid-template-columns: repeat(auto-fit, minmax(min(380px, 100%), 1fr)); }
.more-rows { margin: .4rem 0; font: inherit; color: var(--link); background: none; border: 0; padding: 0;
  cursor: pointer; }
/* What a row unfolds is as wide as the page, however wide its table, and stays in sight. */
tr.more > td > div { position: sticky; left: .5rem; max-width: min(1280px, calc(100vw - 4.5rem)); }
tr.first td { border-top: 2px solid var(--strong); } tr.more > td { background: var(--panel); }
.open { all: unset; cursor: pointer; color: var(--link); white-space: nowrap; }
.filter { display: flex; gap: .6rem; align-items: baseline; flex-wrap: wrap; margin: .4rem 0; }
.filter input { font: inherit; color: inherit; background: var(--back); border: 1px solid var(--strong);
  border-radius: 5px; padding: .15rem .5rem; width: min(22rem, 100%); }
.filter output { color: var(--quiet); font-size: .87rem; }
code, pre { background: var(--panel); border-radius: 3px; font-size: .92em; }
code { padding: .1rem .3rem; overflow-wrap: anywhere; }
tr.more pre { background: var(--back); } pre { padding: .4rem .6rem; margin: .3rem 0; white-space: pre-wrap;
  overflow-wrap: anywhere; }
[hidden] { display: none !important; }
@media print { .filter, nav { display: none; } }
)";

const char* const kPageScript = R"(
"use strict";
const numberOf = text => {
  const found = text.replace(/\u2212/g, "-").match(/-?\d+(\.\d+)?(e[+-]?\d+)?/i);
  return found ? parseFloat(found[0]) : NaN;
};
const MOST = 100;  // rows of a table that is not unfolded
// What a link leads to is unfolded.
const unfold = () => {
  const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let at = target; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
  if (target) target.scrollIntoView();
};
addEventListener("hashchange", unfold);
unfold();
for (const table of document.querySelectorAll("table.data")) {
  const body = table.tBodies[0];
  // A row, and the one that belongs to it.
  const rows = [...body.rows].filter(row => !row.classList.contains("more")).map(row => {
    const next = row.nextElementSibling;
    return { row, more: next && next.classList.contains("more") ? next : null,
             text: row.textContent.toLowerCase() };
  });
  const show = (one, open) => {
    if (!one.more) return;
    one.more.hidden = !open;
    const button = one.row.querySelector(".open");
    if (button) button.setAttribute("aria-expanded", open);
  };
  for (const one of rows) {
    show(one, false);
    const button = one.row.querySelector(".open");
    if (button) button.addEventListener("click", () => show(one, one.more.hidden));
  }
  // Of the rows that a filter leaves the first ones, in the order of the table; all on request.
  let most = rows.length > 1.2 * MOST ? MOST : Infinity, fits = () => true, order = rows;
  const rest = document.createElement("button");
  const showRows = () => {
    let found = 0;
    for (const one of order) {
      const is = fits(one) && ++found <= most;
      one.row.hidden = !is;
      if (!is) show(one, false);
    }
    rest.hidden = found <= most;
    rest.textContent = "Show all " + found + " rows";
    return found;
  };
  rest.className = "more-rows";
  rest.addEventListener("click", () => { most = Infinity; showRows(); });
  if (most < Infinity) table.parentElement.after(rest);
  showRows();
  const open = () => {
    const at = rows.find(one => one.row.id && "#" + one.row.id === decodeURIComponent(location.hash));
    if (!at) return;
    if (at.row.hidden) { most = Infinity; showRows(); }
    show(at, true);
    at.row.scrollIntoView({ block: "center" });
  };
  addEventListener("hashchange", open);
  open();
  if (rows.length >= 6) {
    const box = document.createElement("div"), label = document.createElement("label");
    const input = document.createElement("input"), count = document.createElement("output");
    box.className = "filter";
    input.type = "search";
    input.placeholder = "words, -without";
    label.append("Filter ", input);
    box.append(label, count);
    table.parentElement.before(box);
    const filter = () => {
      const words = input.value.toLowerCase().split(/\s+/).filter(word => word !== "" && word !== "-");
      fits = one => words.every(word => word.startsWith("-") ? !one.text.includes(word.slice(1))
                                                             : one.text.includes(word));
      count.textContent = showRows() + " of " + rows.length + " rows";
    };
    input.addEventListener("input", filter);
    filter();
  }
  [...table.tHead.rows[0].cells].forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const up = head.getAttribute("aria-sort") !== "ascending";
      for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      const numeric = head.classList.contains("r");
      const key = one => {
        const text = one.row.cells[column] ? one.row.cells[column].textContent : "";
        return numeric ? numberOf(text) : text;
      };
      const compare = (a, b) => numeric ? (isNaN(a) ? (isNaN(b) ? 0 : 1) : isNaN(b) ? -1 : up ? a - b : b - a)
        : (up ? 1 : -1) * a.localeCompare(b, "en", { numeric: true });
      const keyed = rows.map((one, i) => [key(one), i, one]);
      keyed.sort((a, b) => compare(a[0], b[0]) || a[1] - b[1]);
      order = keyed.map(([, , one]) => one);
      for (const [, , one] of keyed) {
        one.row.classList.remove("first");
        body.append(one.row);
        if (one.more) body.append(one.more);
      }
      showRows();
    });
  });
}
)";

}  // namespace kinex::lab
