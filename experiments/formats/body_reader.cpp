// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of scenes of rigid bodies only: polygons, rotors that never vanish, a start without
// contacts.
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/real_root.h"
#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/placed_body.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/simple_polygon.h"

namespace kinex::formats {

namespace {

std::string numbered(std::size_t k) { return "vertex " + std::to_string(k); }

Vertex2 read_vertex(const JsonNode& node) {
  node.require_array();
  if (node.size() != 2) {
    node.fail("a vertex of " + counted(node.size(), "number", "numbers"), "write two, [x, y]");
  }
  return {node.at(0).rational(), node.at(1).rational()};
}

void check_distinct(const JsonNode& node, const std::vector<Vertex2>& polygon) {
  std::vector<std::size_t> order(polygon.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return polygon[a] != polygon[b] ? polygon[a] < polygon[b] : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (polygon[order[i]] != polygon[order[i - 1]]) continue;
    node.at(order[i]).fail(
        numbered(order[i]) + " is where " + numbered(order[i - 1]) + " is already",
        "write every vertex once; the last one is joined to the first");
  }
}

// The side of the edge from `a` to `b` on which `c` lies: +1 left.
int turn(const Vertex2& a, const Vertex2& b, const Vertex2& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

// True if the edge from `a` to `b` goes up, or level to the right: its angle is in [0, pi).
bool goes_up(const Vertex2& a, const Vertex2& b) {
  return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0];
}

bool is_clockwise(const std::vector<Vertex2>& polygon) {
  Rational doubled_area;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vertex2& a = polygon[k];
    const Vertex2& b = polygon[(k + 1) % polygon.size()];
    doubled_area += a[0] * b[1] - a[1] * b[0];
  }
  return doubled_area.sign() < 0;
}

void check_simple(const JsonNode& node, const std::vector<Vertex2>& polygon) {
  const auto edges = edges_that_meet(polygon);
  if (!edges) return;
  const auto edge = [&](std::size_t k) {
    return std::to_string(k) + "-" + std::to_string((k + 1) % polygon.size());
  };
  node.fail("the polygon is not simple: its edges " + edge((*edges)[0]) + " and " +
                edge((*edges)[1]) + " meet",
            "write the vertices in their order, counter-clockwise");
}

// Left turns at every vertex and one turn in all make a convex polygon.
void check_convex(const JsonNode& node, const std::vector<Vertex2>& polygon) {
  const std::size_t n = polygon.size();
  std::size_t reflex = n, rises = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vertex2& before = polygon[(k + n - 1) % n];
    const Vertex2& after = polygon[(k + 1) % n];
    const int side = turn(before, polygon[k], after);
    if (side == 0) {
      node.at(k).fail(numbered(k) + " lies on the line of its neighbours", "leave it out");
    }
    if (side < 0 && reflex == n) reflex = k;
    if (!goes_up(before, polygon[k]) && goes_up(polygon[k], after)) ++rises;
  }
  if (reflex < n) check_simple(node, polygon);
  if (reflex < n && is_clockwise(polygon)) {
    node.fail("a polygon whose vertices go clockwise", "write them counter-clockwise");
  }
  if (reflex < n) {
    node.at(reflex).fail("the polygon is not convex: it turns to the right at " + numbered(reflex),
                         "bodies are convex polygons");
  }
  if (rises > 1) {
    node.fail("a polygon that winds round " + std::to_string(rises) + " times",
              "bodies are convex polygons: write the vertices in one turn");
  }
}

// A body at the scene's start and a box around it.
struct Placed {
  std::size_t object;
  Polygon2 polygon;
  double x_low, x_high, y_low, y_high;
};

Placed place(std::size_t object, Polygon2 polygon) {
  const auto by = [](std::size_t axis) {
    return [axis](const Vertex2& a, const Vertex2& b) { return a[axis] < b[axis]; };
  };
  const auto [left, right] = std::minmax_element(polygon.begin(), polygon.end(), by(0));
  const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(), by(1));
  Placed placed{object,
                {},
                (*left)[0].lower_double(),
                (*right)[0].upper_double(),
                (*low)[1].lower_double(),
                (*high)[1].upper_double()};
  placed.polygon = std::move(polygon);
  return placed;
}

[[noreturn]] void fail_in_contact(const JsonNode& objects, const Scene& scene, std::size_t a,
                                  std::size_t b, Contact contact) {
  const auto [first, second] = std::minmax(a, b);
  objects.at(second).fail("the bodies " + show_text(scene.objects[first].id) + " and " +
                              show_text(scene.objects[second].id) +
                              (contact == Contact::kTouching ? " touch" : " overlap") +
                              " at the scene's start",
                          std::string("place them apart") + kOverlappingStartsRemedy);
}

}  // namespace

std::vector<Vertex2> read_polygon(const JsonNode& node) {
  node.require_array();
  if (node.size() < 3) {
    node.fail("a polygon of " + counted(node.size(), "vertex", "vertices"), "write at least 3");
  }
  std::vector<Vertex2> polygon;
  for (std::size_t k = 0; k < node.size(); ++k) polygon.push_back(read_vertex(node.at(k)));
  check_distinct(node, polygon);
  check_convex(node, polygon);
  return polygon;
}

void check_rotor(const JsonNode& node, const Trajectory& trajectory, const Rational& from,
                 const std::optional<Rational>& to) {
  const Polynomial p = Polynomial::from_rationals(trajectory.coordinates[2]);
  const Polynomial q = Polynomial::from_rationals(trajectory.coordinates[3]);
  const char* remedy = "write a rotor whose two parts are never both 0";
  const Polynomial common = gcd(p, q);
  if (common.is_zero()) node.fail("a rotor that is zero", remedy);
  RootCounters counters;
  for (RootWithMultiplicity& zero : isolate_real_roots(common, counters)) {
    if (compare(zero.root, from, counters) < 0) continue;
    if (to && compare(zero.root, *to, counters) > 0) continue;
    node.fail("both parts of the rotor vanish at " + time_text(common, zero.root, counters),
              remedy);
  }
}

// A sweep from left to right over boxes; pairs whose boxes meet are tested exactly.
void check_apart(const JsonNode& objects, const Scene& scene) {
  std::vector<Placed> bodies;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    const MotionPiece* piece = object.motion.piece_after(scene.start);
    if (piece == nullptr) continue;
    bodies.push_back(place(i, placed_polygon(object.polygon, piece->trajectory, scene.start)));
  }
  std::sort(bodies.begin(), bodies.end(), [](const Placed& a, const Placed& b) {
    return a.x_low != b.x_low ? a.x_low < b.x_low : a.object < b.object;
  });
  std::vector<const Placed*> open;  // their boxes reach the sweep line
  for (const Placed& body : bodies) {
    std::erase_if(open, [&](const Placed* other) { return other->x_high < body.x_low; });
    for (const Placed* other : open) {
      objects.poll();
      if (other->y_high < body.y_low || body.y_high < other->y_low) continue;
      const Contact contact = contact_of(other->polygon, body.polygon);
      if (contact == Contact::kApart) continue;
      fail_in_contact(objects, scene, other->object, body.object, contact);
    }
    open.push_back(&body);
  }
}

}  // namespace kinex::formats
