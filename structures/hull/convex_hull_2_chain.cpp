// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: one line more or less on the chain of a node, and the consequences at its ancestors.
//
// At such an instant the corners that come and go are at one place (at the ends: infinitely far),
// so a new corner takes its place beside the old one in the parent's merged order, with the same
// contender and on the same side of it.
#include <algorithm>

#include "structures/hull/convex_hull_2.h"

namespace kinex {

// a and b become neighbours on the chain of a node; kNone: the end of the chain.
void ConvexHull2::join(Index node, Index a, Index b) {
  (a == kNone ? nodes_[node].first : edges_[a].next) = b;
  (b == kNone ? nodes_[node].last : edges_[b].previous) = a;
}

// The same for two corners in the merged order of a node.
void ConvexHull2::join_corners(Index node, Index left, Index right) {
  (left == kNone ? nodes_[node].head : edges_[left].right) = right;
  (right == kNone ? nodes_[node].tail : edges_[right].left) = left;
}

// For a chain of the root, or of a node whose parent is stale: then the hull is read anew anyway.
void ConvexHull2::note_root_change(Index node, Index a, Index b, ObjectId point, bool enters) {
  if (a == kNone || b == kNone || node / 2 != root_) return look_anew();
  ++root_changes_;
  root_change_ = {point, edges_[a].point, edges_[b].point, half(node), enters};
}

// Adds a line between a and b, neighbours on the chain, or at an end of it (a or b is kNone).
ConvexHull2::Index ConvexHull2::enter(Index node, Index a, Index b, ObjectId point) {
  const Index c = allocate_edge(node, point);
  join(node, a, c);
  join(node, c, b);
  const Index p = merge_of(a != kNone ? a : b);
  if (p == kNone) {
    note_root_change(node, a, b, point, true);
    return c;
  }

  const bool red = edges_[a != kNone ? a : b].red;
  edges_[c].merge = p;
  edges_[c].red = red;
  if (a != kNone && b != kNone) {
    edges_[c].contender = edges_[a].contender;
    edges_[c].above = edges_[a].above;
    std::swap(edges_[c].certificates[kSlotX], edges_[a].certificates[kSlotX]);
    join_corners(p, c, edges_[a].right);
    join_corners(p, a, c);
    if (edges_[a].above) {
      const Index up = enter(p, edges_[a].up, edges_[b].up, point);
      edges_[c].up = up;
    }
    const Index over = edges_[a].contender;
    refresh_x(edges_[a].left);
    refresh_x(c);
    if (edges_[over].claimant == a) refresh_claim(over, a);
    refresh_y(a);
    refresh_y(c);
    return c;
  }
  const int end = a == kNone ? 0 : 1;
  const Index corner = end == 0 ? c : a;
  const Index over = end_lines(p, end)[!red];
  Edge& v = edges_[corner];
  v.contender = over;
  v.above = nodes_[p].red[static_cast<std::size_t>(end)] == red;
  const Index left = end == 0 ? kNone : nodes_[p].tail, right = end == 0 ? nodes_[p].head : kNone;
  join_corners(p, left, corner);
  join_corners(p, corner, right);
  if (edges_[corner].above) {
    const Index up =
        end == 0 ? enter(p, kNone, edges_[b].up, point) : enter(p, edges_[a].up, kNone, point);
    edges_[c].up = up;
  }
  refresh_end(p, end);
  refresh_x(edges_[corner].left);
  refresh_x(corner);
  refresh_claim(over, corner);
  refresh_y(corner);
  return c;
}

// Removes a line from its chain. Requires that it is not the only one.
void ConvexHull2::leave(Index node, Index edge) {
  const Index a = edges_[edge].previous, b = edges_[edge].next;
  const Index p = merge_of(edge);
  const int end = a == kNone ? 0 : 1;
  // The corner that is removed, with its claims; a's corner takes its place if that stays.
  const bool inside = a != kNone && b != kNone;
  const Index corner = inside || end == 0 ? edge : a;
  bool simple = p != kNone && edges_[edge].crossings == 0;
  if (p == kNone) {
    note_root_change(node, a, b, edges_[edge].point, false);
  } else if (inside) {
    simple = simple && edges_[a].right == edge && edges_[a].above == edges_[edge].above;
  } else if (end == 0) {
    simple = simple && nodes_[p].head == edge && !crosses_left(p, edge);
  } else {
    simple = simple && nodes_[p].tail == a && !crosses_right(p, a);
  }
  if (!simple) {
    if (p != kNone) spoil(p, "other corners between those that meet");
    join(node, a, b);
    return free_edge(edge);
  }
  const Index over = edges_[corner].contender;
  const Index left = edges_[corner].left, right = edges_[corner].right;
  bool claimed = edges_[over].claimant == corner;
  if (claimed) {
    edges_[over].claimant = kNone;
    edges_[corner].claim = kNoClaim;
  }
  if (inside) {
    claimed = claimed || edges_[over].claimant == a;
    std::swap(edges_[a].certificates[kSlotX], edges_[corner].certificates[kSlotX]);
  }
  drop_all(corner);
  const bool was_above = edges_[corner].above;
  join_corners(p, left, right);
  edges_[corner].left = edges_[corner].right = edges_[corner].contender = kNone;
  join(node, a, b);
  const Index up = edges_[edge].up;
  if (was_above) leave(p, up);
  free_edge(edge);
  if (inside) {
    refresh_x(edges_[a].left);
    refresh_x(a);
    if (claimed) refresh_claim(over, a);
    refresh_y(a);
    return;
  }
  refresh_end(p, end);
  refresh_x(end == 0 ? kNone : left);
  refresh_claim(over, end == 0 ? right : left);
}

// ---- nodes that cannot be repaired in place

// Clears what the merge of a node has stored at the corners of its children, and its chain.
void ConvexHull2::unmerge(Index node) {
  for (const Slot slot : {kSlotLeft, kSlotRight}) drop(slot, node);
  for (const int which : {0, 1}) {
    for (Index e = nodes_[child(node, which)].first; e != kNone; e = edges_[e].next) {
      drop_all(e);
      Edge& edge = edges_[e];
      edge.merge = edge.up = edge.left = edge.right = edge.contender = edge.claimant = kNone;
      edge.claim = kNoClaim;
      edge.crossings = 0;
    }
  }
  nodes_[node].head = nodes_[node].tail = kNone;
  free_chain(node);
}

void ConvexHull2::spoil(Index node, const char* reason) {
  ++spoil_reasons_[reason];
  for (; node != kNone && !nodes_[node].stale; node = parent(node)) {
    unmerge(node);
    nodes_[node].stale = true;
    stale_.push_back(node);
  }
  look_anew();
}

// Merges the stale nodes anew, children first.
void ConvexHull2::mend() {
  std::sort(stale_.begin(), stale_.end(), [this](Index a, Index b) {
    const std::uint32_t ha = tree_[a / 2].height, hb = tree_[b / 2].height;
    return ha != hb ? ha < hb : a < b;
  });
  for (const Index node : stale_) {
    nodes_[node].stale = false;
    merge(node);
    ++node_rebuilds_;
  }
  stale_.clear();
}

}  // namespace kinex
