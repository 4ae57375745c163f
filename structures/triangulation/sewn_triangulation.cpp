// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/triangulation/sewn_triangulation.h"

#include <algorithm>

#include "structures/parts/merge_sort.h"
#include "structures/parts/sort_unique.h"
#include "structures/triangulation/regular_geometry.h"

namespace kinex {

template <class Geometry>
SewnTriangulation<Geometry>::SewnTriangulation(Kernel& kernel, StructureId id, std::size_t objects,
                                               Geometry geometry, const std::string& part,
                                               Kinds kinds)
    : kernel_(&kernel),
      id_(id),
      geometry_(std::move(geometry)),
      facets_(kernel, id, part),
      store_(objects),
      patch_(objects),
      kinds_(kinds) {
  static_assert(kNoCertificate == kNone);
}

template <class Geometry>
void SewnTriangulation<Geometry>::give_up(const std::string& what) {
  if (corrupt_) return;
  corrupt_ = true;
  kernel_->corrupt(id_, what);
}

// ---- certificates

template <class Geometry>
void SewnTriangulation<Geometry>::drop_certificate(Facet f) {
  CertificateId slot = store_.label(f);
  if (!corrupt_) facets_.drop(slot);
  store_.set_label(f, kNoCertificate);
}

template <class Geometry>
void SewnTriangulation<Geometry>::renew_about(ObjectId v) {
  std::vector<Cell> star;
  Complex::star(store_, v, star);
  for (const Cell c : star) {
    for (Facet side = Complex::kCorners * c; side < Complex::kCorners * (c + 1); ++side) {
      const CertificateId label = store_.label(side);
      if (corrupt_ || label == kNoCertificate) continue;
      const Facet f = kernel_->tag(label);
      if (facets_.is_tie(label) || !kernel_->claims(label, claim_of(f))) set_certificate(f);
    }
  }
}

template <class Geometry>
void SewnTriangulation<Geometry>::drop_all_certificates() {
  for (Cell c = 0; c < Complex::capacity(store_); ++c) {
    if (!store_.live(c)) continue;
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) drop_certificate(f);
  }
}

template <class Geometry>
void SewnTriangulation<Geometry>::certify_everything() {
  for (Cell c = 0; c < Complex::capacity(store_) && !corrupt_; ++c) {
    if (!store_.live(c)) continue;
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      if (f < Complex::mate(store_, f)) set_certificate(f);
    }
  }
}

template <class Geometry>
typename SewnTriangulation<Geometry>::Points SewnTriangulation<Geometry>::points_of(Facet f) const {
  Points points{};
  const Simplex s = Complex::simplex(store_, Complex::cell(f));
  std::copy(s.begin(), s.end(), points.begin());
  points.back() = store_.apex(Complex::mate(store_, f));
  return points;
}

// ---- the present instant

template <class Geometry>
void SewnTriangulation<Geometry>::note_change(const Points& points) {
  if (kernel_->instant_is_shared(id_)) {
    if (has_last_change_) suspect_all(last_change_);
    has_last_change_ = false;
    suspect_all(points);
  } else {
    last_change_ = points;
    has_last_change_ = true;
  }
}

// A certificate around the change may be zero at the present instant, without a change of sign. What
// an arithmetic suspects is decided here, so that every exact one settles the same instants; an
// inexact one stays with its suspicion.
template <class Geometry>
void SewnTriangulation<Geometry>::after_change(std::span<const Facet> rim, std::uint64_t zeros) {
  if (corrupt_ || kernel_->possible_zeros() == zeros) return;
  const bool vanishes =
      !kernel_->tells_sign_now() || std::any_of(rim.begin(), rim.end(), [this](Facet f) {
        return kernel_->sign(claim_of(f), When::kNow) == Sign::kZero;
      });
  if (!vanishes) return;
  for (const Facet f : rim) suspect_all(points_of(f));
  kernel_->settle_later(id_);
}

template <class Geometry>
void SewnTriangulation<Geometry>::blocked(Facet f) {
  Points ids = points_of(f);
  std::sort(ids.begin(), ids.end());
  suspect_all(ids);
  drop_certificate(f);
  ++blocks_;
  kernel_->settle_later(id_);
  report_points(kinds_.blocked, ids, false);
}

// All other points of a finite facet are on one sphere, and cells there may have turned over; those around
// vertices on one line, in the plane at one place, of a facet of the hull may wind twice from now on.
template <class Geometry>
bool SewnTriangulation<Geometry>::touched(Facet f) {
  const Query claim = claim_of(f);
  if (!kernel_->is_exact() || !kernel_->fails_at_touch(claim) ||
      kernel_->sign_after(claim) != Sign::kPositive) {
    return false;
  }
  set_certificate(f);
  Points ids = points_of(f);
  std::sort(ids.begin(), ids.end());
  const bool on_hull = ids.back() == store_.infinity();
  if (on_hull) {  // its vertices, then the point, then infinity
    const ObjectId point = std::min(store_.apex(f), store_.apex(Complex::mate(store_, f)));
    std::stable_partition(ids.begin(), ids.end() - 1, [point](ObjectId v) { return v != point; });
  }
  if (!on_hull || is_degenerate_now(ids)) {
    suspect_all(ids);
    kernel_->settle_later(id_);
  }
  report_points(kinds_.touch, ids, false);
  return true;
}

// The points of a facet of the hull are on one line, in the plane at one place, at now itself.
template <class Geometry>
bool SewnTriangulation<Geometry>::is_degenerate_now(const Points& ids) const {
  if constexpr (Complex::kAxes == 2) {
    return geometry_.equal(ids[0], ids[1], When::kNow);
  } else {
    return geometry_.on_line(ids[0], ids[1], ids[2], When::kNow);
  }
}

// Cells about the suspects that cannot stay.
template <class Geometry>
std::vector<typename SewnTriangulation<Geometry>::Cell> SewnTriangulation<Geometry>::wrong_cells() {
  std::vector<Cell> near, star, wrong;
  for (const ObjectId v : suspects_) {
    Complex::star(store_, v, star);
    near.insert(near.end(), star.begin(), star.end());
  }
  sort_unique(near);
  for (const Cell c : near) {
    kernel_->poll();
    if (!geometry_.upright(Complex::simplex(store_, c))) wrong.push_back(c);
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const CertificateId label = store_.label(f);
      if (label != kNoCertificate && !facets_.is_tie(label)) continue;
      wrong.push_back(c);
      wrong.push_back(Complex::cell(Complex::mate(store_, f)));
    }
  }
  add_cells_at_meetings(wrong);
  sort_unique(wrong);
  add_windings(near, wrong);
  return wrong;
}

// All cells at suspects that are at one place at now itself: such points may pass through each other,
// and cells may turn over twice.
template <class Geometry>
void SewnTriangulation<Geometry>::add_cells_at_meetings(std::vector<Cell>& cells) const {
  if (!kernel_->tells_sign_now()) return;
  std::vector<ObjectId> points;
  for (const ObjectId v : suspects_) {
    if (store_.has(v)) points.push_back(v);
  }
  merge_sort(points, [this](ObjectId a, ObjectId b) {
    for (const PredicateId order : geometry_.orders()) {
      const Sign sign = kernel_->sign(Query(order, {a, b}), When::kNow);
      if (sign != Sign::kZero) return sign == Sign::kPositive;
    }
    return a < b;
  });
  std::vector<Cell> star;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool meets =
        (i > 0 && geometry_.equal(points[i - 1], points[i], When::kNow)) ||
        (i + 1 < points.size() && geometry_.equal(points[i], points[i + 1], When::kNow));
    if (!meets) continue;
    Complex::star(store_, points[i], star);
    cells.insert(cells.end(), star.begin(), star.end());
  }
}

// ---- sewing

// The new cells may fit to those around them, and go round an edge twice with them: all these are then
// sewn, too.
template <class Geometry>
bool SewnTriangulation<Geometry>::sew(std::vector<Cell> cells, const Guests& guests) {
  if (!sew_once(std::move(cells), guests)) return false;
  if constexpr (Complex::kAxes == 3) {
    for (int times = 0;; ++times) {
      std::vector<Cell> wound;
      add_windings(fresh_, wound);
      if (wound.empty()) break;
      if (times == kMostWindings || !sew_once(std::move(wound), {})) return false;
    }
  }
  return true;
}

// False, with nothing changed, if everything would have to be sewn.
template <class Geometry>
bool SewnTriangulation<Geometry>::sew_once(std::vector<Cell> cells, const Guests& guests) {
  std::vector<ObjectId> vertices;
  std::vector<Facet> rim;
  std::vector<Simplex> filling;
  for (;;) {
    kernel_->poll();
    sort_unique(cells);
    if (cells.size() >= Complex::cells(store_)) return false;
    const auto inside = [&cells](Cell c) {
      return std::binary_search(cells.begin(), cells.end(), c);
    };
    vertices = guests.came;
    rim.clear();
    for (const Cell c : cells) {
      for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
        const ObjectId v = store_.apex(f);
        const bool gone = std::find(guests.gone.begin(), guests.gone.end(), v) != guests.gone.end();
        if (v != store_.infinity() && !gone) vertices.push_back(v);
        if (!inside(Complex::cell(Complex::mate(store_, f)))) rim.push_back(f);
      }
    }
    if (rim.empty()) return false;  // all of a part that contradictory signs have cut off
    sort_unique(vertices);
    const StaticResult built = build_patch(vertices);
    if (built == StaticResult::kFailed) return false;
    std::vector<Cell> more;  // join the cells
    if (built == StaticResult::kBuilt) {
      if (!find_patch(rim, vertices, filling, more)) {
        more.clear();
      } else {
        if (more.empty()) Complex::add_twins(store_, cells, rim, filling, more);
        if (more.empty() && fill(cells, filling)) break;
      }
    }
    if (more.empty()) {
      for (const Facet f : rim) more.push_back(Complex::cell(Complex::mate(store_, f)));
    }
    cells.insert(cells.end(), more.begin(), more.end());
  }
  ++sews_;
  largest_sew_ = std::max(largest_sew_, cells.size());
  sewn();
  return true;
}

// The cells of the patch that fill the rim; or those outside of it that stand against it. False if all
// of these do.
template <class Geometry>
bool SewnTriangulation<Geometry>::find_patch(const std::vector<Facet>& rim,
                                             const std::vector<ObjectId>& vertices,
                                             std::vector<Simplex>& filling,
                                             std::vector<Cell>& more) const {
  const typename Complex::FacetIndex index(patch_);
  std::vector<bool> barrier(std::size_t{Complex::kCorners} * Complex::capacity(patch_), false);
  std::vector<bool> taken(Complex::capacity(patch_), false);
  std::vector<Cell> chosen;
  const auto take = [&](Cell c) {
    if (taken[c]) return;
    taken[c] = true;
    chosen.push_back(c);
  };
  const auto outside = [this](Facet f) { return Complex::cell(Complex::mate(store_, f)); };
  std::vector<Facet> found;
  for (const Facet f : rim) {
    const Facet at = index.find(store_, f);
    found.push_back(at);
    if (at == kNone) {
      more.push_back(outside(f));
    } else {
      barrier[at] = barrier[Complex::mate(patch_, at)] = true;
    }
  }
  if (!more.empty()) return true;
  for (const Facet f : found) take(Complex::cell(f));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (unsigned k = 0; k < Complex::kCorners; ++k) {
      const Facet f = Complex::facet(chosen[i], k);
      if (!barrier[f]) take(Complex::cell(Complex::mate(patch_, f)));
    }
  }
  filling.clear();
  std::vector<ObjectId> covered;
  for (const Cell c : chosen) {
    filling.push_back(Complex::simplex(patch_, c));
    covered.insert(covered.end(), filling.back().begin(), filling.back().end());
  }
  sort_unique(covered);
  for (const ObjectId v : vertices) {
    if (patch_.has(v) && !std::binary_search(covered.begin(), covered.end(), v)) return false;
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Simplex inner = Complex::simplex(patch_, Complex::cell(found[i]));
    const ObjectId apex = store_.apex(Complex::mate(store_, rim[i]));
    if (patch_.apex(found[i]) == apex || geometry_.is_bad(inner, Complex::place(found[i]), apex)) {
      more.push_back(outside(rim[i]));
    }
  }
  return true;
}

template <class Geometry>
bool SewnTriangulation<Geometry>::fill(const std::vector<Cell>& cells,
                                       const std::vector<Simplex>& filling) {
  std::vector<CertificateId> inside;
  std::vector<Cell> sorted = cells;
  std::sort(sorted.begin(), sorted.end());
  const auto is_inner = [&sorted](Cell c) {
    return std::binary_search(sorted.begin(), sorted.end(), c);
  };
  std::vector<Simplex> old;
  for (const Cell c : sorted) {
    old.push_back(Complex::simplex(store_, c));
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const Facet g = Complex::mate(store_, f);
      if (f < g && is_inner(Complex::cell(g))) inside.push_back(store_.label(f));
    }
  }
  if (!store_.replace(cells, filling, fresh_)) return false;
  hint_ = fresh_.front();
  if (!corrupt_) {
    for (CertificateId& slot : inside) facets_.drop(slot);
  }
  for (const Simplex& s : old) {
    if (!geometry_.is_ghost(s)) untold_.gone(s);
  }
  for (const Simplex& s : filling) {
    if (!geometry_.is_ghost(s)) untold_.came(s);
  }
  filled(old, filling);
  sorted = fresh_;
  std::sort(sorted.begin(), sorted.end());
  for (const Cell c : fresh_) {
    for (Facet f = Complex::kCorners * c; f < Complex::kCorners * (c + 1); ++f) {
      const Facet g = Complex::mate(store_, f);
      if (f > g && is_inner(Complex::cell(g))) continue;
      set_certificate(f);
    }
  }
  return true;
}

template <class Geometry>
void SewnTriangulation<Geometry>::mend() {
  sort_unique(suspects_);
  const std::vector<Cell> wrong = wrong_cells();
  suspects_.clear();
  if (!wrong.empty()) {
    if (instant_ != kernel_->instant_number()) sews_at_instant_ = 0;
    instant_ = kernel_->instant_number();
    if (!kernel_->is_exact() && ++sews_at_instant_ > kMostSews) {
      return give_up("no end of repairs at one instant");
    }
    if (!sew(wrong, {})) {
      return rebuild_because(Complex::kAxes == 2 ? "a degenerate instant reaches every triangle"
                                                 : "a degenerate instant reaches every cell");
    }
  }
  if (!corrupt_) settle_hull();
}

template <class Geometry>
void SewnTriangulation<Geometry>::instant_settled() {
  if (corrupt_) return;
  sort_unique(moved_);
  if (flat_) {
    if (!moved_.empty()) sort_out_flat();
  } else {
    const std::uint64_t sews = sews_;
    for (const ObjectId v : moved_) {
      if (store_.has(v)) suspect(v);
    }
    mend();
    if (!corrupt_ && !flat_) settle_hidden();
    if (corrupt_) return;
    if (untold_.size() != 0 || sews_ != sews) {
      tell_sewn(untold_.take());
    }
  }
  moved_.clear();
  forget_instant();
}

template <class Geometry>
void SewnTriangulation<Geometry>::tell_sewn(const AttributeDifference& change) {
  kernel_->report(id_, kinds_.retile, {}, !change.gone.empty() || !change.came.empty(), change.gone,
                  change.came);
}

// ---- everything anew

template <class Geometry>
void SewnTriangulation<Geometry>::rebuild() {
  if (corrupt_) return;
  construct();
  untold_.clear();
}

template <class Geometry>
void SewnTriangulation<Geometry>::rebuild_because(const std::string& reason) {
  if (corrupt_) return;
  AttributeDifference change;
  if (comes_or_goes_) {
    construct();
  } else {
    const Attribute before = told();
    construct();
    if (!corrupt_) change = difference_between(before, attribute());
  }
  untold_.clear();
  tell_rebuilt(reason, change);
}

template <class Geometry>
void SewnTriangulation<Geometry>::tell_rebuilt(const std::string& reason,
                                               const AttributeDifference& change) {
  kernel_->count_rebuild(id_, reason, change.gone, change.came);
}

template <class Geometry>
void SewnTriangulation<Geometry>::sort_out_flat() {
  construct();
  if (corrupt_ || flat_) return;
  kernel_->count_rebuild(
      id_,
      Complex::kAxes == 2 ? "points leave their common line" : "points leave their common plane",
      {}, attribute().ids);
}

template <class Geometry>
typename SewnTriangulation<Geometry>::Cell SewnTriangulation<Geometry>::hint() const {
  if (hint_ != kNone && hint_ < Complex::capacity(store_) && store_.live(hint_)) return hint_;
  const ObjectId infinity = store_.infinity();
  // Signs that contradict each other can take away every ghost.
  return store_.has(infinity) ? Complex::cell_of(store_, infinity) : kNone;
}

template <class Geometry>
Attribute SewnTriangulation<Geometry>::attribute() const {
  std::vector<Simplex> cells;
  cells.reserve(Complex::cells(store_));
  for (Cell c = 0; c < Complex::capacity(store_); ++c) {
    if (!store_.live(c) || store_.ghost(c)) continue;
    Simplex s = Complex::simplex(store_, c);
    std::sort(s.begin(), s.end());
    cells.push_back(s);
  }
  std::sort(cells.begin(), cells.end());
  Attribute result{Attribute::Shape::kTuples, {}, Complex::kCorners};
  result.ids.reserve(Complex::kCorners * cells.size());
  for (const Simplex& s : cells) result.ids.insert(result.ids.end(), s.begin(), s.end());
  return result;
}

template <class Geometry>
std::size_t SewnTriangulation<Geometry>::common_bytes() const {
  return store_.bytes() + patch_.bytes() + untold_.bytes() + conflicts_.bytes() +
         (suspects_.capacity() + moved_.capacity() + fresh_.capacity()) * sizeof(std::uint32_t);
}

template class SewnTriangulation<RegularGeometry<PlaneComplex>>;
template class SewnTriangulation<RegularGeometry<SpaceComplex>>;

}  // namespace kinex
