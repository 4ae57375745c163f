// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/attribute_json.h"

namespace kinex {

void write_attribute(JsonWriter& json, const Attribute& attribute, const Scene& scene) {
  const auto write_id = [&](ObjectId id) { json.string(scene.objects[id].id); };
  const std::vector<ObjectId>& ids = attribute.ids;
  switch (attribute.shape) {
    case Attribute::Shape::kObject:
      if (ids.empty()) {
        json.null();
      } else {
        write_id(ids.front());
      }
      break;
    case Attribute::Shape::kSequence:
    case Attribute::Shape::kCycle:
      json.begin_array();
      for (const ObjectId id : ids) write_id(id);
      json.end_array();
      break;
    case Attribute::Shape::kEdges:
      json.begin_array();
      for (std::size_t i = 0; i + 1 < ids.size(); i += 2) {
        json.begin_array();
        write_id(ids[i]);
        write_id(ids[i + 1]);
        json.end_array();
      }
      json.end_array();
      break;
  }
}

}  // namespace kinex
