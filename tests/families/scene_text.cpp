// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/families/scene_text.h"

namespace kinex::families {
namespace {

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string piece_text(const PieceText& piece) {
  std::string text = "{";
  if (!piece.from.empty()) text += "\"from\": " + quoted(piece.from) + ", ";
  if (!piece.to.empty()) text += "\"to\": " + quoted(piece.to) + ", ";
  text += "\"coordinates\": " + lists_text(piece.coordinates);
  if (!piece.rotor.empty()) text += ", \"rotor\": " + lists_text(piece.rotor);
  return text + "}";
}

std::string object_text(const ObjectText& object, std::size_t number) {
  std::string text = "{\"id\": " + quoted("o" + std::to_string(number));
  if (!object.polygon.empty()) text += ", \"polygon\": " + lists_text(object.polygon);
  text += ", \"motion\": [";
  for (std::size_t i = 0; i < object.pieces.size(); ++i) {
    text += (i == 0 ? "" : ", ") + piece_text(object.pieces[i]);
  }
  return text + "]}";
}

}  // namespace

std::string list_text(const Coefficients& coefficients) {
  std::string text = "[";
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    text += (i == 0 ? "" : ", ") + quoted(coefficients[i]);
  }
  return text + "]";
}

std::string lists_text(const std::vector<Coefficients>& lists) {
  std::string text = "[";
  for (std::size_t i = 0; i < lists.size(); ++i) text += (i == 0 ? "" : ", ") + list_text(lists[i]);
  return text + "]";
}

std::string scene_text(int dimension, const std::string& start, const std::string& end,
                       const std::vector<ObjectText>& objects, const std::string& more) {
  std::string text =
      "{\"kinex\": 1, \"name\": \"family\", \"dimension\": " + std::to_string(dimension) +
      ", \"time\": {\"start\": " + quoted(start);
  if (!end.empty()) text += ", \"end\": " + quoted(end);
  text += "}, " + more + "\n \"objects\": [";
  for (std::size_t i = 0; i < objects.size(); ++i) {
    text += (i == 0 ? "\n  " : ",\n  ") + object_text(objects[i], i);
  }
  return text + "]}\n";
}

}  // namespace kinex::families
