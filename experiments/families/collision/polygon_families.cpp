// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/polygons.h"

namespace kinex::families {

namespace {

// Two polygons of n and m vertices, the same if --m is not given.
lab::Workload pair(std::string_view name, std::string_view summary,
              void (*generate)(const lab::WorkloadParameters&, Scene&)) {
  lab::Workload workload{name, summary, 2, 2, 2, false, false, true, "", generate};
  workload.bodies = true;
  workload.min_n = workload.min_m = 3;
  workload.n_counts = "vertices of one polygon";
  workload.m_counts = "vertices of the other";
  return workload;
}

lab::Workload with_separation(lab::Workload workload, const Rational& separation) {
  workload.separation = separation;
  return workload;
}

lab::Workload not_nearer_than(lab::Workload workload, const Rational& separation) {
  workload.min_separation = separation;
  return workload;
}

lab::Workload with_turns(lab::Workload workload, int least) {
  workload.takes_turns = true;
  workload.min_turns = least;
  return workload;
}

// --m counts something other than vertices.
lab::Workload with_count(lab::Workload workload, std::string_view n, std::string_view m) {
  workload.min_m = 1;
  workload.n_counts = n;
  workload.m_counts = m;
  return workload;
}

lab::Workload randomised(lab::Workload workload) {
  workload.random = true;
  return workload;
}

lab::Workload without_m(lab::Workload workload) {
  workload.takes_m = false;
  workload.n_counts = "vertices of each polygon";
  workload.m_counts = "";
  return workload;
}

std::vector<lab::Workload> make() {
  const Rational near(Integer(1), Integer(10));
  lab::Workload random = randomised(pair("polygon-random",
                                    "two random polygons of at most --n and --m vertices, turning",
                                    generate_polygon_random));
  random.takes_degree = true;
  random.n_counts = "vertices of one polygon at most";
  random.m_counts = "vertices of the other at most";
  lab::Workload box = randomised(
      pair("polygons-in-box",
           "--n turning polygons of --m (8) vertices cross a box; at --separation or more "
           "when they start",
           generate_polygons_in_box));
  box.min_n = 1;
  box.n_counts = "polygons";
  box.m_counts = "vertices of each";
  box.default_m = 8;
  box.separation = Rational(Integer(1), Integer(4));
  box.max_separation = Rational(Integer(11), Integer(16));
  return {
      with_turns(
          with_separation(
              pair("polygon-orbit",
                   "polygons of --n and --m vertices; one goes --turns times round the other",
                   generate_polygon_orbit),
              near),
          1),
      not_nearer_than(
          with_separation(pair("polygon-orbit-arcs",
                               "two polygons; one goes once round the other, along parabolic arcs",
                               generate_polygon_orbit_arcs),
                          near),
          Rational(Integer(1), Integer(1000000000000))),
      with_turns(
          with_separation(pair("polygon-spin-orbit",
                               "two polygons; one goes --turns times round the other, while it "
                               "turns once itself",
                               generate_polygon_spin_orbit),
                          near),
          0),
      with_turns(with_separation(
                     pair("polygon-gears",
                          "two polygons turn side by side, one --turns times, the other once more",
                          generate_polygon_gears),
                     near),
                 1),
      with_separation(pair("polygon-line", "two polygons; one passes the other on a line",
                           generate_polygon_line),
                      near),
      with_count(with_separation(pair("polygon-fan",
                                      "n (3m + 2) changes of the closest features of two polygons",
                                      generate_polygon_fan),
                                 2),
                 "vertices of the turning polygon", "edges of the other's fan"),
      not_nearer_than(
          with_count(
              with_separation(
                  pair("polygon-tangents",
                       "n (2m + 1) changes of one inner tangent of two polygons, n of the other",
                       generate_polygon_tangents),
                  2),
              "vertices of the turning polygon", "edges of the other's fan"),
          Rational(Integer(3), Integer(4))),
      with_count(
          pair("polygon-jitter", "two polygons; one trembles --m times", generate_polygon_jitter),
          "vertices of each polygon", "times to and fro"),
      randomised(with_count(
          with_separation(
              pair("polygon-kinks", "two polygons; one walks round the other with --m kinks",
                   generate_polygon_kinks),
              near),
          "vertices of each polygon", "kinks")),
      without_m(
          with_separation(pair("polygon-approach", "two polygons; one swings closer, by halves",
                               generate_polygon_approach),
                          near)),
      random,
      box,
  };
}

}  // namespace

const std::vector<lab::Workload>& polygon_workloads() {
  static const std::vector<lab::Workload> kWorkloads = make();
  return kWorkloads;
}

}  // namespace kinex::families
