// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_scene.h"

#include <algorithm>
#include <vector>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

// The structures of a scene's run, as a log lists them.
std::vector<LogStructure> planned_structures(const Scene& scene) {
  std::vector<LogStructure> planned;
  for (const PlannedStructure& one : plan_structures(scene)) {
    LogStructure& structure = planned.emplace_back();
    structure.label = one.request.label;
    structure.structure = one.request.structure;
    if (find_structure_info(one.request.structure)->uses_key) {
      structure.key = key_json(one.request.key, scene);
    }
    if (const std::string options = options_json(one.request, scene); !options.empty()) {
      structure.options = canonical_json(*parse_json(options, ""));
    }
  }
  return planned;
}

std::string names(const std::vector<LogStructure>& structures) {
  std::string text;
  for (const LogStructure& structure : structures) {
    text += (text.empty() ? "" : ", ") + structure.label;
  }
  return text;
}

// An entry of --maintain.
std::string entry_for(const LogStructure& logged) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("structure").string(logged.structure);
  if (!logged.key.empty()) json.key("key").raw(logged.key);
  json.key("as").string(logged.label).end_object();
  if (!logged.options.empty()) {
    text.insert(1, logged.options.substr(1, logged.options.size() - 2) + ", ");
  }
  return text;
}

}  // namespace

void require_same_scene(const LogHeader& header, const std::string& file, const std::string& hash) {
  if (header.scene_hash == hash) return;
  throw InputError(file, "line 1",
                   "it is a log of another scene (" + show_text(header.scene) + ", hash " +
                       header.scene_hash.substr(0, 12) + ")",
                   "give the scene that was run");
}

bool maintains_as_logged(const Scene& scene, const LogHeader& header) {
  const std::vector<LogStructure> planned = planned_structures(scene);
  return std::equal(planned.begin(), planned.end(), header.structures.begin(),
                    header.structures.end(), [](const LogStructure& a, const LogStructure& b) {
                      return a.label == b.label && a.structure == b.structure && a.key == b.key &&
                             a.options == b.options;
                    });
}

void maintain_as_logged(Scene& scene, const LogHeader& header, const std::string& file) {
  if (maintains_as_logged(scene, header)) return;
  std::vector<std::string> entries;
  for (const LogStructure& logged : header.structures) entries.push_back(entry_for(logged));
  try {
    set_maintain(scene, entries);
  } catch (const InputError& error) {
    throw InputError(file, "line 1", error.problem(), "give a log of this program");
  }
}

std::string structures_of(const LogHeader& header) { return names(header.structures); }
std::string structures_of(const Scene& scene) { return names(planned_structures(scene)); }

}  // namespace kinex::formats
