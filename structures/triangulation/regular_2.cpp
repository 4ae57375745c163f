// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/regular_2.h"

#include <algorithm>
#include <utility>

namespace kinex {

Regular2::Regular2(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      geometry_(kernel, scene.extents, static_cast<ObjectId>(scene.objects.size())),
      store_(scene.objects.size()),
      patch_(scene.objects.size()),
      present_(scene.objects.size(), false),
      edges_(kernel, id, "edges"),
      witnesses_(kernel, id, "witnesses"),
      witness_(scene.objects.size()) {
  static_assert(kNoCertificate == Triangulation2::kNone);
}

std::vector<std::string_view> Regular2::event_kinds() const {
  return common_event_kinds(
      {"flip", "enter", "leave", "show", "hide", "witness", "retile", "blocked", "touch"});
}

void Regular2::give_up(const std::string& what) {
  if (corrupt_) return;
  corrupt_ = true;
  kernel_->corrupt(id_, what);
}

// ---- certificates

// A triangle that is identically flat is mended when the instant is settled.
void Regular2::set_certificate(HalfEdge h) {
  if (corrupt_) return;
  const Query query = claim_of(h);
  if (!kernel_->is_exact() && repeats_an_object(query)) {
    return give_up("two triangles on the same three points");
  }
  CertificateId label = store_.label(h);
  Outlook outlook = edges_.set(label, query, h);
  if (outlook == Outlook::kIdenticallyZero) {
    ++ties_;
    outlook = edges_.set(label, tie_claim_of(h), h);
  }
  store_.set_label(h, label);
  if (outlook != Outlook::kIdenticallyZero) return;
  suspect_all(points_of(h));
  kernel_->settle_later(id_);
}

// New motions of v: which of its claims are identically zero may have changed.
void Regular2::renew_about(ObjectId v) {
  if (!store_.has(v)) return;
  const HalfEdge first = store_.out(v);
  HalfEdge h = first;
  do {
    for (const HalfEdge side : {h, Triangulation2::next(h)}) {
      const CertificateId label = store_.label(side);
      if (corrupt_ || label == kNoCertificate) continue;
      const HalfEdge f = kernel_->tag(label);
      if (edges_.is_tie(label) || !kernel_->claims(label, claim_of(f))) set_certificate(f);
    }
    h = store_.around(h);
  } while (h != first);
}

void Regular2::drop_certificate(HalfEdge h) {
  CertificateId label = store_.label(h);
  if (!corrupt_) edges_.drop(label);
  store_.set_label(h, kNoCertificate);
}

std::array<ObjectId, 4> Regular2::points_of(HalfEdge h) const {
  return {store_.origin(h), store_.target(h), store_.apex(h), store_.apex(store_.twin(h))};
}

// ---- flips

// The edge between the apices is not there yet, and both new triangles are upright right after now.
bool Regular2::flippable(HalfEdge h) const {
  const auto [u, v, p, q] = points_of(h);
  if (p == q || store_.adjacent(std::min(p, q), std::max(p, q))) return false;
  return geometry_.upright({p, u, q}) && geometry_.upright({q, v, p});
}

bool Regular2::has_degree_3(ObjectId v) const {
  const HalfEdge h = store_.out(v);
  return store_.around(store_.around(store_.around(h))) == h;
}

// Three triangles around it make one, which is upright and not there on the other side.
bool Regular2::can_hide(ObjectId v) const {
  if (v == store_.infinity() || !has_degree_3(v) || store_.vertices() <= 3) return false;
  const HalfEdge h = store_.out(v);
  const ObjectId a = store_.target(h), b = store_.target(store_.around(h));
  const ObjectId c = store_.target(store_.around(store_.around(h)));
  return a != b && b != c && c != a && geometry_.upright({a, b, c});
}

void Regular2::flip(HalfEdge h) {
  auto [u, v, p, q] = points_of(h);
  const HalfEdge d = store_.flip(h), e = store_.twin(d);
  set_certificate(d);  // first: the arithmetic reuses the polynomial of the failure
  const std::uint64_t zeros = kernel_->possible_zeros();
  const std::array<HalfEdge, 4> rim{Triangulation2::next(d), Triangulation2::previous(d),
                                    Triangulation2::next(e), Triangulation2::previous(e)};
  for (const HalfEdge side : rim) set_certificate(side);
  after_change(rim, zeros);
  if (corrupt_) return;
  if (u > v) std::swap(u, v);
  if (p > q) std::swap(p, q);
  if (v == store_.infinity()) {
    kernel_->report(id_, kLeave, {u, p, q}, true);
  } else if (q == store_.infinity()) {
    kernel_->report(id_, kEnter, {p, u, v}, true);
  } else {
    kernel_->report(id_, kFlip, {u, v, p, q}, true);
  }
}

// The vertex of degree 3 sinks below the triangle of its neighbours, which may be a ghost. The three
// edges claimed the same; the certificate of its new witness is their negation.
void Regular2::hide(ObjectId v) {
  store_.link(v, link_);
  const HalfEdge first = link_[0];
  std::array<ObjectId, 3> corners{store_.origin(first), store_.origin(link_[1]),
                                  store_.origin(link_[2])};
  std::array<CertificateId, 3> gone{};
  for (std::size_t i = 0; i < 3; ++i) gone[i] = store_.label(Triangulation2::next(link_[i]));
  const std::array<Triangulation2::Ear, 1> ear{{{0, 1, 2}}};
  store_.fill(v, {ear.begin(), ear.end()}, filled_);
  const Triangle t = filled_[0];
  hint_ = t;
  Triangle below = t;
  std::sort(corners.begin(), corners.end());
  const bool at_hull = corners[2] == store_.infinity();
  if (at_hull) below = locate(geometry_, store_, v, t);
  if (below != kNone && !store_.ghost(below) && geometry_.conflict(store_, below, v)) below = kNone;
  if (below != kNone && !store_.ghost(below)) {
    set_witness(v, below);
  } else {
    wait(v);
  }
  for (CertificateId label : gone) {
    if (!corrupt_) edges_.drop(label);
  }
  const std::uint64_t zeros = kernel_->possible_zeros();
  const std::array<HalfEdge, 3> rim{3 * t, 3 * t + 1, 3 * t + 2};
  for (const HalfEdge side : rim) set_certificate(side);
  after_change(rim, zeros);
  if (corrupt_) return;
  if (at_hull) {
    kernel_->report(id_, kHide, {v, corners[0], corners[1]}, true);
  } else {
    kernel_->report(id_, kHide, {v, corners[0], corners[1], corners[2]}, true);
  }
}

// A certificate around the change may be zero at the present instant, without a change of sign. What
// an arithmetic suspects is decided here, so that every exact one settles the same instants; an
// inexact one stays with its suspicion.
template <class Rim>
void Regular2::after_change(const Rim& rim, std::uint64_t zeros) {
  if (corrupt_ || kernel_->possible_zeros() == zeros) return;
  const bool vanishes =
      !kernel_->tells_sign_now() || std::any_of(rim.begin(), rim.end(), [this](HalfEdge h) {
        return kernel_->sign(claim_of(h), When::kNow) == Sign::kZero;
      });
  if (!vanishes) return;
  for (const HalfEdge h : rim) suspect_all(points_of(h));
  kernel_->settle_later(id_);
}

// The only change at an instant so far is examined if another one follows.
void Regular2::note_change(const std::array<ObjectId, 4>& points) {
  if (kernel_->instant_is_shared(id_)) {
    if (has_last_change_) suspect_all(last_change_);
    has_last_change_ = false;
    suspect_all(points);
  } else {
    last_change_ = points;
    has_last_change_ = true;
  }
}

void Regular2::certificate_failed(CertificateId failed) {
  if (corrupt_) return;
  if (witnesses_.owns(failed)) return witness_failed(witnesses_.failed(failed));
  const HalfEdge h = edges_.failed(failed);
  const std::array<ObjectId, 4> points = points_of(h);
  const bool on_hull = points[2] == store_.infinity() || points[3] == store_.infinity();
  if (on_hull && kernel_->is_exact() && kernel_->sign_after(claim_of(h)) == Sign::kPositive) {
    return touched(h);
  }
  note_change(points);
  ++changes_;
  if (flippable(h)) return flip(h);
  for (const ObjectId v : {std::min(points[0], points[1]), std::max(points[0], points[1])}) {
    if (!can_hide(v)) continue;
    return hide(v);
  }
  blocked(h);
}

// The certificate of a hull edge is zero at now, and positive right after. Where the ends of the edge
// meet the hull may wind around twice from now on.
void Regular2::touched(HalfEdge h) {
  const std::array<ObjectId, 4> points = points_of(h);
  set_certificate(h);
  if (geometry_.equal(points[0], points[1], When::kNow)) {
    suspect_all(points);
    kernel_->settle_later(id_);
  }
  const ObjectId apex = std::min(points[2], points[3]);
  kernel_->report(id_, kTouch,
                  {std::min(points[0], points[1]), std::max(points[0], points[1]), apex}, false);
}

// No flip is possible yet: the edge goes without a certificate until the instant is settled.
void Regular2::blocked(HalfEdge h) {
  std::array<ObjectId, 4> ids = points_of(h);
  std::sort(ids.begin(), ids.end());
  suspect_all(ids);
  drop_certificate(h);
  ++blocks_;
  kernel_->settle_later(id_);
  if (ids[3] == store_.infinity()) {
    kernel_->report(id_, kBlocked, {ids[0], ids[1], ids[2]}, false);
  } else {
    kernel_->report(id_, kBlocked, {ids[0], ids[1], ids[2], ids[3]}, false);
  }
}

// ---- the attribute

Attribute Regular2::attribute() const {
  std::vector<Corners> cells;
  cells.reserve(store_.triangles());
  for (Triangle t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t) || store_.ghost(t)) continue;
    Corners corners = store_.corners(t);
    std::sort(corners.begin(), corners.end());
    cells.push_back(corners);
  }
  std::sort(cells.begin(), cells.end());
  Attribute result{Attribute::Shape::kTuples, {}, 3};
  result.ids.reserve(3 * cells.size());
  for (const Corners& t : cells) result.ids.insert(result.ids.end(), t.begin(), t.end());
  return result;
}

std::vector<ObjectId> Regular2::hidden() const {
  std::vector<ObjectId> result;
  for (ObjectId v = 0; v < present_.size(); ++v) {
    if (present_[v] && !store_.has(v)) result.push_back(v);
  }
  return result;
}

std::vector<std::array<ObjectId, 2>> Regular2::edges() const {
  std::vector<std::array<ObjectId, 2>> result;
  if (flat_) {
    const std::vector<ObjectId> all = hidden();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) result.push_back({all[i], all[j]});
    }
    return result;
  }
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h))) continue;
    const ObjectId a = store_.origin(h), b = store_.target(h);
    if (a < b && b != store_.infinity()) result.push_back({a, b});
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t Regular2::bytes() const {
  return sizeof(*this) + store_.bytes() + patch_.bytes() + untold_.bytes() + witness_ties_.bytes() +
         present_.capacity() / 8 + witness_.capacity() * sizeof(Witness) +
         (suspects_.capacity() + moved_.capacity() + waiting_.capacity() + fresh_.capacity() +
          filled_.capacity() + link_.capacity() + conflicts_.cells.capacity() +
          conflicts_.mark.capacity()) *
             sizeof(std::uint32_t) +
         conflicts_.star.capacity() * sizeof(Corners);
}

}  // namespace kinex
