// What events mean: their kinds in words, as the structures' descriptors have them.
const EXTERNAL_TEXT = "external: the attribute changes";
const INTERNAL_TEXT = "internal: only its proof changes";

function kindText(structure, kind) {
  const { kinds, meanings } = DATA.structures[structure];
  return meanings[kinds.indexOf(kind)] || "";
}
// What a log record without a certificate is. Kinds of the structure's own report; the others all structures have.
function withoutCertificate(run, e) {
  const { kinds, own } = DATA.structures[run.s[e]], kind = kinds[run.k[e]];
  if (run.k[e] < own || kind === "settled") return "none of its own: reports what this instant has changed";
  return kind === "rebuild" ? "none: the whole proof is made anew" : "none: a change of the scene";
}
// Of a log record, for its title.
function explain(run, k) {
  const e = at(run, k), kind = kindOf(run, k), text = kindText(run.s[e], kind);
  return kind + (text === "" ? "" : ": " + text) + " (" + (run.x[e] === 1 ? EXTERNAL_TEXT : INTERNAL_TEXT) + ")";
}
