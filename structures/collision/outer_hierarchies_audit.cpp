// SPDX-License-Identifier: GPL-3.0-or-later
// OuterHierarchies: the audit. The witness is CGAL's exact areas, orientations and tests of
// convexity, on the polygons of the scene and on the stages of their hierarchies.
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/show_text.h"
#include "structures/collision/outer_hierarchies.h"

namespace kinex {
namespace {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Point = Exact::Point_2;
using Vector = Exact::Vector_2;
using Polygon = CGAL::Polygon_2<Exact>;

Point point(const FramePoint& p) {
  const Rational x(p.x, p.w), y(p.y, p.w);
  return {CGAL::Gmpq(x.raw()), CGAL::Gmpq(y.raw())};
}

Polygon polygon_of(const SceneObject& body) {
  Polygon polygon;
  for (const Vertex2& v : body.polygon) {
    polygon.push_back({CGAL::Gmpq(v[0].raw()), CGAL::Gmpq(v[1].raw())});
  }
  return polygon;
}

// The nodes of the stage before level k, counter-clockwise.
void collect(const OuterHierarchy& tree, std::uint32_t v, int k, std::vector<Point>& stage) {
  const OuterHierarchy::Node& node = tree.node(v);
  if (node.cut_level < k) {
    collect(tree, node.left, k, stage);
    collect(tree, node.right, k, stage);
    return;
  }
  const Point apex = point(node.apex);
  if (stage.empty() || stage.back() != apex) stage.push_back(apex);
}

Polygon stage_of(const OuterHierarchy& tree, int k) {
  std::vector<Point> stage;
  for (std::uint32_t root = 0; root < 4; ++root) collect(tree, root, k, stage);
  while (stage.size() > 1 && stage.back() == stage.front()) stage.pop_back();
  return {stage.begin(), stage.end()};
}

// Both are convex and counter-clockwise: no vertex of `inner` is right of an edge of `outer`. The
// vertex furthest to the right advances monotonically, once around.
bool holds(const Polygon& outer, const Polygon& inner) {
  const std::size_t n = outer.size(), m = inner.size();
  const auto goes_right = [](const Vector& along, const Point& from, const Point& to) {
    return CGAL::orientation(along, to - from) == CGAL::RIGHT_TURN;
  };
  std::size_t far = 0;
  for (std::size_t j = 1; j < m; ++j) {
    if (goes_right(outer[1] - outer[0], inner[far], inner[j])) far = j;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point &from = outer[i], &to = outer[(i + 1) % n];
    for (std::size_t steps = 0; steps < m; ++steps) {
      const std::size_t next = (far + 1) % m;
      if (!goes_right(to - from, inner[far], inner[next])) break;
      far = next;
    }
    if (CGAL::orientation(from, to, inner[far]) == CGAL::RIGHT_TURN) return false;
  }
  return true;
}

void audit_tree(const OuterHierarchy& tree, const Polygon& polygon, const std::string& name,
                AuditReport& report) {
  const auto bad = [&name](const char* what) {
    return [&name, what] { return what + (" the hierarchy of " + name); };
  };
  Polygon outer = stage_of(tree, 0);
  const CGAL::Gmpq box = (polygon.right_vertex()->x() - polygon.left_vertex()->x()) *
                         (polygon.top_vertex()->y() - polygon.bottom_vertex()->y());
  report.check(outer.is_convex() && outer.area() == box && holds(outer, polygon),
               bad("the first stage is not the bounding box in"));
  CGAL::Gmpq left = box;  // of the box, after the tiles
  for (const OuterHierarchy::Node& node : tree.nodes()) {
    if (node.cut == OuterHierarchy::kNone) continue;
    const CGAL::Gmpq tile = CGAL::area(point(tree.node(node.left).apex), point(node.apex),
                                       point(tree.node(node.right).apex));
    report.check(tile > 0, bad("a tile is flat or turned over in"));
    left -= tile;
  }
  report.check(left == polygon.area(), bad("tiles and polygon do not fill the box in"));
  for (int k = 1; k <= tree.levels(); ++k) {
    Polygon stage = stage_of(tree, k);
    report.check(stage.size() >= 3 && stage.is_convex() && stage.area() > 0,
                 bad("a stage is not convex in"));
    report.check(holds(outer, stage), bad("a stage leaves the one before in"));
    outer = std::move(stage);
  }
  report.check(holds(outer, polygon) && outer.area() == polygon.area(),
               bad("the last stage is not the polygon in"));
}

}  // namespace

void OuterHierarchies::audit(const Snapshot&, AuditReport& report) const {
  std::set<const OuterHierarchy*> seen;
  for (ObjectId id = 0; id < trees_.size(); ++id) {
    if (trees(id)[0] == nullptr || !seen.insert(trees(id)[0]).second) continue;
    const SceneObject& body = scene_.objects[id];
    const Polygon polygon = polygon_of(body);
    for (std::size_t i = 0; i < kPolicies.size(); ++i) {
      const std::string name =
          show_text(body.id) + ", " + std::string(cut_policy_name(kPolicies[i]));
      audit_tree(*trees(id)[i], polygon, name, report);
    }
  }
}

}  // namespace kinex
