// SPDX-License-Identifier: GPL-3.0-or-later
// ConvexHull2: failures and their repair.
#include <utility>

#include "structures/hull/convex_hull_2.h"

namespace kinex {

// ---- prefetch: what the next failures will read, fetched while this one is repaired; no effect on
// the state (an empty asm statement keeps compilers from dropping the calls)

// The edge of a claim that probably fails soon; kNone if there is none, or one at the end of a chain.
ConvexHull2::Index ConvexHull2::upcoming_edge(std::size_t i) const {
  const CertificateId c = kernel_->upcoming(id_, i);
  return c == kNoCertificate || slot_of(c) >= kSlotLeft ? kNone : kernel_->tag(c);
}

// Before the repair: the places of the coming failures, and the surroundings of the very next one.
void ConvexHull2::fetch_places() const {
  asm volatile("");
  for (std::size_t i = 1; i <= 4; ++i) fetch(upcoming_edge(i));
  const Index next = upcoming_edge(0);
  if (next == kNone) return;
  const Edge& e = edges_[next];
  for (const Index i : {e.next, e.left, e.right, e.contender}) fetch(i);
  if (e.merge != kNone) __builtin_prefetch(nodes_.data() + e.merge);
}

// After the repair: the certificates at those places, and what may change on purple.
void ConvexHull2::fetch_certificates() const {
  asm volatile("");
  const Index v = upcoming_edge(0);
  if (v == kNone) return;
  const Edge& e = edges_[v];
  for (const Index i : {v, e.left, e.right}) {
    if (i == kNone) continue;
    for (const CertificateId c : edges_[i].certificates) kernel_->prefetch(c);
  }
  if (e.certificates[kSlotY] != kernel_->upcoming(id_, 0)) return;
  for (const Index i : {v, e.next, e.contender}) fetch(edges_[i].up);
}

void ConvexHull2::certificate_failed(CertificateId failed) {
  fetch_places();
  const Slot slot = slot_of(failed);
  const Index place = parts_[slot].failed(failed);
  report_failure(slot, place);
  unsettled_ = false;
  if (!exact_ && repeats_.failed(kernel_->query(failed))) {
    return give_up("a certificate fails again and again");
  }
  // A tie may have been resolved differently, with nothing to repair.
  const bool tie = signs_.tied() && !kernel_->claims(failed, base_query(slot, place));
  drop(slot, place);
  if (tie && claim_holds(slot, place)) {
    refresh(slot, place);
  } else {
    repair(slot, place);
  }
  if (!corrupt_) work_off();
  fetch_certificates();
  if (corrupt_) return;
  if (++spent_ > 1000 + 8 * edges_.size()) start_afresh();
  if (!kernel_->instant_is_shared(id_) && !unsettled_) finish_instant();
}

// Repairs claims that the rule for ties makes negative although they are identically zero.
void ConvexHull2::work_off() {
  const std::size_t most = 1000 + 8 * edges_.size();
  for (std::size_t i = 0; i < todo_.size(); ++i) {
    const auto [place, slot] = todo_[i];
    const CertificateId certificate = certificate_of(slot, place);
    if (!parts_[slot].is_tie(certificate) || kernel_->tag(certificate) != place ||
        claim_holds(slot, place)) {
      continue;
    }
    if (i > most) return give_up("no end of ties");
    repair(slot, place);
  }
  todo_.clear();
}

// With more repairs at one instant than there are lines the static algorithm is faster.
// finish_instant reports the changes of the hull.
void ConvexHull2::start_afresh() {
  spent_ = 0;
  if (!exact_) return;  // left to the simulator's guard
  construct_anew();
  look_anew();
  kernel_->count_rebuild(id_, "too many repairs at one instant");
}

// Nothing fails any more at this instant.
void ConvexHull2::finish_instant() {
  if (corrupt_) return;
  if (!stale_.empty()) {
    mend();
    work_off();
  }
  if (exact_ && kernel_->failure_is_due()) {
    // After one of its own it is called again; after one of another structure it has to ask for it.
    if (kernel_->upcoming(id_, 0) == kNoCertificate) kernel_->settle_later(id_);
    return;
  }
  spent_ = 0;
  if (root_changes_ == 0) return;
  if (!settle_one_vertex()) events_.settle(hull_cycle());
  root_changes_ = 0;
}

// One failure, and one vertex that entered or left between two others. In the cycle, which is
// counter-clockwise, the upper hull runs from right to left.
bool ConvexHull2::settle_one_vertex() {
  if (root_changes_ != 1 || signs_.tied() || kernel_->instant_is_shared(id_)) return false;
  const RootChange& change = root_change_;
  const bool upper = change.half == HullSigns::kUpper;
  const ObjectId from = upper ? change.right : change.left;
  const ObjectId to = upper ? change.left : change.right;
  return change.enters ? events_.entered(change.point, from, to)
                       : events_.left(change.point, from, to);
}

void ConvexHull2::instant_settled() {
  unsettled_ = false;
  finish_instant();
}

void ConvexHull2::report_failure(Slot slot, Index place) {
  const Index node = slot >= kSlotLeft ? place : merge_of(place);
  const std::uint32_t height = nodes_[node].height;
  if (by_level_.size() <= height) by_level_.resize(height + 1, 0);
  ++by_level_[height];
  if (slot == kSlotX) {
    const Corner v = corner(place), w = corner(edges_[place].right);
    return kernel_->report(id_, kX, {v.a, v.b, w.a, w.b}, false);
  }
  if (slot == kSlotY) {
    const Corner v = corner(place);
    const bool left = crosses_left(node, place), right = crosses_right(node, place);
    const Kind kind = left ? (right ? kYb : kYl) : right ? kYr : kYt;
    return kernel_->report(id_, kind, {v.a, v.b, edges_[edges_[place].contender].point}, false);
  }
  const Query query = base_query(slot, place);
  const Claim claim = slot >= kSlotLeft ? kNoClaim : edges_[place].claim;
  const Kind kind = claim == kNoClaim ? kEnd : claim == kAfter ? kSl : claim == kBefore ? kSr : kSt;
  kernel_->report(id_, kind, {query.ids[0], query.ids[1]}, false);
}

void ConvexHull2::repair(Slot slot, Index place) {
  if (slot == kSlotX) return repair_x(place);
  if (slot == kSlotY) return repair_y(place);
  const Query claim = base_query(slot, place);
  if (slot >= kSlotLeft) {
    const auto [blue, red] = end_lines(place, slot - kSlotLeft);
    return pass(place, red, blue, claim);
  }
  const Edge& e = edges_[place];
  const Index passed = slot == kSlotS2 || e.claim == kAfter ? e.next : place;
  pass(merge_of(place), passed, e.contender, claim);
}

// The slope of the contender has passed that of the line on the left (kSlotS1) or on the right of a
// corner.
void ConvexHull2::repair_s(Slot slot, Index v) {
  const Edge& e = edges_[v];
  const Index line = e.contender;
  if (e.claim != kTangent) return set_claim(line, v, kTangent);
  const bool to_left = slot == kSlotS1;
  const Index next = to_left ? e.left : e.right;
  if (next == kNone || edges_[next].contender != line) {
    return set_claim(line, v, to_left ? kBefore : kAfter);
  }
  set_claim(line, next, kTangent);
}

// Two corners of different colours exchange places.
void ConvexHull2::repair_x(Index u) {
  const Index node = merge_of(u);
  const Index w = edges_[u].right;
  if (red_above(u) != red_above(w)) {
    // The chains cross between them: all four lines meet in one point.
    for (const Index v : {u, w}) {
      if (claim_holds(kSlotY, v)) continue;
      drop(kSlotX, u);
      repair_y(v);
      if (!nodes_[node].stale) refresh_x(u);
      return;
    }
    return spoil(node, "two corners and a crossing at one place");
  }
  const Index q = edges_[u].left, t = edges_[w].right;
  const Index line_w = w, next_w = edges_[w].next, line_u = u, next_u = edges_[u].next;
  // Claims of the two about lines that they leave pass to their neighbours.
  for (const Index v : {u, w}) {
    const Index over = edges_[v].contender;
    if (edges_[over].claimant != v) continue;
    const Index heir = v == u ? q : t;
    const bool inherits = heir != kNone && edges_[heir].contender == over;
    edges_[over].claimant = inherits ? heir : kNone;
    if (inherits) std::swap(edges_[heir].claim, edges_[v].claim);
    edges_[v].claim = kNoClaim;
    for (const Slot slot : {kSlotS1, kSlotS2}) {
      if (inherits) std::swap(edges_[heir].certificates[slot], edges_[v].certificates[slot]);
      drop(slot, v);
    }
  }
  std::swap(edges_[u].certificates[kSlotX], edges_[w].certificates[kSlotX]);
  join_corners(node, q, w);
  join_corners(node, w, u);
  join_corners(node, u, t);
  edges_[u].contender = next_w;
  edges_[w].contender = line_u;
  refresh_x(q);
  refresh_x(w);
  refresh_x(u);
  // About lines of w's colour: u leaves the run of one and joins that of the next.
  refresh_claim(line_w, q);
  refresh_claim(next_w, u);
  refresh_claim(next_u, t);
  refresh_claim(line_u, w);
  refresh_y(u);
  refresh_y(w);
}

// A corner ab passes its contender c: purple gains or loses one of the three lines:
//
//     a         b              a     c     b      c shows on purple once it is above the corner ab:
//       '.    .'                '.       .'       one corner is replaced by two, or two by one
//         'ab'        <--->       '.___.'
//     --------------c               (ab)
//
// If the chains cross on one side of the corner only, it is a or b that comes or goes.
void ConvexHull2::repair_y(Index v) {
  const Index node = merge_of(v);
  const Index a = v, b = edges_[v].next, c = edges_[v].contender;
  const bool left = crosses_left(node, v), right = crosses_right(node, v);
  const bool rises = !edges_[v].above;
  // The line that comes or goes, and its neighbours on purple.
  Index before = a, line = c, after = b;
  if (left != right) (rises == left ? after : before) = c;
  if (left != right) line = rises == left ? b : a;
  const bool goes = (left == right) == rises;
  const Index up = edges_[line].up, up_before = edges_[before].up, up_after = edges_[after].up;
  const auto adjacent = [this](Index x, Index y) {
    return x != kNone && y != kNone && edges_[x].next == y;
  };
  const bool possible = goes ? adjacent(up_before, up) && adjacent(up, up_after)
                             : adjacent(up_before, up_after) && up == kNone;
  if (!possible || (left == right && rises != left)) {
    return spoil(node, "a corner and a crossing that it cannot pass");
  }

  edges_[v].above = rises;
  const int at_left = left ? -1 : 1, at_right = right ? -1 : 1;
  count_crossings(a, at_left);
  count_crossings(b, at_right);
  count_crossings(c, at_left + at_right);
  edges_[line].up = kNone;
  if (goes) {
    leave(node, up);
  } else {
    const Index entered = enter(node, up_before, up_after, edges_[line].point);
    edges_[line].up = entered;
  }
  refresh_claim(c, v);
  refresh_claim(a, edges_[v].left);
  refresh_claim(b, edges_[v].right);
  refresh_y(v);
  refresh_y(edges_[v].left);
  refresh_y(edges_[v].right);
}

// The slopes of e and f (of different colours) change order: every claim that contradicts this is
// repaired at once, in both halves where both lines are at the ends of both.
void ConvexHull2::pass(Index node, Index e, Index f, const Query& claim) {
  const ObjectId p = edges_[e].point, q = edges_[f].point;
  // The same lines in the other half, if they are first or last there: read before anything moves.
  const Index other = node ^ 1u;
  Index twins[2]{kNone, kNone};
  if (!nodes_[other].stale) {
    for (const int which : {0, 1}) {
      const Node& chain = nodes_[child(other, which)];
      for (const Index x : {chain.first, chain.last}) {
        if (edges_[x].point == p || edges_[x].point == q) twins[which] = x;
      }
    }
  }
  pass_half(node, e, f, claim);
  if (twins[0] != kNone && twins[1] != kNone && !nodes_[other].stale) {
    pass_half(other, twins[0], twins[1], claim);
  }
}

void ConvexHull2::pass_half(Index node, Index e, Index f, const Query& claim) {
  const Node& x = nodes_[child(node, 0)];
  const Node& y = nodes_[child(node, 1)];
  const auto says = [&](Slot slot, Index place) {
    const Query query = base_query(slot, place);
    return query.ids[0] == claim.ids[0] && query.ids[1] == claim.ids[1];
  };
  const bool wrong[2] = {says(kSlotLeft, node), says(kSlotRight, node)};
  if (wrong[0] && wrong[1]) {
    // Two single lines: the lower one goes from one end to the other.
    const bool red_is_higher =
        signs_.higher(half(node), edges_[x.first].point, edges_[y.first].point);
    const int first = nodes_[node].red[0] != red_is_higher ? 0 : 1;
    turn_end(node, first);
    if (!nodes_[node].stale) turn_end(node, 1 - first);
  } else {
    for (const int end : {0, 1}) {
      if (wrong[end]) turn_end(node, end);
    }
  }
  for (const Index line : {e, f}) {
    if (nodes_[node].stale) return;
    const Index v = edges_[line].claimant;
    if (v == kNone) continue;
    if (says(kSlotS1, v)) {
      repair_s(kSlotS1, v);
    } else if (edges_[v].claim == kTangent && says(kSlotS2, v)) {
      repair_s(kSlotS2, v);
    }
  }
}

// The two first (or last) lines of the chains are parallel: from now on the other one is above, far
// out.
void ConvexHull2::turn_end(Index node, int end) {
  Node& n = nodes_[node];
  const std::size_t at = static_cast<std::size_t>(end);
  const Index corner = end == 0 ? n.head : n.tail;
  const bool inner = corner == kNone ? n.red[1 - at] : red_above(corner);
  const bool crossed = n.red[at] != inner;
  const std::array<Index, 2> lines = end_lines(node, end);
  const Index old = lines[n.red[at]], fresh = lines[!n.red[at]];
  const Index outer = end == 0 ? n.first : n.last;
  const Index up = edges_[old].up;
  const bool possible = up == outer && (crossed ? n.first != n.last : edges_[fresh].up == kNone);
  if (!possible) return spoil(node, "two lines at the end of a chain that cannot pass each other");
  n.red[at] = !n.red[at];
  for (const Index line : lines) count_crossings(line, crossed ? -1 : 1);
  if (crossed) {
    edges_[old].up = kNone;
    leave(node, up);
  } else {
    const ObjectId point = edges_[fresh].point;
    const Index entered = end == 0 ? enter(node, kNone, up, point) : enter(node, up, kNone, point);
    edges_[fresh].up = entered;
  }
  refresh_end(node, end);
  for (const Index line : lines) refresh_claim(line, corner);
  refresh_y(corner);
}

}  // namespace kinex
