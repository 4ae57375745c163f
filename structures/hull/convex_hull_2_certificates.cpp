// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: the certificates, as a function of the combinatorial state.
#include <utility>

#include "structures/hull/convex_hull_2.h"
#include "structures/parts/sort_unique.h"

namespace kinex {

bool ConvexHull2::crosses_left(Index node, Index corner) const {
  const Index left = edges_[corner].left;
  return red_above(corner) != (left == kNone ? nodes_[node].red[0] : red_above(left));
}

bool ConvexHull2::crosses_right(Index node, Index corner) const {
  const Index right = edges_[corner].right;
  return red_above(corner) != (right == kNone ? nodes_[node].red[1] : red_above(right));
}

// The first corner of the other colour over a line, kNone if there is none.
ConvexHull2::Index ConvexHull2::first_of_run(Index line) const {
  const Edge& e = edges_[line];
  const Index c = e.previous == kNone ? nodes_[merge_of(line)].head : edges_[e.previous].right;
  return c != kNone && edges_[c].red != e.red ? c : kNone;
}

ConvexHull2::Index ConvexHull2::last_of_run(Index line) const {
  const Edge& e = edges_[line];
  const Index c = e.next == kNone ? nodes_[merge_of(line)].tail : e.left;
  return c != kNone && edges_[c].red != e.red ? c : kNone;
}

// ---- claims

Query ConvexHull2::base_query(Slot slot, Index place) const {
  if (slot >= kSlotLeft) {
    const int end = slot - kSlotLeft;
    const auto [blue, red] = end_lines(place, end);
    // Far left the smaller slope is above, far right the larger one.
    const bool red_first = nodes_[place].red[static_cast<std::size_t>(end)] == (end == 0);
    return signs_.slopes(edges_[red_first ? red : blue].point,
                         edges_[red_first ? blue : red].point);
  }
  const Edge& e = edges_[place];
  const ObjectId contender = edges_[e.contender].point;
  switch (slot) {
    case kSlotX:
      return signs_.corners(half(e.node), corner(place), corner(e.right));
    case kSlotY:
      return signs_.height(half(e.node), e.above, corner(place), contender);
    case kSlotS1:
      return e.claim == kAfter    ? signs_.slopes(edges_[e.next].point, contender)
             : e.claim == kBefore ? signs_.slopes(contender, e.point)
                                  : signs_.slopes(e.point, contender);
    default:
      return signs_.slopes(contender, edges_[e.next].point);
  }
}

// Just after now, ties resolved.
bool ConvexHull2::claim_holds(Slot slot, Index place) const {
  if (slot == kSlotX) {
    const Edge& e = edges_[place];
    return signs_.corners_hold(half(e.node), corner(place), corner(e.right));
  }
  if (slot == kSlotY) {
    const Edge& e = edges_[place];
    return signs_.above(half(e.node), corner(place), edges_[e.contender].point) == e.above;
  }
  const Query query = base_query(slot, place);
  return signs_.slopes_hold(query.ids[0], query.ids[1]);
}

bool ConvexHull2::needs_y(Index corner) const {
  if (variant_ == Variant::kNaive || edges_[corner].claim == kTangent) return true;
  const Index node = merge_of(corner);
  return crosses_left(node, corner) || crosses_right(node, corner);
}

// ---- keeping certificates

Outlook ConvexHull2::certify(Slot slot, Index place, const Query& query) {
  if (!exact_ && repeats_an_object(query)) give_up("a line meets itself");
  if (corrupt_) return Outlook::kNever;
  const Outlook outlook = parts_[slot].renew(certificate_of(slot, place), query, place);
  if (outlook == Outlook::kFailsNow) unsettled_ = true;
  return outlook;
}

void ConvexHull2::drop(Slot slot, Index place) {
  CertificateId& certificate = certificate_of(slot, place);
  if (certificate != kNoCertificate && !corrupt_) parts_[slot].drop(certificate);
}

void ConvexHull2::drop_all(Index edge) {
  for (const Slot slot : {kSlotX, kSlotY, kSlotS1, kSlotS2}) {
    if (edges_[edge].certificates[slot] != kNoCertificate) drop(slot, edge);
  }
}

void ConvexHull2::refresh(Slot slot, Index place) {
  if (certify(slot, place, base_query(slot, place)) == Outlook::kIdenticallyZero) {
    resolve_tie(slot, place);
  }
}

// The certificate is identically zero.
void ConvexHull2::resolve_tie(Slot slot, Index place) {
  signs_.note_tie();
  if (tied_.size() > 64 + 8 * edges_.size()) sort_unique(tied_);
  tied_.push_back({place, slot});
  bool holds = true;
  if (slot == kSlotX) {
    holds = signs_.corners_tie(corner(place), corner(edges_[place].right));
  } else {
    look_anew();  // a point may from now on lie on a line with its neighbours
    const Query base = base_query(slot, place);
    const HullSigns::Substitutes ties =
        slot == kSlotY ? signs_.height_tie(edges_[place].above, corner(place),
                                           edges_[edges_[place].contender].point)
                       : signs_.slopes_tie(base.ids[0], base.ids[1]);
    holds = ties.holds;
    for (std::size_t i = 0; i < ties.count; ++i) {
      if (certify(slot, place, ties.queries[i]) != Outlook::kIdenticallyZero) return;
    }
  }
  if (!holds) todo_.push_back({place, slot});
}

void ConvexHull2::refresh_x(Index corner) {
  if (corner == kNone) return;
  const Index right = edges_[corner].right;
  if (right == kNone || edges_[right].red == edges_[corner].red) {
    drop(kSlotX, corner);
  } else {
    refresh(kSlotX, corner);
  }
}

void ConvexHull2::refresh_y(Index corner) {
  if (corner == kNone) return;
  if (needs_y(corner)) {
    refresh(kSlotY, corner);
  } else {
    drop(kSlotY, corner);
  }
}

void ConvexHull2::refresh_end(Index node, int end) {
  refresh(end == 0 ? kSlotLeft : kSlotRight, node);
}

// ---- where slopes fall in their runs

void ConvexHull2::drop_claim(Index line) {
  const Index corner = edges_[line].claimant;
  if (corner == kNone) return;
  edges_[line].claimant = kNone;
  Edge& v = edges_[corner];
  const bool tangent = v.claim == kTangent;
  v.claim = kNoClaim;
  drop(kSlotS1, corner);
  drop(kSlotS2, corner);
  if (tangent) refresh_y(corner);
}

void ConvexHull2::set_claim(Index line, Index corner, Claim claim) {
  const Index old = edges_[line].claimant;
  if (old != kNone && old != corner) {
    // The certificates move to the new corner.
    Edge& from = edges_[old];
    for (const Slot slot : {kSlotS1, kSlotS2}) {
      drop(slot, corner);
      std::swap(edges_[corner].certificates[slot], from.certificates[slot]);
    }
    const bool tangent = from.claim == kTangent;
    from.claim = kNoClaim;
    if (tangent) refresh_y(old);
  }
  edges_[line].claimant = corner;
  edges_[corner].claim = claim;
  refresh(kSlotS1, corner);
  if (claim == kTangent) {
    refresh(kSlotS2, corner);
  } else {
    drop(kSlotS2, corner);
  }
  refresh_y(corner);
}

// Finds the claim about a line, if one is needed, starting from the present one or from `hint`, a
// corner of the run. Slopes grow along the run, so the search goes in one direction only.
void ConvexHull2::refresh_claim(Index line, Index hint) {
  if (variant_ == Variant::kNaive) return;
  const Index first = first_of_run(line);
  if (edges_[line].crossings != 0 || first == kNone || !edges_[first].above) {
    return drop_claim(line);
  }
  Index v = edges_[line].claimant;
  if (v == kNone) v = hint != kNone && edges_[hint].contender == line ? hint : first;
  const ObjectId c = edges_[line].point;
  for (int direction = 0;;) {
    const Edge& e = edges_[v];
    if (direction <= 0 && signs_.slopes_hold(c, e.point)) {
      if (v == first) return set_claim(line, v, kBefore);
      v = e.left;
      direction = -1;
      continue;
    }
    if (direction >= 0 && signs_.slopes_hold(edges_[e.next].point, c)) {
      const Index next = e.right;
      if (next == kNone || edges_[next].contender != line || edges_[next].red != e.red) {
        return set_claim(line, v, kAfter);
      }
      v = next;
      direction = 1;
      continue;
    }
    return set_claim(line, v, kTangent);
  }
}

}  // namespace kinex
