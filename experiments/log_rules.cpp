// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/log_rules.h"

#include <algorithm>

namespace kinex {

namespace {

constexpr Effect kNever = Effect::kNever;
constexpr Effect kSometimes = Effect::kSometimes;
constexpr Effect kAlways = Effect::kAlways;

using Rules = std::vector<KindRule>;

struct Row {
  std::vector<std::string_view> structures;
  Rules kinds;
};

Rules hull(Rules own) {
  own.insert(own.begin(), {{"leave", kAlways}, {"enter", kAlways}, {"turn", kAlways}});
  return own;
}

Rules collision(Rules own) {
  own.insert(own.begin(), {{"contact", kAlways},
                           {"graze", kAlways},
                           {"separation", kAlways},
                           {"inside", kNever},
                           {"volume", kNever},
                           {"grid", kNever},
                           {"overlap", kAlways}});
  return own;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows{
      {{"sorted_list"}, {{"swap", kAlways}, {"tie", kAlways}}},
      {{"maximum_tournament", "minimum_tournament"}, {{"replace", kSometimes}, {"tie", kNever}}},
      {{"maximum_heap", "minimum_heap", "maximum_hanger", "minimum_hanger"},
       {{"swap", kSometimes}, {"tie", kNever}, {"replace", kAlways}}},
      {{"maximum_envelope", "minimum_envelope", "maximum_dual_hull", "minimum_dual_hull"},
       {{"replace", kAlways}, {"tie", kAlways}}},
      {{"maximum_sorted_list", "minimum_sorted_list"}, {{"replace", kAlways}}},
      {{"delaunay_2"},
       {{"flip", kSometimes},
        {"enter", kSometimes},
        {"leave", kSometimes},
        {"pass", kSometimes},
        {"blocked", kNever},
        {"reinsert", kNever}}},
      {{"convex_hull_2", "convex_hull_2_naive"},
       hull({{"x", kNever},
             {"yl", kNever},
             {"yr", kNever},
             {"yb", kNever},
             {"yt", kNever},
             {"sl", kNever},
             {"sr", kNever},
             {"st", kNever},
             {"end", kNever}})},
      {{"convex_hull_2_brute_force"},
       hull({{"reflex", kNever}, {"outside", kNever}, {"between", kNever}})},
      {{"convex_hull_2_delaunay"}, hull({})},
      {{"separation_mixed", "separation_minkowski"},
       collision({{"side", kNever}, {"flip", kNever}, {"cell", kNever}})},
      {{"separation_hysteresis"}, collision({{"change", kNever}, {"wedge", kNever}})},
      {{"closest_features", "inner_tangents", "bounding_volumes"}, collision({{"change", kNever}})},
      {{"outer_hierarchy"}, {}},
  };
  return kRows;
}

struct Arity {
  std::string_view predicate;
  std::size_t objects;
};

constexpr Arity kArities[] = {
    {"order_x", 2},
    {"order_y", 2},
    {"order_z", 2},
    {"order_direction", 2},
    {"order_squared_distance", 3},
    {"orientation_2", 3},
    {"slope_order_2", 4},
    {"in_circle_2", 4},
    {"line_slope_order", 2},
    {"line_turn", 3},
    {"line_meeting", 5},
    // of rigid polygons
    {"discs_apart", 3},
    {"discs_overlap", 3},
    {"x_gap", 3},
    {"y_gap", 3},
    {"x_beyond", 2},
    {"x_short_of", 2},
    {"y_beyond", 2},
    {"y_short_of", 2},
    {"along_a", 4},
    {"along_b", 4},
    {"against_a", 4},
    {"against_b", 4},
    {"normal_order", 3},
    {"normal_order_reversed", 3},
    {"right_of_ray", 5},
    {"left_of_ray", 5},
    {"side_a", 3},
    {"side_b", 3},
    {"inside_a", 3},
    {"inside_b", 3},
};

}  // namespace

const std::vector<KindRule>* own_kinds(std::string_view structure) {
  for (const Row& row : rows()) {
    if (std::find(row.structures.begin(), row.structures.end(), structure) !=
        row.structures.end()) {
      return &row.kinds;
    }
  }
  return nullptr;
}

std::optional<std::size_t> arity_of(std::string_view predicate) {
  for (const Arity& entry : kArities) {
    if (entry.predicate == predicate) return entry.objects;
  }
  return std::nullopt;
}

}  // namespace kinex
