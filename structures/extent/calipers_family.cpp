// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/calipers_family.h"

#include <vector>

#include "structures/extent/caliper_extremum.h"
#include "structures/extent/calipers_2.h"
#include "structures/extent/diameter_all_pairs.h"
#include "structures/extent/hull_read.h"

namespace kinex {
namespace {

template <CaliperMeasure kMeasure>
constexpr std::string_view kName = "diameter_2";
template <>
constexpr std::string_view kName<CaliperMeasure::kWidth> = "width_2";
template <>
constexpr std::string_view kName<CaliperMeasure::kArea> = "min_area_rectangle_2";
template <>
constexpr std::string_view kName<CaliperMeasure::kPerimeter> = "min_perimeter_rectangle_2";

std::unique_ptr<Structure> make_calipers(const MakerInput& in) {
  const int folds = static_cast<int>(in.parameter("folds").numerator().to_int64());
  return std::make_unique<Calipers2>(in.kernel, in.id, folds, hull_of(in), in.watched_ids[0]);
}

template <CaliperMeasure kMeasure>
std::unique_ptr<Structure> make_extremum(const MakerInput& in) {
  const bool shares = in.watched.size() > 1;
  return std::make_unique<CaliperExtremum>(
      in.kernel, in.id, kName<kMeasure>, kMeasure, hull_of(in), in.watched_ids[0],
      shares ? dynamic_cast<const Calipers2*>(in.watched[1]) : nullptr);
}

// Of all structures that follow the directions of the edges of a hull (HullCalipers::Kind).
std::vector<KindRule> caliper_kinds() {
  return {{"antiparallel", Effect::kSometimes, "two edges of the hull become antiparallel"},
          {"perpendicular", Effect::kSometimes, "two edges of the hull become perpendicular"},
          {"split", Effect::kNever, "a vertex comes: an edge gives way to two"},
          {"merge", Effect::kNever, "a vertex goes: two edges give way to one"},
          {"renew", Effect::kNever, "the calipers are made anew, with the hull"}};
}

template <CaliperMeasure kMeasure>
StructureInfo caliper_info(std::string_view summary) {
  StructureInfo info;
  info.name = kName<kMeasure>;
  info.summary = summary;
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kSequence;
  if (kMeasure == CaliperMeasure::kArea || kMeasure == CaliperMeasure::kPerimeter) {
    info.role = "rectangle";
  }
  if (kMeasure == CaliperMeasure::kWidth) info.role = "strip";
  info.reads = {{"convex_hull_2", "hull"}};
  info.shares = {"calipers_2", "folds", folds_of(kMeasure)};
  info.kinds = caliper_kinds();
  info.kinds.push_back({"replace", Effect::kSometimes, "another candidate wins a duel"});
  info.kinds.push_back(
      {"tie", Effect::kNever, "another candidate wins a duel: the two are identically equal"});
  info.certificates =
      "at most 2h - 1 for h hull vertices: one for each two directions of edges that are "
      "neighbours, and a tournament of the candidates of all edges, or h - 1 where calipers_2 is "
      "shared; those of the hull besides";
  info.ties = "of candidates that are identically equal that with the smallest edge is the best";
  info.source =
      "Agarwal, Guibas, Hershberger, Veach, Maintaining the extent of a moving point set (2001)";
  info.make = make_extremum<kMeasure>;
  return info;
}

StructureInfo calipers() {
  StructureInfo info{.name = "calipers_2",
                     .summary =
                         "what rotating calipers touch: all antipodal pairs of the hull, or "
                         "the four contacts of two pairs at right angles"};
  info.min_dimension = 2;
  info.shape = Attribute::Shape::kTuples;
  info.width = StructureInfo::kWidthOfParameter;
  info.reads = {{"convex_hull_2", "hull"}};
  info.parameters = {{.name = "folds",
                      .summary = "2 for parallel calipers, 4 for two pairs at right angles",
                      .usual = "2",
                      .least = "2",
                      .most = "4",
                      .step = "2"}};
  info.kinds = caliper_kinds();
  info.certificates =
      "at most h for h hull vertices, one for each two directions of edges that are "
      "neighbours modulo the fold; those of the hull besides";
  info.ties = "identically equal directions are in the order of the tails of their edges";
  info.source =
      "Agarwal, Guibas, Hershberger, Veach, Maintaining the extent of a moving point set (2001)";
  info.make = make_calipers;
  return info;
}

}  // namespace

std::vector<StructureInfo> caliper_structures() {
  StructureInfo diameter = caliper_info<CaliperMeasure::kDiameter>(
      "the farthest pair of points in the plane, among antipodal pairs of the hull");
  diameter.group = "diameter";
  diameter.shape = Attribute::Shape::kTuples;
  diameter.ties = "of pairs with identically equal distances the lexicographically smallest one";

  StructureInfo all_pairs{.name = "diameter_all_pairs",
                          .summary = "the farthest pair of points, by a tournament of all pairs"};
  all_pairs.group = "diameter";
  all_pairs.any_dimension = true;
  all_pairs.shape = Attribute::Shape::kTuples;
  all_pairs.kinds = {
      {"replace", Effect::kSometimes, "another pair wins a duel"},
      {"tie", Effect::kNever, "another pair wins a duel: the distances are identically equal"}};
  all_pairs.certificates = "n(n - 1)/2 - 1, one for each match of a tournament of all pairs";
  all_pairs.ties = diameter.ties;
  all_pairs.source =
      "Guibas, Kinetic data structures: a state of the art report (1998), sections 5 and 6.7";
  all_pairs.make = make_plain<DiameterAllPairs>;

  return {calipers(),
          diameter,
          all_pairs,
          caliper_info<CaliperMeasure::kWidth>(
              "the narrowest strip that holds all points of the plane: its edge of the hull and "
              "the vertex opposite to it"),
          caliper_info<CaliperMeasure::kArea>(
              "the rectangle of least area that holds all points of the plane, in any direction"),
          caliper_info<CaliperMeasure::kPerimeter>(
              "the rectangle of least perimeter that holds all points of the plane, in any "
              "direction")};
}

}  // namespace kinex
