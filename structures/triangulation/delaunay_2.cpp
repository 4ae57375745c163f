// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/delaunay_2.h"

#include <algorithm>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

Delaunay2::Delaunay2(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      exact_(kernel.is_exact()),
      order_{kernel.bind(make_coordinate_order(0)), kernel.bind(make_coordinate_order(1))},
      orientation_(kernel.bind(make_orientation_2())),
      in_circle_(kernel.bind(make_in_circle_2())),
      obtuse_(kernel.bind(make_obtuse_angle_2())),
      edges_(kernel, id, "edges"),
      store_(scene.objects.size()),
      points_(scene.objects.size()),
      line_(kernel, id, "line", AlongLine{order_[0]}) {}

std::vector<std::string_view> Delaunay2::event_kinds() const {
  return common_event_kinds({"flip", "enter", "leave", "pass", "blocked", "reinsert"});
}

void Delaunay2::give_up(const std::string& what) {
  if (corrupt_) return;
  corrupt_ = true;
  kernel_->corrupt(id_, what);
}

bool Delaunay2::upright(ObjectId a, ObjectId b, ObjectId c) const {
  const ObjectId infinity = store_.infinity();
  if (a == infinity || b == infinity || c == infinity) return true;
  return turn(a, b, c) == Sign::kPositive;
}

bool Delaunay2::upright(Triangle t) const {
  return upright(store_.origin(3 * t), store_.origin(3 * t + 1), store_.origin(3 * t + 2));
}

// ---- certificates

Query Delaunay2::query_of(HalfEdge h) const {
  const HalfEdge g = store_.twin(h);
  const ObjectId u = store_.origin(h), v = store_.origin(g);
  const ObjectId p = store_.apex(h), q = store_.apex(g);
  const ObjectId infinity = store_.infinity();
  if (std::max(std::max(u, v), std::max(p, q)) < infinity) return Query::of(in_circle_, v, u, p, q);
  if (p == infinity) return Query::of(orientation_, v, u, q);
  if (q == infinity) return Query::of(orientation_, u, v, p);
  if (u == infinity) return Query::of(orientation_, p, v, q);
  return Query::of(orientation_, q, u, p);
}

void Delaunay2::set_certificate(HalfEdge h) {
  if (corrupt_) return;
  const Query query = query_of(h);
  if (!exact_ && repeats_an_object(query)) {
    return give_up("two triangles on the same three points");
  }
  CertificateId slot = store_.label(h);
  const bool fresh = slot == kNoCertificate;
  const Outlook outlook = edges_.set(slot, query, h);
  if (fresh) store_.set_label(h, slot);
  note_outlook(h, outlook);
}

// That a vertex of the hull is between its two neighbours, where all three are identically collinear.
Query Delaunay2::straight_query_of(HalfEdge h) const {
  Query query = query_of(h);
  query.predicate = obtuse_;
  return query;
}

bool Delaunay2::is_straight(HalfEdge h) const {
  return at_infinity(h) && kernel_->query(store_.label(h)).predicate == obtuse_;
}

void Delaunay2::set_straight(HalfEdge h) {
  straight_ = true;
  CertificateId slot = store_.label(h);
  const Outlook outlook = edges_.set(slot, straight_query_of(h), h);
  fails_now_ = fails_now_ || outlook == Outlook::kFailsNow;
}

// New motions may have made the turn at a hull vertex identically zero, or ended that.
void Delaunay2::follow_turn(HalfEdge h) {
  if (!at_infinity(h) || store_.label(h) == kNoCertificate) return;
  if (is_straight(h) != (kernel_->sign_after(query_of(h)) == Sign::kZero)) set_certificate(h);
}

void Delaunay2::note_outlook(HalfEdge h, Outlook outlook) {
  if (outlook == Outlook::kIdenticallyZero) return at_infinity(h) ? set_straight(h) : ties_.note(h);
  fails_now_ = fails_now_ || outlook == Outlook::kFailsNow;
}

// set_certificate for each of four edges, in this order.
void Delaunay2::set_certificates(const std::array<HalfEdge, 4>& edges) {
  Kernel::Group& group = renewed_;
  group.size = 0;
  bool together = !corrupt_;
  for (const HalfEdge h : edges) {
    const CertificateId label = store_.label(h);
    const Query& query = group.queries[group.size] = query_of(h);
    // What may change anything but the certificates is done one by one.
    together = together && label != kNoCertificate && (exact_ || !repeats_an_object(query));
    group.ids[group.size] = label;
    group.tags[group.size++] = h;
  }
  if (!together) {
    for (const HalfEdge h : edges) set_certificate(h);
    return;
  }
  edges_.set(group);
  for (std::size_t i = 0; i < edges.size(); ++i) note_outlook(edges[i], group.outlooks[i]);
}

void Delaunay2::drop_certificate(HalfEdge h) {
  CertificateId slot = store_.label(h);
  if (!corrupt_) edges_.drop(slot);
  store_.set_label(h, kNoCertificate);
}

// ---- flips

// False if the edge between the opposite vertices exists already (seen from an end of degree
// three).
bool Delaunay2::flippable(HalfEdge h) const {
  const HalfEdge g = store_.twin(h);
  const ObjectId p = store_.apex(h), q = store_.apex(g);
  return p != q && store_.apex(store_.twin(Triangulation2::previous(h))) != q &&
         store_.apex(store_.twin(Triangulation2::next(h))) != q;
}

void Delaunay2::flip(HalfEdge h) {
  const HalfEdge d = store_.flip(h);
  const HalfEdge e = store_.twin(d);
  set_certificate(d);  // first: the arithmetic reuses the polynomial of the failure
  const std::uint64_t zeros = kernel_->possible_zeros();
  set_certificates({Triangulation2::next(d), Triangulation2::previous(d), Triangulation2::next(e),
                    Triangulation2::previous(e)});
  rim_is_zero_ = kernel_->possible_zeros() != zeros && rim_vanishes(d);
}

// A rim certificate of the edge h that was flipped last is zero at the present instant. What an
// arithmetic suspects is decided here, so that every exact one settles the same instants; an
// inexact one stays with its suspicion.
bool Delaunay2::rim_vanishes(HalfEdge h) {
  if (!kernel_->tells_sign_now()) return true;
  for (const HalfEdge side : {h, store_.twin(h)}) {
    for (const HalfEdge rim : {Triangulation2::next(side), Triangulation2::previous(side)}) {
      if (kernel_->sign(query_of(rim), When::kNow) == Sign::kZero) return true;
    }
  }
  return false;
}

// The edge's four points are identically cocircular and the smallest id is not on the edge.
bool Delaunay2::wants_other_diagonal(HalfEdge h) const {
  if (!edges_.is_tie(store_.label(h))) return false;
  const HalfEdge g = store_.twin(h);
  const ObjectId u = store_.origin(h), v = store_.origin(g);
  const ObjectId p = store_.apex(h), q = store_.apex(g);
  if (std::max(std::max(u, v), std::max(p, q)) >= store_.infinity()) return false;
  return std::min(p, q) < std::min(u, v);
}

// Turns identically cocircular points into fans. Each flip raises the degree of the smallest of its
// four points, and no later flip lowers it, so k cocircular points need O(k^2) flips.
void Delaunay2::settle_ties(bool report) {
  std::uint64_t left = 64 + 4 * static_cast<std::uint64_t>(store_.triangles()) * store_.triangles();
  ties_.settle([&](HalfEdge h) {
    if (corrupt_ || !store_.live(Triangulation2::triangle(h)) || !wants_other_diagonal(h)) return;
    const HalfEdge g = store_.twin(h);
    const ObjectId u = store_.origin(h), v = store_.origin(g);
    const ObjectId p = store_.apex(h), q = store_.apex(g);
    if (!flippable(h) || !upright(p, u, q) || !upright(q, v, p)) {
      for (const ObjectId w : {u, v, p, q}) suspect(w);  // flat or turned over: see instant_settled
      return;
    }
    if (left-- == 0) return give_up("cocircular points without end");
    flip(h);
    ++tie_flips_;
    if (report) report_flip(u, v, p, q, true);
  });
}

// The edge u v has been replaced by p q. During a degenerate instant an edge may exist twice, and
// other changes may not be reported yet: this one is then reported with them.
void Delaunay2::report_flip(ObjectId u, ObjectId v, ObjectId p, ObjectId q, bool degenerate) {
  const ObjectId infinity = store_.infinity();
  const bool goes = u != infinity && v != infinity, comes = p != infinity && q != infinity;
  const bool later = untold_.size() > 0 || (degenerate && goes && edges_between(u, v) > 0) ||
                     (degenerate && comes && edges_between(p, q) > 1);
  if (later) {
    if (goes) untold_.gone({u, v});
    if (comes) untold_.came({p, q});
    kernel_->settle_later(id_);
  }
  const std::array<ObjectId, 2> old{std::min(u, v), std::max(u, v)};
  const std::array<ObjectId, 2> fresh{std::min(p, q), std::max(p, q)};
  if (!goes) {
    kernel_->report(id_, kLeave, {old[0], fresh[0], fresh[1]}, !later);
  } else if (!comes) {
    kernel_->report(id_, kEnter, {fresh[0], old[0], old[1]}, !later);
  } else {
    kernel_->report(id_, kFlip, {old[0], old[1], fresh[0], fresh[1]}, !later);
  }
}

int Delaunay2::edges_between(ObjectId a, ObjectId b) const {
  int edges = 0;
  const HalfEdge first = store_.out(a);
  HalfEdge h = first;
  do {
    edges += store_.target(h) == b ? 1 : 0;
    h = store_.around(h);
  } while (h != first);
  return edges;
}

// Large triangulations: what the next failures will visit is brought near while this one is handled.
// (An empty asm statement keeps compilers from dropping the call: prefetches are no effect to them.)
void Delaunay2::prefetch_next() const {
  asm volatile("");
  for (std::size_t i = 1; i <= 4; ++i) {
    const CertificateId later = kernel_->upcoming(id_, i);
    if (later != kNoCertificate) store_.prefetch(kernel_->tag(later));
  }
  const CertificateId first = kernel_->upcoming(id_, 0);
  if (first == kNoCertificate) return;
  const HalfEdge next = kernel_->tag(first);
  if (!store_.live(Triangulation2::triangle(next))) return;
  const HalfEdge twin = store_.twin(next);
  prefetch_points({store_.origin(next), store_.origin(twin), store_.apex(next), store_.apex(twin)});
  for (const HalfEdge h : {next, twin}) {
    for (const HalfEdge side : {Triangulation2::next(h), Triangulation2::previous(h)}) {
      kernel_->prefetch(store_.label(side));
      store_.prefetch(store_.twin(side));
    }
  }
}

// The points on the other side of the rim of the flip that comes now, and what its certificates are
// queued beside.
void Delaunay2::prefetch_rim(HalfEdge h) const {
  const HalfEdge g = store_.twin(h);
  for (const HalfEdge side : {h, g}) {
    kernel_->prefetch_neighbours(store_.label(Triangulation2::next(side)));
    kernel_->prefetch_neighbours(store_.label(Triangulation2::previous(side)));
  }
  prefetch_points({store_.apex(store_.twin(Triangulation2::next(h))),
                   store_.apex(store_.twin(Triangulation2::previous(h))),
                   store_.apex(store_.twin(Triangulation2::next(g))),
                   store_.apex(store_.twin(Triangulation2::previous(g)))});
}

void Delaunay2::prefetch_points(std::array<ObjectId, 4> points) const {
  for (ObjectId& point : points) {
    if (point == store_.infinity()) point = 0;
    store_.prefetch_point(point);
  }
  kernel_->prefetch(id_, points);
}

void Delaunay2::certificate_failed(CertificateId failed) {
  if (corrupt_) return;
  if (on_line_) return pass(failed);
  const HalfEdge h = edges_.failed(failed);
  prefetch_rim(h);
  prefetch_next();
  if (is_straight(h)) {  // two points of the hull meet
    kernel_->settle_later(id_);
    return blocked(h, true);
  }
  const bool shared = kernel_->instant_is_shared(id_);
  const HalfEdge g = store_.twin(h);
  const ObjectId u = store_.origin(h), v = store_.origin(g);
  const ObjectId p = store_.apex(h), q = store_.apex(g);
  if (!flippable(h)) return blocked(h, shared);
  if (shared) {
    if (has_last_quad_) suspects_.insert(suspects_.end(), last_quad_.begin(), last_quad_.end());
    has_last_quad_ = false;
    for (const ObjectId w : {u, v, p, q}) suspect(w);
    const bool there = store_.adjacent(std::min(p, q), std::max(p, q));
    if (there || !upright(p, u, q) || !upright(q, v, p)) return blocked(h, true);
  } else {
    last_quad_ = {u, v, p, q};
    has_last_quad_ = true;
    retries_ = repairs_ = 0;
  }
  fails_now_ = false;
  flip(h);
  if (corrupt_) return;
  if (rim_is_zero_ && !shared) {
    for (const ObjectId w : {u, v, p, q}) suspect(w);
    kernel_->settle_later(id_);
  }
  report_flip(u, v, p, q, shared || fails_now_ || rim_is_zero_);
  if (!ties_.empty()) settle_ties(true);
}

// A failure that no flip can repair. At a degenerate instant the edge goes without a certificate
// until the instant is settled.
void Delaunay2::blocked(HalfEdge h, bool shared) {
  if (!shared && !exact_) return give_up("a flip to an edge that is there already");
  const HalfEdge g = store_.twin(h);
  std::array<ObjectId, 4> ids{store_.origin(h), store_.origin(g), store_.apex(h), store_.apex(g)};
  std::sort(ids.begin(), ids.end());
  for (const ObjectId v : ids) suspect(v);
  drop_certificate(h);
  blocked_ = true;
  if (ids[3] == store_.infinity()) {
    kernel_->report(id_, kBlocked, {ids[0], ids[1], ids[2]}, false);
  } else {
    kernel_->report(id_, kBlocked, {ids[0], ids[1], ids[2], ids[3]}, false);
  }
  if (!shared) rebuild_because("a flip to an edge that is there already");
}

// On a line: two neighbours change places.
void Delaunay2::pass(CertificateId failed) {
  const bool later = untold_.size() > 0;  // reported with earlier changes
  const Attribute before = later ? attribute() : Attribute{};
  const auto swap = line_.failed(failed);
  if (later) untold_.add(difference_between(before, attribute()));
  const auto [a, b] = std::minmax(swap.before, swap.after);
  kernel_->report(id_, kPass, {a, b}, line_.size() > 2 && !later);
}

// ---- the attribute

// Sorted by counting, since viewers read it after every event: O(n), and a sort of the few larger
// neighbours of each vertex. Each edge is once a half-edge from its smaller to its larger end.
Attribute Delaunay2::attribute() const {
  Attribute result;
  result.shape = Attribute::Shape::kTuples;
  if (on_line_) {
    std::vector<std::pair<ObjectId, ObjectId>> edges;
    line_.each_link([&](ObjectId a, ObjectId b, CertificateId) {
      edges.emplace_back(std::min(a, b), std::max(a, b));
    });
    std::sort(edges.begin(), edges.end());
    for (const auto& [a, b] : edges) result.ids.insert(result.ids.end(), {a, b});
    return result;
  }
  const ObjectId infinity = store_.infinity();
  // Of its two half-edges an edge has the one that begins at the smaller id. Which one that is cannot be
  // foretold: it is written in any case, and counted without a branch.
  std::vector<std::pair<ObjectId, ObjectId>> edges(3 * store_.triangle_capacity() + 1);
  std::size_t count = 0;
  const auto take = [&](ObjectId a, ObjectId b) {
    edges[count] = {a, b};
    count += static_cast<std::size_t>(a < b) & static_cast<std::size_t>(b != infinity);
  };
  for (Triangulation2::Triangle t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t)) continue;
    const ObjectId a = store_.origin(3 * t), b = store_.origin(3 * t + 1);
    const ObjectId c = store_.origin(3 * t + 2);
    take(a, b);
    take(b, c);
    take(c, a);
  }
  // By the larger id, then by the smaller one: two passes that keep the order of equals.
  std::vector<std::pair<ObjectId, ObjectId>> sorted(count);
  const auto sort_by = [&](const auto& from, auto& to, const auto& key) {
    std::vector<std::uint32_t> place(infinity + std::size_t{1}, 0);
    for (std::size_t i = 0; i < count; ++i) ++place[key(from[i]) + 1];
    for (std::size_t v = 1; v < place.size(); ++v) place[v] += place[v - 1];
    for (std::size_t i = 0; i < count; ++i) to[place[key(from[i])]++] = from[i];
  };
  sort_by(edges, sorted, [](const auto& edge) { return edge.second; });
  sort_by(sorted, edges, [](const auto& edge) { return edge.first; });
  result.ids.resize(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    result.ids[2 * i] = edges[i].first;
    result.ids[2 * i + 1] = edges[i].second;
  }
  return result;
}

std::vector<ObjectId> Delaunay2::hull() const {
  if (on_line_) return line_.items();
  std::vector<ObjectId> hull;
  const HalfEdge first = store_.out(store_.infinity());
  HalfEdge h = first;
  do {  // counter-clockwise around infinity is clockwise around the hull
    hull.push_back(store_.target(h));
    h = store_.around(h);
  } while (h != first);
  std::reverse(hull.begin(), hull.end());
  std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end()), hull.end());
  return hull;
}

std::vector<ObjectId> Delaunay2::around(ObjectId vertex) const {
  std::vector<ObjectId> result;
  if (on_line_) {
    if (!points_.is_vertex(vertex)) return result;
    for (const ObjectId beside : {line_.previous(vertex), line_.next(vertex)}) {
      if (beside != kNoObject) result.push_back(beside);
    }
  } else if (store_.has(vertex)) {
    const HalfEdge first = store_.out(vertex);
    HalfEdge h = first;
    do {
      if (store_.target(h) != store_.infinity()) result.push_back(store_.target(h));
      h = store_.around(h);
    } while (h != first);
  }
  return result;
}

std::vector<ObjectId> Delaunay2::neighbours(ObjectId vertex) const {
  std::vector<ObjectId> result = around(vertex);
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t Delaunay2::bytes() const {
  const std::size_t words = suspects_.capacity() + moved_.capacity() + mark_.capacity() +
                            cavity_.capacity() + filled_.capacity() + rim_.capacity() +
                            link_.capacity();
  return sizeof(*this) + store_.bytes() + points_.bytes() + line_.bytes() + ties_.bytes() +
         untold_.bytes() + words * sizeof(std::uint32_t);
}

}  // namespace kinex
