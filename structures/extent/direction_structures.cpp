// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/direction_structures.h"

#include "structures/extent/directions_2.h"
#include "structures/extent/extent_directions.h"

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
  for (const char* change : {"leave", "enter", "turn"}) {
    polygon.kinds.push_back({change, Effect::kAlways});
  }
  for (const char* silent : {"replace", "tie"}) polygon.kinds.push_back({silent, Effect::kNever});
  polygon.certificates = "4k for linear motion, of each extreme point against the next one; else "
                         "4k (n - 1), of tournaments";
  polygon.ties = "of points that are identically level in a direction the smallest id is extreme; "
                 "only strict vertices are on the polygon";
  polygon.make = make_directions<MaximaChoice::kByDegree>;

  StructureInfo tournament = polygon;
  tournament.name = "directions_2_tournament";
  tournament.summary = "the same by tournaments, whatever the motion";
  tournament.certificates = "4k (n - 1), those of a tournament for each direction";
  tournament.make = make_directions<MaximaChoice::kTournaments>;

  StructureInfo diameter = base;
  diameter.name = "diameter_directions";
  diameter.summary = "the diameter of points in the plane, by their extents along 2k directions";
  diameter.shape = Attribute::Shape::kTuples;
  diameter.kinds = {{"replace", Effect::kSometimes},
                    {"overtake", Effect::kSometimes},
                    {"tie", Effect::kNever}};
  diameter.certificates =
      "those of the extreme points of 4k directions, as in directions_2, and 2k - 1 of the extents";
  diameter.ties = "of points that are identically level in a direction the smallest id counts; of "
                  "extents that are identically equal the one of the first direction";
  diameter.make = make_extent<Extremum::kMaximum>;

  StructureInfo space = diameter;
  space.name = "diameter_directions_3";
  space.summary = "the diameter of points in space, by their extents along directions";
  space.min_dimension = 3;
  // Each pair of directions may have several predicates.
  space.parameters = {
      {.name = "k",
       .summary = "27 directions and their opposites for 2 and 3, 75 for 4, 5 and 6; a diameter is "
                  "off by a factor of at least 1 - 1/k^2",
       .usual = "6",
       .least = "2",
       .most = "6"}};
  space.certificates =
      "for linear motion one for each extreme point of 54 or 150 directions, else those of a "
      "tournament for each; and a tournament of the 27 or 75 extents";

  StructureInfo width = diameter;
  width.name = "width_directions";
  width.summary = "the width of points in the plane, by their extents along 2k directions";
  width.make = make_extent<Extremum::kMinimum>;
  return {polygon, tournament, diameter, width, space};
}

}  // namespace kinex
