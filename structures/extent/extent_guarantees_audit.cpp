// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "structures/extent/extent_guarantees_audit.h"

namespace kinex {
namespace {

Rational squared_distance(const Snapshot& now, ObjectId a, ObjectId b) {
  Rational sum;
  for (int axis = 0; axis < now.dimension(); ++axis) {
    const Rational d = now.position(b, axis) - now.position(a, axis);
    sum += d * d;
  }
  return sum;
}

Rational cross(const Snapshot& now, ObjectId a, ObjectId b, ObjectId c) {
  const Rational ux = now.position(b, 0) - now.position(a, 0);
  const Rational uy = now.position(b, 1) - now.position(a, 1);
  const Rational vx = now.position(c, 0) - now.position(a, 0);
  const Rational vy = now.position(c, 1) - now.position(a, 1);
  return ux * vy - uy * vx;
}

Rational squared(int k) { return Rational(Integer(k) * Integer(k)); }

// The least value of a rectangle on an edge of the hull of these objects, from its height and its
// width, times the length of the edge, and the square of that length. A segment is an edge.
template <class Value>
Rational least_rectangle(const Snapshot& now, std::span<const ObjectId> objects,
                         const Value& value) {
  const std::vector<ObjectId> hull = exact_hull(now, objects);
  Rational best;
  for (std::size_t i = 0; hull.size() > 1 && i < hull.size(); ++i) {
    const ObjectId a = hull[i], b = hull[(i + 1) % hull.size()];
    const Rational x = now.position(b, 0) - now.position(a, 0);
    const Rational y = now.position(b, 1) - now.position(a, 1);
    Rational height, least, most;
    for (const ObjectId p : hull) {
      const Rational along = x * (now.position(p, 0) - now.position(a, 0)) +
                             y * (now.position(p, 1) - now.position(a, 1));
      height = std::max(height, cross(now, a, b, p));
      least = std::min(least, along);
      most = std::max(most, along);
    }
    const Rational one = value(height, most - least, x * x + y * y);
    if (i == 0 || one < best) best = one;
  }
  return best;
}

}  // namespace

std::vector<ObjectId> living(const Snapshot& snapshot) {
  std::vector<ObjectId> result;
  for (ObjectId id = 0; id < snapshot.objects(); ++id) {
    if (snapshot.alive(id)) result.push_back(id);
  }
  return result;
}

Rational squared_diameter(const Snapshot& snapshot, std::span<const ObjectId> objects) {
  Rational best;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = i + 1; j < objects.size(); ++j) {
      best = std::max(best, squared_distance(snapshot, objects[i], objects[j]));
    }
  }
  return best;
}

std::vector<ObjectId> exact_hull(const Snapshot& snapshot, std::span<const ObjectId> objects) {
  std::vector<ObjectId> sorted(objects.begin(), objects.end());
  const auto order = [&](ObjectId a, ObjectId b) {
    for (const int axis : {0, 1}) {
      const Rational &x = snapshot.position(a, axis), &y = snapshot.position(b, axis);
      if (x != y) return x < y;
    }
    return a < b;
  };
  std::sort(sorted.begin(), sorted.end(), order);
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                           [&](ObjectId a, ObjectId b) {
                             return squared_distance(snapshot, a, b).is_zero();
                           }),
               sorted.end());
  if (sorted.size() < 3) return sorted;
  std::vector<ObjectId> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t base = hull.size();
    for (const ObjectId c : sorted) {
      while (hull.size() >= base + 2 &&
             cross(snapshot, hull[hull.size() - 2], hull.back(), c).sign() <= 0) {
        hull.pop_back();
      }
      hull.push_back(c);
    }
    hull.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }
  return hull;
}

Rational squared_width(const Snapshot& snapshot, std::span<const ObjectId> objects) {
  const std::vector<ObjectId> hull = exact_hull(snapshot, objects);
  if (hull.size() < 3) return {};
  Rational best;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const ObjectId a = hull[i], b = hull[(i + 1) % hull.size()];
    Rational farthest;
    for (const ObjectId c : hull) farthest = std::max(farthest, cross(snapshot, a, b, c));
    const Rational strip = farthest * farthest / squared_distance(snapshot, a, b);
    if (i == 0 || strip < best) best = strip;
  }
  return best;
}

Rational least_area(const Snapshot& snapshot, std::span<const ObjectId> objects) {
  return least_rectangle(snapshot, objects,
                         [](const Rational& height, const Rational& width, const Rational& square) {
                           return height * width / square;
                         });
}

Rational squared_half_perimeter(const Snapshot& snapshot, std::span<const ObjectId> objects) {
  return least_rectangle(snapshot, objects,
                         [](const Rational& height, const Rational& width, const Rational& square) {
                           return (height + width) * (height + width) / square;
                         });
}

// a - b - c <= 2 sqrt(bc).
bool root_at_most_sum(const Rational& a, const Rational& b, const Rational& c) {
  const Rational rest = a - b - c;
  return rest.sign() <= 0 || !(Rational(4) * b * c < rest * rest);
}

void guarantee_diameter(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                        AuditReport& report) {
  const Rational whole = squared_diameter(snapshot, exact_hull(snapshot, living(snapshot)));
  const Rational part = squared_diameter(snapshot, chosen);
  const Rational square = squared(k);
  report.check(!(whole < part) && !(part * (square + Rational(1)) < whole * square),
               [] { return std::string("the diameter is beyond its guarantee"); });
}

void guarantee_width(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                     AuditReport& report) {
  const std::vector<ObjectId> all = exact_hull(snapshot, living(snapshot));
  const Rational whole = squared_width(snapshot, all), part = squared_width(snapshot, chosen);
  report.check(!(whole < part) &&
                   root_at_most_sum(whole, part, squared_diameter(snapshot, chosen) / squared(k)),
               [] { return std::string("the width is beyond its guarantee"); });
}

// With the height H and the width W of the rectangle around the chosen ones, both at most D':
// (H + D'/k)(W + D'/k) <= H W + D'^2 (2k + 1) / k^2.
void guarantee_area(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                    AuditReport& report) {
  const std::vector<ObjectId> all = exact_hull(snapshot, living(snapshot));
  const Rational whole = least_area(snapshot, all), part = least_area(snapshot, chosen);
  const Rational error =
      squared_diameter(snapshot, chosen) * Rational(2 * k + 1) / squared(k);
  report.check(!(whole < part) && !(part + error < whole),
               [] { return std::string("the area is beyond its guarantee"); });
}

void guarantee_perimeter(int k, std::span<const ObjectId> chosen, const Snapshot& snapshot,
                         AuditReport& report) {
  const std::vector<ObjectId> all = exact_hull(snapshot, living(snapshot));
  const Rational whole = squared_half_perimeter(snapshot, all);
  const Rational part = squared_half_perimeter(snapshot, chosen);
  const Rational error = Rational(4) * squared_diameter(snapshot, chosen) / squared(k);
  report.check(!(whole < part) && root_at_most_sum(whole, part, error),
               [] { return std::string("the perimeter is beyond its guarantee"); });
}

}  // namespace kinex
