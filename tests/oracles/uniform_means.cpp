// SPDX-License-Identifier: GPL-3.0-or-later
// Mean numbers of events of points in uniform motion, by simulations that share nothing with kinex: plain
// doubles, the simplest algorithms, nothing included but the standard library and the files beside it. Origin
// and destination of each point are uniform in the unit square (interval, cube), t runs from 0 to 1.
//
// usage: uniform_means WHAT N SEEDS
//   hull      changes of the convex hull: vertices that enter or leave
//   delaunay  changes of the Delaunay triangulation: flips, vertices that enter or leave its hull
//   heap      exchanges in a binary heap of lines, its largest on top, built bottom up in the order of the lines
//   delaunay_3, regular_2, regular_3
//             changes of the triangulation in space, and of points with weights (lifted_changes.h)
// Prints "WHAT N SEEDS MEAN ERROR": over the seeds 1 to SEEDS, with the standard error of the mean.
//
// The numbers of experiments/families/points/reference_means.cpp are what it prints.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <queue>
#include <random>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tests/oracles/lifted_changes.h"
#include "tests/oracles/polynomials.h"

namespace {

using namespace oracles;

// The first time after `now`, before 1, at which p falls from positive to negative.
std::optional<double> first_fall(const Polynomial& p, double now) {
  std::vector<double> all;
  zeros(p, now, 1, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double next = i + 1 < all.size() ? all[i + 1] : 1;
    if (value(p, all[i] + (next - all[i]) / 2) < 0) return all[i];
  }
  return std::nullopt;
}

struct Point {
  Polynomial x, y;
};
std::vector<Point> random_points(int n, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double x0 = uniform(), y0 = uniform(), x1 = uniform(), y1 = uniform();
    points.push_back({{x0, x1 - x0}, {y0, y1 - y0}});
  }
  return points;
}

// Twice the signed area of abc.
Polynomial turn(const Point& a, const Point& b, const Point& c) {
  return difference(product(difference(b.x, a.x), difference(c.y, a.y)),
                    product(difference(b.y, a.y), difference(c.x, a.x)));
}
// Positive while d is outside the circle of the counter-clockwise abc.
Polynomial outside(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto row = [&](const Point& p) {
    const Polynomial x = difference(p.x, d.x), y = difference(p.y, d.y);
    return std::array{x, y, sum(product(x, x), product(y, y))};
  };
  const auto [ax, ay, az] = row(a);
  const auto [bx, by, bz] = row(b);
  const auto [cx, cy, cz] = row(c);
  const Polynomial inside = sum(sum(product(az, difference(product(bx, cy), product(by, cx))),
                                    product(bz, difference(product(cx, ay), product(cy, ax)))),
                                product(cz, difference(product(ax, by), product(ay, bx))));
  return difference({0}, inside);
}

// The hull as a cycle of points. Whatever changes it, a point crosses the line of an edge first: one inside
// enters there, and a neighbour's crossing makes the vertex between them leave.
std::uint64_t hull_changes(int n, std::uint64_t seed) {
  const std::vector<Point> points = random_points(n, seed);
  const auto is_left = [&](int a, int b, int c) { return value(turn(points[a], points[b], points[c]), 0) > 0; };
  int low = 0;
  for (int i = 1; i < n; ++i) {
    if (points[i].y[0] < points[low].y[0]) low = i;
  }
  struct Edge {
    double time = 2;  // of the next crossing of its line
    int by = -1;
  };
  std::vector<int> hull;  // gift wrapping
  for (int at = low; hull.empty() || at != low;) {
    hull.push_back(at);
    int next = at == 0 ? 1 : 0;
    for (int i = 0; i < n; ++i) {
      if (i != at && i != next && is_left(at, i, next)) next = i;
    }
    at = next;
  }
  const auto crossing = [&](int a, int b, double now) {
    Edge edge;
    for (int p = 0; p < n; ++p) {
      if (p == a || p == b) continue;
      const auto time = first_fall(turn(points[a], points[b], points[p]), now);
      if (time && *time < edge.time) edge = {*time, p};
    }
    return edge;
  };
  std::vector<Edge> edges;  // edge i from hull[i] to its successor
  for (std::size_t i = 0; i < hull.size(); ++i) {
    edges.push_back(crossing(hull[i], hull[(i + 1) % hull.size()], 0));
  }
  for (std::uint64_t changes = 0;; ++changes) {
    const auto first = std::min_element(edges.begin(), edges.end(),
                                        [](const Edge& a, const Edge& b) { return a.time < b.time; });
    if (first->by < 0) return changes;
    const double now = first->time;
    const std::size_t h = hull.size(), i = static_cast<std::size_t>(first - edges.begin());
    const std::size_t j = (i + 1) % h;
    const int p = first->by;
    std::size_t gone = h;
    if (p == hull[(j + 1) % h]) gone = j;
    if (p == hull[(i + h - 1) % h]) gone = i;
    if (gone == h) {
      hull.insert(hull.begin() + static_cast<std::ptrdiff_t>(i) + 1, p);
      edges[i] = crossing(hull[i], p, now);
      edges.insert(edges.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   crossing(p, hull[(i + 2) % hull.size()], now));
    } else {
      hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(gone));
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(gone));
      const std::size_t before = (gone + hull.size() - 1) % hull.size();
      edges[before] = crossing(hull[before], hull[(before + 1) % hull.size()], now);
    }
  }
}

// Triangles as the apex left of each directed edge; the point n is at infinity.
class Delaunay {
 public:
  Delaunay(int n, std::uint64_t seed) : n_(n), points_(random_points(n, seed)) { wrap(); }

  std::uint64_t run() {
    const std::unordered_map<std::uint64_t, int> start = apex_;
    for (const auto& [edge, apex] : start) {
      const int a = static_cast<int>(edge / kSide), b = static_cast<int>(edge % kSide);
      if (a < b) schedule(a, b, 0);
    }
    std::uint64_t changes = 0;
    while (!queue_.empty()) {
      const Failure failure = queue_.top();
      queue_.pop();
      const auto [a, b] = failure.edge;
      const auto live = version_.find(key(a, b));
      if (live == version_.end() || live->second != failure.version) continue;
      flip(a, b, failure.time);
      ++changes;
    }
    return changes;
  }

 private:
  static constexpr std::uint64_t kSide = 1u << 20;
  struct Failure {
    double time;
    std::pair<int, int> edge;
    std::uint64_t version;
    bool operator<(const Failure& other) const {
      return std::pair(other.time, other.edge) < std::pair(time, edge);
    }
  };
  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(a) * kSide + static_cast<std::uint64_t>(b);
  }

  // Positive while the edge ab, with c on its left and d on its right, is Delaunay.
  Polynomial legal(int a, int b, int c, int d) const {
    const auto area = [&](int i, int j, int k) { return turn(points_[i], points_[j], points_[k]); };
    if (d == n_) return area(a, b, c);
    if (c == n_) return area(b, a, d);
    if (a == n_) return area(c, b, d);
    if (b == n_) return area(d, a, c);
    return outside(points_[a], points_[b], points_[c], points_[d]);
  }
  void triangle(int a, int b, int c) {
    apex_[key(a, b)] = c;
    apex_[key(b, c)] = a;
    apex_[key(c, a)] = b;
  }
  // By gift wrapping: the apex of an edge is the point whose circle with it has no other on that side.
  void wrap() {
    int low = 0;
    for (int i = 1; i < n_; ++i) {
      if (points_[i].y[0] < points_[low].y[0]) low = i;
    }
    int next = low == 0 ? 1 : 0;
    for (int i = 0; i < n_; ++i) {
      if (i != low && i != next && at_start(turn(points_[low], points_[i], points_[next]))) next = i;
    }
    std::vector<std::pair<int, int>> open{{low, next}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (apex_.count(key(a, b)) != 0) continue;
      int c = n_;
      for (int i = 0; i < n_; ++i) {
        if (i == a || i == b || !at_start(turn(points_[a], points_[b], points_[i]))) continue;
        if (c == n_ || !at_start(outside(points_[a], points_[b], points_[c], points_[i]))) c = i;
      }
      triangle(a, b, c);
      if (c == n_) continue;
      open.insert(open.end(), {{b, a}, {c, b}, {a, c}});
    }
    // Each hull edge has its triangle with infinity, found from the inside; the first from the outside too.
    if (apex_.count(key(next, low)) == 0) triangle(next, low, n_);
  }
  static bool at_start(const Polynomial& p) { return value(p, 0) > 0; }

  void schedule(int a, int b, double now) {
    if (b < a) std::swap(a, b);
    const std::uint64_t version = ++versions_;
    version_[key(a, b)] = version;
    const auto time = first_fall(legal(a, b, apex_.at(key(a, b)), apex_.at(key(b, a))), now);
    if (time) queue_.push({*time, {a, b}, version});
  }
  void flip(int a, int b, double now) {
    const int c = apex_.at(key(a, b)), d = apex_.at(key(b, a));
    apex_.erase(key(a, b));
    apex_.erase(key(b, a));
    version_.erase(key(std::min(a, b), std::max(a, b)));
    triangle(c, d, b);
    triangle(d, c, a);
    schedule(c, d, now);
    for (const auto& [i, j] : {std::pair(a, c), {c, b}, {b, d}, {d, a}}) schedule(i, j, now);
  }

  int n_;
  std::vector<Point> points_;
  std::unordered_map<std::uint64_t, int> apex_;
  std::unordered_map<std::uint64_t, std::uint64_t> version_;  // of the edge from the smaller end
  std::priority_queue<Failure> queue_;
  std::uint64_t versions_ = 0;
};

std::uint64_t heap_exchanges(int n, std::uint64_t seed) {
  const std::vector<Point> points = random_points(n, seed);
  std::vector<int> heap;
  for (int i = 0; i < n; ++i) heap.push_back(i);
  const auto height = [&](std::size_t place) { return points[heap[place]].x[0]; };
  const std::size_t size = heap.size();
  for (std::size_t root = size / 2; root-- > 0;) {  // bottom up
    for (std::size_t at = root; 2 * at + 1 < size;) {
      std::size_t child = 2 * at + 1;
      if (child + 1 < size && height(child + 1) > height(child)) ++child;
      if (height(child) <= height(at)) break;
      std::swap(heap[at], heap[child]);
      at = child;
    }
  }
  std::vector<double> fails(size, 2);  // of place i below its parent
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>,
                      std::greater<>> queue;
  const auto schedule = [&](std::size_t place, double now) {
    if (place == 0 || place >= size) return;
    const Polynomial lead = difference(points[heap[(place - 1) / 2]].x, points[heap[place]].x);
    fails[place] = first_fall(lead, now).value_or(2);
    if (fails[place] < 2) queue.push({fails[place], place});
  };
  for (std::size_t i = 1; i < size; ++i) schedule(i, 0);
  std::uint64_t exchanges = 0;
  while (!queue.empty()) {
    const auto [time, place] = queue.top();
    queue.pop();
    if (fails[place] != time) continue;
    ++exchanges;
    const std::size_t parent = (place - 1) / 2;
    std::swap(heap[parent], heap[place]);
    for (const std::size_t i : {parent, 2 * parent + 1, 2 * parent + 2, 2 * place + 1, 2 * place + 2}) {
      schedule(i, time);
    }
  }
  return exchanges;
}

}  // namespace

int main(int count, char** words) {
  const std::map<std::string, std::uint64_t (*)(int, std::uint64_t)> simulations{
      {"hull", hull_changes},
      {"delaunay", [](int n, std::uint64_t seed) { return Delaunay(n, seed).run(); }},
      {"heap", heap_exchanges},
      {"delaunay_3", [](int n, std::uint64_t seed) { return lifted_changes(3, false, n, seed); }},
      {"regular_2", [](int n, std::uint64_t seed) { return lifted_changes(2, true, n, seed); }},
      {"regular_3", [](int n, std::uint64_t seed) { return lifted_changes(3, true, n, seed); }}};
  const auto chosen = count == 4 ? simulations.find(words[1]) : simulations.end();
  const int n = count == 4 ? std::atoi(words[2]) : 0, seeds = count == 4 ? std::atoi(words[3]) : 0;
  if (chosen == simulations.end() || n < 4 || seeds < 2) {
    std::fprintf(stderr, "usage: uniform_means WHAT N SEEDS, where WHAT is one of\n");
    for (const auto& [what, changes] : simulations) std::fprintf(stderr, "  %s\n", what.c_str());
    return 2;
  }
  double sum = 0, squares = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto events = static_cast<double>(chosen->second(n, static_cast<std::uint64_t>(seed)));
    sum += events;
    squares += events * events;
  }
  const double mean = sum / seeds;
  const double error = std::sqrt((squares - sum * mean) / (seeds - 1.0) / seeds);
  std::printf("%s %d %d %.6g %.3g\n", words[1], n, seeds, mean, error);
}
