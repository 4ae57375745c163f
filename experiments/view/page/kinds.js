// What events mean: their kinds in words, as the structures' descriptors have them.
const EXTERNAL_TEXT = "external: the attribute changes";
const INTERNAL_TEXT = "internal: only its proof changes";

function kindText(structure, kind) {
  const { kinds, meanings } = DATA.structures[structure];
  return meanings[kinds.indexOf(kind)] || "";
}
// Of a log record, for its title.
function explain(run, k) {
  const e = at(run, k), kind = kindOf(run, k), text = kindText(run.s[e], kind);
  return kind + (text === "" ? "" : ": " + text) + " (" + (run.x[e] === 1 ? EXTERNAL_TEXT : INTERNAL_TEXT) + ")";
}
