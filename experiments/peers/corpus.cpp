// SPDX-License-Identifier: GPL-3.0-or-later
// Failures as queries: reported to the libraries' authors, or observed.
#include <numbers>

#include "experiments/peers/case.h"

namespace kinex::peers {

namespace {

PeerShape box(double half_width, double half_height) {
  return {{-half_width, -half_height},
          {half_width, -half_height},
          {half_width, half_height},
          {-half_width, half_height}};
}

PeerCase one_step(std::string name, PeerShape a, PeerShape b, const PeerPose& from,
                  const PeerPose& to) {
  return {"corpus", std::move(name), std::move(a), std::move(b), {{{}, from}, {{}, to}}};
}

}  // namespace

std::vector<PeerCase> corpus_cases() {
  std::vector<PeerCase> cases;
  for (const int n : {8, 16, 64, 200, 255}) {
    PeerCase spin = spin_case(n, 1);
    spin.family = "corpus";
    spin.name = std::to_string(n) + "-gon flies by, turns 6 rad";
    cases.push_back(std::move(spin));
  }
  const double pi = std::numbers::pi;
  // The bar turns by nearly a whole turn or a half one, and is clear of the post at both ends.
  cases.push_back(one_step("bar turns 360 degrees past a post", box(0.25, 0.25), box(2, 0.03125),
                           {0, 1.5, 0}, {0, 1.5, 2 * pi}));
  cases.push_back(one_step("bar turns 180 degrees past a post", box(0.25, 0.25), box(2, 0.03125),
                           {0, 1.5, 0}, {0, 1.5, pi}));
  // Thin plates face each other.
  cases.push_back(one_step("thin plates through each other", box(0.01, 1), box(0.01, 1), {-5, 0, 0},
                           {5, 0.5, 0}));
  cases.push_back(one_step("cubes head-on (fcl 555)", box(1, 1), box(1, 1), {-5, 0, 0}, {5, 0, 0}));
  cases.push_back(one_step("octagon by its corner", regular_shape(8), regular_shape(8),
                           {-20, 1.95, 0}, {20, 1.95, 0}));
  // Its lower side ends 0.01 inside the plate.
  cases.push_back(one_step("box sinks into a long plate", box(50, 0.5), box(0.25, 0.25),
                           {-40, 0.76, 0}, {40, 0.74, 0}));
  cases.push_back(one_step("boxes overlap by 0.1 at rest (libccd 25)", box(1, 1), box(1, 1),
                           {1.9, 0, 0}, {1.9, 0, 0}));
  cases.push_back(one_step("boxes 1e-9 apart at rest", box(1, 1), box(1, 1), {2 + 1e-9, 0.25, 0},
                           {2 + 1e-9, 0.25, 0}));
  cases.push_back(one_step("4096-gons overlap by 1e-6 at rest", regular_shape(4096),
                           regular_shape(4096), {2 - 1e-6, 0, 0}, {2 - 1e-6, 0, 0}));
  return cases;
}

}  // namespace kinex::peers
