// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: one line more or less on the chain of a node, and the consequences at its ancestors.
//
// At such an instant the corners that come and go are at one place (at the ends: infinitely far),
// so a new corner takes its place beside the old one in the parent's merged order, with the same
// contender and on the same side of it.
#include <algorithm>

#include "structures/hull/convex_hull_2.h"

namespace kinex {

void ConvexHull2::link(Index node, Index corner, Index left, Index right) {
  edges_[corner].left = left;
  edges_[corner].right = right;
  (left == kNone ? nodes_[node].head : edges_[left].right) = corner;
  (right == kNone ? nodes_[node].tail : edges_[right].left) = corner;
}

void ConvexHull2::unlink(Index node, Index corner) {
  Edge& e = edges_[corner];
  (e.left == kNone ? nodes_[node].head : edges_[e.left].right) = e.right;
  (e.right == kNone ? nodes_[node].tail : edges_[e.right].left) = e.left;
  e.left = e.right = kNone;
}

// For a chain of the root, or of a node whose parent is stale: then the hull is read anew anyway.
void ConvexHull2::note_root_change(Index node, Index a, Index b, ObjectId point, bool enters) {
  hull_changed_ = true;
  const bool inside = a != kNone && b != kNone && node / 2 == root_;
  root_changes_ += inside ? 1 : 2;
  if (!inside) return;
  root_change_ = {point, edges_[a].point, edges_[b].point, half(node), enters};
}

// Adds a line between a and b, neighbours on the chain, or at an end of it (a or b is kNone).
ConvexHull2::Index ConvexHull2::enter(Index node, Index a, Index b, ObjectId point) {
  const Index c = allocate_edge(node, point);
  edges_[c].previous = a;
  edges_[c].next = b;
  (a == kNone ? nodes_[node].first : edges_[a].next) = c;
  (b == kNone ? nodes_[node].last : edges_[b].previous) = c;
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
    link(p, c, a, edges_[a].right);
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
  const Node& other = nodes_[child(p, red ? 1 : 0)];
  const Index over = end == 0 ? other.first : other.last;
  Edge& v = edges_[corner];
  v.contender = over;
  v.above = nodes_[p].red[static_cast<std::size_t>(end)] == red;
  if (end == 0) {
    link(p, corner, kNone, nodes_[p].head);
  } else {
    link(p, corner, nodes_[p].tail, kNone);
  }
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
  if (p == kNone) note_root_change(node, a, b, edges_[edge].point, false);
  bool merged = p != kNone;
  const int end = a == kNone ? 0 : 1;
  // The corner that is removed, with its claims; a's corner takes its place if that stays.
  const bool inside = a != kNone && b != kNone;
  const Index corner = inside || end == 0 ? edge : a;
  if (merged) {
    bool simple = edges_[edge].crossings == 0;
    if (inside) {
      simple = simple && edges_[a].right == edge && edges_[a].above == edges_[edge].above;
    } else if (end == 0) {
      simple = simple && nodes_[p].head == edge && !crosses_left(p, edge);
    } else {
      simple = simple && nodes_[p].tail == a && !crosses_right(p, a);
    }
    if (!simple) {
      spoil(p, "other corners between those that meet");
      merged = false;
    }
  }
  if (!merged) {
    (a == kNone ? nodes_[node].first : edges_[a].next) = b;
    (b == kNone ? nodes_[node].last : edges_[b].previous) = a;
    free_edge(edge);
    return;
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
  unlink(p, corner);
  edges_[corner].contender = kNone;
  (a == kNone ? nodes_[node].first : edges_[a].next) = b;
  (b == kNone ? nodes_[node].last : edges_[b].previous) = a;
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

// Clears what the merge of a node has stored at the corners of its children.
void ConvexHull2::clear_merge(Index node) {
  for (CertificateId& c : nodes_[node].ends) drop(c);
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
}

void ConvexHull2::spoil(Index node, const char* reason) {
  ++spoil_reasons_[reason];
  for (; node != kNone && !nodes_[node].stale; node = parent(node)) {
    clear_merge(node);
    free_chain(node);
    nodes_[node].stale = true;
    stale_.push_back(node);
  }
  hull_changed_ = true;
  root_changes_ += 2;
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
