// SPDX-License-Identifier: GPL-3.0-or-later
// The proofs of the structures that maintain a maximum or minimum, as data.
#include "structures/maximum/maximum_dual_hull.h"
#include "structures/maximum/maximum_envelope.h"
#include "structures/maximum/maximum_hanger.h"
#include "structures/maximum/maximum_heap.h"
#include "structures/maximum/maximum_tournament.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {
namespace {

// Of the winners to come as many are shown: a proof is shown after every event.
constexpr std::size_t kShown = 8;

void visit_parent_and_child(ProofVisitor& visitor, const ProofGroup& group,
                            CertificateId certificate) {
  visitor.group(group);
  if (certificate != kNoCertificate) visitor.certificate(certificate, "its parent is as good");
}

}  // namespace

void MaximumTournament::visit_proof(ProofVisitor& visitor) const {
  visit_tournament(visitor, tournament_, 0, "",
                   [](Item winner) { return std::vector<ObjectId>{winner}; });
}

void MaximumHeap::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  heap_.each_place([&](std::uint32_t place, Item item, CertificateId certificate) {
    group.kind = place == 0 ? "top of the heap" : "parent and child";
    group.about = {item};
    group.place = place;
    group.parent = place == 0 ? ProofGroup::kNoPlace : (place - 1) / 2;
    group.branch = (place + 1) % 2;
    visit_parent_and_child(visitor, group, certificate);
  });
}

void MaximumHanger::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  std::vector<Place> open;
  if (root_ != kNone) open.push_back(root_);
  while (!open.empty()) {
    const Place p = open.back();
    const Node& node = nodes_[p];
    open.pop_back();
    group.kind = p == root_ ? "top of the hanger" : "parent and child";
    group.about = {node.object};
    group.place = p;
    group.parent = node.parent == kNone ? ProofGroup::kNoPlace : node.parent;
    group.branch = node.parent != kNone && nodes_[node.parent].child[1] == p ? 1 : 0;
    visit_parent_and_child(visitor, group, node.certificate);
    for (const std::size_t side : {1, 0}) {
      if (node.child[side] != kNone) open.push_back(node.child[side]);
    }
  }
}

void MaximumEnvelope::visit_proof(ProofVisitor& visitor) const {
  if (winners_.empty()) return;
  ProofGroup group;
  group.kind = "envelope";
  group.about = {winner()};
  ProofMark& mark = group.marks.emplace_back();
  mark.name = "the winner and the next ones";
  for (std::size_t i = at_; i < winners_.size() && i <= at_ + kShown; ++i) {
    mark.objects.push_back(winners_[i]);
  }
  visitor.group(group);
  if (certificate_ != kNoCertificate)
    visitor.certificate(certificate_, "the winner beats the next");
}

void MaximumDualHull::visit_proof(ProofVisitor& visitor) const {
  if (winner_ == kNoObject) return;
  ProofGroup group;
  group.kind = "tangent of the dual hull";
  group.about = {winner_};
  ProofMark& mark = group.marks.emplace_back();
  mark.name = "the winner and the next vertices";
  mark.objects.push_back(winner_);
  for (ObjectId v = next_; v != kNoObject && mark.objects.size() <= kShown; v = hull_.next(v)) {
    mark.objects.push_back(v);
  }
  visitor.group(group);
  if (certificate_ != kNoCertificate)
    visitor.certificate(certificate_, "the winner beats the next");
}

}  // namespace kinex
