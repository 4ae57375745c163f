# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a page of every structure in Chromium and asks whether its certificates are there and drawn.

usage: view_proofs.py PROGRAM
The witnesses: `kinex run` (certificates created less those retracted are those that are live at the end),
and its log (what fails next is the certificate of the log's next record). What is drawn is seen by its
colour: a certificate that is selected leaves ink of its own in every drawing. Exit code 77 (skipped) where
there is no Chromium.
"""
import json
import re
import sys
import tempfile

from chromium import ask, browser
from view_page import FRAMES, Page, fail

# How scenes are made, and the structures that each shows.
POINTS = ["uniform-square", "--n", "14", "--seed", "4"]
SPACE = ["uniform-square", "--dimension", "3", "--n", "9", "--seed", "4"]
DISCS = ["random-discs", "--n", "9", "--seed", "4"]
LINES = ["random-lines-and-points", "--n", "9", "--seed", "4"]
BOXES = ["random-boxes", "--n", "9", "--seed", "4"]
GRAPH = ["random-graph", "--n", "14", "--m", "8", "--seed", "4"]
BODIES = ["polygons-in-box", "--n", "5", "--m", "3", "--seed", "2"]
LEVEL = ["polygon-approach", "--n", "8"]
HULLS = ["convex_hull_2", "convex_hull_2_naive", "convex_hull_2_brute_force", "convex_hull_2_delaunay"]
MAXIMA = ["tournament", "heap", "hanger", "dual_hull", "envelope", "sorted_list"]
SCENES = [
    ("order", POINTS, ["sorted_list"]),
    ("maxima", POINTS, [f"maximum_{name}" for name in MAXIMA]),
    ("minima", POINTS, [f"minimum_{name}" for name in MAXIMA]),
    ("planes", POINTS, ["delaunay_2", "closest_pair_delaunay", "emst_list", "emst_cycles", "bounding_box"] + HULLS),
    ("extents", POINTS, ["calipers_2", "diameter_2", "diameter_all_pairs", "width_2", "min_area_rectangle_2",
                         "min_perimeter_rectangle_2", "bounding_box_2_hull"]),
    ("directions", POINTS, ["directions_2", "directions_2_tournament", "diameter_directions", "width_directions"]),
    ("circles", POINTS, ["farthest_delaunay_2", "min_circle_2", "min_circle_2_brute_force"]),
    ("pairs", POINTS, ["closest_pair_all", "closest_pair_range_tree", "bichromatic_pair_all",
                        "bichromatic_pair_delaunay", "nearest_site", "voronoi_cell_2"]),
    ("octants", POINTS, ["octants_listed", "octants_local", "closest_pair_cones", "closest_pair_local",
                         "closest_pair_bins", "mst_maximum_norm_list", "mst_maximum_norm_cycles"]),
    ("lines", LINES, ["incidences_all"]),
    ("discs", DISCS, ["disc_pairs_all", "disc_pairs_boxes", "disc_pairs_grid"]),
    ("boxes", BOXES, ["box_pairs"]),
    ("graphs", GRAPH, ["graph_mst_list", "graph_mst_cycles"]),
    ("space", SPACE, ["delaunay_3"]),
    ("ranges", POINTS, ["range_tree_2", "rank_kd_tree_2", "pseudo_kd_tree_2", "trajectory_tree"]),
    ("bodies", BODIES, ["separation_mixed", "separation_hysteresis", "closest_features",
                        "inner_tangents", "bounding_volumes", "outer_hierarchy"]),
    ("level", LEVEL, ["separation_minkowski"]),
]
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
    const found = { drawings: {}, states: [] };
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
        if (option.disabled) continue;
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
          const missing = [claim.name, claim.role, ...claim.form.roles.map(role => role.name)]
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
    """The proof of one structure: its size, what fails next, and that its certificates are seen."""
    if "missing" in found:
        fail(f"{name}: {label}: {found['missing'][0]} is not in {found['missing'][1]!r}")
    last = found["states"][-1]
    if last["live"] != live[label]:
        fail(f"{name}: {label} has {last['live']} certificates at the end, not {live[label]}")
    reads = last["reads"] is not None
    if max(state["groups"] for state in found["states"]) == 0 and not reads and made > 0:
        fail(f"{name}: {label} shows no group")
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
    certificates = max(state["live"] for state in found["states"]) > 0 or reads
    if certificates and (not found["drawings"] or min(found["drawings"].values()) < 8):
        fail(f"{name}: {label}: a selected certificate is not seen: {found['drawings']}")
    if found["colours"] < 4:
        fail(f"{name}: {label}: an empty picture")
    if last["live"] > 0 and found["rows"] == 0:
        fail(f"{name}: {label}: the list of certificates is empty")
    return sum(state["live"] for state in found["states"])


def registered(program, page):
    """The names of all structures, as the reader of scenes lists them when it meets another one."""
    import subprocess
    page.kinex("gen", *POINTS, "-o", "names.json")
    said = subprocess.run([program, "run", str(page.folder / "names.json"), "--maintain", "none_such"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False).stdout
    return set(re.findall(r"\b[a-z]+(?:_[a-z0-9]+)+\b", said)) - {"none_such"}


def main():
    chromium = browser()
    with tempfile.TemporaryDirectory() as folder:
        page = Page(chromium, sys.argv[1], folder)
        seen, shown = 0, set()
        for name, generate, structures in SCENES:
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
                seen += check_structure(name, label, answer["structures"][label], events, live, created[label])
                shown.add(label)
        missing = registered(sys.argv[1], page) - shown
        if missing:
            fail(f"no page shows {sorted(missing)}")
    print(f"{len(shown)} structures, {seen} certificates on their pages, all of them as the runs had them")


if __name__ == "__main__":
    main()
