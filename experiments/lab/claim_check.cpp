// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/claim_check.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "structures/registry.h"

namespace kinex::lab {

RunKey small_run(RunKey run) {
  constexpr int kOnALine = 8;         // kinex-logcheck does level 5 up to 12 ..
  constexpr int kInThePlane = 6;      // .. but takes seconds over all sets of four
  constexpr int kVertices = 3;        // or over all pairs of a vertex and an edge
  constexpr std::uint64_t kSeed = 2;  // of so few points the first scene has a maximum that stays
  const StructureInfo* structure = find_structure_info(run.structure);
  run.n = run.dimension == 1 ? kOnALine : kInThePlane;
  if (structure != nullptr && structure->bodies) run.n = kVertices;
  run.m = std::min(run.m, run.n);
  run.seed = kSeed;
  run.max_events = 0;
  return run;
}

std::vector<std::string> check_claims(std::vector<PaperClaim>& claims, const SecondProgram& program,
                                      RecordStore& store,
                                      const std::function<void(const RunKey&)>& on_run) {
  std::vector<std::string> refusals;
  std::vector<CheckedBy> done;  // claims share runs
  for (PaperClaim& claim : claims) {
    if (claim.small_run.structure.empty()) {
      claim.checked_by.program = program.name();
      claim.checked_by.message = claim.no_small_run;
      continue;
    }
    const std::string key = claim.small_run.text();
    const auto before = std::find_if(done.begin(), done.end(), [&](const CheckedBy& checked) {
      return checked.run.text() == key;
    });
    if (before != done.end()) {
      claim.checked_by = *before;
    } else if (auto stored = store.find_check(claim.small_run, program.name())) {
      claim.checked_by = *std::move(stored);
    } else {
      on_run(claim.small_run);
      claim.checked_by = program.check(claim.small_run);
      done.push_back(claim.checked_by);
      if (claim.checked_by.outcome == CheckedBy::Outcome::kFine) store.add_check(claim.checked_by);
      if (claim.checked_by.outcome == CheckedBy::Outcome::kRefused) {
        refusals.push_back(claim.checked_by.text());
      }
    }
    if (claim.checked_by.outcome != CheckedBy::Outcome::kRefused) continue;
    if (claim.verdict == Verdict::kConfirmed) claim.verdict = Verdict::kOpen;
    claim.observed += "; but a second program refuses the log of a small run";
  }
  return refusals;
}

}  // namespace kinex::lab
