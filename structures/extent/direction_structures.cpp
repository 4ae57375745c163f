// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/direction_structures.h"

#include "structures/extent/directions_2.h"
#include "structures/extent/extent_directions.h"
#include "structures/extent/rectangle_directions.h"

namespace kinex {
namespace {

int directions_of(const MakerInput& in) {
  return static_cast<int>(in.parameter("k").numerator().to_int64());
}

template <MaximaChoice kChoice>
std::unique_ptr<Structure> make_directions(const MakerInput& in) {
  return std::make_unique<Directions2>(in.kernel, in.id, in.scene, directions_of(in), kChoice);
}

template <Extremum kExtremum>
std::unique_ptr<Structure> make_extent(const MakerInput& in) {
  return std::make_unique<ExtentDirections>(in.kernel, in.id, in.scene, directions_of(in),
                                            kExtremum);
}

template <BoxMeasure kMeasure>
std::unique_ptr<Structure> make_rectangle(const MakerInput& in) {
  return std::make_unique<RectangleDirections>(in.kernel, in.id, in.scene, directions_of(in),
                                               kMeasure);
}

// 4 times 60 directions, and one more part: a structure has at most 255 parts.
ParameterInfo number_of_directions() {
  return {.name = "k",
          .summary = "4k directions; a squared diameter is off by a factor of at most 1 + 1/k^2",
          .usual = "4",
          .least = "1",
          .most = "60"};
}

}  // namespace

std::vector<StructureInfo> direction_structures() {
  StructureInfo base;
  base.min_dimension = 2;
  base.parameters = {number_of_directions()};
  base.source = "Agarwal, Har-Peled, Maintaining approximate extent measures of moving points (2001)";

  StructureInfo polygon = base;
  polygon.name = "directions_2";
  polygon.summary = "the extreme points of 4k directions, a hull to a proven error";
  polygon.group = "directions";
  polygon.role = "hull";
  polygon.shape = Attribute::Shape::kCycle;
  constexpr std::string_view kAhead = "another point is ahead in a direction, or in a duel for it";
  polygon.kinds = {
      {"leave", Effect::kAlways, "a point ceases to be a vertex of the polygon"},
      {"enter", Effect::kAlways, "a point becomes a vertex of the polygon"},
      {"turn", Effect::kAlways, "the vertices that stay are in another cyclic order"},
      {"replace", Effect::kNever, kAhead},
      {"tie", Effect::kNever, "another point is ahead: the two are identically level"}};
  polygon.certificates = "4k for linear motion, of each extreme point against the next one; else "
                         "4k (n - 1), of tournaments";
  polygon.ties = "of points that are identically level in a direction the smallest id is extreme; "
                 "only strict vertices are on the polygon";
  polygon.directions = [](int k, int) { return unit_directions_2(k); };
  polygon.make = make_directions<MaximaChoice::kByDegree>;

  StructureInfo tournament = polygon;
  tournament.name = "directions_2_tournament";
  tournament.summary = "the extreme points of 4k directions, by tournaments, whatever the motion";
  tournament.certificates = "4k (n - 1), those of a tournament for each direction";
  tournament.make = make_directions<MaximaChoice::kTournaments>;

  StructureInfo diameter = base;
  diameter.name = "diameter_directions";
  diameter.summary = "the diameter of points in the plane or in space, by extents along directions";
  diameter.any_dimension = true;
  diameter.parameters[0].summary =
      "4k directions; a squared diameter is off by a factor of at most 1 + 1/k^2. In space 6 for 1, "
      "54 for 2 and 3, 150 for 4 and 6, 126 for 5, more than 6 counts as 6, and a diameter is off "
      "by 1 - 1/k^2";
  diameter.shape = Attribute::Shape::kTuples;
  diameter.kinds = {
      {"replace", Effect::kSometimes, kAhead},
      {"overtake", Effect::kSometimes, "another extent wins a duel"},
      {"tie", Effect::kNever, "another point or extent is ahead: the two are identically level"}};
  diameter.certificates =
      "those of the extreme points of 4k directions, as in directions_2, and 2k - 1 of the extents";
  diameter.ties = "of points that are identically level in a direction the smallest id counts; of "
                  "extents that are identically equal the one of the first direction";
  diameter.directions = ExtentDirections::directions;
  diameter.make = make_extent<Extremum::kMaximum>;

  StructureInfo width = diameter;
  width.name = "width_directions";
  width.role = "strip_along";
  width.any_dimension = false;
  width.parameters = base.parameters;
  width.parameters[0].summary =
      "4k directions; a width is off by at most D / sqrt(k^2 + 1) for the diameter D";
  width.summary = "the width of points in the plane, by their extents along 2k directions";
  width.make = make_extent<Extremum::kMinimum>;

  StructureInfo perimeter = base;
  perimeter.name = "min_perimeter_rectangle_directions";
  perimeter.role = "perimeter_along";
  perimeter.summary = "the rectangle of least perimeter with sides along one of 2k directions";
  perimeter.parameters[0].summary =
      "4k directions; a perimeter is off by a factor of at most (k + 1) / sqrt(k^2 + 1)";
  perimeter.shape = Attribute::Shape::kSequence;
  perimeter.kinds = diameter.kinds;
  perimeter.certificates =
      "those of the extreme points of 4k directions, as in directions_2, and k - 1 of the boxes";
  perimeter.ties = "of points that are identically level in a direction the smallest id counts; of "
                   "boxes that are identically equal the one of the first direction";
  perimeter.directions = polygon.directions;
  perimeter.make = make_rectangle<BoxMeasure::kPerimeter>;

  StructureInfo area = perimeter;
  area.name = "min_area_rectangle_directions";
  area.role = "area_along";
  area.summary = "the rectangle of least area with sides along one of 2k directions";
  area.parameters[0].summary =
      "4k directions; an area is off by at most 2 D^2 k / (k^2 + 1) for the diameter D";
  area.make = make_rectangle<BoxMeasure::kArea>;
  return {polygon, tournament, diameter, width, perimeter, area};
}

}  // namespace kinex
