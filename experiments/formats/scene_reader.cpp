// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/scene_reader.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/id_index.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/utf8.h"
#include "experiments/formats/weights.h"

namespace kinex::formats {

namespace {

void read_version(const JsonNode& scene) {
  const JsonNode version = scene.member("kinex");
  if (version.is(JsonValue::Kind::kNumber) && version.rational() == Rational(1)) return;
  version.refuse("a version of the scene format that this program reads", "write \"kinex\": 1");
}

void read_time(const JsonNode& node, Scene& scene) {
  node.require_object({"start", "end"});
  scene.start = node.member("start").rational();
  const auto end = node.find("end");
  if (!end) return;
  scene.end = end->rational();
  if (*scene.end <= scene.start) {
    end->fail(
        "the scene ends at " + shown(end->value()) + ", not after its start",
        "write \"end\" greater than \"start\", or leave it out to run until no event is left");
  }
}

// The polygon of a body; empty for a point.
std::vector<Vertex2> read_shape(const JsonNode& object, bool first, const Scene& scene) {
  const auto polygon = object.find("polygon");
  if (!first && polygon.has_value() != scene.has_bodies()) {
    const JsonNode& odd = polygon ? *polygon : object;
    odd.fail(polygon ? "a body in a scene of points" : "a point in a scene of bodies",
             "give every object a \"polygon\", or none");
  }
  if (!polygon) {
    if (const auto rotor = object.find("rotor")) {
      rotor->fail("a rotor of a point", "remove it, or give the object a \"polygon\"");
    }
    return {};
  }
  if (scene.dimension != 2) {
    polygon->fail("a polygon in a scene of dimension " + std::to_string(scene.dimension),
                  "write \"dimension\": 2, or remove the polygon");
  }
  try {
    return read_polygon(*polygon);
  } catch (const InputError& error) {
    throw InputError(error.file(), error.place(),
                     "body " + show_text(object.member("id").string()) + ": " + error.problem(),
                     error.remedy());
  }
}

// The colour of a point; empty: none.
std::string read_colour(const JsonNode& object) {
  const auto colour = object.find("colour");
  if (!colour) return {};
  if (object.find("polygon")) {
    colour->fail("a colour of a body", "remove it: points alone have colours");
  }
  if (colour->string().empty()) colour->fail("an empty colour", "write a name, or remove it");
  return std::string(colour->string());
}

// The two vertices of an edge of a graph; empty: a point.
std::vector<std::string> read_ends(const JsonNode& object, const Scene& scene) {
  const auto ends = object.find("ends");
  if (!ends) return {};
  ends->require_array();
  if (object.find("polygon") || scene.dimension != 1) {
    ends->fail("an edge of a graph in a scene that is not of points on a line",
               "write \"dimension\": 1 and no \"polygon\": its coordinate is its weight");
  }
  if (ends->size() != 2) {
    ends->fail("an edge with " + counted(ends->size(), "end", "ends"), "write two vertices");
  }
  std::vector<std::string> result;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const JsonNode end = ends->at(i);
    if (end.string().empty()) end.fail("a vertex without a name", "write a name");
    result.emplace_back(end.string());
  }
  if (result[0] == result[1]) {
    ends->fail("an edge from vertex " + show_text(result[0]) + " to itself",
               "write two different vertices");
  }
  return result;
}

// True for a line of the plane.
bool read_line(const JsonNode& object, const Scene& scene) {
  const auto line = object.find("line");
  if (!line || !line->boolean()) return false;
  if (scene.dimension != 2) {
    line->fail("a line in a scene of dimension " + std::to_string(scene.dimension),
               "write \"dimension\": 2: the axes of the line y = a x + b are (a, b)");
  }
  for (const char* const other : {"polygon", "weight"}) {
    if (const auto node = object.find(other)) {
      node->fail(std::string("\"") + other + "\" of a line", "remove it, or \"line\": true");
    }
  }
  if (scene.extents != Extents::kNone) {
    line->fail(std::string("a line in a scene of ") +
                   (scene.extents == Extents::kRadius ? "discs" : "boxes"),
               "remove \"line\": true, or what makes the others more than points");
  }
  return true;
}

void read_objects(const JsonNode& node, Scene& scene) {
  node.require_array();
  IdIndex seen(node.size());
  scene.objects.reserve(node.size());
  bool weighted = false;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode entry = node.at(i);
    entry.require_object({"id", "motion", "polygon", "rotor", "weight", "colour", "ends", "radius",
                          "half_extents", "line"});
    const JsonNode id = entry.member("id");
    if (id.string().empty()) id.fail("an empty id", "write a name");
    if (id.string().size() > kMaxIdLength && characters(id.string()) > kMaxIdLength) {
      id.fail("an id of " + std::to_string(characters(id.string())) + " characters", "write at most 1000");
    }
    const std::size_t first = seen.add(id.string());
    if (first != i) {
      id.fail(
          "the id " + shown(id.value()) + " is that of /objects/" + std::to_string(first) + " too",
          "give one of the two objects another id");
    }
    if (i == 0) scene.extents = read_kind_of_extents(entry);
    check_kind_of_extents(entry, scene);
    std::vector<Vertex2> polygon = read_shape(entry, i == 0, scene);
    scene.objects.push_back({std::string(id.string()),
                             {},
                             std::move(polygon),
                             read_colour(entry),
                             read_ends(entry, scene),
                             read_line(entry, scene)});
    SceneObject& object = scene.objects.back();
    read_motion(entry, scene, !object.polygon.empty(), object.motion);
    weighted = add_weights(entry, scene, object.motion) || weighted;
  }
  if (weighted) complete_weights(scene);
  if (!scene.has_bodies() || scene.overlapping_starts == OverlappingStarts::kContact) return;
  check_apart(node, scene);
  check_appearances(node, scene);
}

// A first line of names, and a second one of as many fields; a script may have a comma, too.
bool is_table(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) == 0) return false;
  const std::size_t at = line.find_first_of(",;\t");
  if (at == line.npos) return false;
  std::string_view second = text.substr(std::min(text.size(), line.size() + 1));
  second = second.substr(0, second.find('\n'));
  return second.find_first_not_of(" \t\r") == second.npos ||
         std::count(line.begin(), line.end(), line[at]) ==
             std::count(second.begin(), second.end(), line[at]);
}

// Text that no JSON begins with: a script, a page, a letter.
bool is_no_json(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r\n");
  if (at == text.npos) return false;
  const char first = text[at];
  return first > ' ' && first < 0x7f &&
         std::string_view("{[\"/-+.").find(first) == std::string_view::npos &&
         std::isdigit(static_cast<unsigned char>(first)) == 0;
}

// Throws InputError for a table, an event log or other text in place of a scene, and says what reads it.
void refuse_other_formats(std::string_view text, const std::string& file) {
  if (text.starts_with("{\"format\": \"" + std::string(kLogFormat) + "\"")) {
    throw InputError(file, "line 1", "this is an event log, not a scene",
                     "give the scene that it was made from; kinex check, log and view read logs");
  }
  if (is_table(text)) {
    throw InputError(file, "line 1", "this is a table, not a scene",
                     "kinex import " + file + " -o SCENE.json makes a scene of it");
  }
  if (is_no_json(text)) {
    std::string_view line = text.substr(text.find_first_not_of(" \t\r\n"));
    line = line.substr(0, line.find_first_of("\r\n"));
    const auto before = text.substr(0, static_cast<std::size_t>(line.data() - text.data()));
    throw InputError(file,
                     "line " + std::to_string(std::count(before.begin(), before.end(), '\n') + 1),
                     show_text(line) + " begins neither a scene nor an event log",
                     "give a scene (JSON, as kinex gen and kinex import make it), or to kinex "
                     "check, log and view an "
                     "event log (kinex run SCENE --events FILE)");
  }
}

// The same for GeoJSON and Moving Features.
void refuse_features(const JsonNode& root, const std::string& file) {
  if (!root.is(JsonValue::Kind::kObject) || root.find("kinex") || !root.find("type")) return;
  throw InputError(file, "", "these are features, not a scene",
                   "kinex import " + file + " -o SCENE.json makes a scene of them");
}

Scene make_scene(const JsonDocument& document, std::string_view text, const std::string& file,
                 Deadline* deadline) {
  const JsonSource source{file, text, 1, deadline};
  const JsonNode root(*document, source);
  refuse_features(root, file);
  if (root.is(JsonValue::Kind::kObject) && root.find("kinex_plan")) {
    root.fail("this is a plan, not a scene", "run a plan by kinex sweep run");
  }
  root.require_object({"kinex", "name", "dimension", "time", "objects", "maintain", "jumps",
                       "overlapping_starts", "queries", "source", "description", "expect",
                       "$schema"});
  read_version(root);
  Scene scene;
  if (const auto name = root.find("name")) scene.name = name->string();
  for (const char* words : {"source", "description", "$schema"}) {
    if (const auto text_field = root.find(words)) text_field->string();
  }
  scene.dimension = root.member("dimension").integer(1, kMaxDimension);
  read_time(root.member("time"), scene);
  if (const auto jumps = root.find("jumps")) scene.jumps = jumps->boolean();
  if (const auto starts = root.find("overlapping_starts")) read_overlapping_starts(*starts, scene);
  read_objects(root.member("objects"), scene);
  if (const auto maintain = root.find("maintain")) read_maintain(*maintain, scene);
  if (const auto queries = root.find("queries")) read_queries(*queries, scene, file);
  return scene;
}

}  // namespace

void read_overlapping_starts(const JsonNode& node, Scene& scene) {
  const std::string_view choice = node.string();
  if (choice == "contact") {
    scene.overlapping_starts = OverlappingStarts::kContact;
  } else if (choice != "refused") {
    node.fail(shown(node.value()) + " is no choice for bodies that start overlapping",
              "write \"refused\" (the default) or \"contact\"");
  }
}

Scene parse_scene(std::string_view text, const std::string& file, Deadline* deadline) {
  refuse_other_formats(text, file);
  return make_scene(parse_json(text, file, 1, deadline), text, file, deadline);
}

Scene read_scene(const std::string& path, Deadline* deadline) {
  std::string text = read_text_file(path);
  refuse_other_formats(text, path);
  return make_scene(parse_json_in_place(text, path, deadline), text, path, deadline);
}

}  // namespace kinex::formats
