// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/attribute_json.h"

namespace kinex::formats {

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
    case Attribute::Shape::kOrders: {
      const std::size_t width = width_of_orders(attribute);
      json.begin_array();
      for (std::size_t i = 0; i < ids.size(); i += width) {
        json.begin_array();
        for (std::size_t k = i; k < i + width; ++k) write_id(ids[k]);
        json.end_array();
      }
      json.end_array();
      break;
    }
    case Attribute::Shape::kTuples:
      json.begin_array();
      for (std::size_t i = 0; i + attribute.width <= ids.size(); i += attribute.width) {
        json.begin_array();
        for (std::size_t k = i; k < i + attribute.width; ++k) write_id(ids[k]);
        json.end_array();
      }
      json.end_array();
      break;
  }
}

}  // namespace kinex::formats
