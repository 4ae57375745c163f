// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects an entry of "maintain" is about: "of", "query" and "colours".
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_parts.h"
#include "structures/registry.h"

namespace kinex::formats {

ObjectId read_object(const JsonNode& node, const Scene& scene) {
  const std::string_view id = node.string();
  const auto object = std::find_if(scene.objects.begin(), scene.objects.end(),
                                   [&](const SceneObject& o) { return o.id == id; });
  if (object == scene.objects.end()) {
    node.fail("there is no object " + show_text(id), "write the id of an object of the scene");
  }
  return static_cast<ObjectId>(object - scene.objects.begin());
}

namespace {

[[noreturn]] void refuse_twice(const JsonNode& node) {
  node.fail(show_text(node.string()) + " stands twice in the list", "remove one");
}

// Each once, by number.
std::vector<ObjectId> read_objects(const JsonNode& node, const Scene& scene) {
  node.require_array();
  std::vector<ObjectId> result;
  std::vector<bool> is_there(scene.objects.size(), false);
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode one = node.at(i);
    const ObjectId object = read_object(one, scene);
    if (is_there[object]) refuse_twice(one);
    is_there[object] = true;
    result.push_back(object);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string read_colour(const JsonNode& node, const Scene& scene) {
  const std::string_view colour = node.string();
  const bool known = std::any_of(scene.objects.begin(), scene.objects.end(),
                                 [&](const SceneObject& o) { return o.colour == colour; });
  if (!known || colour.empty()) {
    node.fail("no object has the colour " + show_text(colour),
              "write a \"colour\" of objects of the scene");
  }
  return std::string(colour);
}

std::vector<std::string> read_colours(const JsonNode& node, const Scene& scene) {
  node.require_array();
  std::vector<std::string> result;
  for (std::size_t i = 0; i < node.size(); ++i) result.push_back(read_colour(node.at(i), scene));
  return result;
}

// The value of "of": a colour, a list of ids, {"colours": [..]} or {"all_but": [ID, ..]}.
Subset read_subset(const JsonNode& node, const Scene& scene) {
  Subset subset;
  if (node.is(JsonValue::Kind::kString)) {
    subset.kind = Subset::Kind::kColours;
    subset.colours = {read_colour(node, scene)};
    return subset;
  }
  if (node.is(JsonValue::Kind::kArray)) {
    subset.kind = Subset::Kind::kObjects;
    subset.objects = read_objects(node, scene);
    return subset;
  }
  const std::string remedy =
      "write a colour, [ID, ..], {\"colours\": [..]} or {\"all_but\": [ID, ..]}";
  if (!node.is(JsonValue::Kind::kObject)) node.refuse("a choice of objects", remedy);
  node.require_object({"colours", "all_but"});
  if (node.size() != 1) {
    node.fail("a choice of objects with " + counted(node.size(), "field", "fields"), remedy);
  }
  if (const auto colours = node.find("colours")) {
    subset.kind = Subset::Kind::kColours;
    subset.colours = read_colours(*colours, scene);
    for (std::size_t i = 1; i < subset.colours.size(); ++i) {
      const auto place = subset.colours.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::find(subset.colours.begin(), place, *place) != place) refuse_twice(colours->at(i));
    }
    return subset;
  }
  subset.objects = read_objects(node.member("all_but"), scene);
  if (!subset.objects.empty()) subset.kind = Subset::Kind::kAllBut;
  return subset;
}

}  // namespace

void read_object_sets(const JsonNode& node, const StructureInfo& info, const Scene& scene,
                      Request& request) {
  const std::string shown_name = show_text(info.name);
  if (const auto of = node.find("of")) request.of = read_subset(*of, scene);
  if (const auto query = node.find("query")) {
    if (!info.query) query->fail(shown_name + " takes no query", "remove it");
    request.query = read_object(*query, scene);
    if (request.query == 0) request.query = kNoObject;  // the usual one
  }
  if (const auto colours = node.find("colours")) {
    if (!info.colours) colours->fail(shown_name + " takes no colours", "remove it");
    request.colours = read_colours(*colours, scene);
    if (request.colours.size() != 2) {
      colours->fail(counted(request.colours.size(), "colour", "colours"), "write two colours");
    }
  }
  if (const auto refusal = refusal_of_objects(info, request, scene)) {
    node.fail(shown_name + " " + refusal->problem, refusal->remedy);
  }
}

}  // namespace kinex::formats
