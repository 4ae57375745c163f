// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: insertion, erasure, new motions.
//
// The tree is kept in balance by weight: no child has more than three quarters of its parent's
// leaves (and a few). An unbalanced subtree is rebuilt: O(log n) times per n changes.
#include <algorithm>

#include "structures/hull/convex_hull_2.h"
#include "structures/parts/sort_unique.h"
#include "structures/parts/ties.h"

namespace kinex {

// The leaf with the fewest ancestors becomes a node over its point and the new one.
void ConvexHull2::insert(ObjectId object) {
  if (corrupt_) return;
  repeats_.clear();
  if (root_ == kNone) {
    root_ = allocate_tree_node();
    make_leaf(root_, object);
    return reset_hull();
  }
  Index t = root_;
  while (tree_[t].children[0] != kNone) {
    const Index a = tree_[t].children[0], b = tree_[t].children[1];
    t = tree_[b].leaves < tree_[a].leaves ? b : a;
  }
  const Index above = tree_[t].parent;
  const Index fresh = allocate_tree_node(), node = allocate_tree_node();
  unmerge_path(above);
  make_leaf(fresh, object);
  tree_[node].children[0] = t;
  tree_[node].children[1] = fresh;
  hang(above, t, node);
  tree_[t].parent = tree_[fresh].parent = node;
  merge_path(node);
}

void ConvexHull2::erase(ObjectId object) {
  if (corrupt_) return;
  const Index t = leaf_of_[object];
  const Index node = tree_[t].parent;
  unmerge_path(node);
  leaf_of_[object] = kNone;
  for (unsigned h = 0; h < kHalves; ++h) free_chain(2 * t + h);
  free_tree_nodes_.push_back(t);
  if (node == kNone) {
    root_ = kNone;
    return reset_hull();
  }
  const Index sibling = tree_[node].children[tree_[node].children[0] == t ? 1 : 0];
  const Index above = tree_[node].parent;
  hang(above, node, sibling);
  free_tree_nodes_.push_back(node);
  merge_path(above);
}

// A tree node takes the place of another below `above`; kNone: of the root.
void ConvexHull2::hang(Index above, Index old, Index fresh) {
  tree_[fresh].parent = above;
  if (above == kNone) {
    root_ = fresh;
  } else {
    tree_[above].children[tree_[above].children[0] == old ? 0 : 1] = fresh;
  }
}

// Takes the merges of a node and all its ancestors apart, the topmost first.
void ConvexHull2::unmerge_path(Index t) {
  std::vector<Index> path;
  for (; t != kNone; t = tree_[t].parent) path.push_back(t);
  for (auto p = path.rbegin(); p != path.rend(); ++p) {
    for (unsigned h = 0; h < kHalves; ++h) unmerge(2 * *p + h);
  }
}

void ConvexHull2::merge_path(Index t) {
  while (t != kNone) {
    update_sizes(t);
    const std::uint32_t a = tree_[tree_[t].children[0]].leaves;
    const std::uint32_t b = tree_[tree_[t].children[1]].leaves;
    if (4 * std::max(a, b) > 3 * (a + b) + 8) {
      t = remake(t);
    } else {
      merge_both(t);
    }
    t = tree_[t].parent;
  }
  work_off();
  reset_hull();
}

// Rebuilds the subtree with root t, whose chains are gone.
ConvexHull2::Index ConvexHull2::remake(Index t) {
  std::vector<ObjectId> objects;
  const Index above = tree_[t].parent;
  take_apart(tree_[t].children[0], objects);
  take_apart(tree_[t].children[1], objects);
  free_tree_nodes_.push_back(t);
  std::sort(objects.begin(), objects.end());
  const Index fresh = build_tree(objects);
  hang(above, t, fresh);
  return fresh;
}

// Requires that nothing above t is merged.
void ConvexHull2::take_apart(Index t, std::vector<ObjectId>& objects) {
  const bool is_leaf = tree_[t].children[0] == kNone;
  if (is_leaf) objects.push_back(edges_[nodes_[2 * t].first].point);
  for (unsigned h = 0; h < kHalves; ++h) is_leaf ? free_chain(2 * t + h) : unmerge(2 * t + h);
  if (!is_leaf) {
    for (const Index child : tree_[t].children) take_apart(child, objects);
  }
  free_tree_nodes_.push_back(t);
}

// Certificates have been rescheduled. Ties may have come or gone. The certificate that keeps a tie
// need not name all of its points.
void ConvexHull2::motions_changed(std::span<const ObjectId> objects) {
  if (corrupt_) return;
  repeats_.clear();
  std::vector<Claimed> claims;
  claims.swap(tied_);
  each_tie(*kernel_, id_, objects, [&](CertificateId certificate) {
    claims.push_back({kernel_->tag(certificate), slot_of(certificate)});
  });
  sort_unique(claims);
  for (const auto& [place, slot] : claims) {
    if (place >= (slot >= kSlotLeft ? nodes_.size() : edges_.size())) continue;
    const CertificateId certificate = certificate_of(slot, place);
    if (certificate == kNoCertificate) continue;
    if (!parts_[slot].is_tie(certificate) &&
        kernel_->claims(certificate, base_query(slot, place))) {
      continue;
    }
    drop(slot, place);
    refresh(slot, place);
  }
  work_off();
  // Points that were tied may have separated and become vertices, with nothing to repair.
  if (signs_.tied()) look_anew();
}

}  // namespace kinex
