// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of a tournament as data (core/engine/proof.h): a group for each node of its tree, about
// the objects of its winner.
#ifndef KINEX_STRUCTURES_PARTS_TOURNAMENT_PROOF_H
#define KINEX_STRUCTURES_PARTS_TOURNAMENT_PROOF_H

#include <cstdint>
#include <span>
#include <string>

#include "core/engine/proof.h"

namespace kinex {

// `tree`: another number for each tournament of a structure. `text`: what the tournament is about,
// in words, or empty. `about(item)`: the objects of an item. The tournament has each_node()
// (structures/parts/kinetic_tournament.h).
template <class Tournament, class About>
void visit_tournament(ProofVisitor& visitor, const Tournament& tournament, std::uint32_t tree,
                      const std::string& text, const About& about) {
  ProofGroup group;
  group.text = text;
  const auto place = [tree](std::uint32_t node) { return std::uint64_t{tree} << 32 | node; };
  tournament.each_node([&](std::uint32_t node, const auto& item,
                           std::span<const CertificateId> certificates) {
    const bool played = !certificates.empty();
    group.kind = played ? "match" : "entrant";
    group.about = about(item);
    group.place = place(node);
    group.parent = node == 1 ? ProofGroup::kNoPlace : place(node / 2);
    group.branch = node % 2;
    visitor.group(group);
    for (const CertificateId certificate : certificates) {
      if (certificate != kNoCertificate) {
        visitor.certificate(certificate, "the winner beats the loser");
      }
    }
  });
}

}  // namespace kinex

#endif
