// SPDX-License-Identifier: GPL-3.0-or-later
// A closest pair, of one colour or two, that changes nm - 1 times, and a spanning tree that changes
// 2nm - 2 times.
#include <algorithm>
#include <cstdint>
#include <string>

#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

namespace {

void add_resting(Scene& scene, int j) {
  lab::add_object(scene, "row" + std::to_string(j), {{Rational(j)}, {Rational(0)}});
}

// The i-th of those that pass a row of m.
void add_passing(Scene& scene, int i, int m) {
  lab::add_object(scene, "p" + std::to_string(i),
                  {{lab::fraction(-std::int64_t{m} * i, 1), Rational(1)}, {lab::fraction(1, 10)}});
}

}  // namespace

// m points rest in a row, 1 apart. n points pass over it at a height of 1/10, one after another, m
// apart, so that right over the row there is one of them, and only one:
//
//      .   -->    .   -->    .   -->
//                 o  o  o  o              m = 4 points at rest, 0 <= t <= nm - 1/2
//
// The moving point over the row forms the closest pair with each point of the row in turn: all nm
// pairs, nm - 1 changes. In the minimum spanning tree it hangs at the nearest point of the row
// while it is near that, and replaces the row's edge while it is between two: at every gap one
// change before and one after the middle.
void generate_pass_along_row(const lab::WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n, m = parameters.m;
  scene.start = 0;
  scene.end = lab::fraction(2 * std::int64_t{n} * m - 1, 2);
  for (int j = 0; j < m; ++j) add_resting(scene, j);
  for (int i = 0; i < n; ++i) add_passing(scene, i, m);
}

// The same with colours: the row of m is red, the n that pass it are blue. They are in turn as long as there
// are both, so that of as many the two colours are also the objects at even and at odd places. All nm pairs
// are the closest of two colours in turn: nm - 1 changes. In the maximum norm the lengths are max(|x|, 1/10)
// for the differences x along the row, of which only one is at most 1/10 at any time: as many changes, at the
// same instants.
void generate_colours_along_row(const lab::WorkloadParameters& parameters, Scene& scene) {
  const int n = parameters.n, m = parameters.m;
  scene.start = 0;
  scene.end = lab::fraction(2 * std::int64_t{n} * m - 1, 2);
  for (int i = 0; i < std::max(n, m); ++i) {
    if (i < m) {
      add_resting(scene, i);
      scene.objects.back().colour = "red";
    }
    if (i < n) {
      add_passing(scene, i, m);
      scene.objects.back().colour = "blue";
    }
  }
}

}  // namespace kinex::families
