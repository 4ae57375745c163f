// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: CGAL's vertical decomposition of the arrangement of the lines, at exact positions, says
// which features are above and below each vertex. Where one of them is a vertex, or lines meet or coincide
// identically, it leaves a choice: there the heights of all lines at the crossing decide, as polynomials in
// infinitesimals by which the lines are raised.
#include <CGAL/Arr_linear_traits_2.h>
#include <CGAL/Arr_vertical_decomposition_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <list>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "structures/arrangement/trapezoids_2.h"

namespace kinex {
namespace {

using Number = CGAL::Gmpq;
using Exact = CGAL::Simple_cartesian<Number>;
using Traits = CGAL::Arr_linear_traits_2<Exact>;
using Planar = CGAL::Arrangement_2<Traits>;
using Ids = std::vector<ObjectId>;

struct Line {
  Number slope, height;
  friend bool operator==(const Line&, const Line&) = default;
  friend bool operator<(const Line& l, const Line& m) {
    return std::tie(l.slope, l.height) < std::tie(m.slope, m.height);
  }
};

// A number and multiples of infinitesimals, the largest first.
class Raised {
 public:
  explicit Raised(Number value) : value_(std::move(value)) {}
  void add(ObjectId infinitesimal, const Number& factor) { parts_[infinitesimal] += factor; }
  bool operator<(const Raised& other) const {
    if (value_ != other.value_) return value_ < other.value_;
    std::map<ObjectId, Number> rest = other.parts_;
    for (const auto& [id, factor] : parts_) rest[id] -= factor;
    for (const auto& [id, factor] : rest) {
      if (factor != 0) return factor > 0;
    }
    return false;
  }

 private:
  Number value_;
  std::map<ObjectId, Number> parts_;
};

class WallsWitness {
 public:
  WallsWitness(const Snapshot& snapshot, const Ids& lines) : ids_(lines) {
    std::vector<Traits::Curve_2> curves;
    for (const ObjectId l : lines) {
      const Line line{Number(snapshot.position(l, 0).raw()), Number(snapshot.position(l, 1).raw())};
      lines_.emplace(l, line);
      Ids& same = same_[line];
      if (same.empty()) curves.emplace_back(Exact::Line_2(line.slope, -1, line.height));
      same.push_back(l);
    }
    CGAL::insert(planar_, curves.begin(), curves.end());
    decompose();
  }

  // The next line above the crossing of l and m, or below it; kNoObject: none.
  ObjectId next(ObjectId l, ObjectId m, bool up) const {
    const Line &a = lines_.at(l), &b = lines_.at(m);
    const Number x = (a.height - b.height) / (b.slope - a.slope);
    // By how much it goes to the right if l is raised by 1, and m by as much to the left.
    const Number shift = Number(1) / (b.slope - a.slope);
    const auto height = [&](ObjectId line) {
      const Line& h = lines_.at(line);
      Raised result(h.slope * x + h.height);
      result.add(line, 1);
      result.add(l, h.slope * shift);
      result.add(m, -h.slope * shift);
      return result;
    };
    const Raised own = height(l);
    ObjectId best = kNoObject;
    for (const ObjectId h : ids_) {
      if (h == l || h == m) continue;
      const Raised there = height(h);
      if (up ? !(own < there) : !(there < own)) continue;
      if (best == kNoObject || (up ? there < height(best) : height(best) < there)) best = h;
    }
    return best;
  }
  // True if CGAL's decomposition agrees that this is the next line, or leaves a choice.
  bool agrees(ObjectId l, ObjectId m, bool up, ObjectId line) const {
    const Line &a = lines_.at(l), &b = lines_.at(m);
    if (same_.at(a).size() > 1 || same_.at(b).size() > 1) return true;
    const Number x = (a.height - b.height) / (b.slope - a.slope);
    const auto& [through, above, below] = features_.at({x, a.slope * x + a.height});
    if (through > 2) return true;
    const std::vector<Line>& there = up ? above : below;
    if (line == kNoObject) return there.empty();
    return std::find(there.begin(), there.end(), lines_.at(line)) != there.end();
  }
  std::size_t crossings() const {
    std::size_t result = 0;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) result += cross(ids_[j], ids_[i]) ? 1 : 0;
    }
    return result;
  }
  bool knows(ObjectId l) const { return lines_.contains(l); }
  bool cross(ObjectId l, ObjectId m) const { return lines_.at(l).slope != lines_.at(m).slope; }

 private:
  struct Features {
    std::size_t through = 0;  // lines
    std::vector<Line> above, below;
  };

  static Line line_of(const Planar::Halfedge_const_handle& edge) {
    const Exact::Line_2 line = edge->curve().supporting_line();
    return {-line.a() / line.b(), -line.c() / line.b()};
  }
  // The lines of an edge, or through a vertex; none of a face.
  static std::vector<Line> lines_of_feature(const CGAL::Object& feature) {
    Planar::Halfedge_const_handle edge;
    Planar::Vertex_const_handle vertex;
    std::vector<Line> result;
    if (CGAL::assign(edge, feature)) {
      if (!edge->is_fictitious()) result.push_back(line_of(edge));
    } else if (CGAL::assign(vertex, feature) && !vertex->is_at_open_boundary()) {
      auto around = vertex->incident_halfedges();
      const auto first = around;
      do {
        const Line line = line_of(around);
        if (std::find(result.begin(), result.end(), line) == result.end()) result.push_back(line);
      } while (++around != first);
    }
    return result;
  }
  void decompose() {
    using Decomposed =
        std::pair<Planar::Vertex_const_handle, std::pair<CGAL::Object, CGAL::Object>>;
    std::list<Decomposed> found;
    CGAL::decompose(planar_, std::back_inserter(found));
    for (const auto& [vertex, features] : found) {
      if (vertex->is_at_open_boundary()) continue;
      const auto& point = vertex->point();
      features_[{point.x(), point.y()}] = {vertex->degree() / 2, lines_of_feature(features.second),
                                           lines_of_feature(features.first)};
    }
  }

  Ids ids_;
  std::map<ObjectId, Line> lines_;
  std::map<Line, Ids> same_;
  Planar planar_;
  std::map<std::pair<Number, Number>, Features> features_;
};

}  // namespace

void Trapezoids2::audit(const Snapshot& snapshot, AuditReport& report) const {
  Ids lines;
  for (ObjectId l = 0; l < snapshot.objects(); ++l) {
    if (snapshot.alive(l)) lines.push_back(l);
  }
  const WallsWitness witness(snapshot, lines);
  std::size_t walls = 0;
  walls_.each(false, [&](const FaceWalls::Wall& wall, ObjectId end) {
    ++walls;
    const auto [l, m, side] = wall;
    const bool up = side == FaceWalls::kUp;
    const auto name = [l = l, m = m] { return std::to_string(l) + ", " + std::to_string(m); };
    const bool crosses = witness.knows(l) && witness.knows(m) && witness.cross(l, m);
    report.check(crosses, [&] { return "a crossing of parallel lines " + name(); });
    if (!crosses) return;
    const bool same = witness.next(l, m, up) == end;
    report.check(same, [&] { return "another line is next to crossing " + name(); });
    if (!same) return;
    report.check(witness.agrees(l, m, up, end),
                 [&] { return "another feature is next to crossing " + name() + " for CGAL"; });
  });
  report.check(walls == 2 * witness.crossings(), [] { return "another number of walls"; });
  const std::size_t n = lines.size();
  report.check(trapezoids() == n + 1 + 3 * witness.crossings(),
               [] { return "another number of trapezoids"; });
}

}  // namespace kinex
