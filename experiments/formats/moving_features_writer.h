// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a scene as OGC Moving Features JSON (prism form): MovingPoint, or MovingPolygon for bodies.
//
// Linear pieces whose numbers have finite decimals are written as they are; importing them again gives the
// same motions. Other times are rounded to 12 digits after the point, other places to 15; pieces of higher
// degree are sampled, more densely where they bend, until the straight lines between are near enough.
// "properties"."kinex" of each feature says "exact": true, or "error_at_most": a number that the distance on
// every axis never exceeds, at any time. Where an object jumps, or is absent for a while, its prisms are
// those of a MovingGeometryCollection.
//
// The member "kinex" of the file has name, time, axes and what is maintained: moving_features.h reads it.
#ifndef KINEX_EXPERIMENTS_FORMATS_MOVING_FEATURES_WRITER_H
#define KINEX_EXPERIMENTS_FORMATS_MOVING_FEATURES_WRITER_H

#include <cstddef>
#include <optional>
#include <string>

#include "core/motion/scene.h"

namespace kinex::formats {

struct MovingFeaturesForm {
  Rational time_zero;             // seconds since 1970 at t = 0
  Rational tolerance;             // > 0: of the straight lines in place of curves
  std::optional<Rational> until;  // in place of the scene's end
};

struct WrittenFeatures {
  std::string text;
  std::size_t inexact = 0;  // objects
  Rational error;           // the largest of theirs
};

// Throws InputError, with `file` as its file, for a scene without an end (and no `until`), for dates beyond
// the years 1 to 9999, for bodies that turn, and where a tolerance takes too many samples.
WrittenFeatures write_moving_features(const Scene& scene, const std::string& file,
                                      const MovingFeaturesForm& form);

}  // namespace kinex::formats

#endif
