// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/scene_writer.h"

#include "experiments/formats/json_writer.h"
#include "experiments/formats/sha256.h"
#include "experiments/formats/weights.h"

namespace kinex::formats {

namespace {

constexpr int kExactBits = 53;  // integers that every JSON reader holds exactly

void write_number(JsonWriter& json, const Rational& value) {
  const std::string text = value.to_string();
  if (value.is_integer() && value.numerator().bit_length() <= kExactBits) {
    json.raw(text);
  } else {
    json.string(text);
  }
}

template <class Numbers>
void write_numbers(JsonWriter& json, const Numbers& numbers) {
  json.begin_array();
  for (const Rational& number : numbers) write_number(json, number);
  json.end_array();
}

void write_axes(JsonWriter& json, const Trajectory& trajectory, int first, int last) {
  json.begin_array();
  for (int axis = first; axis < last; ++axis) {
    write_numbers(json, trajectory.coordinates[static_cast<std::size_t>(axis)]);
  }
  json.end_array();
}

bool turns(const Trajectory& trajectory) {
  return trajectory.coordinates[2] != std::vector<Rational>{1} ||
         trajectory.coordinates[3] != std::vector<Rational>{0};
}

void write_weight(JsonWriter& json, const std::vector<Rational>& weight) {
  json.key("weight");
  if (weight.size() == 1) {
    write_number(json, weight[0]);
  } else {
    write_numbers(json, weight);
  }
}

// The coordinates as the value of the key just written, then the rotor of a body that has one, or
// the extents.
void write_trajectory(JsonWriter& json, const Trajectory& trajectory, const Scene& scene) {
  const bool body = scene.has_bodies();
  write_axes(json, trajectory, 0, scene.dimension);
  if (scene.extents == Extents::kRadius) {
    write_numbers(json.key("radius"), trajectory.coordinates.back());
  } else if (scene.extents == Extents::kHalfExtents) {
    write_axes(json.key("half_extents"), trajectory, scene.dimension, scene.axes());
  }
  if (!body || !turns(trajectory)) return;
  json.key("rotor");
  write_axes(json, trajectory, 2, kBodyAxes);
}

// A weight that is not the same in all pieces stands in each of them.
void write_motion(JsonWriter& json, const SceneObject& object, const Scene& scene) {
  const Motion& motion = object.motion;
  const MotionPiece& first = motion.pieces.front();
  const bool own_weights = scene.extents == Extents::kWeight && !common_weight(object, scene);
  if (motion.pieces.size() == 1 && !first.from && !first.to) {
    write_trajectory(json, first.trajectory, scene);
    return;
  }
  json.begin_array();
  for (const MotionPiece& piece : motion.pieces) {
    json.begin_object();
    if (piece.from) {
      json.key("from");
      write_number(json, *piece.from);
    }
    if (piece.to) {
      json.key("to");
      write_number(json, *piece.to);
    }
    json.key("coordinates");
    write_trajectory(json, piece.trajectory, scene);
    if (own_weights) write_weight(json, piece.trajectory.coordinates.back());
    json.end_object();
  }
  json.end_array();
}

void write_key(JsonWriter& json, const Key& key, const Scene& scene) {
  switch (key.kind) {
    case Key::Kind::kCoordinate:
      json.string(std::string(1, "xyz"[key.axis]));
      break;
    case Key::Kind::kDirection:
      json.begin_object().key("direction").begin_array();
      for (const Rational& entry : key.direction) write_number(json, entry);
      json.end_array().end_object();
      break;
    case Key::Kind::kSquaredDistance:
      json.begin_object()
          .key("squared_distance_to")
          .string(scene.objects[key.object].id)
          .end_object();
      break;
  }
}

void write_texts(JsonWriter& json, const std::vector<std::string>& texts) {
  json.begin_array();
  for (const std::string& text : texts) json.string(text);
  json.end_array();
}

void write_subset(JsonWriter& json, const Subset& subset, const Scene& scene) {
  std::vector<std::string> ids;
  for (const ObjectId object : subset.objects) ids.push_back(scene.objects[object].id);
  if (subset.kind == Subset::Kind::kObjects) return write_texts(json, ids);
  if (subset.kind == Subset::Kind::kColours && subset.colours.size() == 1) {
    json.string(subset.colours[0]);
    return;
  }
  const bool colours = subset.kind == Subset::Kind::kColours;
  json.begin_object().key(colours ? "colours" : "all_but");
  write_texts(json, colours ? subset.colours : ids);
  json.end_object();
}

bool has_options(const Request& request) {
  return !request.over.empty() || !request.parameters.empty() ||
         request.of.kind != Subset::Kind::kAll || request.query != kNoObject ||
         !request.colours.empty();
}

void write_options(JsonWriter& json, const Request& request, const Scene& scene);

void write_request(JsonWriter& json, const Request& request, const Scene& scene) {
  const bool default_key = request.key.kind == Key::Kind::kCoordinate && request.key.axis == 0;
  const bool is_named = !request.label.empty() && request.label != request.structure;
  if (default_key && !is_named && !has_options(request)) {
    json.string(request.structure);
    return;
  }
  json.begin_object().key("structure").string(request.structure);
  if (!default_key) {
    json.key("key");
    write_key(json, request.key, scene);
  }
  write_options(json, request, scene);
  if (is_named) json.key("as").string(request.label);
  json.end_object();
}

void write_options(JsonWriter& json, const Request& request, const Scene& scene) {
  if (request.of.kind != Subset::Kind::kAll) write_subset(json.key("of"), request.of, scene);
  if (request.query != kNoObject) json.key("query").string(scene.objects[request.query].id);
  if (!request.colours.empty()) write_texts(json.key("colours"), request.colours);
  for (const Request& over : request.over) write_request(json.key("over"), over, scene);
  for (const Parameter& parameter : request.parameters) {
    json.key(parameter.name);
    write_number(json, parameter.value);
  }
}

}  // namespace

void write_choices(JsonWriter& json, const Scene& scene) {
  if (scene.jumps) json.key("jumps").boolean(true);
  if (scene.overlapping_starts == OverlappingStarts::kContact) {
    json.key("overlapping_starts").string("contact");
  }
}

void write_queries(JsonWriter& json, const Scene& scene) {
  if (scene.queries.empty()) return;
  json.line(1).key("queries").begin_array();
  for (const BoxQuery& query : scene.queries) {
    json.line(2).begin_object().key("at");
    write_number(json, query.at);
    json.key("box").begin_array();
    for (const auto& side : query.box) write_numbers(json, side);
    json.end_array().end_object();
  }
  json.end_array();
}

std::string write_scene(const Scene& scene) { return write_scene(scene, {}); }

std::string write_scene(const Scene& scene, const SceneWords& words) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("kinex").number(1).key("name").string(scene.name);
  write_words(json, words);
  json.key("dimension").number(scene.dimension);
  json.key("time").begin_object().key("start");
  write_number(json, scene.start);
  if (scene.end) {
    json.key("end");
    write_number(json, *scene.end);
  }
  json.end_object();
  write_choices(json, scene);
  json.line(1).key("objects").begin_array();
  for (const SceneObject& object : scene.objects) {
    json.line(2).begin_object().key("id").string(object.id);
    if (!object.polygon.empty()) {
      json.key("polygon").begin_array();
      for (const Vertex2& vertex : object.polygon) write_numbers(json, vertex);
      json.end_array();
    }
    if (scene.extents == Extents::kWeight) {
      const auto weight = common_weight(object, scene);
      if (weight && *weight != std::vector<Rational>{Rational()}) write_weight(json, *weight);
    }
    if (!object.colour.empty()) json.key("colour").string(object.colour);
    if (!object.ends.empty()) write_texts(json.key("ends"), object.ends);
    if (object.line) json.key("line").boolean(true);
    json.key("motion");
    write_motion(json, object, scene);
    json.end_object();
  }
  json.end_array();
  json.line(1).key("maintain").begin_array();
  for (const Request& request : scene.maintain) write_request(json, request, scene);
  json.end_array();
  write_queries(json, scene);
  json.end_object();
  text += '\n';
  return text;
}

std::string scene_hash(const Scene& scene) { return sha256_hex(write_scene(scene)); }

std::string request_json(const Request& request, const Scene& scene) {
  std::string text;
  JsonWriter json(text);
  write_request(json, request, scene);
  return text;
}

std::string options_json(const Request& request, const Scene& scene) {
  if (!has_options(request)) return "";
  std::string text;
  JsonWriter json(text);
  write_options(json.begin_object(), request, scene);
  json.end_object();
  return text;
}

std::string key_json(const Key& key, const Scene& scene) {
  std::string text;
  JsonWriter json(text);
  write_key(json, key, scene);
  return text;
}

}  // namespace kinex::formats
