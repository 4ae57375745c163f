// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_polygons.h"

#include <charconv>
#include <string_view>
#include <unordered_set>

#include "experiments/formats/csv_fields.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"

namespace kinex::formats {

namespace {

constexpr const char* kPolygonColumns = "name the columns id,x,y: a row for each vertex";

// Reads the polygon as that of a scene, so that both refuse the same ones. Fields that are numbers
// need no escapes.
std::vector<Vertex2> polygon_of(const std::string& id, const std::vector<const CsvRow*>& rows,
                                std::size_t x, std::size_t y, const std::string& file) {
  std::string text;
  for (const CsvRow* row : rows) {
    text += text.empty() ? "[[\"" : ",[\"";
    text += row->fields[x] + "\",\"" + row->fields[y] + "\"]";
  }
  text += "]";
  const JsonDocument document = parse_json(text, file);
  const JsonValue& tree = *document;
  try {
    return read_polygon(JsonNode(tree, JsonSource{file, text}));
  } catch (const InputError& error) {
    // The place is "/K" for vertex K, or "/" for the polygon.
    std::size_t vertex = 0;
    const std::string& path = error.place();
    std::from_chars(path.data() + 1, path.data() + path.size(), vertex);
    throw InputError(file, place_of_row(*rows[vertex]), show_text(id) + ": " + error.problem(),
                     remedy_without_line(error));
  }
}

// "line 7"; "" for an object of --fixed.
std::string place_of(const std::string& id, const ObjectTable& objects) {
  const auto line = objects.lines.find(id);
  return line == objects.lines.end() ? "" : "line " + std::to_string(line->second);
}

void check_known(const Scene& scene, const PolygonTable& polygons, const ObjectTable& objects) {
  std::unordered_set<std::string> fixed{kEveryId};
  for (const SceneObject& object : scene.objects) fixed.insert(object.id);
  for (const PolygonTable::Entry& entry : polygons.entries) {
    if (fixed.contains(entry.id) || objects.lines.contains(entry.id)) continue;
    throw InputError(polygons.file, "line " + std::to_string(entry.line),
                     "there is no object " + show_text(entry.id),
                     "write an id of " + objects.file + ", or \"*\" for all without a polygon");
  }
}

// Checks the scene with the scene reader.
void check_scene(const Scene& scene, const ObjectTable& objects) {
  try {
    parse_scene(write_scene(scene), objects.file);
  } catch (const InputError& error) {
    constexpr std::string_view kObjects = "/objects/";
    const std::string& path = error.place();
    std::size_t object = scene.objects.size();
    if (path.starts_with(kObjects)) {
      std::from_chars(path.data() + kObjects.size(), path.data() + path.size(), object);
    }
    const bool known = object < scene.objects.size();
    std::string remedy = remedy_without_line(error);
    const std::string_view in_scenes = kOverlappingStartsRemedy;
    if (const auto at = remedy.find(in_scenes); at != std::string::npos) {
      remedy.replace(at, in_scenes.size(), ", or give --overlapping-starts contact (not refused)");
    }
    throw InputError(objects.file, known ? place_of(scene.objects[object].id, objects) : "",
                     error.problem(), remedy);
  }
}

}  // namespace

const std::vector<Vertex2>* PolygonTable::find(const std::string& id) const {
  auto at = number.find(id);
  if (at == number.end()) at = number.find(kEveryId);
  return at == number.end() ? nullptr : &entries[at->second].vertices;
}

PolygonTable parse_polygons(std::string_view text, const std::string& file) {
  const CsvTable table = parse_csv(text, file);
  const auto id = table.column("id"), x = table.column("x"), y = table.column("y");
  if (!id || !x || !y || table.columns.size() != 3) {
    check_names(table.columns, table.separator, file);
    throw InputError(file, "line 1", "the columns are not id, x and y", kPolygonColumns);
  }
  if (table.rows.empty()) throw InputError(file, "", "there are no rows", kPolygonColumns);
  PolygonTable polygons{file, {}, {}};
  std::vector<std::vector<const CsvRow*>> rows;  // of each entry
  for (const CsvRow& row : table.rows) {
    const std::string& name = row.fields[*id];
    check_csv_id(name, file, place_of_row(row));
    for (const std::size_t column : {*x, *y}) csv_number(table, row, column, file);
    const auto [entry, is_new] = polygons.number.emplace(name, rows.size());
    if (is_new) {
      polygons.entries.push_back({name, row.line, {}});
      rows.emplace_back();
    }
    rows[entry->second].push_back(&row);
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    PolygonTable::Entry& entry = polygons.entries[k];
    entry.vertices = polygon_of(entry.id, rows[k], *x, *y, file);
  }
  return polygons;
}

void make_bodies(Scene& scene, const PolygonTable& polygons, const ObjectTable& objects) {
  check_known(scene, polygons, objects);
  for (SceneObject& object : scene.objects) {
    const std::vector<Vertex2>* polygon = polygons.find(object.id);
    if (polygon == nullptr) {
      const std::string place = place_of(object.id, objects);
      throw InputError(place.empty() ? "--fixed" : objects.file, place,
                       show_text(object.id) + " has no polygon in " + polygons.file,
                       "add its vertices there, or those of \"*\", for all that have none");
    }
    object.polygon = *polygon;
  }
  check_scene(scene, objects);
}

void refuse_overlapping_points(const Scene& scene) {
  if (scene.overlapping_starts == OverlappingStarts::kRefused) return;
  throw InputError("--overlapping-starts", "", "points do not overlap",
                   "give --polygons too, or leave it out");
}

}  // namespace kinex::formats
