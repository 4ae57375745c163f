// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/circle_family.h"

#include "structures/extent/bounding_box_2_hull.h"
#include "structures/extent/farthest_delaunay_2.h"
#include "structures/extent/hull_read.h"
#include "structures/extent/min_circle_2.h"
#include "structures/extent/min_circle_2_brute_force.h"

namespace kinex {
namespace {

std::unique_ptr<Structure> make_box(const MakerInput& in) {
  return std::make_unique<BoundingBox2Hull>(in.kernel, in.id, hull_of(in));
}

std::unique_ptr<Structure> make_triangulation(const MakerInput& in) {
  return std::make_unique<FarthestDelaunay2>(in.kernel, in.id, in.scene, hull_of(in));
}

std::unique_ptr<Structure> make_circle(const MakerInput& in) {
  return std::make_unique<MinCircle2>(in.kernel, in.id,
                                      dynamic_cast<const FarthestDelaunay2&>(*in.watched[0]));
}

StructureInfo box() {
  StructureInfo info{.name = "bounding_box_2_hull",
                     .summary = "the extreme points of both axes, by four pointers on the hull"};
  info.min_dimension = 2;
  info.reads = {{.structure = "convex_hull_2", .role = "hull"}};
  info.kinds = {{"replace", Effect::kSometimes, "another vertex is on a side"}};
  info.role = "box";
  info.instead = "bounding_box";
  info.certificates = "8, two for each side of the box; those of the hull besides";
  info.ties = "of hull vertices with identically equal coordinates the smallest id is on the side";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 6.7";
  info.make = make_box;
  return info;
}

StructureInfo triangulation() {
  StructureInfo info{.name = "farthest_delaunay_2",
                     .summary = "the farthest-point Delaunay triangulation of the hull's vertices"};
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kTuples;
  info.reads = {{.structure = "convex_hull_2", .role = "hull"}};
  info.kinds = {{"flip", Effect::kSometimes,
                 "a diagonal gives way to the other one: four vertices are on one circle"}};
  info.certificates = "h - 3 for h hull vertices, one for each diagonal; those of the hull besides";
  info.ties = "the diagonal of four identically cocircular points contains the smallest id";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 6.9";
  info.make = make_triangulation;
  return info;
}

StructureInfo circle() {
  StructureInfo info{.name = "min_circle_2",
                     .summary = "the smallest enclosing circle, by the farthest-point triangulation"};
  info.group = "min_circle";
  info.role = "circle";
  info.min_dimension = 2;
  info.reads = {{.structure = "farthest_delaunay_2", .passes_over = true}};
  info.kinds = {{"to_two", Effect::kSometimes, "two points determine the circle from now on"},
                {"to_three", Effect::kSometimes, "three points determine the circle from now on"}};
  info.certificates =
      "at most 3, of the angles at one triangle or side; those of farthest_delaunay_2 besides";
  info.ties = "all hull vertices that stay on the circle are named";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 6.9";
  info.make = make_circle;
  return info;
}

StructureInfo circle_by_brute_force() {
  StructureInfo info = circle();
  info.name = "min_circle_2_brute_force";
  info.summary = "the smallest enclosing circle, every point against it";
  info.reads = {};
  info.certificates = "n - 2 or n + 1: every point in the circle of two or three points";
  info.ties = "all points that stay on the circle are named, of equal ones the smallest id";
  info.source = "Welzl, Smallest enclosing disks (1991), for the static algorithm";
  info.make = make_plain<MinCircle2BruteForce>;
  return info;
}

}  // namespace

std::vector<StructureInfo> circle_structures() {
  return {box(), triangulation(), circle(), circle_by_brute_force()};
}

}  // namespace kinex
