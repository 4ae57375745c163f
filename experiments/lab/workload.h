// SPDX-License-Identifier: GPL-3.0-or-later
// Workloads: named generators of scenes. The same name, parameters and seed give the same scene, byte
// by byte, on every machine: only integers are drawn, and nothing is computed in floating point.
#ifndef KINEX_EXPERIMENTS_LAB_WORKLOAD_H
#define KINEX_EXPERIMENTS_LAB_WORKLOAD_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/descriptor.h"

namespace kinex::lab {

struct WorkloadParameters {
  int n = 100;             // the size: objects, or what the workload says; >= 1
  int m = 0;               // a second size, if the workload has one; 0: the workload's default
  std::uint64_t seed = 1;  // ignored by workloads without random numbers
  int degree = 1;          // of the motion, if the workload has a choice
  int dimension = 0;       // 0: the workload's default
  std::optional<Rational> separation = std::nullopt;  // of two bodies; nullopt: the default
  int turns = -1;                                     // -1: once
};

// What makes the scenes of a workload easy or hard.
enum class SceneKind {
  kWorst,     // many events by construction; everything else
  kRandom,    // random motion in general position
  kTies,      // simultaneous and degenerate events
  kNewPlans,  // flight plans that change, objects that come and go
};

struct Workload {
  std::string_view name;
  std::string_view summary;  // one line
  int default_dimension;
  int min_dimension, max_dimension;
  bool random;  // takes a seed
  bool takes_degree;
  bool takes_m;
  std::string_view maintain;  // "": the usual one (family.h)
  // Fills time and objects. Requires valid parameters with their dimension set.
  void (*generate)(const WorkloadParameters&, Scene&);
  int min_n = 1, min_m = 1;
  int default_m = 0;                                  // 0: same as n
  bool bodies = false;                                // rigid polygons, not points
  std::optional<Rational> separation = std::nullopt;  // the default, if the family takes one
  bool takes_turns = false;
  int min_turns = 1;
  std::optional<Rational> min_separation = std::nullopt;  // nullopt: anything above 0
  std::optional<Rational> max_separation = std::nullopt;  // nullopt: any
  SceneKind scenes = SceneKind::kWorst;
  int default_n = 100;
  std::string_view n_counts = "objects";  // what --n is the number of
  std::string_view m_counts = "";         // the same of --m
};

// Sets the kind of the scenes of these workloads among `all`.
void set_kind(std::vector<Workload>& all, SceneKind kind,
              const std::vector<std::string_view>& names);
// Sets what the sizes of these workloads are the numbers of.
struct SizeWords {
  std::string_view name, n, m = "";
};
void set_sizes(std::vector<Workload>& all, const std::vector<SizeWords>& words);

inline constexpr int kMaxWorkloadSize = 10000000;
inline constexpr int kMaxWorkloadDegree = 20;
inline constexpr int kMaxWorkloadTurns = 100000;

// Those of all families, in the order in which users see them.
const std::vector<Workload>& workloads();
const Workload* find_workload(std::string_view name);

// The parameters with the workload's defaults in place of those that were left out. Throws
// InputError for parameters that the workload does not have or allow; its place is the option of
// `kinex gen`, for example "--n".
WorkloadParameters resolved(const Workload& workload, WorkloadParameters parameters);

// The scene, named after its parameters, with the workload's default structure in `maintain`.
// Throws as resolved() does.
Scene generate_scene(const Workload& workload, WorkloadParameters parameters);
// Makes the points of a scene of one axis edges of a graph, if they are none: the k-th joins the
// k-th pair of vertices in the order 01, 02, 12, 03, 13, .. (n(n-1)/2 points: a complete graph).
void join_vertices(Scene& scene);
// Makes the points of a scene discs or boxes, if they are points: the radii, or half extents, are
// constants from a twelfth to a third of the largest distance that two of the n points have along an
// axis at the start, divided by the root of n (of the next power of two). Or gives the points weights:
// the squares of such radii.
void give_extents(Scene& scene, Extents extents);
// Makes the points of a plane scene lines y = a x + b with (a, b) in the place of (x, y), if none is
// one: all of them, or with points every second one.
void make_lines(Scene& scene, LineUse lines);
// The same for a workload by its name, with this structure alone to maintain; its points are edges
// if the structure is for graphs, discs, boxes or lines if it is for these. Throws std::invalid_argument for an unknown workload.
Scene generate_scene(std::string_view workload, const WorkloadParameters& parameters,
                     std::string_view structure);

}  // namespace kinex::lab

#endif
