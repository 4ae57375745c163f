// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: the proof as data: two trees, of the upper and of the lower hulls. A node merges the
// hulls of its two children.
#include <string>

#include "structures/hull/convex_hull_2.h"

namespace kinex {

std::string_view ConvexHull2::role_of(Slot slot, Index place) const {
  switch (slot) {
    case kSlotX:
      return "two edges in the order of their slopes";
    case kSlotY:
      return edges_[place].claim == kTangent ? "tangent: beyond the other hull"
             : edges_[place].above           ? "beside a crossing: beyond the other hull"
                                             : "beside a crossing: within the other hull";
    case kSlotS1:
    case kSlotS2:
      return edges_[place].claim == kTangent ? "tangent: a vertex within the span of an edge"
                                             : "no tangent: a vertex beside an edge";
    case kSlotLeft:
      return "first vertices of the two hulls";
    default:
      return "last vertices of the two hulls";
  }
}

void ConvexHull2::visit_proof(ProofVisitor& visitor) const {
  if (root_ == kNone) return;
  ProofGroup group;
  std::vector<Index> open{root_};
  while (!open.empty()) {
    const Index t = open.back();
    open.pop_back();
    const TreeNode& tree_node = tree_[t];
    for (Index node = 2 * t; node < 2 * t + kHalves; ++node) {
      group.kind = half(node) == HullSigns::kUpper ? "upper hull" : "lower hull";
      group.text =
          std::to_string(tree_node.leaves) + (tree_node.leaves == 1 ? " point" : " points");
      group.place = node;
      group.parent = tree_node.parent == kNone ? ProofGroup::kNoPlace : parent(node);
      group.branch = tree_node.parent != kNone && tree_[tree_node.parent].children[1] == t ? 1 : 0;
      ProofMark mark;
      mark.name = "hull of the node";
      for (Index e = nodes_[node].first; e != kNone; e = edges_[e].next) {
        mark.objects.push_back(edges_[e].point);
      }
      group.about = leaf(node) ? mark.objects : std::vector<ObjectId>{};
      group.marks.assign(1, std::move(mark));
      visitor.group(group);
      if (!leaf(node)) visit_merge(node, visitor);
    }
    if (tree_node.children[0] == kNone) continue;
    for (const Index child : tree_node.children) open.push_back(child);
  }
}

// The certificates of the merge at a node: at its ends, and at the corners of its children.
void ConvexHull2::visit_merge(Index node, ProofVisitor& visitor) const {
  const auto show = [&](Slot slot, Index place) {
    const CertificateId certificate = certificate_of(slot, place);
    if (certificate != kNoCertificate) visitor.certificate(certificate, role_of(slot, place));
  };
  for (const Slot slot : {kSlotLeft, kSlotRight}) show(slot, node);
  for (const int which : {0, 1}) {
    for (Index e = nodes_[child(node, which)].first; e != kNone; e = edges_[e].next) {
      for (const Slot slot : {kSlotX, kSlotY, kSlotS1, kSlotS2}) show(slot, e);
    }
  }
}

}  // namespace kinex
