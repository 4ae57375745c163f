// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/claim_check.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "structures/registry.h"

namespace kinex::lab {

RunKey small_run(RunKey run) {
  constexpr int kOnALine = 8;         // kinex-logcheck does level 5 up to 12 ..
  constexpr int kInThePlane = 6;      // .. but takes seconds over all sets of four
  constexpr int kVertices = 3;        // or over all pairs of a vertex and an edge
  constexpr std::uint64_t kSeed = 2;  // of so few points the first scene has a maximum that stays
  const StructureInfo* structure = find_structure_info(run.structure);
  WorkloadParameters& size = run.parameters;
  size.n = size.dimension == 1 ? kOnALine : kInThePlane;
  if (structure != nullptr && structure->bodies) size.n = kVertices;
  size.m = std::min(size.m, size.n);
  size.seed = kSeed;
  run.max_events = 0;
  return run;
}

std::vector<std::string> check_claims(std::vector<PaperClaim>& claims, const std::string& program,
                                      const std::function<CheckedBy(const RunKey&)>& check) {
  std::vector<std::string> refusals;
  std::map<std::string, CheckedBy> done;  // claims share runs
  for (PaperClaim& claim : claims) {
    if (claim.small_run.structure.empty()) {
      claim.checked_by.program = program;
      claim.checked_by.message = claim.no_small_run;
      continue;
    }
    const std::string key = claim.small_run.text();
    auto known = done.find(key);
    if (known == done.end()) {
      known = done.emplace(key, check(claim.small_run)).first;
      if (known->second.finding == CheckedBy::Finding::kRefused) {
        refusals.push_back(known->second.text());
      }
    }
    claim.checked_by = known->second;
    if (claim.checked_by.finding != CheckedBy::Finding::kRefused) continue;
    if (claim.verdict == Verdict::kConfirmed) claim.verdict = Verdict::kOpen;
    claim.observed += "; but a second program refuses the log of a small run";
  }
  return refusals;
}

}  // namespace kinex::lab
