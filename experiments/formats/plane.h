// SPDX-License-Identifier: GPL-3.0-or-later
// Plane: how the coordinates of a geographic file become those of a scene.
//
// A scene's coordinates are planar; degrees are not. A file whose coordinate reference system is geographic,
// or not named (then it is WGS 84), is refused unless the user says how to project it.
#ifndef KINEX_EXPERIMENTS_FORMATS_PLANE_H
#define KINEX_EXPERIMENTS_FORMATS_PLANE_H

#include <optional>
#include <string>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/formats/json_node.h"

namespace kinex::formats {

// The name of the plane of a scene, in files that kinex writes.
inline constexpr const char* kScenePlane = "kinex:plane";

class Plane {
 public:
  Plane() = default;
  // Coordinates are planar, whatever the file says.
  static Plane as_they_are();
  // Metres east and north of "LON,LAT" (degrees), by two rational factors: those of the sphere of radius
  // 6371008.8 m there, as multiples of 2^-30. Throws InputError that names --local.
  static Plane around(const std::string& text);

  // `crs`: the "crs" that holds for `node`, if there is one. Throws InputError that names `node` for
  // coordinates that are not planar.
  void check(const std::optional<JsonNode>& crs, const JsonNode& node) const;
  // A position as the file has it, in the scene's plane.
  void project(std::vector<Rational>& position) const;
  // "x = 67956.. (longitude - 13.4)"; empty where positions stay as they are.
  std::string text() const;

 private:
  enum class Form { kAsNamed, kAsTheyAre, kAround };
  Form form_ = Form::kAsNamed;
  Rational longitude_, latitude_, east_, north_;  // kAround: origin, and metres a degree
};

}  // namespace kinex::formats

#endif
