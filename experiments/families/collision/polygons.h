// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the families of rigid polygons: nearly regular polygons with rational vertices on
// a circle, rotors of many turns, paths of straight lines. No floating point.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_POLYGONS_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_POLYGONS_H

#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/lab/workload.h"

namespace kinex {

using Coefficients = std::vector<Rational>;

// Vertices exactly on the circle, counter-clockwise from (radius, 0), their angles within about
// 2^-39 of those of the regular polygon; quarter turns are exact. n >= 3.
std::vector<Vertex2> regular_polygon(int n, const Rational& radius);
// The largest y of a vertex.
Rational top_of(const std::vector<Vertex2>& polygon);

// A rotor in one piece of time.
struct RotorPiece {
  std::optional<Rational> from, to;
  Coefficients p, q;
};
// `count` half turns of a body, that is, quarter turns of the rotor's argument, counter-clockwise,
// in the time from 0 to `span`; each in a piece of its own and linear in t. The first and the last
// piece are extended for all time. count >= 1.
std::vector<RotorPiece> half_turns(int count, const Rational& span);
// The rotors of one body turned twice: the products of both, in the pieces of `fine`. Requires that
// `fine` refines `coarse`.
std::vector<RotorPiece> composed(const std::vector<RotorPiece>& fine,
                                 const std::vector<RotorPiece>& coarse);

// A body that stays at (x, y) and turns.
void add_turning_body(Scene& scene, std::string id, std::vector<Vertex2> polygon, const Rational& x,
                      const Rational& y, const std::vector<RotorPiece>& rotor);
// A body with one flight plan.
void add_body(Scene& scene, std::string id, std::vector<Vertex2> polygon, Coefficients x,
              Coefficients y, Coefficients p = {1}, Coefficients q = {0});
// A body that is at points[i] at t = i, and moves in straight lines without turning. At least two
// points.
void add_body_on_polyline(Scene& scene, std::string id, std::vector<Vertex2> polygon,
                          const std::vector<Vertex2>& points);

// All families of rigid polygons.
const std::vector<Workload>& polygon_workloads();

// polygon_orbits.cpp: two nearly regular polygons of radius 1
void generate_polygon_orbit(const WorkloadParameters&, Scene&);
void generate_polygon_orbit_arcs(const WorkloadParameters&, Scene&);
void generate_polygon_spin_orbit(const WorkloadParameters&, Scene&);
void generate_polygon_gears(const WorkloadParameters&, Scene&);
void generate_polygon_line(const WorkloadParameters&, Scene&);
// polygon_fans.cpp: a turning polygon before a fan of nearly parallel edges
void generate_polygon_fan(const WorkloadParameters&, Scene&);
void generate_polygon_tangents(const WorkloadParameters&, Scene&);
// polygon_paths.cpp: paths of straight lines
void generate_polygon_jitter(const WorkloadParameters&, Scene&);
void generate_polygon_kinks(const WorkloadParameters&, Scene&);
void generate_polygon_approach(const WorkloadParameters&, Scene&);
// polygon_random.cpp
void generate_polygon_random(const WorkloadParameters&, Scene&);
void generate_polygons_in_box(const WorkloadParameters&, Scene&);

}  // namespace kinex

#endif
