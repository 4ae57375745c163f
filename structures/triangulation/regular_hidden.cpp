// SPDX-License-Identifier: GPL-3.0-or-later
// RegularTriangulation: hidden points and their witnesses; vertices that hide, and points that show.
#include "structures/parts/sort_unique.h"
#include "structures/triangulation/regular_triangulation.h"

namespace kinex {

template <class Complex>
Query RegularTriangulation<Complex>::witness_query(ObjectId h, std::size_t i) const {
  const Simplex& corners = witness_[h].corners;
  if (i + 1 == kClaims) return this->geometry_.power_claim(corners, h);
  Simplex with = corners;
  with[i] = h;
  return this->geometry_.orientation_claim(with);
}

// Requires that h is in the finite cell, and not in conflict with it.
template <class Complex>
void RegularTriangulation<Complex>::set_witness(ObjectId h, Cell c) {
  Witness& witness = witness_[h];
  witness.corners = Complex::simplex(this->store_, c);
  // The power first: it may be a failed one, negated.
  for (std::size_t n = 0; n < kClaims; ++n) {
    if (this->corrupt_) return;
    const std::size_t i = n == 0 ? kClaims - 1 : n - 1;
    witnesses_.set(witness.certificates[i], witness_query(h, i), h);
  }
}

template <class Complex>
void RegularTriangulation<Complex>::drop_witness(ObjectId h) {
  for (CertificateId& slot : witness_[h].certificates) {
    if (!this->corrupt_) witnesses_.drop(slot);
    slot = kNoCertificate;
  }
  witness_[h].corners.fill(kNoObject);
}

// h goes without a witness until the instant is settled.
template <class Complex>
void RegularTriangulation<Complex>::wait(ObjectId h) {
  drop_witness(h);
  waiting_.push_back(h);
  this->kernel_->settle_later(this->id_);
}

// From a corner of its last witness that is still a vertex.
template <class Complex>
typename RegularTriangulation<Complex>::Cell RegularTriangulation<Complex>::locate_hidden(
    ObjectId h) const {
  Cell from = this->hint();
  for (const ObjectId v : witness_[h].corners) {
    if (v == kNoObject || !this->store_.has(v)) continue;
    from = Complex::cell_of(this->store_, v);
    break;
  }
  return locate<Complex>(this->geometry_, this->store_, h, from).cell;
}

// One failure at an instant: the triangulation of the vertices is right, and h is located in it. Where
// more fails, the triangulation is repaired first.
template <class Complex>
void RegularTriangulation<Complex>::witness_failed(ObjectId h) {
  const bool shared = this->kernel_->instant_is_shared(this->id_);
  const Cell c = shared ? this->kNone : locate_hidden(h);
  const bool conflict = c != this->kNone && shows_in(c, h);
  if (c != this->kNone && !conflict) {
    set_witness(h, c);
  } else if (conflict && show(h, c)) {
    return;
  } else {
    ++waits_;
    wait(h);
  }
  this->kernel_->report(this->id_, kinds_.witness, {h}, false);
}

// Certificates between the new cells. One of them may be a failed one, negated: these are the first.
template <class Complex>
void RegularTriangulation<Complex>::certify_inside() {
  rim_.clear();
  std::vector<Cell> sorted = this->fresh_;
  std::sort(sorted.begin(), sorted.end());
  for (const Cell c : this->fresh_) {
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const Facet g = Complex::mate(this->store_, f);
      if (!std::binary_search(sorted.begin(), sorted.end(), Complex::cell(g))) {
        rim_.push_back(f);
      } else if (f < g) {
        set_certificate(f);
      }
    }
  }
}

template <class Complex>
void RegularTriangulation<Complex>::certify_rim() {
  const std::uint64_t zeros = this->kernel_->possible_zeros();
  for (const Facet f : rim_) set_certificate(f);
  this->after_change(rim_, zeros);
}

// h becomes a vertex in the cell c, which may be a ghost. False, with nothing changed, if it is in
// conflict with others, too, or on a facet.
template <class Complex>
bool RegularTriangulation<Complex>::show(ObjectId h, Cell c) {
  find_conflicts<Complex>(this->geometry_, this->store_, h, c, this->conflicts_);
  if (this->conflicts_.cells.size() != 1) return false;
  for (const Simplex& s : this->conflicts_.star) {
    if (!this->geometry_.upright(s)) return false;
  }
  Points points{};  // h, then the vertices of the cell
  points.front() = h;
  const Simplex old = Complex::simplex(this->store_, c);
  std::copy(old.begin(), old.end(), points.begin() + 1);
  std::sort(points.begin() + 1, points.end());
  if (!this->store_.replace(this->conflicts_.cells, this->conflicts_.star, this->fresh_)) {
    return false;
  }
  this->hint_ = this->fresh_.front();
  ++changes_;
  this->note_change(points);
  certify_inside();
  drop_witness(h);
  certify_rim();
  if (!this->corrupt_) report_change(kinds_.show, points);
  return true;
}

// The facets between the cells at v claimed the same; the certificate of its new witness is their negation.
template <class Complex>
bool RegularTriangulation<Complex>::hide(ObjectId v) {
  if (v == this->store_.infinity() || this->store_.vertices() <= Complex::kCorners) return false;
  std::vector<Cell> star;
  Complex::star(this->store_, v, star);
  if (star.size() != Complex::kCorners) return false;
  const Simplex first = Complex::simplex(this->store_, star[0]);
  std::vector<CertificateId> gone;
  ObjectId other = kNoObject;  // the neighbour that is not in the first cell
  for (const Cell c : star) {
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const Facet g = Complex::mate(this->store_, f);
      const ObjectId apex = this->store_.apex(f);
      if (apex != v && f < g) gone.push_back(this->store_.label(f));
      if (std::find(first.begin(), first.end(), apex) == first.end()) other = apex;
    }
  }
  const Simplex below = this->geometry_.replaced(first, v, other);
  if (other == kNoObject || !this->geometry_.upright(below)) return false;
  if (!this->store_.replace(star, std::span(&below, 1), this->fresh_)) return false;
  Cell c = this->hint_ = this->fresh_.front();
  if (this->store_.ghost(c)) c = locate<Complex>(this->geometry_, this->store_, v, c).cell;
  if (c != this->kNone && !shows_in(c, v)) {
    set_witness(v, c);
  } else {
    wait(v);
  }
  for (CertificateId& slot : gone) {
    if (!this->corrupt_) this->facets_.drop(slot);
  }
  certify_inside();
  certify_rim();
  Points points{};
  points.front() = v;
  std::copy(below.begin(), below.end(), points.begin() + 1);
  std::sort(points.begin() + 1, points.end());
  if (!this->corrupt_) report_change(kinds_.hide, points);
  return true;
}

// What has been sewn: new vertices need no witness, and vertices that are none any more wait for one.
template <class Complex>
void RegularTriangulation<Complex>::filled(const std::vector<Simplex>& old,
                                           const std::vector<Simplex>& filling) {
  for (const Simplex& s : filling) {
    for (const ObjectId v : s) {
      if (v != this->store_.infinity()) drop_witness(v);
    }
  }
  std::vector<ObjectId> vertices;
  for (const Simplex& s : old) vertices.insert(vertices.end(), s.begin(), s.end());
  sort_unique(vertices);
  for (const ObjectId v : vertices) {
    if (v != this->store_.infinity() && present_[v] && !this->store_.has(v)) wait(v);
  }
}

// A point that is neither a vertex nor has a witness becomes the one or gets the other.
template <class Complex>
void RegularTriangulation<Complex>::put_in(ObjectId object) {
  const Cell c = locate_hidden(object);
  if (c == this->kNone) return this->rebuild_because("a point was not found");
  if (!shows_in(c, object)) return set_witness(object, c);
  find_conflicts<Complex>(this->geometry_, this->store_, object, c, this->conflicts_);
  const bool everywhere = this->conflicts_.cells.size() >= Complex::cells(this->store_);
  if (!everywhere && this->fill(this->conflicts_.cells, this->conflicts_.star)) return;
  if (everywhere || !this->sew(this->conflicts_.cells, {{}, {object}})) {
    this->rebuild_because("a point shows at a degenerate instant");
  }
}

// Gives a witness to every hidden point that waits for one, or makes it a vertex, which may hide
// others. Witnesses that hold identically are looked at again after new motions: the ties decide.
template <class Complex>
void RegularTriangulation<Complex>::settle_hidden() {
  witness_ties_.settle([this](ObjectId h) {
    const Witness& witness = witness_[h];
    const bool tied = std::any_of(witness.certificates.begin(), witness.certificates.end(),
                                  [this](CertificateId c) { return witnesses_.is_tie(c); });
    if (tied) wait(h);
  });
  std::vector<ObjectId> round;
  for (std::uint32_t rounds = 0; !waiting_.empty() && !this->corrupt_ && !this->flat_; ++rounds) {
    if (!this->kernel_->is_exact() && rounds > this->kMostSews) {
      return this->give_up("no end of points that hide each other");
    }
    round.swap(waiting_);
    waiting_.clear();
    sort_unique(round);
    for (const ObjectId h : round) {
      if (this->corrupt_ || this->flat_) break;
      const bool settled = !present_[h] || this->store_.has(h) || witness_[h].there();
      if (!settled) put_in(h);
    }
  }
}

// What other files call.
template Query RegularTriangulation<PlaneComplex>::witness_query(ObjectId, std::size_t) const;
template void RegularTriangulation<PlaneComplex>::set_witness(ObjectId, std::uint32_t);
template void RegularTriangulation<PlaneComplex>::drop_witness(ObjectId);
template void RegularTriangulation<PlaneComplex>::witness_failed(ObjectId);
template void RegularTriangulation<PlaneComplex>::wait(ObjectId);
template void RegularTriangulation<PlaneComplex>::put_in(ObjectId);
template bool RegularTriangulation<PlaneComplex>::hide(ObjectId);
template void RegularTriangulation<PlaneComplex>::settle_hidden();
template void RegularTriangulation<PlaneComplex>::filled(
    const std::vector<Triangulation2::Corners>&, const std::vector<Triangulation2::Corners>&);
template Query RegularTriangulation<SpaceComplex>::witness_query(ObjectId, std::size_t) const;
template void RegularTriangulation<SpaceComplex>::set_witness(ObjectId, std::uint32_t);
template void RegularTriangulation<SpaceComplex>::drop_witness(ObjectId);
template void RegularTriangulation<SpaceComplex>::witness_failed(ObjectId);
template void RegularTriangulation<SpaceComplex>::wait(ObjectId);
template void RegularTriangulation<SpaceComplex>::put_in(ObjectId);
template bool RegularTriangulation<SpaceComplex>::hide(ObjectId);
template void RegularTriangulation<SpaceComplex>::settle_hidden();
template void RegularTriangulation<SpaceComplex>::filled(const std::vector<Triangulation3::Quad>&,
                                                         const std::vector<Triangulation3::Quad>&);

}  // namespace kinex
