// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/hull/family.h"

#include <initializer_list>

#include "structures/hull/convex_hull_2.h"
#include "structures/hull/convex_hull_2_brute_force.h"
#include "structures/hull/convex_hull_2_delaunay.h"

namespace kinex {
namespace {

template <ConvexHull2::Variant kVariant>
std::unique_ptr<Structure> make_divided(const MakerInput& in) {
  return std::make_unique<ConvexHull2>(in.kernel, in.id, in.scene, kVariant);
}

std::unique_ptr<Structure> make_of_triangulation(const MakerInput& in) {
  return std::make_unique<ConvexHull2Delaunay>(in.kernel, in.id,
                                               dynamic_cast<const Delaunay2&>(*in.watched[0]));
}

// Of changes of the hull, then kinds of certificates that change nothing.
std::vector<KindRule> kinds(std::initializer_list<KindRule> silent) {
  std::vector<KindRule> all{
      {"leave", Effect::kAlways, "a point ceases to be a vertex of the hull"},
      {"enter", Effect::kAlways, "a point becomes a vertex of the hull"},
      {"turn", Effect::kAlways, "the vertices that stay are in another cyclic order"}};
  all.insert(all.end(), silent);
  return all;
}

}  // namespace

StructureFamily hull_family() {
  StructureInfo base;
  base.group = "convex_hull";
  base.min_dimension = 2;
  base.shape = Attribute::Shape::kCycle;
  base.role = "hull";
  base.ties = "only strict vertices are on the hull; of identically equal points the smallest id";
  base.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), sections 6 and 11";

  StructureInfo local = base;
  local.name = "convex_hull_2";
  local.summary = "the convex hull of points in the plane, by divide and conquer";
  local.kinds = kinds(
      {{"x", Effect::kNever, "two neighbouring corners of two colours change their order"},
       {"yl", Effect::kNever, "a corner meets the other chain, which it crosses on its left"},
       {"yr", Effect::kNever, "a corner meets the other chain, which it crosses on its right"},
       {"yb", Effect::kNever, "a corner meets the other chain, which it crosses on both sides"},
       {"yt", Effect::kNever, "a corner meets the other chain, without a crossing beside it"},
       {"sl", Effect::kNever, "the slope of a line is no longer after those of its run"},
       {"sr", Effect::kNever, "the slope of a line is no longer before those of its run"},
       {"st", Effect::kNever, "the slope of a line is no longer between those of its tangent"},
       {"end", Effect::kNever, "the first or the last lines of two chains change their order"}});
  local.certificates =
      "O(n log n): orders of corners, corners above or below the other chain, orders "
      "of slopes, at every node of the tree";
  local.make = make_divided<ConvexHull2::Variant::kLocal>;

  StructureInfo naive = base;
  naive.name = "convex_hull_2_naive";
  naive.summary = "the convex hull of points in the plane, by divide and conquer without local certificates";
  naive.certificates =
      "O(n log n), up to n of one point: as convex_hull_2, but every corner has one "
      "against the other chain";
  naive.kinds = local.kinds;
  naive.make = make_divided<ConvexHull2::Variant::kNaive>;

  StructureInfo brute_force = base;
  brute_force.name = "convex_hull_2_brute_force";
  brute_force.summary = "the convex hull, every point against every hull edge";
  brute_force.fails_at_touch = true;
  brute_force.kinds =
      kinds({{"reflex", Effect::kNever, "a vertex and its two neighbours are on one line"},
             {"outside", Effect::kNever, "a point crosses the line of an edge of the hull"},
             {"between", Effect::kNever, "two points on one line change places"}});
  brute_force.certificates =
      "(n - h) h + h for h hull vertices: every point inside every hull edge, and "
      "a left turn at every vertex; two more where a point is always on the line of an edge";
  brute_force.make = make_plain<ConvexHull2BruteForce>;

  StructureInfo reader = base;
  reader.name = "convex_hull_2_delaunay";
  reader.summary = "the convex hull, read off the Delaunay triangulation";
  reader.reads = {{"delaunay_2"}};
  reader.kinds = kinds({});
  reader.certificates = "none of its own, it reads the 3n - 3 of delaunay_2";
  reader.make = make_of_triangulation;

  return {"hull", {local, naive, brute_force, reader}};
}

}  // namespace kinex
