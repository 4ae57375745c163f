# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a page of every structure in Chromium and asks whether its certificates are there and drawn.

usage: view_proofs.py PROGRAM
The witnesses: `kinex run` (certificates created less those retracted are those that are live at the end),
and its log (what fails next is the certificate of the log's next record, and is named after nearly all states
that it follows). What is drawn is seen by its colour: a certificate that is selected leaves ink of its own in
every drawing. Exit code 77 (skipped) where there is no Chromium.
"""
import json
import sys
import tempfile

from chromium import ask, browser
from view_page import FRAMES, Page, fail

# How scenes are made, by the objects that structures are about; the first one that a structure takes shows it.
SCENES = {
    "points": [["uniform-square", "--n", "14", "--seed", "4"],
               ["uniform-square", "--dimension", "3", "--n", "9", "--seed", "4"]],
    "discs": [["random-discs", "--n", "9", "--seed", "4"]],
    "boxes": [["random-boxes", "--n", "9", "--seed", "4"]],
    "lines": [["uniform-square", "--n", "9", "--seed", "4"]],
    "lines and points": [["random-lines-and-points", "--n", "9", "--seed", "4"]],
    "edges": [["random-graph", "--n", "14", "--m", "8", "--seed", "4"]],
    "bodies": [["polygons-in-box", "--n", "5", "--m", "3", "--seed", "2"], ["polygon-approach", "--n", "8"]],
}
MOST_ON_A_PAGE = 8
LEAST_NAMED = 0.95  # of the states after which a certificate fails
# Selects certificates in every drawing that the page offers.
PROBE = """
<pre id="probe"></pre><script>
const errors = [];
addEventListener("error", e => errors.push(String(e.message)));
const settle = () => new Promise(done => setTimeout(done, 60));
const inkOf = name => {
  const canvas = document.getElementById("picture");
  const colour = [1, 3, 5].map(i => parseInt(COLOUR[name].slice(i, i + 2), 16));
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) if (colour.every((c, j) => pixels[i + j] === c)) ++count;
  return count;
};
const any = () => {
  const canvas = document.getElementById("picture");
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  const colours = new Set();
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] > 0) colours.add((pixels[i] << 16) + (pixels[i + 1] << 8) + pixels[i + 2]);
  }
  return colours.size;
};
async function answer() {
  await settle();
  const result = { structures: {}, errors };
  for (const structure of DATA.structures) {
    const select = document.getElementById("structure");
    select.value = DATA.structures.indexOf(structure);
    select.dispatchEvent(new Event("change"));
    const found = { drawings: {}, states: [], mute: structure.kinds.filter((_, i) => !structure.meanings[i]) };
    result.structures[structure.label] = found;
    for (const k of [BEFORE, BEFORE + ((LAST - BEFORE) >> 1), LAST]) {
      app.setEvent(k);
      await settle();
      const state = kinexState().proofs[structure.label];
      const next = app.proof === null ? null : app.proof.next(k);
      found.states.push({ event: k, live: state.certificates.length, groups: state.groups, reads: state.reads,
                          next: next === null ? null : [app.proof.certificate(next[0]).text, next[1]] });
      if (app.proof === null || app.proof.live.size === 0) continue;
      // One whose objects are all there, of the pair that is shown if bodies are.
      const here = c => (BODIES ? app.proofs[app.shown()].claims(app.pair()).some(x => x.number === c)
        : app.proof.certificate(c).ids.every(id => alive[id]));
      const chosen = [...app.proof.live].filter(here).slice(0, 40);
      for (const option of document.getElementById("drawing").options) {
        // A drawing in which one was seen need not be looked at again.
        if (option.disabled || found.drawings[option.value] >= 8) continue;
        app.select(null);
        app.setMode(option.value);
        await settle();
        const before = inkOf("selected");
        let most = 0;
        for (const c of chosen.filter((_, i) => i % Math.ceil(chosen.length / 4) === 0)) {
          app.select(c);
          await settle();
          most = Math.max(most, inkOf("selected") - before);
          const text = document.getElementById("proof").innerText;
          const claim = app.proof.certificate(c);
          const missing = [claim.name.split("/")[0], claim.role, ...claim.form.roles.map(role => role.name)]
            .filter(word => !text.includes(word));
          if (missing.length > 0) found.missing = [missing, text];
        }
        found.drawings[option.value] = Math.max(found.drawings[option.value] || 0, most);
      }
    }
    app.select(null);
    await settle();
    found.colours = any();
    document.getElementById("show-certificates").click();
    await settle();
    found.rows = document.querySelectorAll("#certificate-rows .row").length;
    document.getElementById("show-records").click();
    await settle();
    found.moves = document.querySelectorAll("#event .moves li").length;
  }
  return result;
}
addEventListener("load", () => answer().catch(e => ({ thrown: String(e.stack) })).then(result => {
  document.getElementById("probe").textContent = JSON.stringify(result);
}));
</script>"""


def check_structure(name, label, found, events, live, made):
    """The proof of one structure: its size, what fails next, and that its certificates are seen. Returns how many certificates there were,
    and of how many states a later record has a certificate and the page names it as what fails next."""
    if "missing" in found:
        fail(f"{name}: {label}: {found['missing'][0]} is not in {found['missing'][1]!r}")
    if found["mute"]:
        fail(f"{name}: {label} has kinds of events without an explanation: {found['mute']}")
    last = found["states"][-1]
    if last["live"] != live[label]:
        fail(f"{name}: {label} has {last['live']} certificates at the end, not {live[label]}")
    reads = last["reads"] is not None
    if max(state["groups"] for state in found["states"]) == 0 and not reads and made > 0:
        fail(f"{name}: {label} shows no group")
    failing = named = 0
    for state in found["states"]:
        if reads:
            continue
        later = [e for e in events if e["structure"] == label and e["certificate"] and e["seq"] > state["event"]]
        wanted = None
        if later:
            certificate = later[0]["certificate"]
            wanted = ["%s(%s)" % (certificate["predicate"], ", ".join(certificate["ids"])), later[0]["seq"]]
        # A certificate that is made at the instant at which it fails is not there yet.
        if state["next"] is not None and state["next"] != wanted:
            fail(f"{name}: after event {state['event']} {state['next']} fails next in {label}, not {wanted}")
        failing += wanted is not None
        named += wanted is not None and state["next"] == wanted
    certificates = max(state["live"] for state in found["states"]) > 0 or reads
    if certificates and (not found["drawings"] or min(found["drawings"].values()) < 8):
        fail(f"{name}: {label}: a selected certificate is not seen: {found['drawings']}")
    if found["colours"] < 4:
        fail(f"{name}: {label}: an empty picture")
    if last["live"] > 0 and found["rows"] == 0:
        fail(f"{name}: {label}: the list of certificates is empty")
    return sum(state["live"] for state in found["states"]), failing, named


def pages_of(page):
    """[(name, how the scene is made, structures)]: every structure that is listed, with those of its family."""
    pages = []
    for info in json.loads(page.kinex("list", "structures", "--json").stdout):
        for scene in SCENES[info["objects"]]:
            done = page.kinex("gen", *scene, "--maintain", info["name"], "--force", "-o", "try.json", allowed=(0, 2))
            if done.returncode == 0:
                break
        else:
            fail(f"no scene suits {info['name']}")
        last = pages[-1] if pages else ("", None, [])
        if last[:2] != (info["family"], scene) or len(last[2]) == MOST_ON_A_PAGE:
            last = (info["family"], scene, [])
            pages.append(last)
        last[2].append(info["name"])
    return [(f"{family}-{i}", scene, names) for i, (family, scene, names) in enumerate(pages)]


def main():
    chromium = browser()
    with tempfile.TemporaryDirectory() as folder:
        page = Page(chromium, sys.argv[1], folder)
        seen, failing, named, shown = 0, 0, 0, set()
        for name, generate, structures in pages_of(page):
            page.kinex("gen", *generate, "--maintain", ",".join(structures), "-o", f"{name}.json")
            events, _ = page.run(name)
            summary = json.loads((page.folder / f"{name}.exact.summary.json").read_text(encoding="utf-8"))
            live = {label: s["certificates"]["created"] - s["certificates"]["retracted"]
                    for label, s in summary["structures"].items()}
            created = {label: s["certificates"]["created"] for label, s in summary["structures"].items()}
            page.kinex("view", f"{name}.json", "-o", f"{name}.html")
            html = (page.folder / f"{name}.html").read_text(encoding="utf-8")
            answer = ask(chromium, html.replace("<body>", "<body>" + FRAMES), PROBE, "",
                         ["--window-size=1400,900", "--virtual-time-budget=60000"])
            if "thrown" in answer or answer["errors"]:
                fail(f"{name}: {answer}")
            for label in structures:
                counts = check_structure(name, label, answer["structures"][label], events, live, created[label])
                seen, failing, named = seen + counts[0], failing + counts[1], named + counts[2]
                shown.add(label)
    if named < LEAST_NAMED * failing or failing < len(shown) / 2:
        fail(f"of {failing} states after which a certificate fails, the page names it in {named}")
    print(f"{len(shown)} structures, {seen} certificates on their pages, all of them as the runs had them; of {failing} that fail next {named} are named")


if __name__ == "__main__":
    main()
