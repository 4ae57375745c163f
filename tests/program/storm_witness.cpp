// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/program/storm_witness.h"

#include <gmp.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace kinex {

namespace {

using Wide = __int128;

int sign(Wide value) { return (value > 0) - (value < 0); }

std::int64_t tenths(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos || point + 2 != text.size()) throw std::runtime_error(text);
  return std::stoll(text.substr(0, point) + text.substr(point + 1));
}

std::int64_t units(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::int64_t denominator =
      slash == std::string::npos ? 1 : std::stoll(text.substr(slash + 1));
  const std::int64_t scaled = std::stoll(text.substr(0, slash)) * Storms::kUnits;
  if (scaled % denominator != 0) throw std::runtime_error("not in units: " + text);
  return scaled / denominator;
}

// GMP's rational as a value.
class Fraction {
 public:
  Fraction() { mpq_init(value_); }
  Fraction(std::int64_t numerator, std::int64_t denominator) : Fraction() {
    mpz_set_si(mpq_numref(value_), numerator);
    mpz_set_si(mpq_denref(value_), denominator);
    mpq_canonicalize(value_);
  }
  Fraction(const Fraction& other) : Fraction() { mpq_set(value_, other.value_); }
  Fraction& operator=(const Fraction& other) {
    mpq_set(value_, other.value_);
    return *this;
  }
  ~Fraction() { mpq_clear(value_); }

  int sign() const { return mpq_sgn(value_); }
  friend Fraction operator+(const Fraction& a, const Fraction& b) { return by(mpq_add, a, b); }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return by(mpq_sub, a, b); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) { return by(mpq_mul, a, b); }
  friend Fraction operator/(const Fraction& a, const Fraction& b) { return by(mpq_div, a, b); }
  friend bool operator<(const Fraction& a, const Fraction& b) {
    return mpq_cmp(a.value_, b.value_) < 0;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return mpq_equal(a.value_, b.value_) != 0;
  }

 private:
  template <class Operation>
  static Fraction by(Operation operation, const Fraction& a, const Fraction& b) {
    Fraction result;
    operation(result.value_, a.value_, b.value_);
    return result;
  }
  mpq_t value_;
};

struct Point {
  Fraction x, y;
  friend bool operator<(const Point& a, const Point& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  }
};

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Fraction dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Fraction cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

// Points on the boundary of the convex hull, those inside of its edges too; 0 if all are on a line.
std::size_t hull_size(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::set<std::size_t> boundary;
  for (const int side : {1, -1}) {
    std::vector<std::size_t> chain;
    for (std::size_t i = 0; i < points.size(); ++i) {
      while (chain.size() >= 2) {
        const Point& a = points[chain[chain.size() - 2]];
        if (cross(points[chain.back()] - a, points[i] - a).sign() * side >= 0) break;
        chain.pop_back();
      }
      chain.push_back(i);
    }
    boundary.insert(chain.begin(), chain.end());
  }
  const Point& first = points.front();
  const bool on_line = std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return cross(points.back() - first, p - first).sign() == 0;
  });
  return on_line ? 0 : boundary.size();
}

// True if there is an open set of circles through u and v with every other point outside: their
// centres are (u + v)/2 + s * (v - u turned left), and each point bounds s from one side.
bool strictly_delaunay(const std::vector<Point>& points, std::size_t u, std::size_t v) {
  std::optional<Fraction> low, high;
  const Point d = points[v] - points[u];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == u || i == v) continue;
    const Point w = points[i] - points[u];
    const Fraction side = cross(d, w);     // > 0: left of uv
    const Fraction slack = dot(w, w - d);  // of the circle with uv as diameter
    if (side.sign() == 0) {
      if (slack.sign() <= 0) return false;
      continue;
    }
    // |w - c|^2 > |c|^2 for c = d/2 + s (-d.y, d.x): slack > 2 s side.
    const Fraction limit = slack / (side + side);
    if (side.sign() > 0) {
      if (!high || limit < *high) high = limit;
    } else {
      if (!low || *low < limit) low = limit;
    }
  }
  return !low || !high || *low < *high;
}

}  // namespace

Storms::Storms(const std::string& file) {
  std::ifstream lines(file);
  std::string line;
  std::getline(lines, line);
  if (line != "id,t,x,y") throw std::runtime_error(file + ": " + line);
  std::map<std::string, std::size_t> numbers;
  std::vector<Storm> all;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string id, t, x, y;
    std::getline(std::getline(std::getline(fields, id, ','), t, ','), x, ',') >> y;
    const auto [entry, is_new] = numbers.emplace(id, all.size());
    if (is_new) all.push_back({id, {}});
    all[entry->second].fixes.push_back({units(t), {tenths(x), tenths(y)}});
  }
  start_ = end_ = all.at(0).fixes[0].time;
  for (Storm& storm : all) {
    std::stable_sort(storm.fixes.begin(), storm.fixes.end(),
                     [](const Fix& a, const Fix& b) { return a.time < b.time; });
    storm.fixes.erase(std::unique(storm.fixes.begin(), storm.fixes.end(),
                                  [](const Fix& a, const Fix& b) { return a.time == b.time; }),
                      storm.fixes.end());
    start_ = std::min(start_, storm.fixes.front().time);
    end_ = std::max(end_, storm.fixes.back().time);
    if (storm.fixes.size() > 1) storms_.push_back(std::move(storm));
  }
}

std::vector<const Storms::Storm*> Storms::alive(std::int64_t time) const {
  std::vector<const Storm*> result;
  for (const Storm& storm : storms_) {
    if (storm.fixes.front().time <= time && time < storm.fixes.back().time) {
      result.push_back(&storm);
    }
  }
  return result;
}

std::size_t Storms::alive_count(std::int64_t time) const { return alive(time).size(); }

// The piece from fix i to fix i + 1 that is flown right after `time`.
std::size_t Storms::piece_of(const Storm& storm, std::int64_t time) {
  const auto after = std::upper_bound(storm.fixes.begin(), storm.fixes.end(), time,
                                      [](std::int64_t t, const Fix& fix) { return t < fix.time; });
  return static_cast<std::size_t>(after - storm.fixes.begin()) - 1;
}

namespace {

// x (west to east) over one piece, times its duration.
struct Line {
  std::int64_t width;
  Wide start, slope;  // at the time in question, and per unit
};

}  // namespace

// -1 if a is west of b right after `time`, 1 if east of it, 0 if they are equal for a while.
int Storms::order_after(const Storm& a, const Storm& b, std::int64_t time) {
  const auto line_of = [time](const Storm& storm) {
    const std::size_t i = piece_of(storm, time);
    const Fix& from = storm.fixes[i];
    const Fix& to = storm.fixes[i + 1];
    const std::int64_t width = to.time - from.time;
    const Wide slope = to.position[0] - from.position[0];
    return Line{width, Wide(from.position[0]) * width + slope * (time - from.time), slope};
  };
  const Line la = line_of(a), lb = line_of(b);
  const int now = sign(la.start * lb.width - lb.start * la.width);
  return now != 0 ? now : sign(la.slope * lb.width - lb.slope * la.width);
}

std::vector<std::string> Storms::west_to_east(std::int64_t time) const {
  std::vector<const Storm*> order = alive(time);
  std::stable_sort(order.begin(), order.end(), [time](const Storm* a, const Storm* b) {
    return order_after(*a, *b, time) < 0;
  });
  std::vector<std::string> ids;
  for (const Storm* storm : order) ids.push_back(storm->id);
  return ids;
}

// a comes before b in the file. Between two fixes of either, both fly straight: the order changes
// at most once inside, and is a new one right after the fix.
std::uint64_t Storms::exchanges_of(const Storm& a, const Storm& b) {
  const std::int64_t from = std::max(a.fixes.front().time, b.fixes.front().time);
  const std::int64_t to = std::min(a.fixes.back().time, b.fixes.back().time);
  if (from >= to) return 0;
  std::set<std::int64_t> times{from, to};
  for (const Storm* storm : {&a, &b}) {
    for (const Fix& fix : storm->fixes) {
      if (from < fix.time && fix.time < to) times.insert(fix.time);
    }
  }
  const auto line_at = [](const Storm& storm, std::size_t i, std::int64_t time) {
    const Fix& p = storm.fixes[i];
    const Fix& q = storm.fixes[i + 1];
    return Line{q.time - p.time,
                Wide(p.position[0]) * (q.time - p.time) +
                    Wide(q.position[0] - p.position[0]) * (time - p.time),
                0};
  };
  const auto compare_at = [&](std::int64_t piece_time, std::int64_t time) {
    const Line la = line_at(a, piece_of(a, piece_time), time);
    const Line lb = line_at(b, piece_of(b, piece_time), time);
    return sign(la.start * lb.width - lb.start * la.width);
  };
  std::uint64_t count = 0;
  int last = 0;
  for (auto t = times.begin(); std::next(t) != times.end(); ++t) {
    int order = order_after(a, b, *t);
    if (order == 0) order = -1;  // equal for a while: in the order of the file
    if (last != 0 && order != last) ++count;
    last = order;
    const int at_end = compare_at(*t, *std::next(t));
    if (compare_at(*t, *t) * at_end < 0) {
      ++count;
      last = at_end;
    }
  }
  return count;
}

std::uint64_t Storms::exchanges() const {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < storms_.size(); ++i) {
    for (std::size_t j = i + 1; j < storms_.size(); ++j) {
      count += exchanges_of(storms_[i], storms_[j]);
    }
  }
  return count;
}

std::uint64_t Storms::turns() const {
  std::uint64_t count = 0;
  for (const Storm& storm : storms_) {
    for (std::size_t i = 1; i + 1 < storm.fixes.size(); ++i) {
      const Fix &a = storm.fixes[i - 1], &b = storm.fixes[i], &c = storm.fixes[i + 1];
      bool turns = false;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        turns = turns || Wide(b.position[axis] - a.position[axis]) * (c.time - b.time) !=
                             Wide(c.position[axis] - b.position[axis]) * (b.time - a.time);
      }
      if (turns) ++count;
    }
  }
  return count;
}

std::uint64_t Storms::arrivals() const {
  return static_cast<std::uint64_t>(
      std::count_if(storms_.begin(), storms_.end(),
                    [this](const Storm& storm) { return storm.fixes.front().time > start_; }));
}

std::uint64_t Storms::departures() const {
  return static_cast<std::uint64_t>(
      std::count_if(storms_.begin(), storms_.end(),
                    [this](const Storm& storm) { return storm.fixes.back().time < end_; }));
}

std::vector<Storms::Place> Storms::places_at(std::int64_t time) const {
  std::vector<Place> places;
  for (const Storm* storm : alive(time)) {
    const std::size_t i = piece_of(*storm, time);
    const Fix &p = storm->fixes[i], &q = storm->fixes[i + 1];
    Place place{storm->id, {}, q.time - p.time};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      place.numerators[axis] = p.position[axis] * place.denominator +
                               (q.position[axis] - p.position[axis]) * (time - p.time);
    }
    places.push_back(std::move(place));
  }
  return places;
}

namespace {

// Exact points by the names of their storms.
template <class Places>
struct NamedPoints {
  explicit NamedPoints(const Places& places) {
    for (const auto& place : places) {
      numbers.emplace(place.id, points.size());
      points.push_back({Fraction(place.numerators[0], place.denominator),
                        Fraction(place.numerators[1], place.denominator)});
    }
  }
  // Both numbers, if there are two such storms.
  std::optional<std::pair<std::size_t, std::size_t>> pair(const std::string& a,
                                                          const std::string& b) const {
    const auto u = numbers.find(a), v = numbers.find(b);
    if (u == numbers.end() || v == numbers.end() || u == v) return std::nullopt;
    return std::minmax(u->second, v->second);
  }
  Fraction squared_distance(std::size_t a, std::size_t b) const {
    const Point d = points[b] - points[a];
    return dot(d, d);
  }
  std::vector<Point> points;
  std::map<std::string, std::size_t> numbers;
};

}  // namespace

std::string Storms::delaunay_complaint(
    std::int64_t time, const std::vector<std::pair<std::string, std::string>>& edges) const {
  const NamedPoints named(places_at(time));
  const std::vector<Point>& points = named.points;
  const std::size_t n = points.size();
  std::vector<Point> sorted = points;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (!(sorted[i] < sorted[i + 1])) return "the witness cannot tell: two storms at one place";
  }
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (const auto& [a, b] : edges) {
    const auto edge = named.pair(a, b);
    if (!edge) return "a storm that is not there: " + a + " " + b;
    if (!seen.insert(*edge).second) return "twice: " + a + " " + b;
    if (!strictly_delaunay(points, edge->first, edge->second)) return "not Delaunay: " + a + " " + b;
  }
  if (n < 2) return edges.empty() ? "" : "edges of fewer than two points";
  const std::size_t hull = hull_size(points);
  const std::size_t expected = hull == 0 ? n - 1 : 3 * n - 3 - hull;
  if (edges.size() == expected) return "";
  return std::to_string(edges.size()) + " edges, not " + std::to_string(expected);
}

std::string Storms::closest_pair_complaint(
    std::int64_t time, const std::pair<std::string, std::string>& pair) const {
  const NamedPoints named(places_at(time));
  const auto told = named.pair(pair.first, pair.second);
  if (!told) return "not a pair of storms: " + pair.first + " " + pair.second;
  const Fraction least = named.squared_distance(told->first, told->second);
  for (std::size_t b = 0; b < named.points.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (named.squared_distance(a, b) < least) return "another pair is closer";
    }
  }
  return "";
}

std::string Storms::tree_complaint(
    std::int64_t time, const std::vector<std::pair<std::string, std::string>>& edges) const {
  const NamedPoints named(places_at(time));
  const std::size_t n = named.points.size();
  struct Neighbour {
    std::size_t number;
    Fraction length;
  };
  std::vector<std::vector<Neighbour>> neighbours(n);
  for (const auto& [a, b] : edges) {
    const auto edge = named.pair(a, b);
    if (!edge) return "a storm that is not there: " + a + " " + b;
    const Fraction length = named.squared_distance(edge->first, edge->second);
    neighbours[edge->first].push_back({edge->second, length});
    neighbours[edge->second].push_back({edge->first, length});
  }
  if (edges.size() + 1 != n) return "not n - 1 edges";
  for (std::size_t root = 0; root < n; ++root) {
    std::vector<std::optional<Fraction>> longest(n);  // edge on the way from the root
    longest[root] = Fraction();
    std::vector<std::size_t> reached{root};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const Neighbour& next : neighbours[reached[i]]) {
        if (longest[next.number]) continue;
        longest[next.number] = std::max(*longest[reached[i]], next.length);
        reached.push_back(next.number);
        if (named.squared_distance(root, next.number) < *longest[next.number]) {
          return "not a shortest tree";
        }
      }
    }
    if (reached.size() != n) return "not connected";
  }
  return "";
}

}  // namespace kinex
