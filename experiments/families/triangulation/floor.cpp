// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/triangulation/floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/points/floor.h"
#include "experiments/families/points/floor_timetable.h"
#include "experiments/lab/cpu_clock.h"
#include "structures/plan.h"

namespace kinex::families {

namespace floors {

namespace {

// Of the sphere: the vertex at infinity closes it outside of the hull. An edge's certificate says
// that it is locally Delaunay; at the hull that is an orientation.
template <std::size_t D>
class FloorDelaunay {
 public:
  FloorDelaunay(const Scene& scene, double start)
      : x_(coordinates<D>(scene, 0)),
        y_(coordinates<D>(scene, 1)),
        infinite_(static_cast<std::uint32_t>(x_.size())) {
    Simulator simulator(scene, make_arithmetic("exact", scene), {});
    add_structures(simulator, scene);
    simulator.start();
    build(simulator.structure(asked_structure(scene)).attribute().ids, start);
  }

  std::size_t edges() const { return sides_.size(); }

  double failure(std::uint32_t edge, double now, double limit, bool fresh) const {
    const auto [t, i] = sides_[edge];
    const Triangle& triangle = triangles_[t];
    const Triangle& other = triangles_[triangle.next[i]];
    const std::uint32_t a = triangle.vertex[i], b = triangle.vertex[(i + 1) % 3],
                        c = triangle.vertex[(i + 2) % 3], d = other.vertex[place(other, edge)];
    if (d == infinite_) return root(turn(a, b, c), now, limit, fresh);
    if (a == infinite_) return root(turn(d, c, b), now, limit, fresh);
    if (b == infinite_) return root(turn(a, c, d), now, limit, fresh);
    if (c == infinite_) return root(turn(a, d, b), now, limit, fresh);
    return root(outside(a, b, c, d), now, limit, fresh);
  }

  // The edges of the quadrilateral around it are written to `rim`.
  void flip(std::uint32_t edge, std::array<std::uint32_t, 4>& rim) {
    const auto [t, i] = sides_[edge];
    const std::uint32_t u = triangles_[t].next[i];
    const std::uint32_t j = place(triangles_[u], edge);
    const Triangle a = triangles_[t], b = triangles_[u];
    const std::uint32_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const std::uint32_t p = a.vertex[i], v = a.vertex[i1], q = b.vertex[j], w = a.vertex[i2];
    triangles_[t] = {{p, v, q}, {b.next[j1], u, a.next[i2]}, {b.edge[j1], edge, a.edge[i2]}};
    triangles_[u] = {{q, w, p}, {a.next[i1], t, b.next[j2]}, {a.edge[i1], edge, b.edge[j2]}};
    rim = {a.edge[i1], a.edge[i2], b.edge[j1], b.edge[j2]};
    attach(a.next[i1], a.edge[i1], u, 0);
    attach(a.next[i2], a.edge[i2], t, 2);
    attach(b.next[j1], b.edge[j1], t, 0);
    attach(b.next[j2], b.edge[j2], u, 2);
    sides_[edge] = {t, 1};
  }

 private:
  // Counter-clockwise; next and edge [i] are opposite of vertex [i].
  struct Triangle {
    std::array<std::uint32_t, 3> vertex, next, edge;
  };
  struct Side {
    std::uint32_t triangle, place;
  };
  using Area = FloorPolynomial<2 * D + 1>;

  static std::uint32_t place(const Triangle& t, std::uint32_t edge) {
    return t.edge[0] == edge ? 0 : t.edge[1] == edge ? 1 : 2;
  }

  void attach(std::uint32_t neighbour, std::uint32_t edge, std::uint32_t t, std::uint32_t at) {
    triangles_[neighbour].next[place(triangles_[neighbour], edge)] = t;
    sides_[edge] = {t, at};
  }

  template <std::size_t N>
  static double root(const FloorPolynomial<N>& p, double now, double limit, bool fresh) {
    return fresh ? first_root(without_root(p, now), now, limit) : first_root(p, now, limit);
  }

  // Positive: counter-clockwise.
  Area turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return (x_[a] - x_[c]) * (y_[b] - y_[c]) - (x_[b] - x_[c]) * (y_[a] - y_[c]);
  }

  // Positive: d is outside of the circle through a, b, c.
  FloorPolynomial<4 * D + 1> outside(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                     std::uint32_t d) const {
    const Coordinate<D> ax = x_[a] - x_[d], ay = y_[a] - y_[d], bx = x_[b] - x_[d],
                        by = y_[b] - y_[d], cx = x_[c] - x_[d], cy = y_[c] - y_[d];
    const Area bc = cx * by - bx * cy, ca = ax * cy - cx * ay, ab = bx * ay - ax * by;
    return (ax * ax + ay * ay) * bc + (bx * bx + by * by) * ca + (cx * cx + cy * cy) * ab;
  }

  void build(const std::vector<ObjectId>& edges, double start);
  void connect();

  std::vector<Coordinate<D>> x_, y_;
  std::uint32_t infinite_;
  std::vector<Triangle> triangles_;
  std::vector<Side> sides_;  // of an edge: one of its two
};

// From the edges at the start: between two edges that follow each other around a vertex there is a
// triangle, or, where they are half a turn apart or more, the outside.
template <std::size_t D>
void FloorDelaunay<D>::build(const std::vector<ObjectId>& edges, double start) {
  std::vector<std::vector<std::pair<double, std::uint32_t>>> around(x_.size());
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    const ObjectId a = edges[k], b = edges[k + 1];
    const double dx = value(x_[b] - x_[a], start), dy = value(y_[b] - y_[a], start);
    around[a].emplace_back(std::atan2(dy, dx), b);
    around[b].emplace_back(std::atan2(-dy, -dx), a);
  }
  constexpr double kTurn = 6.283185307179586;
  for (std::uint32_t v = 0; v < infinite_; ++v) {
    auto& star = around[v];
    std::sort(star.begin(), star.end());
    for (std::size_t k = 0; k < star.size(); ++k) {
      const auto& [angle, a] = star[k];
      const auto& [following, b] = star[(k + 1) % star.size()];
      const double between = following - angle + (k + 1 < star.size() ? 0 : kTurn);
      if (between >= 0.5 * kTurn) {
        triangles_.push_back({{b, v, infinite_}, {}, {}});
      } else if (v < a && v < b) {
        triangles_.push_back({{v, a, b}, {}, {}});
      }
    }
  }
  connect();
}

template <std::size_t D>
void FloorDelaunay<D>::connect() {
  struct Half {
    std::uint32_t low, high, triangle, place;
    bool operator<(const Half& o) const { return std::pair(low, high) < std::pair(o.low, o.high); }
  };
  std::vector<Half> halves;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles_[t].vertex[(i + 1) % 3];
      const std::uint32_t b = triangles_[t].vertex[(i + 2) % 3];
      halves.push_back({std::min(a, b), std::max(a, b), t, i});
    }
  }
  std::stable_sort(halves.begin(), halves.end());
  for (std::size_t k = 0; k + 1 < halves.size(); k += 2) {
    const Half &a = halves[k], &b = halves[k + 1];
    if (a < b) throw std::logic_error("the floor's triangulation is not closed");
    const auto edge = static_cast<std::uint32_t>(sides_.size());
    triangles_[a.triangle].next[a.place] = b.triangle;
    triangles_[b.triangle].next[b.place] = a.triangle;
    triangles_[a.triangle].edge[a.place] = triangles_[b.triangle].edge[b.place] = edge;
    sides_.push_back({a.triangle, a.place});
  }
}

template <std::size_t D>
lab::BenchRun run_delaunay(const Scene& scene, double start, double end, std::uint64_t most) {
  FloorDelaunay<D> delaunay(scene, start);
  const auto failure = [&](std::uint32_t edge, double now, double limit, bool fresh) {
    return delaunay.failure(edge, now, limit, fresh);
  };
  FloorTimetable times(delaunay.edges(), start, end);
  for (std::uint32_t e = 0; e < delaunay.edges(); ++e) times.renew(e, start, false, failure);

  std::uint64_t events = 0;
  const double begin = lab::cpu_seconds();
  std::uint32_t edge = 0;
  std::array<std::uint32_t, 4> rim{};
  for (double now = start; (most == 0 || events < most) && times.next(edge, now, failure);) {
    ++events;
    delaunay.flip(edge, rim);
    times.renew(edge, now, true, failure);
    for (const std::uint32_t e : rim) times.renew(e, now, false, failure);
    times.note(5, now);
  }
  return {.seconds = lab::cpu_seconds() - begin, .events = events};
}

}  // namespace

}  // namespace floors

lab::BenchRun run_delaunay_floor(const Scene& scene, std::uint64_t most) {
  if (scene.dimension != 2) throw std::invalid_argument("this floor is for the plane");
  return floors::run_of_degree(scene, [&]<std::size_t D>(double start, double end) {
    return floors::run_delaunay<D>(scene, start, end, most);
  });
}

}  // namespace kinex::families
