// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: the repair of degenerate instants, as in space (delaunay_3_sew.cpp). Some triangles are
// wrong: S. They are cut out, and the hole is filled with triangles C of the static triangulation R of
// their vertices:
//   1. Every edge on the rim of S must be an edge of R, with a triangle of R on its inner side. Else the
//      triangle outside joins S.
//   2. C: the triangles of R that are reached from there without crossing the rim. Every vertex of R must
//      be in C. Else all triangles across the rim join S.
//   3. No edge on the rim may be in conflict with the triangle outside. Else that triangle joins S.
//   4. No edge inside C may exist outside of it. Else the triangles there join S.
// Vertices of S that R hides are located when all is sewn. What is upright and regular at every edge,
// with a hull that turns once, is the regular triangulation of its vertices, which is unique. It ends,
// because S grows; if S has become everything, the static algorithm builds all of it.
#include <algorithm>
#include <set>
#include <utility>

#include "structures/parts/merge_sort.h"
#include "structures/parts/sort_unique.h"
#include "structures/triangulation/regular_2.h"

namespace kinex {
namespace {

// Adds the triangles outside `cells` at edges that `filling` has inside: these would be there twice.
void add_twin_edges(const Triangulation2& store, const std::vector<Triangulation2::Triangle>& cells,
                    const std::vector<Triangulation2::HalfEdge>& rim,
                    const std::vector<Triangulation2::Corners>& filling,
                    std::vector<Triangulation2::Triangle>& more) {
  std::set<std::pair<ObjectId, ObjectId>> known;
  for (const Triangulation2::HalfEdge h : rim) {
    known.insert(std::minmax(store.origin(h), store.target(h)));
  }
  for (const Triangulation2::Corners& t : filling) {
    for (std::size_t i = 0; i < 3; ++i) {
      const ObjectId a = std::min(t[i], t[(i + 1) % 3]), b = std::max(t[i], t[(i + 1) % 3]);
      if (!known.insert({a, b}).second) continue;
      const Triangulation2::HalfEdge h = store.between(a, b);  // a is finite
      if (h == Triangulation2::kNone) continue;
      for (const Triangulation2::HalfEdge side : {h, store.twin(h)}) {
        const Triangulation2::Triangle there = Triangulation2::triangle(side);
        if (!std::binary_search(cells.begin(), cells.end(), there)) more.push_back(there);
      }
    }
  }
}

}  // namespace

void Regular2::star_of(ObjectId v, std::vector<Triangle>& out) const {
  out.clear();
  if (!store_.has(v)) return;
  const HalfEdge first = store_.out(v);
  HalfEdge h = first;
  do {
    out.push_back(Triangulation2::triangle(h));
    h = store_.around(h);
  } while (h != first);
}

// Triangles about the suspects that cannot stay. `hull`: becomes true if one of them is at the hull.
std::vector<Regular2::Triangle> Regular2::wrong_cells(bool& hull) {
  std::vector<Triangle> near, star, wrong;
  for (const ObjectId v : suspects_) {
    star_of(v, star);
    near.insert(near.end(), star.begin(), star.end());
  }
  sort_unique(near);
  for (const Triangle t : near) {
    kernel_->poll();
    hull = hull || store_.ghost(t);
    if (!geometry_.upright(store_.corners(t))) wrong.push_back(t);
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const CertificateId label = store_.label(h);
      if (label != kNoCertificate && !edges_.is_tie(label)) continue;
      wrong.push_back(t);
      wrong.push_back(Triangulation2::triangle(store_.twin(h)));
    }
  }
  add_cells_at_meetings(wrong);
  sort_unique(wrong);
  return wrong;
}

// All triangles at suspects that are at one place at now itself: such points may pass through each
// other, and triangles may turn over twice.
void Regular2::add_cells_at_meetings(std::vector<Triangle>& cells) {
  if (!kernel_->tells_sign_now()) return;
  std::vector<ObjectId> points;
  for (const ObjectId v : suspects_) {
    if (store_.has(v)) points.push_back(v);
  }
  merge_sort(points, [this](ObjectId a, ObjectId b) {
    for (int axis = 0; axis < 2; ++axis) {
      const Sign sign = kernel_->sign(Query(geometry_.order(axis), {a, b}), When::kNow);
      if (sign != Sign::kZero) return sign == Sign::kPositive;
    }
    return a < b;
  });
  std::vector<Triangle> star;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool meets =
        (i > 0 && geometry_.equal(points[i - 1], points[i], When::kNow)) ||
        (i + 1 < points.size() && geometry_.equal(points[i], points[i + 1], When::kNow));
    if (!meets) continue;
    star_of(points[i], star);
    cells.insert(cells.end(), star.begin(), star.end());
  }
}

// False if everything would have to be sewn.
bool Regular2::sew(std::vector<Triangle> cells, const Guests& guests) {
  std::vector<ObjectId> vertices;
  std::vector<HalfEdge> rim;
  std::vector<Corners> filling;
  for (;;) {
    kernel_->poll();
    sort_unique(cells);
    if (cells.size() >= store_.triangles()) return false;
    vertices = guests.came;
    rim.clear();
    for (const Triangle t : cells) {
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        const ObjectId v = store_.origin(h);
        const bool gone = std::find(guests.gone.begin(), guests.gone.end(), v) != guests.gone.end();
        if (v != store_.infinity() && !gone) vertices.push_back(v);
        const Triangle beyond = Triangulation2::triangle(store_.twin(h));
        if (!std::binary_search(cells.begin(), cells.end(), beyond)) rim.push_back(h);
      }
    }
    sort_unique(vertices);
    const StaticResult built = build_static(geometry_, vertices, false, patch_);
    if (built == StaticResult::kFailed) return false;
    std::vector<Triangle> more;  // join the triangles
    if (built == StaticResult::kBuilt) {
      if (!find_patch(rim, vertices, filling, more)) {
        more.clear();
      } else {
        if (more.empty()) add_twin_edges(store_, cells, rim, filling, more);
        if (more.empty() && fill(cells, filling)) break;
      }
    }
    if (more.empty()) {
      for (const HalfEdge h : rim) more.push_back(Triangulation2::triangle(store_.twin(h)));
    }
    cells.insert(cells.end(), more.begin(), more.end());
  }
  ++sews_;
  largest_sew_ = std::max(largest_sew_, cells.size());
  return true;
}

// The triangles of the patch that fill the rim; or those outside of it that stand against it. False if
// all of these do.
bool Regular2::find_patch(const std::vector<HalfEdge>& rim, const std::vector<ObjectId>& vertices,
                          std::vector<Corners>& filling, std::vector<Triangle>& more) const {
  std::vector<bool> barrier(patch_.half_edge_capacity(), false);
  std::vector<bool> taken(patch_.triangle_capacity(), false);
  std::vector<HalfEdge> found;
  for (const HalfEdge h : rim) {
    const HalfEdge at = patch_.between(store_.origin(h), store_.target(h));
    found.push_back(at);
    if (at == kNone) {
      more.push_back(Triangulation2::triangle(store_.twin(h)));
    } else {
      barrier[at] = barrier[patch_.twin(at)] = true;
    }
  }
  if (!more.empty()) return true;
  std::vector<Triangle> chosen;
  const auto take = [&](Triangle t) {
    if (taken[t]) return;
    taken[t] = true;
    chosen.push_back(t);
  };
  for (const HalfEdge h : found) take(Triangulation2::triangle(h));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (HalfEdge h = 3 * chosen[i]; h < 3 * chosen[i] + 3; ++h) {
      if (!barrier[h]) take(Triangulation2::triangle(patch_.twin(h)));
    }
  }
  filling.clear();
  std::vector<ObjectId> covered;
  for (const Triangle t : chosen) {
    const Corners corners = patch_.corners(t);
    filling.push_back(corners);
    covered.insert(covered.end(), corners.begin(), corners.end());
  }
  sort_unique(covered);
  for (const ObjectId v : vertices) {
    if (patch_.has(v) && !std::binary_search(covered.begin(), covered.end(), v)) return false;
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Triangle inner = Triangulation2::triangle(found[i]);
    const ObjectId apex = store_.apex(store_.twin(rim[i]));
    if (patch_.apex(found[i]) == apex ||
        geometry_.is_bad(patch_.corners(inner), opposite(found[i]), apex)) {
      more.push_back(Triangulation2::triangle(store_.twin(rim[i])));
    }
  }
  return true;
}

// Replaces triangles, with their certificates; vertices that this hides wait for a witness. False, with
// nothing changed, if the new ones do not fit.
bool Regular2::fill(const std::vector<Triangle>& cells, const std::vector<Corners>& filling) {
  std::vector<Triangle> sorted = cells;
  std::sort(sorted.begin(), sorted.end());
  std::vector<CertificateId> inside;
  std::vector<Corners> old;
  std::vector<ObjectId> vertices;
  for (const Triangle t : sorted) {
    old.push_back(store_.corners(t));
    vertices.insert(vertices.end(), old.back().begin(), old.back().end());
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge g = store_.twin(h);
      if (h > g || !std::binary_search(sorted.begin(), sorted.end(), Triangulation2::triangle(g)))
        continue;
      if (store_.label(h) != kNoCertificate) inside.push_back(store_.label(h));
    }
  }
  if (!store_.replace(cells, filling, fresh_)) return false;
  hint_ = fresh_.front();
  for (CertificateId label : inside) {
    if (!corrupt_) edges_.drop(label);
  }
  for (const Corners& t : old) {
    if (!geometry_.is_ghost(t)) untold_.gone(t);
  }
  for (const Corners& t : filling) {
    if (!geometry_.is_ghost(t)) untold_.came(t);
    for (const ObjectId v : t) {
      if (v != store_.infinity()) drop_witness(v);
    }
  }
  sorted = fresh_;
  std::sort(sorted.begin(), sorted.end());
  for (const Triangle t : fresh_) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge g = store_.twin(h);
      if (h > g && std::binary_search(sorted.begin(), sorted.end(), Triangulation2::triangle(g)))
        continue;
      set_certificate(h);
    }
  }
  sort_unique(vertices);
  for (const ObjectId v : vertices) {
    if (v != store_.infinity() && present_[v] && !store_.has(v)) wait(v);
  }
  return true;
}

// Along the hull the direction turns from left to right once: with left turns everywhere the hull is
// then a simple convex polygon.
bool Regular2::hull_turns_once() const {
  std::vector<ObjectId> corners;
  const HalfEdge first = store_.out(store_.infinity());
  HalfEdge at = first;
  do {
    corners.push_back(store_.target(at));
    at = store_.around(at);
  } while (at != first);
  std::vector<bool> forward;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ObjectId a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    Sign s = kernel_->sign_after(geometry_.order(0), {a, b});
    if (s == Sign::kZero) s = kernel_->sign_after(geometry_.order(1), {a, b});
    forward.push_back(s == Sign::kPositive);
  }
  int starts = 0;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (forward[i] && !forward[i == 0 ? forward.size() - 1 : i - 1]) ++starts;
  }
  return starts == 1;
}

void Regular2::mend() {
  sort_unique(suspects_);
  bool hull = false;
  const std::vector<Triangle> wrong = wrong_cells(hull);
  suspects_.clear();
  if (!wrong.empty()) {
    if (instant_ != kernel_->instant_number()) sews_at_instant_ = 0;
    instant_ = kernel_->instant_number();
    if (!kernel_->is_exact() && ++sews_at_instant_ > kMostSews) {
      return give_up("no end of repairs at one instant");
    }
    if (!sew(wrong, {})) return rebuild_because("a degenerate instant reaches every triangle");
  }
  if (hull && !corrupt_ && !hull_turns_once()) rebuild_because("the hull winds around twice");
}

void Regular2::instant_settled() {
  if (corrupt_) return;
  sort_unique(moved_);
  if (flat_) {
    if (!moved_.empty()) sort_out_line();
  } else {
    const std::uint64_t sews = sews_;
    for (const ObjectId v : moved_) {
      if (store_.has(v)) suspect(v);
    }
    mend();
    if (!corrupt_ && !flat_) settle_hidden();
    if (corrupt_) return;
    if (untold_.size() != 0 || sews_ != sews) {
      const AttributeDifference change = untold_.take();
      kernel_->report(id_, kRetile, {}, !change.gone.empty() || !change.came.empty(), change.gone,
                      change.came);
    }
  }
  moved_.clear();
  suspects_.clear();
  has_last_change_ = false;
}

}  // namespace kinex
