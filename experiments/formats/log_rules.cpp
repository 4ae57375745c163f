// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_rules.h"

#include <algorithm>

#include "structures/registry.h"

namespace kinex::formats {

namespace {

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
    {"order_pair_distance", 4},
    {"orientation_2", 3},
    {"slope_order_2", 4},
    {"in_circle_2", 4},
    {"orientation_3", 4},
    {"in_sphere_3", 5},
    {"unfolded_3", 4},
    {"orientation_xy", 3},
    {"orientation_xz", 3},
    {"orientation_yz", 3},
    {"in_circle_xy", 4},
    {"in_circle_xz", 4},
    {"in_circle_yz", 4},
    {"obtuse_angle_3", 3},
    {"acute_angle_2", 3},
    {"obtuse_angle_2", 3},
    {"edge_dot_2", 4},
    {"order_extent", 4},
    {"order_extent_3", 3},
    {"order_extent_2", 2},
    {"order_box_area", 8},
    {"order_box_perimeter", 8},
    {"order_strip", 6},
    {"order_rectangle_area", 10},
    {"order_rectangle_perimeter", 10},
    {"line_slope_order", 2},
    {"line_turn", 3},
    {"line_meeting", 5},
    // of discs and boxes
    {"power_2", 4},
    {"disc_power_2", 4},
    {"power_3", 5},
    {"disc_power_3", 5},
    {"power_xy", 4},
    {"power_xz", 4},
    {"power_yz", 4},
    {"disc_power_xy", 4},
    {"disc_power_xz", 4},
    {"disc_power_yz", 4},
    {"disc_overlap", 2},
    {"disc_apart", 2},
    {"radius_order", 4},
    {"radius_order_negated", 4},
    {"gap_left", 4},
    {"gap_left_negated", 4},
    {"gap_right", 4},
    {"gap_right_negated", 4},
    {"gap_product", 4},
    {"gap_product_negated", 4},
    {"lower_ends_x", 2},
    {"lower_ends_y", 2},
    {"lower_ends_z", 2},
    {"upper_ends_x", 2},
    {"upper_ends_y", 2},
    {"upper_ends_z", 2},
    {"meeting_x", 2},
    {"meeting_y", 2},
    {"meeting_z", 2},
    {"apart_x", 2},
    {"apart_y", 2},
    {"apart_z", 2},
    {"half_width_x", 1},
    {"half_width_y", 1},
    {"half_width_z", 1},
    {"no_width_x", 1},
    {"no_width_y", 1},
    {"no_width_z", 1},
    // of lines
    {"line_side", 2},
    {"line_under", 2},
    {"line_order", 3},
    {"order_line_height", 4},
    {"order_line_distance", 4},
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
  const StructureInfo* info = find_structure_info(structure);
  return info == nullptr ? nullptr : &info->kinds;
}

// "order_strip/012123": predicates/points/shared_arguments.h.
std::optional<std::size_t> arity_of(std::string_view predicate) {
  if (const std::size_t slash = predicate.find('/'); slash != std::string_view::npos) {
    const std::string_view pattern = predicate.substr(slash + 1);
    if (arity_of(predicate.substr(0, slash)) != pattern.size()) return std::nullopt;
    std::string sorted(pattern);
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const char least = i == 0 ? '0' : sorted[i - 1];
      if (sorted[i] != least && (i == 0 || sorted[i] != least + 1)) return std::nullopt;
    }
    return static_cast<std::size_t>(sorted.back() - '0') + 1;
  }
  for (const Arity& entry : kArities) {
    if (entry.predicate == predicate) return entry.objects;
  }
  return std::nullopt;
}

std::vector<std::string> predicate_names() {
  std::vector<std::string> names;
  for (const Arity& entry : kArities) names.emplace_back(entry.predicate);
  return names;
}

}  // namespace kinex::formats
