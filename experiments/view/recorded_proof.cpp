// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/recorded_proof.h"

#include <algorithm>
#include <map>
#include <set>

namespace kinex::view {

std::vector<std::uint32_t> certificates_after(const RecordedProof& proof, std::uint64_t event) {
  std::set<std::uint32_t> live;
  for (const ProofChange& change : proof.changes) {
    if (change.event > event) break;
    for (const std::uint32_t c : change.gone) live.erase(c);
    live.insert(change.came.begin(), change.came.end());
  }
  return {live.begin(), live.end()};
}

std::optional<GroupProof> group_after(const RecordedProof& proof, std::span<const ObjectId> about,
                                      std::uint64_t event) {
  std::map<std::uint32_t, std::uint32_t> states;  // by the number of the group
  for (const ProofChange& change : proof.changes) {
    if (change.event > event) break;
    for (const std::uint32_t group : change.ended) states.erase(group);
    for (const std::uint32_t state : change.states) states[proof.groups[state].group] = state;
  }
  const auto found = std::find_if(states.begin(), states.end(), [&](const auto& entry) {
    const std::vector<ObjectId>& own = proof.groups[entry.second].state.about;
    return std::equal(own.begin(), own.end(), about.begin(), about.end());
  });
  if (found == states.end()) return std::nullopt;
  std::vector<std::uint32_t> own;
  for (const std::uint32_t c : certificates_after(proof, event)) {
    if (proof.certificates[c].group == found->first) own.push_back(c);
  }
  std::sort(own.begin(), own.end(), [&](std::uint32_t a, std::uint32_t b) {
    return proof.certificates[a].slot < proof.certificates[b].slot;
  });
  GroupProof result;
  for (const std::uint32_t c : own) result.claims.push_back(proof.certificates[c].claim);
  result.state = proof.groups[found->second].state;
  return result;
}

}  // namespace kinex::view
