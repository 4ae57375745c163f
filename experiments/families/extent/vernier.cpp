// SPDX-License-Identifier: GPL-3.0-or-later
// A diameter that changes nm - 1 times, and a width and rectangles that change 2nm - n - m times.
#include <string>
#include <utility>

#include "experiments/families/extent/calipers_experiments.h"
#include "experiments/lab/workload_parts.h"

namespace kinex::families {
namespace {

// The point of the unit circle at the angle 2 atan q.
std::pair<Rational, Rational> on_circle(const Rational& q) {
  const Rational all = Rational(1) + q * q;
  return {(Rational(1) - q * q) / all, Rational(2) * q / all};
}

}  // namespace

// With u(q) = on_circle(q) and D = m n^2, n points A_i = -u(i/D) are at rest, and m points B_j move
// with unit speed along the tangents of the unit circle in u(-jn/D), where they are at t = 0.
//
// Proof. |B_j|^2 = 1 + t^2 for all j. With x = atan t and the angles f_i of -A_i and g_j of the
// tangent's point, clockwise, |A_i B_j|^2 = 2 + t^2 + 2 sqrt(1 + t^2) cos(x - (f_i + g_j)). The nm
// sums f_i + g_j are different, since D^2 > j(j+1) n^2 (n-1), and lie in [0, 60) degrees; x passes
// all of them. The farthest of these pairs is that whose sum is nearest to x, each once: nm - 1
// changes. Pairs of two A or two B are shorter: at most 1, and less than 0.95 sqrt(1 + t^2).
void generate_vernier(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, m = parameters.m, d = m * n * n;
  scene.start = Rational(-1000000);
  scene.end = Rational(1000000);
  for (std::int64_t i = 0; i < n; ++i) {
    const auto [x, y] = on_circle(Rational(Integer(i), Integer(d)));
    lab::add_object(scene, "a" + std::to_string(i), {{-x}, {-y}});
  }
  for (std::int64_t j = 0; j < m; ++j) {
    const auto [x, y] = on_circle(Rational(Integer(-j * n), Integer(d)));
    lab::add_object(scene, "b" + std::to_string(j), {{x, -y}, {y, x}});
  }
}

// The points at rest turned by 90 degrees about the centre: (x, y) to (-y, x). Their n - 1 edges become
// perpendicular to the m - 1 edges of the moving points at the instants at which they are antiparallel
// in the vernier: (n - 1)(m - 1) times. Of the two edges that join the points at rest to the moving ones
// it has been counted, not proved, that they are perpendicular 2m times to some edge, and that the
// contacts change m(n + 2) times in all.
void generate_vernier_turned(const lab::WorkloadParameters& parameters, Scene& scene) {
  generate_vernier(parameters, scene);
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    auto& axes = scene.objects[static_cast<std::size_t>(i)].motion.pieces[0].trajectory.coordinates;
    std::swap(axes[0], axes[1]);
    for (Rational& c : axes[0]) c = -c;
  }
}

// n tips pass below a polygonal arc of m edges, one after another. With G = 1/(100 T^2) for the end
// T = n(m - 1), s = G/(100000 m) and T_i = (m - 1)(i + 1/2):
//
//   arc    p_j = (j, s j (m - j)), j = 0 .. m                 at rest
//   far    (-F, -1/10), (F, -1/10)                            at rest; F = 1000, or 2 (T + m) if T + m
//                                                             is 1000 or more
//   tips   A_i = (t - T_i + m/2, -1 + G T_i^2 - 2 G T_i t)    i = 0 .. n - 1
//
// Proof. A strip is narrowest where its width, as a function of the direction, stops falling and
// begins to rise: at an edge whose antipodal vertex is above it. While tip i is the lowest these
// are the edges of the arc: the distance of the tip from each is linear in t, and least while the
// tip is below its middle, so there are m - 1 changes. From tip i to tip i + 1 the edge of the two
// is antiparallel to the arc's edges, from the right to the left, and the strip lies on it
// meanwhile, opposite to p_(m-1) .. p_1: m changes. Together n(m - 1) + (n - 1)m. The rectangles
// touch the far points, so their extents along the edges are constants L_j that differ by far less
// than s; area L_j D_j and half perimeter L_j + D_j change as the distances D_j do. (Tips come T + m/2
// far from the arc: with F = 1000 and n = m = 48 rectangles touch them, and areas change 4518 times
// instead of 4512.)
void generate_comb(const lab::WorkloadParameters& parameters, Scene& scene) {
  const std::int64_t n = parameters.n, m = parameters.m, end = n * (m - 1);
  const Rational g(Integer(1), Integer(100 * end * end));
  const Rational s = g / Rational(Integer(100000 * m));
  scene.start = 0;
  scene.end = Rational(Integer(end));
  for (std::int64_t j = 0; j <= m; ++j) {
    lab::add_object(scene, "p" + std::to_string(j),
                    {{Rational(Integer(j))}, {s * Rational(Integer(j * (m - j)))}});
  }
  // Farther than any tip comes.
  const Rational far(Integer(end + m < 1000 ? 1000 : 2 * (end + m)));
  const Rational low(Integer(-1), Integer(10));
  lab::add_object(scene, "west", {{-far}, {low}});
  lab::add_object(scene, "east", {{far}, {low}});
  for (std::int64_t i = 0; i < n; ++i) {
    const Rational at(Integer((m - 1) * (2 * i + 1)), Integer(2));
    lab::add_object(scene, "tip" + std::to_string(i),
                    {{Rational(Integer(m), Integer(2)) - at, Rational(1)},
                     {g * at * at - Rational(1), Rational(-2) * g * at}});
  }
}

// n points that are all at the origin at t = 0: what is extreme in one direction before is extreme
// in the opposite one afterwards, and no pair, strip or rectangle changes.
void generate_through_point(const lab::WorkloadParameters& parameters, Scene& scene) {
  scene.start = Rational(-1);
  scene.end = Rational(1);
  for (std::int64_t i = 0; i < parameters.n; ++i) {
    const std::int64_t s = i * i;
    lab::add_object(scene, "p" + std::to_string(i),
                    {{Rational(0), Rational(Integer((17 * s + 5 * i + 3) % 21 - 10))},
                     {Rational(0), Rational(Integer((19 * s + 7 * i + 1) % 23 - 11))}});
  }
}

}  // namespace kinex::families
