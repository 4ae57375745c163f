// SPDX-License-Identifier: GPL-3.0-or-later
// FeatureGeometry: the times and places of one feature of a Moving Features file, before the time zero is
// known.
#ifndef KINEX_EXPERIMENTS_FORMATS_FEATURE_GEOMETRY_H
#define KINEX_EXPERIMENTS_FORMATS_FEATURE_GEOMETRY_H

#include <optional>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/plane.h"
#include "experiments/formats/time_scale.h"
#include "experiments/formats/trace.h"

namespace kinex::formats {

// Fixes in ascending order of time, without a gap.
struct FeatureRun {
  std::vector<Fix> fixes;
  bool step = false;
  std::string path;  // of its times
};

struct FeatureGeometry {
  std::vector<FeatureRun> runs;
  std::vector<Vertex2> polygon;  // of a body
  bool assumed_linear = false;   // no interpolation is named
};

// What is the same in a whole file.
struct FeatureReading {
  TimeScale& scale;
  const Plane& plane;
  const std::string& file;
  bool linear = false;                // Discrete is read as Linear
  std::optional<int> dimension = {};  // of the positions so far
};

// "temporalGeometry". Throws InputError, as the next ones do.
FeatureGeometry read_temporal_geometry(const JsonNode& node, const std::optional<JsonNode>& crs,
                                       FeatureReading& reading);
// A LineString and its times.
FeatureGeometry read_trajectory(const JsonNode& geometry, const JsonNode& times,
                                FeatureReading& reading);
// [x, y] or [x, y, z], in the scene's plane.
std::vector<Rational> read_position(const JsonNode& node, FeatureReading& reading);
// A string with a date, or a number: milliseconds since 1970.
Rational read_datetime(const JsonNode& node, FeatureReading& reading);

}  // namespace kinex::formats

#endif
