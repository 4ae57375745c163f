// SPDX-License-Identifier: GPL-3.0-or-later
// SpaceFlips: the flips 2-3 and 3-2 of delaunay_3 and regular_3, those of the hull included. The picture is
// in delaunay_3.h.
#ifndef KINEX_STRUCTURES_TRIANGULATION_SPACE_FLIPS_H
#define KINEX_STRUCTURES_TRIANGULATION_SPACE_FLIPS_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "structures/triangulation/space_complex.h"

namespace kinex {

// Base: a SewnTriangulation of the SpaceComplex.
template <class Base>
class SpaceFlips : public Base {
 public:
  // The ranks of their kinds of events, the first of each structure.
  enum Flip : std::uint8_t { kFlip23, kFlip32, kEnter, kLeave, kHull23, kHull32, kSpaceFlips };

 protected:
  using Base::Base;
  using Facet = Triangulation3::Facet;

  // Makes the flip of the facet and reports it; false, with nothing changed: it is not allowed.
  bool flip(Facet f) {
    const Triangulation3::Around around = this->store_.around(f);
    if (!allowed(f, around)) return false;
    if (around.cells == 2) {
      flip_2_3(f);
    } else {
      flip_3_2(f, around.edge);
    }
    return true;
  }
  // set_certificate for each of several facets, in this order.
  virtual void set_certificates(std::span<const Facet> facets) {
    for (const Facet f : facets) this->set_certificate(f);
  }

 private:
  bool allowed(Facet f, const Triangulation3::Around& around) const;
  void flip_2_3(Facet f);
  void flip_3_2(Facet f, Facet out);
  void renew(std::span<const Facet> rim) {
    const std::uint64_t zeros = this->kernel_->possible_zeros();
    set_certificates(rim);
    this->after_change(rim, zeros);
  }
};

// The new cells are upright right after now, and what they share is not there yet.
template <class Base>
bool SpaceFlips<Base>::allowed(Facet f, const Triangulation3::Around& around) const {
  if (around.cells > 3) return false;
  const Triangulation3& store = this->store_;
  const Triangulation3::Quad old = store.quad(Triangulation3::cell(f));
  const ObjectId p = store.apex(f), q = store.apex(store.mate(f)), infinity = store.infinity();
  for (unsigned k = 0; k < 4; ++k) {
    const bool changes = around.cells == 2 ? k != f % 4 : k != f % 4 && k != around.edge % 4;
    if (!changes) continue;
    Triangulation3::Quad quad = old;
    quad[k] = q;
    if (!this->geometry_.upright(quad)) return false;
  }
  if (around.cells == 2) {
    return p == infinity ? !store.adjacent(q, p) : !store.adjacent(p, q);
  }
  const ObjectId y = store.apex(around.edge);
  return p == infinity ? !store.has_facet(q, p, y) : !store.has_facet(p, q, y);
}

template <class Base>
void SpaceFlips<Base>::flip_2_3(Facet f) {
  const ObjectId infinity = this->store_.infinity();
  ObjectId p = this->store_.apex(f), q = this->store_.apex(this->store_.mate(f));
  if (p > q) std::swap(p, q);
  const Triangulation3::Triple t = this->store_.triple(f);
  std::array<Facet, 9> fresh;
  this->store_.flip_2_3(f, fresh);
  // First of all: the arithmetic reuses the polynomial of the failure.
  for (std::size_t i = 0; i < 3; ++i) this->set_certificate(fresh[i]);
  renew(std::span(fresh).subspan(3));
  if (q == infinity) {
    this->kernel_->report(this->id_, kEnter, {p, t[0], t[1], t[2]}, true);
  } else if (t[2] == infinity) {
    this->kernel_->report(this->id_, kHull23, {p, q, t[0], t[1]}, true);
  } else {
    this->kernel_->report(this->id_, kFlip23, {p, q, t[0], t[1], t[2]}, true);
  }
}

template <class Base>
void SpaceFlips<Base>::flip_3_2(Facet f, Facet out) {
  const ObjectId infinity = this->store_.infinity();
  Triangulation3::Triple t{this->store_.apex(f), this->store_.apex(out),
                           this->store_.apex(this->store_.mate(f))};
  std::sort(t.begin(), t.end());
  ObjectId u = kNoObject, v = kNoObject;  // the edge
  for (const ObjectId w : this->store_.triple(f)) {
    if (w != this->store_.apex(out)) (u == kNoObject ? u : v) = w;
  }
  std::array<Facet, 7> fresh;
  std::array<CertificateId, 2> gone;
  this->store_.flip_3_2(f, out, fresh, gone);
  this->set_certificate(fresh[0]);
  if (!this->corrupt_) {
    for (CertificateId& slot : gone) this->facets_.drop(slot);
  }
  renew(std::span(fresh).subspan(1));
  if (v == infinity) {
    this->kernel_->report(this->id_, kLeave, {u, t[0], t[1], t[2]}, true);
  } else if (t[2] == infinity) {
    this->kernel_->report(this->id_, kHull32, {u, v, t[0], t[1]}, true);
  } else {
    this->kernel_->report(this->id_, kFlip32, {u, v, t[0], t[1], t[2]}, true);
  }
}

}  // namespace kinex

#endif
