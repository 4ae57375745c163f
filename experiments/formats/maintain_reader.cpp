// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/scene_reader.h"
#include "structures/family_summary.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

constexpr std::string_view kAxisNames = "xyz";
const std::string kOption = "--maintain";  // the place of errors outside a file

std::vector<std::string> structure_names() {
  std::vector<std::string> names;
  for (const StructureInfo& info : structure_infos()) names.emplace_back(info.name);
  return names;
}

std::optional<int> axis_of(std::string_view name, int dimension) {
  if (name.size() != 1) return std::nullopt;
  const std::size_t axis = kAxisNames.find(name[0]);
  if (axis == std::string_view::npos || static_cast<int>(axis) >= dimension) return std::nullopt;
  return static_cast<int>(axis);
}

std::string axes_of(int dimension) {
  std::string result;
  for (int axis = 0; axis < dimension; ++axis) {
    if (axis > 0) result += ", ";
    result += std::string("\"") + kAxisNames[static_cast<std::size_t>(axis)] + "\"";
  }
  return result;
}

// What is wrong with a name that no structure has. Names of groups and families are easily taken for one.
Refusal complaint_about_unknown(const std::string& name, const Scene& scene) {
  std::string suiting, all;
  for (const StructureInfo& info : structure_infos()) {
    if (info.group.empty() || info.group != name) continue;
    const auto add = [&info](std::string& list) {
      list += (list.empty() ? "" : ", ") + std::string(info.name);
    };
    add(all);
    if (!refusal_of(info, scene)) add(suiting);
  }
  if (!all.empty()) {
    return {show_text(name) + " is what several structures maintain, not one of them",
            "write one of " + (suiting.empty() ? all : suiting)};
  }
  for (const FamilySummary& family : family_summaries()) {
    if (family.name != name) continue;
    return {show_text(name) + " is a family of structures, not one of them",
            "kinex list structures --family " + name + " names them"};
  }
  return {show_text(name) + " is not a known structure",
          did_you_mean(name, structure_names(), "kinex list structures names them")};
}

// The problem with maintaining `name` in the scene: {problem, remedy}, or nothing.
std::optional<Refusal> complaint_about(const std::string& name, const Scene& scene) {
  const StructureInfo* info = find_structure_info(name);
  if (info == nullptr) return complaint_about_unknown(name, scene);
  std::optional<Refusal> refusal = refusal_of(*info, scene);
  if (refusal && info->bodies && !scene.has_bodies()) {
    refusal->problem = "is for convex polygons, the scene has points";
    refusal->remedy =
        "maintain a structure for points (kinex list structures), or give the objects polygons (kinex import --polygons)";
  }
  if (refusal) refusal->problem = show_text(name) + " " + refusal->problem;
  return refusal;
}

// What "NAME:AXIS", which --maintain takes, is in a scene; empty if `text` is no such entry.
std::string spelled_out(std::string_view text, const Scene& scene) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return {};
  const StructureInfo* const info = find_structure_info(text.substr(0, colon));
  const std::string axis(text.substr(colon + 1));
  if (info == nullptr || !info->uses_key || !axis_of(axis, scene.dimension)) return {};
  return "{\"structure\": \"" + std::string(info->name) + "\", \"key\": \"" + axis + "\"}";
}

bool label_is_taken(const Scene& scene, std::string_view label) {
  return std::any_of(scene.maintain.begin(), scene.maintain.end(),
                     [&](const Request& other) { return other.label == label; });
}

bool are_too_many(const Scene& scene) { return scene.maintain.size() > kMostStructures; }

// The requested structures, and those that they read, must fit one run.
std::optional<Refusal> complaint_about_number(const Scene& scene) {
  if (!are_too_many(scene) && plan_structures(scene).size() <= kMostStructures) return std::nullopt;
  const std::string most = std::to_string(kMostStructures);
  return Refusal{"more than " + most + " structures in one run, those included that others read",
                 "maintain at most " + most + ", and the others in a run of their own"};
}

Key read_direction(const JsonNode& node, int dimension) {
  node.require_array();
  if (node.size() != static_cast<std::size_t>(dimension)) {
    node.fail("a direction of " + counted(node.size(), "entry", "entries") +
                  " in a scene of dimension " + std::to_string(dimension),
              "write one number per axis");
  }
  Key key;
  key.kind = Key::Kind::kDirection;
  bool all_zero = true;
  for (std::size_t axis = 0; axis < node.size(); ++axis) {
    key.direction.push_back(node.at(axis).rational());
    if (!key.direction.back().is_zero()) all_zero = false;
  }
  if (all_zero) node.fail("a direction that is zero", "write at least one number that is not 0");
  return key;
}

Key read_distance(const JsonNode& node, const Scene& scene) {
  const std::string_view id = node.string();
  const ObjectId object = read_object(node, scene);
  if (!lives_throughout(scene.objects[object].motion, scene)) {
    node.fail("object " + show_text(id) + " does not exist for the whole time of the scene",
              "measure the distance to one that does");
  }
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = object;
  return key;
}

Key read_key(const JsonNode& node, const Scene& scene) {
  const std::string remedy = "write " + axes_of(scene.dimension) +
                             ", {\"direction\": [..]} or {\"squared_distance_to\": ID}";
  if (node.is(JsonValue::Kind::kString)) {
    const std::optional<int> axis = axis_of(node.string(), scene.dimension);
    if (!axis) node.refuse("a key in dimension " + std::to_string(scene.dimension), remedy);
    Key key;
    key.axis = *axis;
    return key;
  }
  if (!node.is(JsonValue::Kind::kObject)) node.refuse("a key", remedy);
  node.require_object({"direction", "squared_distance_to"});
  if (node.size() != 1) node.fail("a key with " + counted(node.size(), "field", "fields"), remedy);
  if (const auto direction = node.find("direction"))
    return read_direction(*direction, scene.dimension);
  return read_distance(node.member("squared_distance_to"), scene);
}

// The parameter, if the member gives it another value than usual.
std::optional<Parameter> read_parameter(const JsonNode& member, const ParameterInfo& known,
                                        const StructureInfo& info) {
  Parameter given{std::string(known.name), member.rational()};
  if (const auto refusal = refusal_of_parameter(info, given)) {
    member.fail(show_text(info.name) + " cannot have " + given.name + " = " + shown(member.value()),
                refusal->remedy);
  }
  if (given.value == Rational::parse(known.usual).value()) return std::nullopt;
  return given;
}

// The members of an entry that suit the structure.
std::vector<std::string_view> members_of(const StructureInfo& info) {
  std::vector<std::string_view> members{"structure", "as"};
  if (!info.bodies && !info.colours) members.emplace_back("of");
  if (info.uses_key) members.emplace_back("key");
  if (reading_of_choice(info) != nullptr) members.emplace_back("over");
  if (info.query) members.emplace_back("query");
  if (info.colours) members.emplace_back("colours");
  for (const ParameterInfo& parameter : info.parameters) members.push_back(parameter.name);
  return members;
}

// Refuses members that no structure has, and parameters of others.
void check_members(const JsonNode& node, const StructureInfo& info) {
  const std::vector<std::string_view> suiting = members_of(info);
  std::string all;
  for (const std::string_view one : suiting)
    all += (all.empty() ? "\"" : ", \"") + std::string(one) + "\"";
  const Reading* const reading = reading_of_choice(info);
  const std::span<const JsonValue> keys = node.value().keys();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string_view key = keys[i].text();
    if (key == "of" || key == "key" || key == "over" || key == "query" || key == "colours")
      continue;
    if (std::find(suiting.begin(), suiting.end(), key) != suiting.end()) continue;
    std::string remedy = did_you_mean(key, {suiting.begin(), suiting.end()}, "known are " + all);
    const StructureInfo* const read =
        reading == nullptr ? nullptr : find_structure_info(reading->structure);
    if (read != nullptr &&
        std::any_of(read->parameters.begin(), read->parameters.end(),
                    [key](const ParameterInfo& one) { return one.name == key; })) {
      remedy = "it is a parameter of " + std::string(read->name) +
               ", which this structure reads: write \"over\": {\"structure\": \"" +
               std::string(read->name) + "\", \"" + std::string(key) + "\": ..}";
    }
    node.at(i).fail(show_text(key) + " is not a known field", remedy);
  }
}

Request read_request(const JsonNode& node, const Scene& scene);

// The structure to be read in place of the usual one, if it is another one.
std::optional<Request> read_over(const JsonNode& node, const StructureInfo& info,
                                 const Scene& scene) {
  Request over = read_request(node, scene);
  if (node.is(JsonValue::Kind::kObject) && node.find("of")) {
    node.member("of").fail("a choice of objects for what is read", "write \"of\" one level higher");
  }
  if (const auto refusal = refusal_of_over(info, over)) {
    node.fail(show_text(info.name) + " " + refusal->problem, refusal->remedy);
  }
  const Reading* const reading = reading_of_choice(info);
  if (over.structure == reading->structure && over.key == Key{} && over.over.empty() &&
      over.parameters.empty()) {
    return std::nullopt;
  }
  over.label.clear();
  return over;
}

// The request of an entry, not yet in the scene.
Request read_request(const JsonNode& node, const Scene& scene) {
  Request request;
  const bool plain = node.is(JsonValue::Kind::kString);
  if (!plain && !node.is(JsonValue::Kind::kObject)) {
    node.refuse("an entry of \"maintain\"",
                "write a structure's name or {\"structure\": NAME, ..}");
  }
  const JsonNode name = plain ? node : node.member("structure");
  request.structure = name.string();
  if (const auto complaint = complaint_about(request.structure, scene)) {
    const std::string entry = spelled_out(request.structure, scene);
    if (!entry.empty()) name.fail(complaint->problem, "in a scene write " + entry);
    name.fail(complaint->problem, complaint->remedy);
  }
  request.label = request.structure;
  if (!plain) {
    check_members(node, *find_structure_info(request.structure));
    if (const auto key = node.find("key")) {
      if (!find_structure_info(request.structure)->uses_key) {
        key->fail(show_text(request.structure) + " takes no key", "remove it");
      }
      request.key = read_key(*key, scene);
      const StructureInfo& info = *find_structure_info(request.structure);
      if (const auto refusal = refusal_of_key(info, request.key)) {
        key->fail(show_text(request.structure) + " " + refusal->problem, refusal->remedy);
      }
    }
    const StructureInfo& info = *find_structure_info(request.structure);
    read_object_sets(node, info, scene, request);
    if (const auto over = node.find("over")) {
      if (auto read = read_over(*over, info, scene)) request.over.push_back(*std::move(read));
    }
    for (const ParameterInfo& parameter : info.parameters) {
      const auto member = node.find(parameter.name);
      if (!member) continue;
      if (auto given = read_parameter(*member, parameter, info)) {
        request.parameters.push_back(*std::move(given));
      }
    }
    if (const auto label = node.find("as")) {
      request.label = label->string();
      if (request.label.empty() || request.label == "t" || request.label == "queries") {
        label->refuse("a usable label", "write a name other than \"\", \"t\" and \"queries\"");
      }
    }
  }
  return request;
}

void read_entry(const JsonNode& node, Scene& scene) {
  Request request = read_request(node, scene);
  if (label_is_taken(scene, request.label)) {
    node.fail("the label " + show_text(request.label) + " is used twice",
              "give each a name of its own with \"as\"");
  }
  scene.maintain.push_back(std::move(request));
}

// Splits at commas, but not at those inside of JSON: of braces, brackets and strings.
std::vector<std::string> split_entries(std::string_view text) {
  std::vector<std::string> entries;
  std::string entry;
  int depth = 0;
  bool quoted = false;
  const auto finish = [&] {
    const std::size_t begin = entry.find_first_not_of(" \t\r\n");
    const std::size_t end = entry.find_last_not_of(" \t\r\n");
    entries.push_back(begin == std::string::npos ? "" : entry.substr(begin, end + 1 - begin));
    entry.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ',' && depth <= 0 && !quoted) {
      finish();
      continue;
    }
    entry += c;
    if (quoted && c == '\\' && i + 1 < text.size()) entry += text[++i];
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '{' || c == '[')) ++depth;
    if (!quoted && (c == '}' || c == ']')) --depth;
  }
  finish();
  return entries;
}

// NAME or NAME:AXIS.
void read_short_entry(const std::string& entry, Scene& scene) {
  const std::size_t colon = entry.find(':');
  Request request;
  request.structure = entry.substr(0, colon);
  request.label = entry;
  if (const auto complaint = complaint_about(request.structure, scene)) {
    throw InputError(kOption, "", complaint->problem, complaint->remedy);
  }
  if (colon != std::string::npos) {
    const std::string axis_name = entry.substr(colon + 1);
    const std::optional<int> axis = axis_of(axis_name, scene.dimension);
    if (!find_structure_info(request.structure)->uses_key) {
      throw InputError(kOption, "",
                       show_text(request.structure) + " takes no key, as " + show_text(axis_name),
                       "write " + request.structure + " alone");
    }
    if (!axis) {
      throw InputError(kOption, "",
                       show_text(axis_name) + " is not a key of " + show_text(request.structure),
                       "a 1-D structure takes " + axes_of(scene.dimension) +
                           "; other keys are written as in a scene, {\"structure\": NAME, ..}");
    }
    request.key.axis = *axis;
  }
  if (label_is_taken(scene, request.label)) {
    throw InputError(kOption, "", show_text(entry) + " stands twice", "remove one");
  }
  scene.maintain.push_back(std::move(request));
}

// An entry of --maintain.
void read_option_entry(const std::string& entry, Scene& scene) {
  if (entry.empty() || entry[0] != '{') return read_short_entry(entry, scene);
  const JsonDocument document = parse_json(entry, kOption);
  const JsonValue& tree = *document;
  const JsonSource source{kOption, entry, 0};
  read_entry(JsonNode(tree, source), scene);
}

// All of them in one: "PROBLEM; REMEDY; and PROBLEM; REMEDY", the first few.
InputError all_of(const std::vector<InputError>& errors) {
  const InputError& first = errors.front();
  std::string remedy = first.remedy();
  constexpr std::size_t kMostTold = 8;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    if (i == kMostTold) {
      remedy += "; and " + std::to_string(errors.size() - i) + " more";
      break;
    }
    remedy += "; and " + (errors[i].place().empty() ? "" : errors[i].place() + ": ") +
              errors[i].problem();
    if (!errors[i].remedy().empty()) remedy += "; " + errors[i].remedy();
  }
  return {first.file(), first.place(), first.problem(), remedy};
}

}  // namespace

void read_maintain(const JsonNode& node, Scene& scene) {
  node.require_array();
  for (std::size_t i = 0; i < node.size(); ++i) {
    read_entry(node.at(i), scene);
    if (i + 1 < node.size() && !are_too_many(scene)) continue;
    if (const auto complaint = complaint_about_number(scene)) {
      node.at(i).fail(complaint->problem, complaint->remedy);
    }
  }
}

void set_maintain(Scene& scene, const std::vector<std::string>& texts) {
  scene.maintain.clear();
  std::vector<InputError> errors;
  for (const std::string& text : texts) {
    for (const std::string& entry : split_entries(text)) {
      try {
        read_option_entry(entry, scene);
      } catch (const InputError& error) {
        errors.push_back(error);
      }
      if (are_too_many(scene)) break;
    }
  }
  if (!errors.empty()) throw all_of(errors);
  if (const auto complaint = complaint_about_number(scene)) {
    throw InputError(kOption, "", complaint->problem, complaint->remedy);
  }
}

}  // namespace kinex::formats
