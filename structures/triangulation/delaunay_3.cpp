// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/delaunay_3.h"

#include <algorithm>

#include "structures/parts/sort_unique.h"

namespace kinex {

Delaunay3::Delaunay3(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      geometry_(kernel, static_cast<ObjectId>(scene.objects.size())),
      facets_(kernel, id, "facets"),
      store_(scene.objects.size()),
      patch_(scene.objects.size()),
      points_(scene.objects.size()) {
  static_assert(kNoCertificate == Triangulation3::kNone);
}

std::vector<std::string_view> Delaunay3::event_kinds() const {
  return common_event_kinds(
      {"flip_2_3", "flip_3_2", "enter", "leave", "hull_2_3", "hull_3_2", "retile", "blocked"});
}

void Delaunay3::give_up(const std::string& what) {
  if (corrupt_) return;
  corrupt_ = true;
  kernel_->corrupt(id_, what);
}

// ---- certificates

void Delaunay3::set_certificate(Facet f) {
  if (corrupt_) return;
  CertificateId slot = store_.label(f);
  const Outlook outlook = facets_.set(slot, claim_of(f), f);
  store_.set_label(f, slot);
  note_outlook(f, outlook);
}

// set_certificate for each of several facets, in this order.
void Delaunay3::set_certificates(std::span<const Facet> facets) {
  Kernel::Group group;
  while (!facets.empty() && !corrupt_) {
    group.size = 0;
    while (group.size < std::min(facets.size(), Kernel::Group::kMost)) {
      const Facet f = facets[group.size];
      if (store_.label(f) == kNoCertificate) break;
      group.ids[group.size] = store_.label(f);
      group.queries[group.size] = claim_of(f);
      group.tags[group.size++] = f;
    }
    if (group.size == 0) {
      set_certificate(facets.front());
      facets = facets.subspan(1);
      continue;
    }
    facets_.set(group);
    for (std::size_t i = 0; i < group.size; ++i) note_outlook(facets[i], group.outlooks[i]);
    facets = facets.subspan(group.size);
  }
}

// A tie that is not as it should be is mended when the instant is settled.
void Delaunay3::note_outlook(Facet f, Outlook outlook) {
  if (outlook != Outlook::kIdenticallyZero || !is_bad(f)) return;
  suspect_all(points_of(f));
  kernel_->settle_later(id_);
}

void Delaunay3::drop_certificate(Facet f) {
  CertificateId slot = store_.label(f);
  if (!corrupt_) facets_.drop(slot);
  store_.set_label(f, kNoCertificate);
}

std::array<ObjectId, 5> Delaunay3::points_of(Facet f) const {
  const Quad q = store_.quad(Triangulation3::cell(f));
  return {q[0], q[1], q[2], q[3], store_.apex(store_.mate(f))};
}

// ---- flips

// The new cells are upright right after now, and what they share is not there yet.
bool Delaunay3::allowed(Facet f, const Triangulation3::Around& around) const {
  if (around.cells > 3) return false;
  const Cell c = Triangulation3::cell(f);
  const Quad old = store_.quad(c);
  const ObjectId p = store_.apex(f), q = store_.apex(store_.mate(f)), infinity = store_.infinity();
  for (unsigned k = 0; k < 4; ++k) {
    const bool changes = around.cells == 2 ? k != f % 4 : k != f % 4 && k != around.edge % 4;
    if (!changes) continue;
    Quad quad = old;
    quad[k] = q;
    if (!geometry_.upright(quad)) return false;
  }
  if (around.cells == 2) {
    return p == infinity ? !store_.adjacent(q, p) : !store_.adjacent(p, q);
  }
  const ObjectId y = store_.apex(around.edge);
  return p == infinity ? !store_.has_facet(q, p, y) : !store_.has_facet(p, q, y);
}

void Delaunay3::flip_2_3(Facet f) {
  const ObjectId infinity = store_.infinity();
  ObjectId p = store_.apex(f), q = store_.apex(store_.mate(f));
  if (p > q) std::swap(p, q);
  const Triangulation3::Triple t = store_.triple(f);
  std::array<Facet, 9> fresh;
  store_.flip_2_3(f, fresh);
  // First of all: the arithmetic reuses the polynomial of the failure.
  for (std::size_t i = 0; i < 3; ++i) set_certificate(fresh[i]);
  const std::uint64_t zeros = kernel_->possible_zeros();
  const std::span<const Facet> rim = std::span(fresh).subspan(3);
  set_certificates(rim);
  after_flip(rim, zeros);
  if (q == infinity) {
    kernel_->report(id_, kEnter, {p, t[0], t[1], t[2]}, true);
  } else if (t[2] == infinity) {
    kernel_->report(id_, kHull23, {p, q, t[0], t[1]}, true);
  } else {
    kernel_->report(id_, kFlip23, {p, q, t[0], t[1], t[2]}, true);
  }
}

void Delaunay3::flip_3_2(Facet f, Facet out) {
  const ObjectId infinity = store_.infinity();
  Triangulation3::Triple t{store_.apex(f), store_.apex(out), store_.apex(store_.mate(f))};
  std::sort(t.begin(), t.end());
  ObjectId u = kNoObject, v = kNoObject;  // the edge
  for (const ObjectId w : store_.triple(f)) {
    if (w != store_.apex(out)) (u == kNoObject ? u : v) = w;
  }
  std::array<Facet, 7> fresh;
  std::array<CertificateId, 2> gone;
  store_.flip_3_2(f, out, fresh, gone);
  set_certificate(fresh[0]);
  if (!corrupt_) {
    for (CertificateId& slot : gone) facets_.drop(slot);
  }
  const std::uint64_t zeros = kernel_->possible_zeros();
  const std::span<const Facet> rim = std::span(fresh).subspan(1);
  set_certificates(rim);
  after_flip(rim, zeros);
  if (v == infinity) {
    kernel_->report(id_, kLeave, {u, t[0], t[1], t[2]}, true);
  } else if (t[2] == infinity) {
    kernel_->report(id_, kHull32, {u, v, t[0], t[1]}, true);
  } else {
    kernel_->report(id_, kFlip32, {u, v, t[0], t[1], t[2]}, true);
  }
}

// A certificate around the flip may be zero at the present instant, without a change of sign. What an
// arithmetic suspects is decided here, so that every exact one settles the same instants; an inexact
// one stays with its suspicion.
void Delaunay3::after_flip(std::span<const Facet> rim, std::uint64_t zeros) {
  if (corrupt_ || kernel_->possible_zeros() == zeros || !rim_vanishes(rim)) return;
  for (const Facet f : rim) suspect_all(points_of(f));
  kernel_->settle_later(id_);
}

bool Delaunay3::rim_vanishes(std::span<const Facet> rim) const {
  if (!kernel_->tells_sign_now()) return true;
  return std::any_of(rim.begin(), rim.end(), [this](Facet f) {
    return kernel_->sign(claim_of(f), When::kNow) == Sign::kZero;
  });
}

void Delaunay3::certificate_failed(CertificateId failed) {
  if (corrupt_) return;
  const Facet f = facets_.failed(failed);
  const bool shared = kernel_->instant_is_shared(id_);
  const std::array<ObjectId, 5> points = points_of(f);
  if (shared) {
    if (has_last_flip_) suspect_all(last_flip_);
    has_last_flip_ = false;
    suspect_all(points);
  }
  const Triangulation3::Around around = store_.around(f);
  if (!allowed(f, around)) return blocked(f);
  if (!shared) {
    last_flip_ = points;
    has_last_flip_ = true;
  }
  if (around.cells == 2) {
    flip_2_3(f);
  } else {
    flip_3_2(f, around.edge);
  }
}

// No flip is possible yet: the facet goes without a certificate until the instant is settled.
void Delaunay3::blocked(Facet f) {
  std::array<ObjectId, 5> ids = points_of(f);
  std::sort(ids.begin(), ids.end());
  suspect_all(ids);
  drop_certificate(f);
  ++blocks_;
  kernel_->settle_later(id_);
  if (ids[4] == store_.infinity()) {
    kernel_->report(id_, kBlocked, {ids[0], ids[1], ids[2], ids[3]}, false);
  } else {
    kernel_->report(id_, kBlocked, {ids[0], ids[1], ids[2], ids[3], ids[4]}, false);
  }
}

// ---- the attribute

Attribute Delaunay3::attribute() const {
  std::vector<Quad> cells;
  cells.reserve(store_.cells());
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c) || store_.ghost(c)) continue;
    Quad q = store_.quad(c);
    std::sort(q.begin(), q.end());
    cells.push_back(q);
  }
  std::sort(cells.begin(), cells.end());
  Attribute result{Attribute::Shape::kTuples, {}, 4};
  result.ids.reserve(4 * cells.size());
  for (const Quad& q : cells) result.ids.insert(result.ids.end(), q.begin(), q.end());
  return result;
}

std::vector<std::array<ObjectId, 2>> Delaunay3::edges() const {
  std::vector<std::array<ObjectId, 2>> result;
  if (flat_) {
    for (ObjectId a = 0; a < objects(); ++a) {
      if (!points_.is_vertex(a)) continue;
      for (ObjectId b = a + 1; b < objects(); ++b) {
        if (points_.is_vertex(b)) result.push_back({a, b});
      }
    }
    return result;
  }
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c)) continue;
    Quad q = store_.quad(c);
    std::sort(q.begin(), q.end());
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (q[j] != store_.infinity()) result.push_back({q[i], q[j]});
      }
    }
  }
  sort_unique(result);
  return result;
}

std::size_t Delaunay3::bytes() const {
  return sizeof(*this) + store_.bytes() + patch_.bytes() + untold_.bytes() + points_.bytes() +
         (suspects_.capacity() + moved_.capacity() + fresh_.capacity() +
          conflicts_.cells.capacity() + conflicts_.mark.capacity()) *
             sizeof(std::uint32_t) +
         conflicts_.star.capacity() * sizeof(Quad);
}

}  // namespace kinex
