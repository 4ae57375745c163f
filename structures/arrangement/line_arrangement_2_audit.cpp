// SPDX-License-Identifier: GPL-3.0-or-later
// The witness: CGAL's arrangement of the lines at exact positions. Its vertices on a line, from left
// to right, are where the line crosses the others; the numbers of its vertices, edges and faces are
// those that follow from the orders. Lines that cross a line in the same vertex meet identically:
// their order is that of the crossings if one of them alone is raised, that of the smallest id that
// matters.
#include <CGAL/Arr_linear_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/arrangement/line_arrangement_2.h"

namespace kinex {

namespace {

using Number = CGAL::Gmpq;
using Exact = CGAL::Simple_cartesian<Number>;
using Traits = CGAL::Arr_linear_traits_2<Exact>;
using Planar = CGAL::Arrangement_2<Traits>;
using Ids = std::vector<ObjectId>;

class Witness {
 public:
  Witness(const Snapshot& snapshot, const Ids& lines)
      : slope_(snapshot.objects()), height_(snapshot.objects()) {
    std::vector<Traits::Curve_2> curves;
    for (const ObjectId l : lines) {
      slope_[l] = Number(snapshot.position(l, 0).raw());
      height_[l] = Number(snapshot.position(l, 1).raw());
      Ids& same = ids_[{slope_[l], height_[l]}];
      if (same.empty()) curves.emplace_back(Exact::Line_2(slope_[l], -1, height_[l]));
      same.push_back(l);
    }
    CGAL::insert(planar_, curves.begin(), curves.end());
    for (auto v = planar_.vertices_begin(); v != planar_.vertices_end(); ++v) {
      Ids through;
      auto edge = v->incident_halfedges();
      const auto first = edge;
      do {
        const Exact::Line_2 line = edge->curve().supporting_line();
        const Ids& same = ids_.at({-line.a() / line.b(), -line.c() / line.b()});
        through.insert(through.end(), same.begin(), same.end());
      } while (++edge != first);
      std::sort(through.begin(), through.end());
      through.erase(std::unique(through.begin(), through.end()), through.end());
      for (const ObjectId l : through) vertices_[l].emplace_back(v->point().x(), through);
    }
    for (auto& [line, vertices] : vertices_) std::sort(vertices.begin(), vertices.end());
  }

  // By slope, of parallels the higher one first, of equal lines the smaller id.
  bool is_steeper_behind(ObjectId l, ObjectId m) const {
    if (slope_[l] != slope_[m]) return slope_[l] < slope_[m];
    if (height_[l] != height_[m]) return height_[l] > height_[m];
    return l < m;
  }
  Ids order_on(ObjectId line, const Ids& lines) const {
    Ids result;
    for (const ObjectId m : lines) {
      if (m != line && slope_[m] == slope_[line]) result.push_back(m);
    }
    result.push_back(line);
    const auto found = vertices_.find(line);
    if (found == vertices_.end()) return result;
    for (auto [x, others] : found->second) {
      std::erase_if(others, [&](ObjectId m) { return slope_[m] == slope_[line]; });
      std::sort(others.begin(), others.end(),
                [&](ObjectId m, ObjectId k) { return goes_first(line, m, k); });
      result.insert(result.end(), others.begin(), others.end());
    }
    return result;
  }
  // In runs of crossings at one place, a vertex each.
  std::size_t runs(ObjectId line, const Ids& crossings) const {
    std::size_t result = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      if (i == 0 || x(line, crossings[i - 1]) != x(line, crossings[i])) ++result;
    }
    return result;
  }
  const Planar& planar() const { return planar_; }
  std::size_t distinct() const { return ids_.size(); }
  // The smallest id of the lines at this one's place.
  ObjectId first_of(ObjectId l) const { return ids_.at({slope_[l], height_[l]}).front(); }

 private:
  Number x(ObjectId l, ObjectId m) const { return (height_[l] - height_[m]) / (slope_[m] - slope_[l]); }
  // How far the crossing of l and m goes to the right if the line `raised` alone is raised by 1.
  Number shift(ObjectId raised, ObjectId l, ObjectId m) const {
    const Number rise(static_cast<int>(raised == l) - static_cast<int>(raised == m));
    return rise / (slope_[m] - slope_[l]);
  }
  bool goes_first(ObjectId l, ObjectId m, ObjectId k) const {
    std::array<ObjectId, 3> three{l, m, k};
    std::sort(three.begin(), three.end());
    for (const ObjectId raised : three) {
      const Number first = shift(raised, l, m), second = shift(raised, l, k);
      if (first != second) return first < second;
    }
    return m < k;
  }

  std::vector<Number> slope_, height_;  // by object
  std::map<std::pair<Number, Number>, Ids> ids_;
  Planar planar_;
  std::map<ObjectId, std::vector<std::pair<Number, Ids>>> vertices_;
};

}  // namespace

void LineArrangement2::audit(const Snapshot& snapshot, AuditReport& report) const {
  Ids lines;
  for (ObjectId l = 0; l < snapshot.objects(); ++l) {
    if (snapshot.alive(l)) lines.push_back(l);
  }
  report.check(lines == crossings_.lines(), [] { return "other lines than those that are there"; });
  if (lines != crossings_.lines()) return;
  const Witness witness(snapshot, lines);
  std::size_t ends = 0, edges = 0;  // of edges, at vertices; of distinct lines
  for (const ObjectId l : lines) {
    const Ids& row = crossings_.order(l);
    const bool same = witness.order_on(l, lines) == row;
    report.check(same, [l] { return "another order of crossings on line " + std::to_string(l); });
    if (!same) return;
    if (witness.first_of(l) != l) continue;
    const auto own = std::find(row.begin(), row.end(), l);
    const std::size_t vertices = witness.runs(l, Ids(own + 1, row.end()));
    edges += vertices + 1;
    ends += vertices;
  }
  // n lines make n + 1 faces, and k - 1 more at each vertex of k lines, which is k of `ends`.
  const Planar& planar = witness.planar();
  report.check(planar.number_of_edges() == edges, [] { return "another number of edges"; });
  report.check(planar.number_of_vertices() + planar.number_of_faces() ==
                   1 + witness.distinct() + ends,
               [] { return "another number of vertices and faces"; });
  std::sort(lines.begin(), lines.end(), [&witness](ObjectId l, ObjectId m) {
    return witness.is_steeper_behind(l, m);
  });
  report.check(lines == slopes_.items(), [] { return "another order of slopes"; });
}

}  // namespace kinex
