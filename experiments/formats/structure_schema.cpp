// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/structure_schema.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/formats/json_writer.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

using Names = std::vector<std::string_view>;

constexpr int kInDefinitions = 4;  // spaces before a definition
constexpr std::size_t kLineLength = 110;

void write_reference(JsonWriter& json, std::string_view definition) {
  json.begin_object();
  json.key("$ref").string("#/definitions/" + std::string(definition));
  json.end_object();
}

// {"enum": [..]} in lines of usual length, which continue after so many spaces.
void write_names(JsonWriter& json, const Names& names, std::size_t spaces) {
  std::string text = "{\"enum\": [";
  std::size_t length = spaces + text.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += ',';
    if (length + names[i].size() > kLineLength) {
      text += '\n' + std::string(spaces, ' ');
      length = spaces;
    } else if (i > 0) {
      text += ' ';
    }
    append_json_string(text, names[i]);
    length += names[i].size() + 4;
  }
  json.raw(text + "]}");
}

// A number of a descriptor as a JSON number; empty: it is no finite decimal, as far as is seen here.
std::string json_number(const std::string& text) {
  if (text.find('/') == std::string::npos) return text;
  const Rational value = Rational::parse(text).value();
  const double near = value.to_double();
  if (!(Rational::from_double(near) == value)) return {};
  std::array<char, 32> decimal{};
  const auto [end, error] = std::to_chars(decimal.data(), decimal.data() + decimal.size(), near);
  return {decimal.data(), end};
}

void write_limit(JsonWriter& json, const char* keyword, std::string_view limit) {
  const std::string number = json_number(std::string(limit));
  if (!number.empty()) json.key(keyword).raw(number);
}

// A number in its range, or a text, whose value the reader alone checks.
void write_parameter(JsonWriter& json, const ParameterInfo& parameter) {
  json.begin_object().key("description").string(parameter.summary).key("default");
  const std::string usual = json_number(std::string(parameter.usual));
  if (usual.empty()) {
    json.string(parameter.usual);
  } else {
    json.raw(usual);
  }
  json.key("anyOf").begin_array().begin_object();
  json.key("type").string(parameter.whole ? "integer" : "number");
  write_limit(json, "minimum", parameter.least);
  if (!parameter.most.empty()) {
    write_limit(json, parameter.most_is_allowed ? "maximum" : "exclusiveMaximum", parameter.most);
  }
  if (!parameter.step.empty()) {
    const Rational step = Rational::parse(parameter.step).value();
    const bool from_zero = (Rational::parse(parameter.least).value() / step).is_integer();
    if (from_zero) write_limit(json, "multipleOf", parameter.step);
  }
  json.end_object();
  write_reference(json, "number_text");
  json.end_array().end_object();
}

// The members of an object for the structure beside its name, one a line, the first without its
// indentation.
std::string members_of(const StructureInfo& info) {
  std::string text;
  JsonWriter json(text);
  json.begin_object();
  const auto member = [&](std::string_view name) -> JsonWriter& {
    return json.line(kInDefinitions + 8).key(name);
  };
  if (info.uses_key) write_reference(member("key"), info.linear() ? "linear_key" : "key");
  if (const Reading* const choice = reading_of_choice(info)) {
    write_reference(member("over"), "over_" + std::string(choice->role));
  }
  for (const ParameterInfo& parameter : info.parameters) {
    write_parameter(member(parameter.name), parameter);
  }
  if (info.query) {
    member("query").begin_object().key("$ref").string("#/definitions/id");
    json.key("description").string("The object that it is about; default: the first").end_object();
  }
  if (info.colours) write_reference(member("colours"), "two_colours");
  if (info.bodies || info.colours) {
    member("of").begin_object().key("description").string("All of them");
    json.key("const").begin_object().key("all_but").begin_array().end_array().end_object();
    json.end_object();
  } else {
    write_reference(member("of"), "subset");
  }
  write_reference(member("as"), "label");
  return text.substr(text.find('"'));
}

// Structures that take the same members, in the order of the first of them.
std::vector<std::pair<std::string, Names>> structures_by_members() {
  std::vector<std::pair<std::string, Names>> groups;
  for (const StructureInfo& info : structure_infos()) {
    const std::string members = members_of(info);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& known) { return known.first == members; });
    if (group == groups.end()) group = groups.insert(group, {members, {}});
    group->second.push_back(info.name);
  }
  return groups;
}

void write_request(JsonWriter& json) {
  Names all;
  for (const StructureInfo& info : structure_infos()) all.push_back(info.name);
  json.line(kInDefinitions).key("request").begin_object();
  json.line(kInDefinitions + 2).key("description");
  json.string("A structure by its name, or with the members that it takes (kinex explain NAME)");
  json.line(kInDefinitions + 2).key("anyOf").begin_array().line(kInDefinitions + 4);
  write_names(json, all, kInDefinitions + 6);
  for (const auto& [members, names] : structures_by_members()) {
    json.line(kInDefinitions + 4).begin_object().line(kInDefinitions + 6);
    json.key("type").string("object").key("required").begin_array().string("structure").end_array();
    json.key("additionalProperties").boolean(false);
    json.line(kInDefinitions + 6).key("properties").begin_object();
    json.line(kInDefinitions + 8).key("structure");
    write_names(json, names, kInDefinitions + 10);
    json.line(kInDefinitions + 8).raw(members);
    json.line(kInDefinitions + 6).end_object().line(kInDefinitions + 4).end_object();
  }
  json.line(kInDefinitions + 2).end_array().line(kInDefinitions).end_object();
}

// What structures read by a role, in place of the usual structure: without "of", which stands one
// level higher.
void write_choices(JsonWriter& json) {
  std::set<std::string_view> roles;
  for (const StructureInfo& info : structure_infos()) {
    if (const Reading* const choice = reading_of_choice(info)) roles.insert(choice->role);
  }
  for (const std::string_view role : roles) {
    Names names;
    for (const StructureInfo& info : structure_infos()) {
      if (info.role == role) names.push_back(info.name);
    }
    json.line(kInDefinitions).key("over_" + std::string(role)).begin_object();
    json.line(kInDefinitions + 2).key("description");
    json.string("The structure to read in place of the usual one, which has the role: " +
                std::string(role));
    json.line(kInDefinitions + 2).key("allOf").begin_array().line(kInDefinitions + 4);
    write_reference(json, "request");
    json.line(kInDefinitions + 4).begin_object().key("anyOf").begin_array();
    json.line(kInDefinitions + 6);
    write_names(json, names, kInDefinitions + 8);
    json.line(kInDefinitions + 6).begin_object().line(kInDefinitions + 8).key("type");
    json.string("object").line(kInDefinitions + 8).key("properties").begin_object();
    write_names(json.key("structure"), names, kInDefinitions + 10);
    json.end_object().line(kInDefinitions + 8).key("not").begin_object().key("required");
    json.begin_array().string("of").end_array().end_object();
    json.line(kInDefinitions + 6).end_object().line(kInDefinitions + 4).end_array().end_object();
    json.line(kInDefinitions + 2).end_array().line(kInDefinitions).end_object();
  }
}

void write_linear_key(JsonWriter& json) {
  json.line(kInDefinitions).key("linear_key").begin_object();
  json.key("allOf").begin_array();
  write_reference(json, "key");
  json.begin_object().key("not").begin_object().key("type").string("object");
  json.key("required").begin_array().string("squared_distance_to").end_array();
  json.end_object().end_object().end_array().end_object();
}

}  // namespace

std::string structure_definitions() {
  std::string text;
  JsonWriter json(text);
  json.begin_object();
  write_request(json);
  write_choices(json);
  write_linear_key(json);
  return text.substr(2);  // without the bracket and the line break
}

}  // namespace kinex::formats
