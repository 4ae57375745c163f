// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/feature_geometry.h"

#include <algorithm>
#include <utility>

#include "core/numbers/show_text.h"
#include "experiments/formats/counted.h"

namespace kinex::formats {

namespace {

using Kind = JsonValue::Kind;

enum class Shape { kPoint, kPolygon };

// "Linear", ["Linear"]; empty: it is not named.
std::string interpolation_of(const JsonNode& node) {
  for (const char* name : {"interpolation", "interpolations"}) {
    const std::optional<JsonNode> member = node.find(name);
    if (!member) continue;
    if (!member->is(Kind::kArray)) return std::string(member->string());
    if (member->size() != 1) {
      member->fail(counted(member->size(), "interpolation", "interpolations") + " in one array",
                   "write one");
    }
    return std::string(member->at(0).string());
  }
  return "";
}

// True for Step.
bool is_step(const JsonNode& node, FeatureReading& reading, bool& assumed) {
  const std::string name = interpolation_of(node);
  if (name == "Step" || name == "Stepwise") return true;
  if (name == "Linear") return false;
  if (name.empty()) {
    assumed = true;
    return false;
  }
  if (name == "Discrete") {
    if (reading.linear) return false;
    node.fail("the interpolation is Discrete: nothing is known between two times",
              "give --linear to connect the places by straight lines");
  }
  node.fail("the interpolation " + show_text(name) + " cannot be read",
            "write Linear or Step, with as many times as the curve needs");
}

std::vector<Rational> read_times(const JsonNode& node, FeatureReading& reading) {
  node.require_array();
  if (node.size() == 0) node.fail("no times", "write one for each place");
  std::vector<Rational> times;
  for (std::size_t i = 0; i < node.size(); ++i) {
    times.push_back(read_datetime(node.at(i), reading));
    if (i == 0 || times[i - 1] < times[i]) continue;
    node.at(i).fail(
        times[i - 1] == times[i] ? "the time before it is the same" : "the time before it is later",
        "write times in ascending order, each once");
  }
  return times;
}

void require_one_each(const JsonNode& times, const JsonNode& places) {
  places.require_array();
  if (times.size() == places.size()) return;
  places.fail(
      counted(places.size(), "place", "places") + " for " + counted(times.size(), "time", "times"),
      "write one place for each time");
}

// The only ring of a polygon, without its last vertex, which is the first.
std::vector<Vertex2> read_ring(const JsonNode& polygon, FeatureReading& reading) {
  polygon.require_array();
  if (polygon.size() == 0) polygon.fail("a polygon without rings", "write its exterior ring");
  // [[x, y], ..]: the ring itself, as some programs write it.
  const bool bare = polygon.at(0).is(Kind::kArray) && polygon.at(0).size() > 0 &&
                    !polygon.at(0).at(0).is(Kind::kArray);
  if (!bare && polygon.size() != 1) {
    polygon.fail(
        counted(polygon.size(), "ring", "rings") + " in a polygon, but bodies have no holes",
        "keep the exterior ring");
  }
  const JsonNode ring = bare ? polygon : polygon.at(0);
  ring.require_array();
  std::vector<Vertex2> vertices;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::vector<Rational> position = read_position(ring.at(i), reading);
    if (position.size() != 2)
      ring.at(i).fail("a vertex with 3 axes", "bodies are plane; write two");
    vertices.push_back({position[0], position[1]});
  }
  if (vertices.size() < 4 || vertices.front() != vertices.back()) {
    ring.fail("a ring that is not closed",
              "write three vertices or more, and the first one again at the end");
  }
  vertices.pop_back();
  return vertices;
}

Rational doubled_area(const std::vector<Vertex2>& polygon) {
  Rational area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex2& a = polygon[i];
    const Vertex2& b = polygon[(i + 1) % polygon.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

// Places of the first vertex; the polygon about it, counter-clockwise.
std::vector<std::vector<Rational>> read_polygons(const JsonNode& places, FeatureReading& reading,
                                                 std::vector<Vertex2>& polygon) {
  std::vector<std::vector<Rational>> origins;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::vector<Vertex2> ring = read_ring(places.at(i), reading);
    const Vertex2 origin = ring.front();
    for (Vertex2& vertex : ring) vertex = {vertex[0] - origin[0], vertex[1] - origin[1]};
    if (doubled_area(ring).sign() < 0) std::reverse(ring.begin() + 1, ring.end());
    if (polygon.empty()) polygon = ring;
    if (ring != polygon) {
      places.at(i).fail("the polygon turns or deforms",
                        "polygons that are moved without turning are bodies; give points and "
                        "--polygons for others");
    }
    origins.push_back({origin[0], origin[1]});
  }
  return origins;
}

FeatureRun make_run(const JsonNode& times, const JsonNode& places, bool step, Shape shape,
                    FeatureReading& reading, std::vector<Vertex2>& polygon) {
  require_one_each(times, places);
  std::vector<Rational> ts = read_times(times, reading);
  std::vector<std::vector<Rational>> positions;
  if (shape == Shape::kPolygon) {
    positions = read_polygons(places, reading, polygon);
  } else {
    for (std::size_t i = 0; i < places.size(); ++i)
      positions.push_back(read_position(places.at(i), reading));
  }
  FeatureRun run{{}, step, times.path()};
  for (std::size_t i = 0; i < ts.size(); ++i)
    run.fixes.push_back({std::move(ts[i]), std::move(positions[i]), {}});
  return run;
}

// A MovingPoint or MovingPolygon; or a sequence of one, which has the interpolation of `outer`.
void read_primitive(const JsonNode& node, const JsonNode& outer, Shape shape,
                    FeatureReading& reading, FeatureGeometry& geometry) {
  const bool step = is_step(outer, reading, geometry.assumed_linear);
  geometry.runs.push_back(make_run(node.member("datetimes"), node.member("coordinates"), step,
                                   shape, reading, geometry.polygon));
}

Shape shape_of(const JsonNode& node) {
  const JsonNode type = node.member("type");
  if (type.string() == "MovingPoint" || type.string() == "MovingGeomPoint") return Shape::kPoint;
  if (type.string() == "MovingPolygon") return Shape::kPolygon;
  type.refuse("a moving geometry that can be read", "write MovingPoint or MovingPolygon");
}

// By time; runs of one feature must not overlap.
void sort_runs(FeatureGeometry& geometry, const JsonNode& node) {
  std::vector<FeatureRun>& runs = geometry.runs;
  std::stable_sort(runs.begin(), runs.end(), [](const FeatureRun& a, const FeatureRun& b) {
    return a.fixes.front().t < b.fixes.front().t;
  });
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].fixes.front().t < runs[i - 1].fixes.back().t) {
      node.fail("the times of " + runs[i - 1].path + " and " + runs[i].path + " overlap",
                "give a feature one place at a time");
    }
  }
}

}  // namespace

Rational read_datetime(const JsonNode& node, FeatureReading& reading) {
  if (node.is(Kind::kNumber)) {
    Rational seconds = node.rational() / Rational(1000);
    if (!has_iso_text(seconds)) {
      node.refuse("a number of milliseconds since 1970",
                  "write one of the years 1 to 9999, or a date");
    }
    return reading.scale.read_seconds(std::move(seconds));
  }
  const std::string_view text = node.string();
  if (!looks_like_date(text)) {
    node.refuse("a date",
                "write it as \"2024-05-01T12:30:05Z\", or as a number of milliseconds since 1970");
  }
  return reading.scale.read(text, reading.file, node.path(), show_text(text));
}

std::vector<Rational> read_position(const JsonNode& node, FeatureReading& reading) {
  node.require_array();
  const int dimension = static_cast<int>(node.size());
  if (dimension != 2 && dimension != 3) {
    node.fail("a position of " + counted(node.size(), "number", "numbers"),
              "write [x, y] or [x, y, z]");
  }
  if (reading.dimension.value_or(dimension) != dimension) {
    node.fail("a position of " + std::to_string(dimension) +
                  " numbers in a file with positions of " + std::to_string(*reading.dimension),
              "write all with the same axes");
  }
  reading.dimension = dimension;
  std::vector<Rational> position;
  for (std::size_t axis = 0; axis < node.size(); ++axis)
    position.push_back(node.at(axis).rational());
  reading.plane.project(position);
  return position;
}

FeatureGeometry read_temporal_geometry(const JsonNode& node, const std::optional<JsonNode>& crs,
                                       FeatureReading& reading) {
  if (!node.is(Kind::kObject))
    node.refuse("a moving geometry", "write {\"type\": \"MovingPoint\", ..}");
  const std::optional<JsonNode> own = node.find("crs");
  reading.plane.check(own ? own : crs, node);
  FeatureGeometry geometry;
  if (node.member("type").string() == "MovingGeometryCollection") {
    const JsonNode prisms = node.member("prisms");
    prisms.require_array();
    if (prisms.size() == 0) prisms.fail("a collection of nothing", "write a prism");
    const Shape shape = shape_of(prisms.at(0));
    for (std::size_t i = 0; i < prisms.size(); ++i) {
      const JsonNode prism = prisms.at(i);
      if (shape_of(prism) != shape)
        prism.fail("points and polygons in one collection", "write one kind of them");
      read_primitive(prism, prism, shape, reading, geometry);
    }
  } else if (const auto sequences = node.find("sequences")) {
    sequences->require_array();
    for (std::size_t i = 0; i < sequences->size(); ++i) {
      read_primitive(sequences->at(i), node, shape_of(node), reading, geometry);
    }
  } else {
    read_primitive(node, node, shape_of(node), reading, geometry);
  }
  sort_runs(geometry, node);
  return geometry;
}

FeatureGeometry read_trajectory(const JsonNode& geometry, const JsonNode& times,
                                FeatureReading& reading) {
  FeatureGeometry result;
  result.runs.push_back(make_run(times, geometry.member("coordinates"), false, Shape::kPoint,
                                 reading, result.polygon));
  return result;
}

}  // namespace kinex::formats
