// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/calipers.h"

#include <algorithm>
#include <string>

#include "predicates/points/edge_predicates.h"
#include "predicates/predicates.h"

namespace kinex {

Calipers::Calipers(Kernel& kernel, StructureId structure, int folds)
    : kernel_(&kernel),
      folds_(folds),
      slots_(kernel, structure, "calipers"),
      slope_(kernel.bind(make_slope_order_2())),
      turn_(kernel.bind(make_orientation_2())),
      dot_(kernel.bind(make_edge_dot_2())),
      dots_(kernel, make_edge_dot_2()) {}

ObjectId Calipers::least_contact(ObjectId edge, int k) const {
  // Edges of one tie stand together, at most one for each fold.
  ObjectId e = edge;
  for (int steps = 1, turns = 0; steps < folds_ && slots_.is_tie(state_[e].certificate); ++steps) {
    turns += state_[e].turn;
    e = state_[e].after;
    if (modulo(turns) == k) return std::min(e, ring_.next(e));
  }
  e = state_[edge].before;
  for (int steps = 1, turns = 0; steps < folds_ && slots_.is_tie(state_[e].certificate); ++steps) {
    turns -= state_[e].turn;
    if (modulo(turns) == k) return std::min(e, ring_.next(e));
    e = state_[e].before;
  }
  return contact(edge, k);
}

std::vector<ObjectId> Calipers::list() const {
  std::vector<ObjectId> result;
  if (!has_list()) return result;
  const std::vector<ObjectId> cycle = ring_.cycle();
  for (ObjectId e = cycle[0]; result.size() < cycle.size(); e = state_[e].after) {
    result.push_back(e);
  }
  return result;
}

// A quarter turn: of the edge with the smaller tail, and the other. So the claim that follows a
// swap names the same objects, the first two exchanged.
Query Calipers::claim(ObjectId e, ObjectId f, int k) const {
  const ObjectId e_to = ring_.next(e), f_to = ring_.next(f);
  if (quarters(k) == 2) {  // f x e >= 0
    if (e_to == f) return Query(turn_, {f, e, f_to});
    if (f_to == e) return Query(turn_, {f, e, e_to});
    return e < f ? Query(slope_, {e_to, e, f, f_to}) : Query(slope_, {f, f_to, e, e_to});
  }
  std::array<ObjectId, 4> ids{e, e_to, f, f_to};  // e . f >= 0
  if (f < e) ids = {f, f_to, e, e_to};
  if (quarters(k) == 1) std::swap(ids[0], ids[1]);
  return dots_.query(ids);
}

void Calipers::make_room(ObjectId vertex) {
  if (state_.size() <= vertex) state_.resize(std::size_t{vertex} + 1);
}

void Calipers::link(ObjectId e, ObjectId f, int turn) {
  state_[e].after = f;
  state_[f].before = e;
  state_[e].turn = static_cast<std::uint8_t>(modulo(turn));
}

void Calipers::certify(ObjectId e) {
  Edge& edge = state_[e];
  if (edge.turn == 0) return slots_.drop(edge.certificate);
  const Query query = claim(e, edge.after, edge.turn);
  if (slots_.holds(edge.certificate, query, e)) return;
  ties_.set(slots_, edge.certificate, query, e);
}

// d e f g becomes d f e g.
void Calipers::swap(ObjectId e) {
  const ObjectId f = state_[e].after, d = state_[e].before, g = state_[f].after;
  const int k = state_[e].turn, to_e = state_[d].turn, from_f = state_[f].turn;
  state_[e].contact[index(k)] = ring_.next(f);
  state_[f].contact[index(modulo(-k))] = e;
  link(d, f, to_e + k);
  link(e, g, k + from_f);
  link(f, e, -k);
  for (const ObjectId renewed : {d, f, e}) certify(renewed);
  changes_.insert(changes_.end(), {e, f});
}

// In an exact arithmetic ties are a few edges each, which come in order after few swaps.
void Calipers::settle() {
  const std::size_t most = 64 + 4 * ring_.size() * ring_.size();
  std::size_t swaps = 0;
  ties_.settle([&](ObjectId e) {
    if (!slots_.is_tie(state_[e].certificate) || e < state_[e].after) return;
    if (++swaps <= most) swap(e);
  });
  if (swaps > most) kernel_->corrupt(slots_.structure(), "all edges of the hull are parallel");
}

bool Calipers::enter(ObjectId vertex, ObjectId from, ObjectId to) {
  if (!has_list() || !ring_.enter(vertex, from, to)) return false;
  make_room(vertex);
  state_[vertex].contact = state_[from].contact;
  link(vertex, state_[from].after, state_[from].turn);
  link(from, vertex, 0);
  for (const ObjectId renewed : {state_[from].before, from, vertex}) certify(renewed);
  changes_.insert(changes_.end(), {from, vertex});
  settle();
  return true;
}

bool Calipers::leave(ObjectId vertex) {
  if (ring_.size() < 4 || !ring_.has(vertex)) return false;
  const ObjectId from = ring_.previous(vertex), to = ring_.next(vertex);
  // Its edge goes back to that of its predecessor.
  std::size_t most = static_cast<std::size_t>(folds_) * ring_.size();
  const Edge& edge = state_[vertex];
  while (edge.before != from || state_[from].turn != 0) {
    if (state_[edge.before].turn == 0 || most-- == 0) return false;
    swap(edge.before);
  }
  ring_.leave(vertex, from, to);
  link(from, edge.after, edge.turn);
  slots_.drop(state_[vertex].certificate);
  for (const ObjectId renewed : {state_[from].before, from}) certify(renewed);
  changes_.insert(changes_.end(), {from, vertex});
  settle();
  return true;
}

Calipers::Swap Calipers::failed(CertificateId failed) {
  const ObjectId e = slots_.failed(failed);
  const Swap result = swap_of(e);
  swap(e);
  settle();
  return result;
}

Calipers::Swap Calipers::dropped(CertificateId failed) {
  const ObjectId e = slots_.failed(failed);
  slots_.drop(state_[e].certificate);
  return swap_of(e);
}

void Calipers::motions_changed(std::span<const ObjectId> objects) {
  ties_.note_of(slots_, objects);
  settle();
}

void Calipers::clear() {
  for (Edge& edge : state_) slots_.drop(edge.certificate);
}

void Calipers::check(AuditReport& report) const {
  const std::vector<ObjectId> cycle = ring_.cycle();
  if (!has_list()) return;
  int turns = 0;
  ObjectId e = cycle[0];
  std::size_t length = 0;
  do {
    const Edge& edge = state_[e];
    turns += edge.turn;
    ++length;
    report.check(ring_.has(e) && state_[edge.after].before == e,
                 [] { return "the list of directions is broken"; });
    if (edge.turn == 0) {
      report.check(edge.certificate == kNoCertificate && edge.after == ring_.next(e),
                   [] { return "neighbours without a turn are not edges in a row"; });
    } else {
      report.check(slots_.holds(edge.certificate, claim(e, edge.after, edge.turn), e),
                   [e] { return "a wrong certificate of the edge of " + std::to_string(e); });
      report.check(!slots_.is_tie(edge.certificate) || e < edge.after, [e] {
        return "the edge of " + std::to_string(e) + " is before one of a smaller tail";
      });
    }
    e = edge.after;
  } while (e != cycle[0] && length <= cycle.size());
  report.check(length == cycle.size(), [] { return "the list of directions lacks an edge"; });
  report.check(modulo(turns + 1) == 0, [] { return "the turns do not add up"; });
  // rot_k(e) touches the tail of the first edge at or after it.
  for (const ObjectId edge : cycle) {
    std::vector<std::vector<ObjectId>> by_turn(static_cast<std::size_t>(folds_));
    int turn = 0;
    for (ObjectId f = edge; (turn += state_[f].turn, f = state_[f].after) != edge;) {
      by_turn[static_cast<std::size_t>(modulo(turn))].push_back(f);
    }
    ObjectId expected = edge;
    for (int k = folds_ - 1; k > 0; --k) {
      const auto& there = by_turn[static_cast<std::size_t>(k)];
      if (!there.empty()) expected = there.front();
      report.check(contact(edge, k) == expected,
                   [edge] { return "a wrong contact of the edge of " + std::to_string(edge); });
    }
  }
}

std::size_t Calipers::bytes() const {
  return ring_.bytes() + state_.capacity() * sizeof(Edge) + ties_.bytes() + dots_.bytes() +
         changes_.capacity() * sizeof(ObjectId);
}

}  // namespace kinex
