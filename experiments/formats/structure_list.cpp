// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/structure_list.h"

#include <vector>

#include "experiments/formats/json_writer.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

std::string_view objects_of(const StructureInfo& info) {
  if (info.bodies) return "bodies";
  if (info.graph) return "edges";
  if (info.lines == LineUse::kAlone) return "lines";
  if (info.lines == LineUse::kWithPoints) return "lines and points";
  if (info.extents == Extents::kRadius) return "discs";
  return info.extents == Extents::kHalfExtents ? "boxes" : "points";
}

std::string_view name_of(Effect effect) {
  if (effect == Effect::kNever) return "internal";
  return effect == Effect::kAlways ? "external" : "internal or external";
}

void write_if(JsonWriter& json, const char* name, std::string_view text) {
  if (!text.empty()) json.key(name).string(text);
}

void write_takes(JsonWriter& json, const StructureInfo& info) {
  json.begin_array();
  if (info.uses_key) json.string("key");
  if (reading_of_choice(info) != nullptr) json.string("over");
  for (const ParameterInfo& one : info.parameters) json.string(one.name);
  if (info.query) json.string("query");
  if (info.colours) json.string("colours");
  if (!info.bodies && !info.colours) json.string("of");
  json.string("as").end_array();
}

void write_parameters(JsonWriter& json, const StructureInfo& info) {
  json.begin_array();
  for (const ParameterInfo& one : info.parameters) {
    json.begin_object().key("name").string(one.name).key("summary").string(one.summary);
    json.key("usual").string(one.usual).key("least").string(one.least);
    write_if(json, "most", one.most);
    json.key("most_is_allowed").boolean(one.most_is_allowed);
    json.key("whole").boolean(one.whole);
    write_if(json, "step", one.step);
    json.end_object();
  }
  json.end_array();
}

void write_kinds(JsonWriter& json, const StructureInfo& info) {
  json.begin_array();
  for (const KindRule& rule : info.kinds) {
    json.begin_object().key("kind").string(rule.kind).key("effect").string(name_of(rule.effect));
    json.key("text").string(rule.text).end_object();
  }
  json.end_array();
}

void write(JsonWriter& json, const StructureInfo& info) {
  json.begin_object().key("name").string(info.name).key("summary").string(info.summary);
  json.key("family").string(family_of(info.name));
  write_if(json, "group", info.group);
  json.key("objects").string(objects_of(info)).key("axes").number(info.min_dimension);
  json.key("more_axes").boolean(info.any_dimension);
  json.key("follows_motion").boolean(info.has_events);
  if (info.largest_degree != StructureInfo::kAnyDegree) {
    json.key("largest_degree").number(info.largest_degree);
  }
  write_takes(json.key("takes"), info);
  write_parameters(json.key("parameters"), info);
  json.key("reads").begin_array();
  for (const Reading& reading : info.reads) json.string(reading.structure);
  json.end_array();
  write_if(json, "role", info.role);
  write_kinds(json.key("kinds"), info);
  json.end_object();
}

}  // namespace

std::string structure_list(std::string_view family) {
  std::string text;
  JsonWriter json(text);
  json.begin_array();
  for (const StructureInfo& info : structure_infos()) {
    if (!family.empty() && family_of(info.name) != family) continue;
    write(json.line(1), info);
  }
  json.end_array();
  return text + "\n";
}

}  // namespace kinex::formats
