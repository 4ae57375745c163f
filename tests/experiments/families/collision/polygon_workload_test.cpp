// SPDX-License-Identifier: GPL-3.0-or-later
// The families of rigid polygons keep what their headers promise.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/families/collision/contact_witness.h"
#include "experiments/families/collision/polygons.h"
#include "experiments/formats/angles.h"
#include "experiments/formats/placed_body.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/workload.h"
#include "tests/experiments/expect_input_error.h"
#include "tests/sanitized.h"

namespace kinex {
namespace polygon_workload_test {

Rational fraction_of(std::int64_t p, std::int64_t q) { return Rational(Integer(p), Integer(q)); }

Scene generate(std::string_view name, int n, int m = 0,
               std::optional<Rational> separation = std::nullopt, int turns = -1,
               std::uint64_t seed = 1, int degree = 1) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  parameters.seed = seed;
  parameters.degree = degree;
  parameters.separation = std::move(separation);
  parameters.turns = turns;
  return lab::generate_scene(*lab::find_workload(name), parameters);
}

formats::Polygon2 at(const Scene& scene, std::size_t object, const Rational& t) {
  const SceneObject& body = scene.objects[object];
  return formats::placed_polygon(body.polygon, body.motion.piece_after(t)->trajectory, t);
}

// Where the second body is in the frame of the first, and how it is turned there: its rotor's
// argument, doubled.
struct Relative {
  Rational x, y;
  double turn;
};
Relative relative(const Scene& scene, const Rational& t) {
  const Trajectory& a = scene.objects[0].motion.piece_after(t)->trajectory;
  const Trajectory& b = scene.objects[1].motion.piece_after(t)->trajectory;
  const auto get = [&](const Trajectory& of, int axis) { return of.position(axis, t); };
  const Rational p = get(a, 2), q = get(a, 3), n = p * p + q * q;
  const Rational c = (p * p - q * q) / n, s = Rational(2) * p * q / n;
  const Rational dx = get(b, 0) - get(a, 0), dy = get(b, 1) - get(a, 1);
  const Rational re = p * get(b, 2) + q * get(b, 3), im = p * get(b, 3) - q * get(b, 2);
  return {c * dx + s * dy, c * dy - s * dx, 2 * std::atan2(im.to_double(), re.to_double())};
}

Rational squared(const Relative& r) { return r.x * r.x + r.y * r.y; }

TEST(PolygonWorkload, RegularPolygonsAreOnTheirCircle) {
  for (const int n : {3, 4, 5, 7, 8, 100, 1001}) {
    const Rational radius = fraction_of(3, 2);
    const std::vector<Vertex2> polygon = families::regular_polygon(n, radius);
    ASSERT_EQ(polygon.size(), static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
      const Vertex2& v = polygon[static_cast<std::size_t>(k)];
      EXPECT_EQ(v[0] * v[0] + v[1] * v[1], radius * radius);
      const double angle = 2 * M_PI * k / n;
      EXPECT_NEAR(v[0].to_double(), 1.5 * std::cos(angle), 1e-11) << n << " " << k;
      EXPECT_NEAR(v[1].to_double(), 1.5 * std::sin(angle), 1e-11) << n << " " << k;
    }
  }
  EXPECT_EQ(families::regular_polygon(4, 1), (formats::Polygon2{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}));
}

TEST(PolygonWorkload, FixedPointFunctions) {
  EXPECT_NEAR(formats::approximate_pi().to_double(), M_PI, 1e-15);
  for (const int k : {0, 1, 2, 9, 100, 12345}) {
    EXPECT_NEAR(formats::approximate_root(fraction_of(k, 7)).to_double(), std::sqrt(k / 7.0), 1e-14);
  }
  for (int k = 0; k <= 20; ++k) {
    const formats::CosSin turn = formats::approximate_cos_sin(fraction_of(k, 10));
    EXPECT_NEAR(turn.cos.to_double(), std::cos(k / 10.0), 1e-15);
    EXPECT_NEAR(turn.sin.to_double(), std::sin(k / 10.0), 1e-15);
  }
}

TEST(PolygonWorkload, EveryFamilyIsApartAndWritesBack) {
  for (const lab::Workload& workload : families::polygon_workloads()) {
    for (const int n : {3, 5, 12}) {
      Scene scene = generate(workload.name, n);
      scene.maintain.clear();
      const std::string text = formats::write_scene(scene);
      EXPECT_EQ(formats::write_scene(formats::parse_scene(text, "again")), text) << workload.name;  // checks contacts
    }
  }
}

TEST(PolygonWorkload, OrbitIsAnExactCircle) {
  const Rational separation = fraction_of(1, 1000);
  const Scene scene = generate("polygon-orbit", 12, 7, separation, 3);
  EXPECT_EQ(scene.objects[1].motion.pieces.size(), 6u);
  const Rational r = Rational(2) + separation;
  double angle = 0, last = 0;
  for (int k = 0; k < 600; ++k) {
    const Relative here = relative(scene, fraction_of(k, 100));
    EXPECT_EQ(squared(here), r * r);
    EXPECT_NEAR(std::remainder(here.turn, 2 * M_PI), 0, 1e-12);
    const double now = std::atan2(here.y.to_double(), here.x.to_double());
    angle += std::remainder(now - last, 2 * M_PI);
    last = now;
  }
  EXPECT_NEAR(angle, -6 * M_PI, 0.3);  // clockwise
}

TEST(PolygonWorkload, ArcsStayInTheirRing) {
  for (const int inverse : {1, 10, 1000}) {
    const Rational separation = fraction_of(1, inverse);
    const Scene scene = generate("polygon-orbit-arcs", 4, 4, separation);
    const Rational low = Rational(2) + separation;
    const Rational high = low + separation / Rational(10);
    const Integer arcs = scene.end->numerator();
    for (std::int64_t k = 0; k < arcs.to_int64() * 16; ++k) {
      const Relative here = relative(scene, fraction_of(k, 16));
      EXPECT_GE(squared(here), low * low);
      EXPECT_LE(squared(here), high * high);
      EXPECT_EQ(k % 16 == 0, squared(here) == low * low);
    }
  }
}

TEST(PolygonWorkload, SpinOrbitTurnsOnce) {
  for (const int turns : {0, 1, 3}) {
    const Scene scene = generate("polygon-spin-orbit", 4, 4, fraction_of(1, 10), turns);
    double orbit = 0, spin = 0, at_last = 0, turned_last = 0;
    for (int k = 0; k < 400; ++k) {
      const Relative here = relative(scene, fraction_of(k, 200));
      EXPECT_EQ(squared(here), fraction_of(441, 100));
      const double now = std::atan2(here.y.to_double(), here.x.to_double());
      const double step = std::remainder(here.turn - turned_last, 2 * M_PI);
      EXPECT_GE(step, 0);
      EXPECT_LT(step, 0.1);
      orbit += std::remainder(now - at_last, 2 * M_PI);
      spin += step;
      at_last = now;
      turned_last = here.turn;
    }
    EXPECT_NEAR(orbit, -2 * M_PI * turns, 0.3);
    EXPECT_NEAR(spin, 2 * M_PI, 0.1);
  }
}

TEST(PolygonWorkload, LineHasItsClearance) {
  for (const auto& [n, m] : {std::pair{4, 4}, {8, 12}, {5, 7}}) {
    const Rational separation = fraction_of(1, 64);
    const Scene scene = generate("polygon-line", n, m, separation);
    Rational low = at(scene, 1, 0)[0][1], high = at(scene, 0, 0)[0][1];
    for (const Vertex2& v : at(scene, 1, 0)) low = std::min(low, v[1]);
    for (const Vertex2& v : at(scene, 0, 0)) high = std::max(high, v[1]);
    EXPECT_EQ(low - high, separation);
  }
  // The tops are vertices: they meet one above the other.
  const Scene scene = generate("polygon-line", 4, 8, fraction_of(1, 64));
  EXPECT_EQ(formats::squared_distance(at(scene, 0, fraction_of(1, 2)), at(scene, 1, fraction_of(1, 2))),
            fraction_of(1, 64 * 64));
}

// The closest features of two polygons by brute force: (vertex or edge of a, vertex or edge of b),
// edges as n + k.
std::pair<std::size_t, std::size_t> closest(const formats::Polygon2& a, const formats::Polygon2& b) {
  std::pair<std::size_t, std::size_t> best;
  std::optional<Rational> least;
  const auto look = [&](const formats::Polygon2& tips, const formats::Polygon2& edges, bool swapped) {
    for (std::size_t i = 0; i < tips.size(); ++i) {
      for (std::size_t k = 0; k < edges.size(); ++k) {
        const Vertex2 &p = edges[k], &q = edges[(k + 1) % edges.size()];
        const Rational ex = q[0] - p[0], ey = q[1] - p[1];
        const Rational dx = tips[i][0] - p[0], dy = tips[i][1] - p[1];
        const Rational along = ex * dx + ey * dy, length = ex * ex + ey * ey;
        std::size_t feature = edges.size() + k;
        Rational d;
        if (along.sign() <= 0) {
          feature = k;
          d = dx * dx + dy * dy;
        } else if (along >= length) {
          continue;  // the next edge's first end
        } else {
          const Rational across = ex * dy - ey * dx;
          d = across * across / length;
        }
        if (least && !(d < *least)) continue;
        least = d;
        best = swapped ? std::pair{feature, i} : std::pair{i, feature};
      }
    }
  };
  look(a, b, false);
  look(b, a, true);
  return best;
}

// How often the pair that `pair_of` finds changes as the polygon turns by one of its 8 vertices,
// sampled.
template <class PairOf>
int changes_of_a_tooth(const Scene& scene, const PairOf& pair_of) {
  const int samples = test::kSanitized ? 600 : 1500;
  std::optional<std::pair<std::size_t, std::size_t>> last;
  int changes = 0;
  for (int k = 0; k <= samples; ++k) {
    // In the first piece the body is turned by 2 atan(t / (1 - t)): from 0 to 45 degrees.
    const Rational tan = fraction_of(k, samples) * fraction_of(41421356, 100000000);
    const Rational t = tan / (Rational(1) + tan);
    const auto now = pair_of(at(scene, 0, t), at(scene, 1, t));
    changes += last && *last != now;
    last = now;
  }
  return changes;
}

TEST(PolygonWorkload, FanIsCrossedTwicePerVertex) {
  const int n = 8, m = 3;
  const Scene scene = generate("polygon-fan", n, m, 2);
  EXPECT_EQ(changes_of_a_tooth(scene, closest), 3 * m + 2);
}

// The vertices that the inner tangent with b on its left touches: all of a is on its right.
std::pair<std::size_t, std::size_t> tangent(const formats::Polygon2& a, const formats::Polygon2& b) {
  const auto side = [](const Vertex2& p, const Vertex2& q, const Vertex2& v) {
    return ((q[0] - p[0]) * (v[1] - p[1]) - (q[1] - p[1]) * (v[0] - p[0])).sign();
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      bool good = true;
      for (const Vertex2& v : a) good = good && side(a[i], b[j], v) <= 0;
      for (const Vertex2& v : b) good = good && side(a[i], b[j], v) >= 0;
      if (good) return {i, j};
    }
  }
  ADD_FAILURE() << "no tangent";
  return {};
}

TEST(PolygonWorkload, TangentsCrossTheirFanTwicePerVertex) {
  const int n = 8, m = 3;
  const Scene scene = generate("polygon-tangents", n, m, 2);
  EXPECT_EQ(changes_of_a_tooth(scene, tangent), 2 * m + 1);
}

TEST(PolygonWorkload, PathsKeepTheirClearance) {
  const Rational separation = fraction_of(1, 50);
  const Scene kinks = generate("polygon-kinks", 8, 12, separation);
  EXPECT_EQ(kinks.objects[1].motion.pieces.size(), 13u);
  const Scene approach = generate("polygon-approach", 8, 0, separation);
  for (const Scene* scene : {&kinks, &approach}) {
    const std::int64_t steps = scene->end->numerator().to_int64() * 8;
    for (std::int64_t k = 0; k <= steps; ++k) {
      const Rational t = fraction_of(k, 8);
      EXPECT_GE(formats::squared_distance(at(*scene, 0, t), at(*scene, 1, t)),
                scene == &kinks ? separation * separation : separation * separation / Rational(4));
    }
  }
  const Scene jitter = generate("polygon-jitter", 8, 5);
  EXPECT_EQ(jitter.objects[1].motion.pieces.size(), 10u);
  EXPECT_EQ(*jitter.end, Rational(10));
}

TEST(PolygonWorkload, RandomOnesCollideNowAndThen) {
  int contacts = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Scene scene = generate("polygon-random", 5, 6, std::nullopt, -1, seed, 2);
    const auto found = families::find_contacts(scene.objects[0], scene.objects[1], scene.start, scene.end);
    contacts += found.first() != nullptr;
  }
  EXPECT_GT(contacts, 1);
  EXPECT_LT(contacts, 11);
}

TEST(PolygonWorkload, ParametersAreChecked) {
  EXPECT_INPUT_ERROR(generate("polygon-orbit", 2),
                     "polygon-orbit: --n: 2 vertices of one polygon; write a number");
  EXPECT_INPUT_ERROR(generate("polygon-orbit", 4, 2), "--m: 2 vertices");
  EXPECT_INPUT_ERROR(generate("polygon-orbit", 4, 4, Rational(0)),
                     "--separation: 0 is no distance");
  EXPECT_INPUT_ERROR(generate("polygon-orbit", 4, 4, Rational::parse("-1e99999").value()),
                     "--separation: about -1e+99999 is no distance; write");
  EXPECT_INPUT_ERROR(generate("polygon-orbit", 4, 4, Rational(1), 0), "--turns: 0 turns");
  EXPECT_INPUT_ERROR(generate("polygon-fan", 4, 4, Rational(1), 2),
                     "--turns: this workload takes none");
  EXPECT_INPUT_ERROR(generate("polygon-jitter", 4, 4, Rational(1)), "--separation: this workload");
  EXPECT_INPUT_ERROR(generate("polygon-tangents", 4, 4, fraction_of(1, 10)),
                     "--separation: 1/10 is too near; write 3/4 or more");
  EXPECT_INPUT_ERROR(generate("polygon-approach", 4, 4), "--m: this workload has one size only");
  EXPECT_NO_THROW(generate("polygon-fan", 4, 1));
  EXPECT_NO_THROW(generate("polygons-in-box", 1, 3));
  EXPECT_INPUT_ERROR(generate("polygons-in-box", 4, 4, fraction_of(3, 4)),
                     "--separation: 3/4 is too far; write 11/16 or less");
}

}  // namespace polygon_workload_test
}  // namespace kinex
