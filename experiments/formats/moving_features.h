// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a scene from GeoJSON with times, and from OGC Moving Features JSON (OGC 19-045r3).
//
// A Feature, or a FeatureCollection, each feature in one of these forms:
//   prism       "temporalGeometry": MovingPoint, or MovingPolygon, or a MovingGeometryCollection of one of
//               them ("prisms"); each with "datetimes", "coordinates", "interpolation" (or "interpolations").
//               MovingGeomPoint and "sequences", as MobilityDB writes them, are read too.
//   trajectory  "geometry": a LineString, and "properties"."datetimes", one for each vertex
//   fixes       "geometry": a Point, and a property with its time; several features may have one id
//
// Ids are those of the features, or of their property "id". Dates are RFC 3339; in "datetimes" a number
// counts milliseconds since 1970. Linear between two times; Step: at rest, then a jump; Discrete is refused
// unless it is to be read as Linear; Quadratic, Cubic and curves of others are refused. Decimals are exact
// as written.
//
// A MovingPolygon is a body if all its polygons are one polygon that is moved without turning (vertices that
// move linearly deform a polygon that turns); this is checked exactly. Its origin is its first vertex.
//
// What kinex writes (moving_features_writer.h) has a member "kinex", which gives back what a scene has beside
// its objects, and others in "properties" for what objects have beside their places (feature_members.h).
//
// A moving geometry alone, as MobilityDB's asMFJSON gives it, is one object: its "id", or "1".
#ifndef KINEX_EXPERIMENTS_FORMATS_MOVING_FEATURES_H
#define KINEX_EXPERIMENTS_FORMATS_MOVING_FEATURES_H

#include <string>
#include <string_view>

#include "experiments/formats/csv_import.h"
#include "experiments/formats/plane.h"

namespace kinex::formats {

struct MovingFeaturesOptions {
  // Of these: times, time zero, the columns "id" and "t" (names of properties), fixed, polygons,
  // overlapping_starts.
  ImportOptions common;
  Plane plane;
  bool linear = false;   // Discrete is read as Linear
  bool maintain = true;  // what the file says is to be maintained is read, and its queries
};

// True if the text begins as JSON does, not as a table.
bool looks_like_json(std::string_view text);

// Throws InputError with the JSON path, or the option.
ImportReport import_moving_features(std::string_view text, const std::string& file,
                                    const MovingFeaturesOptions& options);

}  // namespace kinex::formats

#endif
