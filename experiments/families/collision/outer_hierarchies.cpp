// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how many nodes of an outer hierarchy have their apex at a distance of s or more from
//   the polygon, and how deep are they?
// Sources: the introduction of Erickson, Guibas, Stolfi, Zhang (1999) promises O(sqrt(D / s))
//   vertices; constants and checks: structures/collision/hierarchy_bounds.h, as in every run.
// Exactness: the table's distances are in doubles, of exact apexes.
// Cost: a second, ten in full.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "experiments/families/collision/experiments.h"
#include "experiments/families/collision/polygons.h"
#include "structures/collision/hierarchy_bounds.h"

namespace kinex::families {
namespace {

constexpr double kSlack = 1 + 1e-9;
constexpr double kNodes = 4;  // times min(n, sqrt(D / s)); measured: 2.28

using Point = std::array<double, 2>;

Point to_point(const FramePoint& p) {
  const std::vector<Rational> at = p.coordinates();
  return {(at[0] / at[2]).to_double(), (at[1] / at[2]).to_double()};
}

double distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double length = dx * dx + dy * dy;
  const double along = std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length, 0.0, 1.0);
  return std::hypot(p[0] - a[0] - along * dx, p[1] - a[1] - along * dy);
}

// Vertices on the unit circle at the angles 2 atan(2^-k), and two behind.
std::vector<Vertex2> exponential_polygon(int n) {
  std::vector<Vertex2> polygon;
  for (int k = n - 3; k >= 0; --k) {
    const Rational u(Integer(1), Integer::power_of_two(static_cast<unsigned long>(k)));
    const Rational scale = Rational(1) / (Rational(1) + u * u);
    polygon.push_back({scale * (Rational(1) - u * u), scale * Rational(2) * u});
  }
  polygon.push_back({Rational(-1), Rational(0)});
  polygon.push_back({Rational(0), Rational(-1)});
  return polygon;
}

std::vector<Vertex2> random_polygon(int n) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = 3;
  return lab::generate_scene(*lab::find_workload("polygon-random"), parameters).objects.front().polygon;
}

std::vector<Vertex2> thin_polygon(int n) {
  std::vector<Vertex2> polygon = regular_polygon(n, 1);
  for (Vertex2& vertex : polygon) vertex[1] /= Rational(64);
  return polygon;
}

class PolygonStudy {
 public:
  PolygonStudy(std::string name, const std::vector<Vertex2>& polygon, CutPolicy policy)
      : name_(std::move(name)),
        policy_(policy),
        tree_(frame_polygon(polygon, false), policy),
        n_(static_cast<double>(tree_.polygon().size())) {
    for (const FramePoint& vertex : tree_.polygon().vertices) vertices_.push_back(to_point(vertex));
    for (const Point& a : vertices_) {
      for (const Point& b : vertices_) {
        diameter_ = std::max(diameter_, std::hypot(a[0] - b[0], a[1] - b[1]));
      }
    }
    for (const OuterHierarchy::Node& node : tree_.nodes()) far_.push_back(from_polygon(node));
  }

  // Returns the nodes over min(n, sqrt(D / s)).
  double add_row(double relative, std::vector<std::vector<std::string>>& rows) const {
    const double s = relative * diameter_, root = std::sqrt(diameter_ / s);
    int nodes = 0, ends = 0, depth = 0;
    for (std::size_t v = 0; v < far_.size(); ++v) {
      if (far_[v] < s) continue;
      const OuterHierarchy::Node& node = tree_.nodes()[v];
      ++nodes;
      depth = std::max(depth, node.depth);
      const auto is_far = [&](std::uint32_t child) {
        return child != OuterHierarchy::kNone && far_[child] >= s;
      };
      if (!is_far(node.left) && !is_far(node.right)) ++ends;
    }
    rows.push_back({std::string(cut_policy_name(policy_)), name_, fmt::format("{:.0f}", n_),
                    fmt::format("{:.0e}", relative), fmt::format("{}", nodes),
                    fmt::format("{:.2f}", nodes / std::min(n_, root)), fmt::format("{}", ends),
                    fmt::format("{:.2f}", ends / root), fmt::format("{}", depth),
                    fmt::format("{}", tree_.depth())});
    return nodes / std::min(n_, root);
  }

  const OuterHierarchy& tree() const { return tree_; }

 private:
  // The nearest point of P is on the chain, or an end of it.
  double from_polygon(const OuterHierarchy::Node& node) const {
    const Point apex = to_point(node.apex);
    const std::size_t n = vertices_.size();
    double least =
        std::hypot(apex[0] - vertices_[node.begin % n][0], apex[1] - vertices_[node.begin % n][1]);
    for (std::size_t k = 0; k < node.count; ++k) {
      const std::size_t i = (node.begin + k) % n;
      least = std::min(least, distance(apex, vertices_[i], vertices_[(i + 1) % n]));
    }
    return least;
  }

  std::string name_;
  CutPolicy policy_;
  OuterHierarchy tree_;
  double n_, diameter_ = 0;
  std::vector<Point> vertices_;
  std::vector<double> far_;  // of the apex, per node
};

lab::Check check_of(const BoundCheck& bound) {
  return {bound.id,
          "bound",
          "",
          "<= " + bound.bound.to_string(),
          bound.observed.to_string(),
          bound.source,
          bound.holds ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
          std::nullopt};
}

}  // namespace

lab::StudyResult study_outer_hierarchies(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "outer_hierarchy";
  result.table.title = "outer hierarchies: nodes with apexes at distance s or more";
  result.table.header = {
      "policy", "polygon",     "n",           "s/D",  "nodes", "/ min(n, sqrt(D/s))",
      "apart",  "/ sqrt(D/s)", "their depth", "depth"};
  std::vector<std::pair<std::string, std::vector<Vertex2>>> polygons{
      {"regular", regular_polygon(64, 1)},
      {"random", random_polygon(64)},
      {"thin", thin_polygon(64)},
      {"exponential", exponential_polygon(28)}};
  if (!quick) {
    polygons.emplace_back("regular", regular_polygon(1024, 1));
    polygons.emplace_back("random", random_polygon(1024));
  }
  double most = 0;
  for (const CutPolicy policy :
       {CutPolicy::kMedian, CutPolicy::kCompass, CutPolicy::kDudley, CutPolicy::kBalancedDudley}) {
    const bool metric = policy == CutPolicy::kDudley || policy == CutPolicy::kBalancedDudley;
    HierarchyBounds bounds(policy);
    for (const auto& [name, polygon] : polygons) {
      if (!go_on()) return result;
      const PolygonStudy study(name, polygon, policy);
      bounds.add(study.tree());
      for (const double s : {1e-1, 1e-2, 1e-3, 1e-4}) {
        const double nodes = study.add_row(s, result.table.rows);
        if (metric) most = std::max(most, nodes);
      }
    }
    for (const BoundCheck& bound :
         bounds.checks("outer_hierarchy." + std::string(cut_policy_name(policy)))) {
      result.checks.push_back(check_of(bound));
    }
  }
  result.checks.push_back(
      {"outer_hierarchy.nodes", "at most", "", fmt::format("<= {:.4g}", kNodes),
       fmt::format("{:.4g}", most),
       "nodes over min(n, sqrt(D / s)), Dudley's cuts; Erickson, Guibas, Stolfi, Zhang 1999: O(1); "
       "the constant is measured",
       most <= kNodes * kSlack ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted, std::nullopt});
  return result;
}

}  // namespace kinex::families
