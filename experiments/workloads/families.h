// SPDX-License-Identifier: GPL-3.0-or-later
// The generators behind the names of workload.h, and their common parts.
#ifndef KINEX_EXPERIMENTS_WORKLOADS_FAMILIES_H
#define KINEX_EXPERIMENTS_WORKLOADS_FAMILIES_H

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/workload.h"

namespace kinex {

// std::mt19937_64 is specified bit by bit; the standard's distributions are not, hence these.
class WorkloadRandom {
 public:
  explicit WorkloadRandom(std::uint64_t seed) : engine_(seed) {}
  // Uniform in [0, bound), bound > 0.
  std::uint64_t below(std::uint64_t bound) {
    const std::uint64_t rejected = (~bound + 1) % bound;  // 2^64 mod bound
    for (;;) {
      const std::uint64_t drawn = engine_();
      if (drawn >= rejected) return drawn % bound;
    }
  }
  // Uniform in [low, high].
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }

 private:
  std::mt19937_64 engine_;
};

// Coordinates are multiples of 2^-20.
inline constexpr std::int64_t kGridUnits = std::int64_t{1} << 20;
inline Rational on_grid(std::int64_t units) {
  return Rational(Integer(units), Integer(kGridUnits));
}
inline Rational fraction(std::int64_t p, std::int64_t q) {
  return Rational(Integer(p), Integer(q));
}

inline void add_object(Scene& scene, std::string id,
                       std::vector<std::vector<Rational>> coordinates) {
  Trajectory trajectory{std::move(coordinates)};
  trajectory.normalise();
  Motion motion;
  motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
  scene.objects.push_back({std::move(id), std::move(motion)});
}

// uniform.cpp: origin and destination at random, t in [0, 1]
void generate_uniform_square(const WorkloadParameters&, Scene&);
void generate_uniform_disk(const WorkloadParameters&, Scene&);
void generate_gaussian(const WorkloadParameters&, Scene&);
// lattices.cpp
void generate_grid(const WorkloadParameters&, Scene&);
void generate_lattice(const WorkloadParameters&, Scene&);
// worst_1d.cpp: the largest numbers of events of sorting and of two structures for a maximum
void generate_sort_worst(const WorkloadParameters&, Scene&);
void generate_tournament_worst(const WorkloadParameters&, Scene&);
void generate_heap_worst(const WorkloadParameters&, Scene&);
// hull_worst.cpp
void generate_hull_worst(const WorkloadParameters&, Scene&);
// meetings.cpp: degenerate at t = 1/2, or nearly so
void generate_meet(const WorkloadParameters&, Scene&);
void generate_through_one_point(const WorkloadParameters&, Scene&);
void generate_near_one_point(const WorkloadParameters&, Scene&);
void generate_collinear_instant(const WorkloadParameters&, Scene&);
// circles.cpp: degenerate at all times
void generate_counter_rotating_rings(const WorkloadParameters&, Scene&);
void generate_expanding_circle(const WorkloadParameters&, Scene&);
void generate_rotating_circle(const WorkloadParameters&, Scene&);
// static_one_mover.cpp
void generate_static_one_mover(const WorkloadParameters&, Scene&);
// changes.cpp: flight plans that change, objects that come and go
void generate_new_plans(const WorkloadParameters&, Scene&);
void generate_come_and_go(const WorkloadParameters&, Scene&);

}  // namespace kinex

#endif
