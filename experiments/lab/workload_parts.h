// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the generators of workloads: random numbers that are the same everywhere,
// coordinates on a grid, objects with one flight plan.
#ifndef KINEX_EXPERIMENTS_LAB_WORKLOAD_PARTS_H
#define KINEX_EXPERIMENTS_LAB_WORKLOAD_PARTS_H

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::lab {

// std::mt19937_64 is specified bit by bit; the standard's distributions are not. These are.
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

// A linear congruential generator that every program can repeat: s := (1103515245 s + 12345) mod 2^31
// from s = seed; each number is floor(s / 2^16).
class RepeatableNumbers {
 public:
  explicit RepeatableNumbers(std::uint64_t seed) : state_(seed) {}
  std::int64_t next() {
    state_ = (1103515245 * state_ + 12345) % (std::uint64_t{1} << 31);
    return static_cast<std::int64_t>(state_ >> 16);
  }
  // A position, next() mod 100, and a velocity, (next() mod 41) - 20.
  std::vector<Rational> line() {
    const std::int64_t position = next() % 100, velocity = next() % 41 - 20;
    return {Rational(position), Rational(velocity)};
  }

 private:
  std::uint64_t state_;
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

}  // namespace kinex::lab

#endif
