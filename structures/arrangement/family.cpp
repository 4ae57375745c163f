// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/family.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "structures/arrangement/closest_point_line.h"
#include "structures/arrangement/incidences_all.h"
#include "structures/arrangement/incidences_cutting.h"
#include "structures/arrangement/line_arrangement_2.h"
#include "structures/arrangement/line_bounds.h"
#include "structures/arrangement/line_sample.h"
#include "structures/arrangement/points_in_arrangement.h"
#include "structures/arrangement/trapezoids_2.h"

namespace kinex {
namespace {

StructureInfo incidences() {
  StructureInfo all;
  all.name = "incidences_all";
  all.group = "incidences";
  all.summary = "which points are above which lines, all pairs watched: the baseline";
  all.min_dimension = 2;
  all.shape = Attribute::Shape::kTuples;
  all.lines = LineUse::kWithPoints;
  all.kinds = {{"above", Effect::kAlways, "a point comes above a line"},
               {"below", Effect::kAlways, "a point comes below a line"},
               {"change", Effect::kNever, "a point passes a line, at an instant that is not over"},
               {"tie", Effect::kNever, "a point is identically on a line from now on"}};
  all.certificates = "nm for n lines and m points, one for each of both";
  all.ties = "a point that is identically on a line is below it";
  all.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  all.make = make_plain<IncidencesAll>;
  return all;
}

// As many lines as the parameter "r" says.
Subset sample_of(const Request& request, const Scene& scene) {
  std::size_t size = 0;
  for (const Parameter& parameter : request.parameters) {
    if (parameter.name != "r") continue;
    const Integer most(static_cast<std::int64_t>(scene.objects.size()));
    size = static_cast<std::size_t>(std::min(parameter.value.numerator(), most).to_int64());
  }
  return sample_of_lines(request.of, scene, size);
}

StructureInfo incidences_by_cutting() {
  StructureInfo cutting = incidences();
  cutting.name = "incidences_cutting";
  cutting.summary =
      "which points are above which lines, by the trapezoids of a random sample of lines";
  cutting.reads = {{"line_arrangement_2"}, {"trapezoids_2"}};
  cutting.sample = sample_of;
  cutting.parameters = {{.name = "r",
                         .summary = "lines in the sample; 0 for the cube root of their number",
                         .usual = "0",
                         .least = "0"}};
  cutting.kinds.push_back(
      {"cell", Effect::kNever, "a line or a point goes to other trapezoids of the sample"});
  cutting.certificates =
      "O(n r + (n^2 / r) log n) expected for n lines and n points; those of trapezoids_2, of r "
      "lines, besides";
  cutting.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<IncidencesCutting>(in.kernel, in.id,
                                               dynamic_cast<const Trapezoids2&>(*in.watched[1]),
                                               sample_of(in.request, in.scene).objects, in.scene);
  };
  return cutting;
}

StructureInfo arrangement_of_lines() {
  StructureInfo info;
  info.name = "line_arrangement_2";
  info.summary =
      "the arrangement of moving lines: their order by slope, and on each the order of the others";
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kOrders;
  info.role = "crossings";
  info.lines = LineUse::kAlone;
  info.kinds = {
      {"triple", Effect::kAlways, "the triangle of three lines turns over"},
      {"parallel", Effect::kAlways, "two lines change their order by slope"},
      {"equal", Effect::kAlways, "two parallel lines pass through each other"},
      {"swap", Effect::kNever,
       "two crossings of a line change places, at an instant that is not over"},
      {"slopes", Effect::kNever, "two slopes change places, at an instant that is not over"},
      {"tie", Effect::kNever, "two lines coincide identically from now on"}};
  info.certificates = "n^2 - n - 1 for n lines, one for each two neighbours by slope, or on a line";
  info.ties =
      "lines are raised by infinitesimals, more so the smaller the id; parallel ones cross nowhere";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    std::vector<bool> lines = lines_of(in.scene);
    const std::vector<bool> members = in.scene.members(in.request.of);
    for (ObjectId id = 0; id < members.size(); ++id) lines[id] = lines[id] && members[id];
    return std::make_unique<LineArrangement2>(in.kernel, in.id, lines);
  };
  return info;
}

StructureInfo places_of_points() {
  StructureInfo info;
  info.name = "points_in_arrangement";
  info.summary =
      "the lines next to each point, above and below, in the arrangement of moving lines";
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kSequence;
  info.role = "next_lines";
  info.lines = LineUse::kWithPoints;
  info.reads = {{"line_arrangement_2"}};
  info.kinds = {{"above", Effect::kAlways, "another line is next above a point"},
                {"below", Effect::kAlways, "another line is next below a point"},
                {"move", Effect::kNever, "the proof of a point's place fails"}};
  info.certificates = "6 for each point; those of line_arrangement_2, of the lines, besides";
  info.ties =
      "a point that is identically on a line is below it; of two lines that identically meet above "
      "or "
      "below a point the smaller id is the higher one";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<PointsInArrangement>(
        in.kernel, in.id, dynamic_cast<const LineArrangement2&>(*in.watched[0]), in.scene);
  };
  return info;
}

StructureInfo trapezoids() {
  StructureInfo info;
  info.name = "trapezoids_2";
  info.summary = "the vertical decomposition of the arrangement of moving lines into trapezoids";
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kSequence;
  info.role = "walls";
  info.lines = LineUse::kAlone;
  info.reads = {{"line_arrangement_2"}};
  info.kinds = {{"wall_up", Effect::kAlways, "the wall above a crossing ends on another line"},
                {"wall_down", Effect::kAlways, "the wall below a crossing ends on another line"},
                {"wall_pass", Effect::kNever,
                 "two walls in a face, from above and from below, pass each other"}};
  info.certificates =
      "n (n - 1) for n lines, one for each wall at most; those of line_arrangement_2 besides";
  info.ties =
      "lines are raised by infinitesimals, more so the smaller the id; parallel ones cross nowhere";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = [](const MakerInput& in) -> std::unique_ptr<Structure> {
    return std::make_unique<Trapezoids2>(in.kernel, in.id,
                                         dynamic_cast<const LineArrangement2&>(*in.watched[0]));
  };
  return info;
}

template <LineMeasure kMeasure>
std::unique_ptr<Structure> make_closest(const MakerInput& in) {
  return std::make_unique<ClosestPointLine>(in.kernel, in.id, in.scene, kMeasure);
}

StructureInfo closest_of(LineMeasure measure) {
  const bool vertical = measure == LineMeasure::kHeight;
  StructureInfo info;
  info.name = vertical ? "closest_point_line_vertical" : "closest_point_line";
  info.summary = vertical
                     ? "the line and the point at the smallest vertical distance, among all pairs"
                     : "the line and the point that are closest to each other, among all pairs";
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kTuples;
  info.lines = LineUse::kWithPoints;
  info.kinds = {
      {"replace", Effect::kSometimes, "another pair wins a duel"},
      {"tie", Effect::kNever, "another pair wins a duel: the distances are identically equal"}};
  info.certificates =
      "nm - 1 for n lines and m points, one for each match in the tournament of all pairs";
  info.ties = "of pairs at identically equal distances the lexicographically smallest one";
  info.source = "Guibas, Kinetic data structures: a state of the art report (1998), section 7";
  info.make = vertical ? make_closest<LineMeasure::kHeight> : make_closest<LineMeasure::kDistance>;
  return info;
}

}  // namespace

StructureFamily arrangement_family() {
  return {"arrangement",
          {incidences(), incidences_by_cutting(), arrangement_of_lines(), places_of_points(),
           trapezoids(), closest_of(LineMeasure::kDistance), closest_of(LineMeasure::kHeight)}};
}

}  // namespace kinex
