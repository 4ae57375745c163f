// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the families of rigid polygons: nearly regular polygons with rational vertices on
// a circle, rotors of many turns, paths of straight lines. No floating point.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_POLYGONS_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_POLYGONS_H

#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/lab/workload.h"

namespace kinex::families {

using Coefficients = std::vector<Rational>;

// Vertices exactly on the circle, counter-clockwise from (radius, 0). Their angles are within about
// 2^-39 radians of those of the regular polygon; quarter turns are exact. Requires n >= 3.
std::vector<Vertex2> regular_polygon(int n, const Rational& radius);
// The largest y of a vertex.
Rational top_of(const std::vector<Vertex2>& polygon);

// A rotor on [from, to]: coefficients of p and q in t, low degree first.
struct RotorPiece {
  std::optional<Rational> from, to;
  Coefficients p, q;
};
// `count` half turns of a body (quarter turns of the rotor's argument), counter-clockwise, from
// time 0 to `span`. Each is one piece, linear in t. The first and the last piece are unbounded in
// time. Requires count >= 1.
std::vector<RotorPiece> half_turns(int count, const Rational& span);
// The composition of two turns: the products of both rotors, in the pieces of `fine`. Requires that
// the pieces of `fine` refine those of `coarse`.
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
const std::vector<lab::Workload>& polygon_workloads();

// polygon_orbits.cpp: two nearly regular polygons of radius 1
void generate_polygon_orbit(const lab::WorkloadParameters&, Scene&);
void generate_polygon_orbit_arcs(const lab::WorkloadParameters&, Scene&);
void generate_polygon_spin_orbit(const lab::WorkloadParameters&, Scene&);
void generate_polygon_gears(const lab::WorkloadParameters&, Scene&);
void generate_polygon_line(const lab::WorkloadParameters&, Scene&);
// polygon_fans.cpp: a turning polygon in front of a fan of nearly parallel edges
void generate_polygon_fan(const lab::WorkloadParameters&, Scene&);
void generate_polygon_tangents(const lab::WorkloadParameters&, Scene&);
// polygon_paths.cpp: paths of straight lines
void generate_polygon_jitter(const lab::WorkloadParameters&, Scene&);
void generate_polygon_kinks(const lab::WorkloadParameters&, Scene&);
void generate_polygon_approach(const lab::WorkloadParameters&, Scene&);
// polygon_random.cpp
void generate_polygon_random(const lab::WorkloadParameters&, Scene&);
void generate_polygons_in_box(const lab::WorkloadParameters&, Scene&);

}  // namespace kinex::families

#endif
