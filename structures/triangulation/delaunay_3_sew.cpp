// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: the repair of degenerate instants. Some cells are wrong: S. They are cut out, and the
// hole is filled with cells C of the static triangulation R of their vertices:
//   1. Every facet on the rim of S must be a facet of R, with a cell of R on its inner side. Else the
//      cell outside it joins S.
//   2. C: the cells of R that are reached from there without crossing the rim. Every vertex of S must
//      be in C. Else all cells across the rim join S.
//   3. No facet on the rim may be in conflict with the cell outside. Else that cell joins S.
//   4. No edge or facet inside C may exist outside of it. Else the cells there join S.
// In the plane, with the rim drawn; v: a vertex of S; x: a cell of R beyond the rim, left out:
//
//    v-----v             v-----v             v-----v
//    |     |             |  \ C|x\           |  \  |
//    |  S  v---v         | C   v---v         |     v---v
//    |         |         |  / C  \C|         |  /    \ |
//    v---------v         v---------v         v---------v
//    S, cut out          R                   the hole filled with C
//
// All else is right by itself: the cells of C are upright, and the facets between them regular. A
// triangulation that is locally regular everywhere is regular, and the one with the ties of
// space_geometry.h is unique. It ends, because S grows. If S has become everything, the static
// algorithm builds all of it.
#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "structures/parts/merge_sort.h"
#include "structures/parts/sort_unique.h"
#include "structures/triangulation/delaunay_3.h"
#include "structures/triangulation/edge_winding.h"

namespace kinex {
namespace {

// The facets of a triangulation, by their vertices and orientation.
class FacetIndex {
 public:
  explicit FacetIndex(const Triangulation3& store) {
    for (Triangulation3::Cell c = 0; c < store.cell_capacity(); ++c) {
      if (!store.live(c)) continue;
      const Triangulation3::Quad quad = store.quad(c);
      for (unsigned i = 0; i < 4; ++i) {
        entries_.push_back({store.triple(4 * c + i), Triangulation3::side(quad, i), 4 * c + i});
      }
    }
    std::sort(entries_.begin(), entries_.end());
  }
  Triangulation3::Facet find(const Triangulation3::Triple& triple, int side) const {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{triple, side, 0});
    const bool found =
        at != entries_.end() && std::get<0>(*at) == triple && std::get<1>(*at) == side;
    return found ? std::get<2>(*at) : Triangulation3::kNone;
  }

 private:
  using Entry = std::tuple<Triangulation3::Triple, int, Triangulation3::Facet>;
  std::vector<Entry> entries_;
};

// Adds the cells around edges of `near` that they go round more than once. Edges of cells that are
// wrong anyway are passed over.
void add_windings(const SpaceGeometry& geometry, const Triangulation3& store,
                  const std::vector<Triangulation3::Cell>& near,
                  std::vector<Triangulation3::Cell>& wrong) {
  const std::vector<Triangulation3::Cell> known = wrong;
  std::set<std::pair<ObjectId, ObjectId>> seen;
  for (const Triangulation3::Cell c : near) {
    const Triangulation3::Quad quad = store.quad(c);
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = i + 1; j < 4; ++j) {
        const auto [u, v] = std::minmax(quad[i], quad[j]);
        if (v == store.infinity() || !seen.emplace(u, v).second) continue;
        const auto around = cells_around_edge(store, c, i, j);
        const bool wrong_anyway = std::any_of(around.begin(), around.end(), [&](auto other) {
          return std::binary_search(known.begin(), known.end(), other);
        });
        if (wrong_anyway || goes_round_once(geometry, store, around, u, v)) continue;
        wrong.insert(wrong.end(), around.begin(), around.end());
      }
    }
  }
  sort_unique(wrong);
}

// Adds the cells outside `cells` that have an edge or a facet which `quads` have inside: these would
// be there twice.
void add_twins(const Triangulation3& store, const std::vector<Triangulation3::Cell>& cells,
               const std::vector<Triangulation3::Facet>& rim,
               const std::vector<Triangulation3::Quad>& quads,
               std::vector<Triangulation3::Cell>& more) {
  std::set<Triangulation3::Triple> on_rim;
  std::set<std::pair<ObjectId, ObjectId>> edges;
  for (const Triangulation3::Facet f : rim) {
    const Triangulation3::Triple t = store.triple(f);
    on_rim.insert(t);
    edges.insert({t[0], t[1]});
    edges.insert({t[0], t[2]});
    edges.insert({t[1], t[2]});
  }
  std::vector<Triangulation3::Cell> star;
  const auto look_for = [&](std::initializer_list<ObjectId> face) {
    // From a finite vertex: infinity, the largest id, is in many cells.
    store.star(*face.begin(), star);
    for (const Triangulation3::Cell c : star) {
      if (std::binary_search(cells.begin(), cells.end(), c)) continue;
      const bool all = std::all_of(face.begin(), face.end(), [&](ObjectId v) {
        return store.place_of(c, v) != Triangulation3::kNone;
      });
      if (all) more.push_back(c);
    }
  };
  std::set<Triangulation3::Triple> seen;
  for (Triangulation3::Quad quad : quads) {
    std::sort(quad.begin(), quad.end());
    for (std::size_t out = 0; out < 4; ++out) {
      Triangulation3::Triple t{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != out) t[count++] = quad[k];
      }
      if (on_rim.count(t) != 0 || !seen.insert(t).second) continue;
      look_for({t[0], t[1], t[2]});
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (edges.insert({quad[i], quad[j]}).second) look_for({quad[i], quad[j]});
      }
    }
  }
}

}  // namespace

// Cells about the suspects that cannot stay.
std::vector<Delaunay3::Cell> Delaunay3::wrong_cells() {
  std::vector<Cell> near, star, wrong;
  for (const ObjectId v : suspects_) {
    store_.star(v, star);
    near.insert(near.end(), star.begin(), star.end());
  }
  sort_unique(near);
  for (const Cell c : near) {
    kernel_->poll();
    if (!geometry_.upright(store_.quad(c))) wrong.push_back(c);
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      const CertificateId label = store_.label(f);
      if (label != kNoCertificate && !(facets_.is_tie(label) && is_bad(f))) continue;
      wrong.push_back(c);
      wrong.push_back(Triangulation3::cell(store_.mate(f)));
    }
  }
  add_cells_at_meetings(wrong);
  sort_unique(wrong);
  add_windings(geometry_, store_, near, wrong);
  return wrong;
}

// All cells at suspects that are at one place at now itself: such points may pass through each other,
// and cells may turn over twice.
void Delaunay3::add_cells_at_meetings(std::vector<Cell>& cells) {
  if (!kernel_->tells_sign_now()) return;
  std::vector<ObjectId> points;
  for (const ObjectId v : suspects_) {
    if (store_.has(v)) points.push_back(v);
  }
  merge_sort(points, [this](ObjectId a, ObjectId b) {
    for (int axis = 0; axis < 3; ++axis) {
      const Sign sign = kernel_->sign(Query(geometry_.order(axis), {a, b}), When::kNow);
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
    store_.star(points[i], star);
    cells.insert(cells.end(), star.begin(), star.end());
  }
}

// False if everything would have to be sewn.
bool Delaunay3::sew(std::vector<Cell> cells, const Guests& guests) {
  std::vector<std::pair<ObjectId, ObjectId>> hidden;
  std::vector<ObjectId> vertices;
  std::vector<Facet> rim;
  std::vector<Quad> quads;
  for (;;) {
    kernel_->poll();
    sort_unique(cells);
    if (cells.size() >= store_.cells()) return false;
    const auto inside = [&cells](Cell c) {
      return std::binary_search(cells.begin(), cells.end(), c);
    };
    vertices = guests.came;
    rim.clear();
    for (const Cell c : cells) {
      for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
        const ObjectId v = store_.apex(f);
        const bool gone = std::find(guests.gone.begin(), guests.gone.end(), v) != guests.gone.end();
        if (v != store_.infinity() && !gone) vertices.push_back(v);
        if (!inside(Triangulation3::cell(store_.mate(f)))) rim.push_back(f);
      }
    }
    sort_unique(vertices);
    hidden.clear();
    const StaticResult built = build_static(geometry_, vertices, false, patch_, hidden);
    if (built == StaticResult::kFailed) return false;
    std::vector<Cell> more;  // join the cells
    if (built == StaticResult::kBuilt) {
      if (!find_patch(rim, vertices, hidden, quads, more)) {
        more.clear();
      } else {
        if (more.empty()) add_twins(store_, cells, rim, quads, more);
        if (more.empty() && fill(cells, quads)) break;
      }
    }
    if (more.empty()) {
      for (const Facet f : rim) more.push_back(Triangulation3::cell(store_.mate(f)));
    }
    cells.insert(cells.end(), more.begin(), more.end());
  }
  ++sews_;
  largest_sew_ = std::max(largest_sew_, cells.size());
  for (const auto& [v, behind] : hidden) points_.hide(v, behind);
  return true;
}

// The cells of the patch that fill the rim; or those outside of it that stand against it. False if all
// of these do.
bool Delaunay3::find_patch(const std::vector<Facet>& rim, const std::vector<ObjectId>& vertices,
                           const std::vector<std::pair<ObjectId, ObjectId>>& hidden,
                           std::vector<Quad>& quads, std::vector<Cell>& more) const {
  const FacetIndex index(patch_);
  std::vector<bool> barrier(4 * std::size_t{patch_.cell_capacity()}, false);
  std::vector<bool> taken(patch_.cell_capacity(), false);
  std::vector<Cell> chosen;
  const auto take = [&](Cell c) {
    if (taken[c]) return;
    taken[c] = true;
    chosen.push_back(c);
  };
  std::vector<Facet> found;
  for (const Facet f : rim) {
    const Quad quad = store_.quad(Triangulation3::cell(f));
    const Facet at = index.find(store_.triple(f), Triangulation3::side(quad, f % 4));
    found.push_back(at);
    if (at == kNone) {
      more.push_back(Triangulation3::cell(store_.mate(f)));
    } else {
      barrier[at] = barrier[patch_.mate(at)] = true;
    }
  }
  if (!more.empty()) return true;
  for (const Facet f : found) take(Triangulation3::cell(f));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (Facet f = 4 * chosen[i]; f < 4 * chosen[i] + 4; ++f) {
      if (!barrier[f]) take(Triangulation3::cell(patch_.mate(f)));
    }
  }
  quads.clear();
  std::vector<ObjectId> covered;
  for (const Cell c : chosen) {
    const Quad quad = patch_.quad(c);
    quads.push_back(quad);
    covered.insert(covered.end(), quad.begin(), quad.end());
  }
  for (const auto& [v, behind] : hidden) covered.push_back(v);
  sort_unique(covered);
  if (!std::includes(covered.begin(), covered.end(), vertices.begin(), vertices.end()))
    return false;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Quad inner = patch_.quad(Triangulation3::cell(found[i]));
    const ObjectId apex = store_.apex(store_.mate(rim[i]));
    if (patch_.apex(found[i]) == apex || geometry_.is_bad(inner, found[i] % 4, apex)) {
      more.push_back(Triangulation3::cell(store_.mate(rim[i])));
    }
  }
  return true;
}

// Replaces cells, with their certificates. False, with nothing changed, if the new ones do not fit.
bool Delaunay3::fill(const std::vector<Cell>& cells, const std::vector<Quad>& quads) {
  std::vector<CertificateId> inside;
  std::vector<Cell> sorted = cells;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Quad> old;
  for (const Cell c : sorted) {
    old.push_back(store_.quad(c));
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      const Facet g = store_.mate(f);
      if (f > g || !std::binary_search(sorted.begin(), sorted.end(), Triangulation3::cell(g)))
        continue;
      inside.push_back(store_.label(f));
    }
  }
  if (!store_.replace(cells, quads, fresh_)) return false;
  hint_ = fresh_.front();
  if (!corrupt_) {
    for (CertificateId& slot : inside) facets_.drop(slot);
  }
  for (const Quad& quad : old) {
    if (!geometry_.is_ghost(quad)) untold_.gone(quad);
  }
  for (const Quad& quad : quads) {
    if (!geometry_.is_ghost(quad)) untold_.came(quad);
  }
  sorted = fresh_;
  std::sort(sorted.begin(), sorted.end());
  for (const Cell c : fresh_) {
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      const Facet g = store_.mate(f);
      if (f > g && std::binary_search(sorted.begin(), sorted.end(), Triangulation3::cell(g)))
        continue;
      set_certificate(f);
    }
  }
  return true;
}

void Delaunay3::mend() {
  sort_unique(suspects_);
  const std::vector<Cell> wrong = wrong_cells();
  suspects_.clear();
  if (wrong.empty()) return;
  if (instant_ != kernel_->instant_number()) sews_at_instant_ = 0;
  instant_ = kernel_->instant_number();
  if (!kernel_->is_exact() && ++sews_at_instant_ > kMostSews) {
    return give_up("no end of repairs at one instant");
  }
  if (!sew(wrong, {})) rebuild_because("a degenerate instant reaches every cell");
}

void Delaunay3::instant_settled() {
  if (corrupt_) return;
  sort_unique(moved_);
  if (flat_) {
    if (!moved_.empty()) sort_out_plane();
  } else {
    const std::uint64_t sews = sews_;
    for (const ObjectId v : moved_) {
      if (store_.has(v)) suspect(v);
    }
    mend();
    if (!corrupt_ && !flat_) part_hidden();
    if (corrupt_) return;
    if (untold_.size() != 0 || sews_ != sews) {
      const AttributeDifference change = untold_.take();
      kernel_->report(id_, kRetile, {}, !change.gone.empty() || !change.came.empty(), change.gone,
                      change.came);
    }
  }
  moved_.clear();
  suspects_.clear();
  has_last_flip_ = false;
}

}  // namespace kinex
