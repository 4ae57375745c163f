// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/box_queries.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_value.h"
#include "experiments/formats/scene_parts.h"
#include "structures/parts/range_search.h"
#include "structures/registry.h"

namespace kinex::formats {
namespace {

using Side = std::array<Rational, 2>;

const std::string kOption = "--query";  // the place of errors outside a file

// The role of structures that answer queries (structures/parts/range_search.h).
bool searches(const StructureInfo& info) { return info.role == kRangeSearch; }

bool answers(const Request& request) {
  const StructureInfo* info = find_structure_info(request.structure);
  return info != nullptr && searches(*info);
}

std::string names_of_searchers() {
  std::string names;
  for (const StructureInfo& info : structure_infos()) {
    if (searches(info)) names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  return names;
}

std::string axis_name(std::size_t axis) { return std::string(1, "xyz"[axis]); }

// The two numbers of an axis, in a message.
std::string empty_side(std::size_t axis, const Side& side) {
  return "an empty box: along " + axis_name(axis) + " it begins at " + time_text(side[0]) +
         " and ends at " + time_text(side[1]);
}

std::vector<Side> read_box(const JsonNode& node, const Scene& scene) {
  node.require_array();
  const auto axes = static_cast<std::size_t>(scene.dimension);
  if (node.size() != axes) {
    node.fail("a box of " + counted(node.size(), "axis", "axes") + " in a scene of " +
                  counted(axes, "axis", "axes"),
              "write [least, largest] for every axis");
  }
  std::vector<Side> box;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const JsonNode side = node.at(axis);
    side.require_array();
    if (side.size() != 2) {
      side.fail("a side of " + counted(side.size(), "number", "numbers"), "write [least, largest]");
    }
    box.push_back({side.at(0).rational(), side.at(1).rational()});
    if (box.back()[1] < box.back()[0]) {
      side.fail(empty_side(axis, box.back()), "write the smaller number first");
    }
  }
  return box;
}

void check_time(const JsonNode& node, const Rational& t, const Scene& scene) {
  if (!(t < scene.start) && !(scene.end && *scene.end < t)) return;
  node.fail("a query at " + shown(node.value()) + ", outside of the scene's time",
            "write a time from " + time_text(scene.start) + " on" +
                (scene.end ? ", at most " + time_text(*scene.end) : ""));
}

}  // namespace

void read_queries(const JsonNode& node, Scene& scene, const std::string& file) {
  node.require_array();
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode entry = node.at(i);
    entry.require_object({"at", "box"});
    const JsonNode at = entry.member("at");
    BoxQuery query{at.rational(), {}};
    check_time(at, query.at, scene);
    query.box = read_box(entry.member("box"), scene);
    scene.queries.push_back(std::move(query));
  }
  // --maintain may add structures to a scene without any.
  if (!scene.maintain.empty()) check_answered(scene, file, "/queries/0");
}

bool answers_queries(const Scene& scene) {
  return scene.queries.empty() ||
         std::any_of(scene.maintain.begin(), scene.maintain.end(),
                     [](const Request& request) { return answers(request); });
}

void check_answered(const Scene& scene, const std::string& file, const std::string& place) {
  if (scene.queries.empty()) return;
  for (const Request& request : scene.maintain) {
    if (answers(request) && request.label == "box") {
      throw InputError(file, place, "the label \"box\" of a structure that answers queries",
                       "give " + request.structure + " another label with \"as\"");
    }
  }
  if (answers_queries(scene)) return;
  throw InputError(file, place, "a query that no structure answers",
                   "maintain one of " + names_of_searchers());
}

std::vector<Side> read_box_option(const std::string& text, const Scene& scene) {
  std::vector<Rational> numbers;
  std::string token;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i] != ',') {
      token += text[i];
      continue;
    }
    const std::optional<Rational> number = Rational::parse(token);
    if (!number) {
      throw InputError(kOption, "", show_text(token) + " of " + show_text(text) + " is no number",
                       "write numbers as in a scene, X1,X2,Y1,Y2");
    }
    numbers.push_back(*number);
    token.clear();
  }
  const auto axes = static_cast<std::size_t>(scene.dimension);
  if (numbers.size() != 2 * axes) {
    throw InputError(kOption, "",
                     show_text(text) + " has " + counted(numbers.size(), "number", "numbers") +
                         ", the scene has " + counted(axes, "axis", "axes"),
                     "write two numbers for every axis, X1,X2,Y1,Y2");
  }
  std::vector<Side> box;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    box.push_back({numbers[2 * axis], numbers[2 * axis + 1]});
    if (box.back()[1] < box.back()[0]) {
      throw InputError(kOption, "", show_text(text) + " is " + empty_side(axis, box.back()),
                       "write the smaller number first");
    }
  }
  return box;
}

}  // namespace kinex::formats
