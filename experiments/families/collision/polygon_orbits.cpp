// SPDX-License-Identifier: GPL-3.0-or-later
// Two nearly regular polygons of radius 1; one moves round or past the other at a small distance.
//
// Seen from A, B is a point outside their Minkowski sum, which holds the disc of radius
// rho = cos(pi/n) + cos(pi/m) about the centre. A certificate that proves a convex set of positions
// free covers an arc of at most 2 arccos(rho / R) of a path within the radius R. So one round needs
// at least pi / arccos(rho / R) certificates, of the order of sqrt(1 / separation).
//
//        ____.____      R
//      '  ___|___  '    the convex set beyond a tangent of the disc covers this arc of the path
//     . '    |rho  ' .
//    :       +        :
#include "experiments/families/collision/polygons.h"
#include "experiments/formats/angles.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {

// An exact circle: B stays at distance 2 + separation, and both turn alike, so that B goes round in
// A's frame without turning in it. R = 2 + separation. Each round takes the time 2.
void generate_polygon_orbit(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 2 * parameters.turns;
  const auto rotor = half_turns(2 * parameters.turns, *scene.end);
  add_turning_body(scene, "a", regular_polygon(parameters.n, 1), 0, 0, rotor);
  add_turning_body(scene, "b", regular_polygon(parameters.m, 1),
                   Rational(2) + *parameters.separation, 0, rotor);
}

// Nothing turns: one round along parabolic arcs, of degree 2. They touch the circle of radius
// r = 2 + separation at their ends and lie outside it in between: an arc of angle 2a by at most
// r (1 - cos a)^2 / (2 cos a), which is below r a^4 / 7 for a <= pi/8. There are enough arcs to
// keep that within separation / 10, so R = 2 + 11/10 separation.
void generate_polygon_orbit_arcs(const lab::WorkloadParameters& parameters, Scene& scene) {
  const Rational r = Rational(2) + *parameters.separation;
  int arcs = 8;
  for (;; arcs += 4) {
    const Rational a = formats::approximate_pi() / Rational(arcs);
    if (r * a * a * a * a * Rational(10) <= Rational(7) * *parameters.separation) break;
  }
  scene.start = 0;
  scene.end = arcs;
  add_body(scene, "a", regular_polygon(parameters.n, 1), {0}, {0});
  const std::vector<Vertex2> ends = regular_polygon(arcs, r);
  Motion motion;
  for (int i = 0; i < arcs; ++i) {
    const Vertex2& p = ends[static_cast<std::size_t>(i)];
    const Vertex2& q = ends[static_cast<std::size_t>((i + 1) % arcs)];
    // The tangents of the circle at p and q meet at c.
    const Rational scale = r * r / (r * r + p[0] * q[0] + p[1] * q[1]);
    const Rational t = i;
    std::vector<Coefficients> coordinates;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational c = scale * (p[axis] + q[axis]);
      // p + 2 (c - p) u + (p - 2 c + q) u^2 with u = t - i
      const Rational linear = Rational(2) * (c - p[axis]);
      const Rational square = p[axis] - Rational(2) * c + q[axis];
      coordinates.push_back(
          {p[axis] - linear * t + square * t * t, linear - Rational(2) * square * t, square});
    }
    coordinates.push_back({1});
    coordinates.push_back({0});
    MotionPiece piece{std::nullopt, std::nullopt, {std::move(coordinates)}};
    piece.trajectory.normalise();
    if (i > 0) piece.from = t;
    if (i + 1 < arcs) piece.to = t + Rational(1);
    motion.pieces.push_back(std::move(piece));
  }
  scene.objects.push_back({"b", std::move(motion), regular_polygon(parameters.m, 1)});
}

// In A's frame B turns once about its own centre, which goes round on an exact circle `turns`
// times.
void generate_polygon_spin_orbit(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 2;
  const Rational distance = Rational(2) + *parameters.separation;
  std::vector<RotorPiece> rotor = half_turns(2, 2);
  if (parameters.turns == 0) {
    add_body(scene, "a", regular_polygon(parameters.n, 1), {0}, {0});
  } else {
    const std::vector<RotorPiece> orbit = half_turns(2 * parameters.turns, 2);
    add_turning_body(scene, "a", regular_polygon(parameters.n, 1), 0, 0, orbit);
    rotor = composed(orbit, rotor);
  }
  add_turning_body(scene, "b", regular_polygon(parameters.m, 1), distance, 0, rotor);
}

// Both stay in place and turn counter-clockwise: A `turns` times in the time 2, B once more. All
// rotors are linear, in pieces of a half turn. R = 2 + separation.
void generate_polygon_gears(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 2;
  add_turning_body(scene, "a", regular_polygon(parameters.n, 1), 0, 0,
                   half_turns(2 * parameters.turns, 2));
  add_turning_body(scene, "b", regular_polygon(parameters.m, 1),
                   Rational(2) + *parameters.separation, 0,
                   half_turns(2 * parameters.turns + 2, 2));
}

// B passes above A on a horizontal line, at the distance `separation` above the top of their
// Minkowski sum.
void generate_polygon_line(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = 0;
  scene.end = 1;
  std::vector<Vertex2> a = regular_polygon(parameters.n, 1);
  std::vector<Vertex2> b = regular_polygon(parameters.m, 1);
  std::vector<Vertex2> turned = b;
  for (Vertex2& vertex : turned) vertex[1] = -vertex[1];
  const Rational height = top_of(a) + top_of(turned) + *parameters.separation;
  add_body(scene, "a", std::move(a), {0}, {0});
  add_body(scene, "b", std::move(b), {-4, 8}, {height});
}

}  // namespace kinex::families
