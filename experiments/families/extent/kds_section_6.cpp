// SPDX-License-Identifier: GPL-3.0-or-later
// Question: is the smallest enclosing circle the smallest circumcircle of the triangles of the
//   farthest-point Delaunay triangulation, and does it change only with that triangulation or with
//   the hull? (Guibas 1998, section 6.9.)
// Scene: obtuse_triangle.cpp, kept as papers/kds-report-1998/obtuse-triangle.json.
// Expected: neither. A triangle is its own triangulation; where an angle is obtuse the circle is the
//   one on the opposite side, smaller than the circumcircle, and it changes 4 times.
// Cost: nothing.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/extent/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {
namespace {

constexpr const char* kWorkload = "obtuse-triangle";
constexpr std::array kMaintained{"convex_hull_2", "farthest_delaunay_2", "min_circle_2"};

Rational squared_distance(const Snapshot& now, ObjectId a, ObjectId b) {
  const Rational x = now.position(a, 0) - now.position(b, 0);
  const Rational y = now.position(a, 1) - now.position(b, 1);
  return x * x + y * y;
}

// The square of the radius of the circle through three points: that of abc / (4 area).
Rational squared_circumradius(const Snapshot& now) {
  const Rational cross =
      (now.position(1, 0) - now.position(0, 0)) * (now.position(2, 1) - now.position(0, 1)) -
      (now.position(1, 1) - now.position(0, 1)) * (now.position(2, 0) - now.position(0, 0));
  return squared_distance(now, 0, 1) * squared_distance(now, 1, 2) * squared_distance(now, 2, 0) /
         (Rational(4) * cross * cross);
}

std::string names(const Scene& scene, const std::vector<ObjectId>& ids) {
  std::string text;
  for (const ObjectId id : ids) text += scene.objects[id].id;
  return text;
}

// Columns of the study's table.
enum Column : std::size_t { kTime, kCircle, kRadius, kTriangle, kCircles, kFlips, kHulls };

}  // namespace

lab::StudyResult study_kds_section_6(bool, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-6-circle";
  result.table.title = "the smallest circle of a triangle with a moving corner";
  result.table.header = {"t",
                         "circle on",
                         "squared radius",
                         "squared circumradius",
                         "changes of the circle",
                         "of the triangulation",
                         "of the hull"};
  result.table.note = "a = (0, 0), b = (4, 0), c = (t - 2, 1); changes are counted from t = 0 on";
  Scene scene = lab::generate_scene(kWorkload, {.n = 3}, kMaintained.back());
  scene.maintain.clear();
  for (const char* structure : kMaintained) scene.maintain.push_back({structure, structure, {}});
  SimulatorOptions options;
  options.audit = AuditLevel::kEvents;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  simulator->start();
  std::array<StructureId, kMaintained.size()> ids{};
  for (StructureId id = 0; id < simulator->structures(); ++id) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (simulator->label(id) == kMaintained[i]) ids[i] = id;
    }
  }
  // Between the changes, and at the end.
  for (const Rational& t : {Rational(1), lab::fraction(17, 8), Rational(4), lab::fraction(47, 8),
                            Rational(7), Rational(8)}) {
    if (!go_on()) return result;
    simulator->run_until(t);
    const Snapshot now = simulator->snapshot(t);
    const std::vector<ObjectId> on = simulator->structure(ids[2]).attribute().ids;
    const Rational radius = on.size() == 2 ? squared_distance(now, on[0], on[1]) / Rational(4)
                                           : squared_circumradius(now);
    const auto changes = [&](std::size_t i) {
      return std::to_string(simulator->ledger(ids[i]).external);
    };
    result.table.rows.push_back({t.to_string(), names(scene, on), radius.to_string(),
                                 squared_circumradius(now).to_string(), changes(2), changes(1),
                                 changes(0)});
  }
  simulator->run_until(std::nullopt);
  result.checks.push_back(
      {"section-6-circle.audit", "audit", "", "0 violations",
       std::to_string(simulator->violations().size()), "CGAL's smallest circle after every event",
       simulator->violations().empty() ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted,
       std::nullopt});
  return result;
}

namespace {

// Three instants, each with the triangle, its smallest circle, and the circumcircle.
lab::Figure figure() {
  lab::Figure figure;
  figure.title = "The smallest circle of a triangle";
  figure.caption =
      "Corner c moves to the right. The smallest circle (solid) is the circumcircle (dashed) only "
      "while no angle is obtuse. Hull and farthest-point triangulation, the triangle, are "
      "constant.";
  figure.width = 840;
  figure.height = 330;
  std::string& script = figure.script;
  script =
      "set multiplot layout 1,3\nset parametric\nset trange [0:2*pi]\nset samples 200\nunset key\n"
      "unset border\nunset tics\nset size ratio -1\nset xrange [-2.6:6.2]\nset yrange [-4.4:7]\n";
  struct Panel {
    const char *title, *corner;
    double x, cx, cy, r, ox, oy, outer;
  };
  const Panel panels[] = {
      {"t = 1: on bc", "c", -1, 1.5, 0.5, 2.549510, 2, 3, 3.605551},
      {"t = 17/8: on abc", "c", 0.125, 2, 0.257812, 2.016548, 2, 0.257812, 2.016548},
      {"t = 4: on ab", "c", 2, 2, 0, 2, 2, -1.5, 2.5}};
  for (const Panel& p : panels) {
    script += fmt::format(
        "set title '{}'\nunset label\nset label 1 'a' at 0,0 offset -1.5,-0.6\n"
        "set label 2 'b' at 4,0 offset 0.6,-0.6\nset label 3 '{}' at {},1 offset -0.6,0.9\n"
        "plot {}+{}*cos(t),{}+{}*sin(t) w l lw 1.2 dt 2 lc rgb '{}', "
        "{}+{}*cos(t),{}+{}*sin(t) w l lw 2 lc rgb '{}', "
        "'-' w lp lw 1.2 pt 7 ps 0.6 lc rgb '#222222'\n0 0\n4 0\n{} 1\n0 0\ne\n",
        p.title, p.corner, p.x, p.ox, p.outer, p.oy, p.outer, lab::look(1).colour, p.cx, p.r, p.cy,
        p.r, lab::look(0).colour, p.x);
  }
  script += "unset multiplot\n";
  return figure;
}

}  // namespace

lab::PartReport kds_section_6_report(const lab::StudyResult& result, const std::string& command) {
  lab::PartReport report;
  if (result.table.rows.empty()) return report;
  const std::vector<std::string>& first = result.table.rows.front();
  const std::vector<std::string>& last = result.table.rows.back();
  lab::PaperClaim circle;
  circle.id = "section-6.smallest-circumcircle";
  circle.statement =
      "The smallest enclosing circle is the smallest circumcircle of a triangle of the "
      "farthest-point Delaunay triangulation.";
  circle.expected = "equal squared radii, at any time";
  circle.observed =
      fmt::format("at t = {} the circle is on {}, of squared radius {}; the only triangle has {}",
                  first[kTime], first[kCircle], first[kRadius], first[kTriangle]);
  circle.verdict =
      first[kRadius] == first[kTriangle] ? lab::Verdict::kConfirmed : lab::Verdict::kRefuted;
  circle.assumptions = {"none; it holds where three points determine the circle"};
  circle.counterexample =
      "an obtuse triangle: its smallest enclosing circle has the longest side as a diameter";

  lab::PaperClaim changes;
  changes.id = "section-6.changes-with-the-triangulation";
  changes.statement =
      "The smallest enclosing circle cannot change while the hull and the farthest-point Delaunay "
      "triangulation do not.";
  changes.expected = "0 changes of the circle, for 0 of the hull and 0 of the triangulation";
  changes.observed =
      fmt::format("{} changes of the circle, {} of the triangulation, {} of the hull",
                  last[kCircles], last[kFlips], last[kHulls]);
  changes.verdict = last[kCircles] != "0" && last[kFlips] == "0" && last[kHulls] == "0"
                        ? lab::Verdict::kRefuted
                        : lab::Verdict::kConfirmed;
  changes.counterexample =
      "a corner that passes beside the other two: the triangle is obtuse, acute, obtuse, acute and "
      "obtuse";
  changes.assumptions = {"the set of points on the circle is its combinatorial description"};
  for (lab::PaperClaim* claim : {&circle, &changes}) {
    claim->place = "section 6.9";
    claim->kind = "finding";
    claim->command = command;
    claim->tolerance = "none";
    claim->small_run.structure = kMaintained.back();
    claim->small_run.workload = kWorkload;
    claim->small_run = lab::small_run(std::move(claim->small_run));
    report.claims.push_back(std::move(*claim));
  }
  report.figures.push_back(figure());
  report.figure_names.push_back("section-6-circle");
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
