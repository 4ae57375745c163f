// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a scene as OGC Moving Features JSON (prism form): MovingPoint, or MovingPolygon for bodies.
//
// Linear pieces whose numbers have finite decimals are written as they are; importing them again gives the
// same scene, with the same hash. Other times are rounded to 12 digits after the point, other places to 15;
// pieces of higher degree are sampled, more densely where they bend, until the straight lines between are near enough.
// "properties"."kinex" of each feature says "exact": true, or "error_at_most": a number that the distance on
// every axis never exceeds, at any time. Where an object jumps, or is absent for a while, its prisms are
// those of a MovingGeometryCollection.
//
// The member "kinex" of the file has what a scene has beside its objects, "properties"."kinex" what an object
// has beside its places (feature_members.h): moving_features.h reads both.
#ifndef KINEX_EXPERIMENTS_FORMATS_MOVING_FEATURES_WRITER_H
#define KINEX_EXPERIMENTS_FORMATS_MOVING_FEATURES_WRITER_H

#include <cstddef>
#include <optional>
#include <string>

#include "core/motion/scene.h"
#include "experiments/formats/scene_words.h"

namespace kinex::formats {

struct MovingFeaturesForm {
  Rational time_zero;             // seconds since 1970 at t = 0
  Rational tolerance;             // > 0: of the straight lines in place of curves
  std::optional<Rational> until;  // in place of the scene's end
  SceneWords words;               // of the scene's file
};

struct WrittenFeatures {
  std::string text;
  std::size_t inexact = 0;  // objects
  std::size_t absent = 0;   // objects that are left out: they come after `until`
  Rational error;           // the largest of theirs
};

// Throws InputError, with `file` as its file, for a scene without an end (and no `until`), for dates beyond
// the years 1 to 9999, for bodies that turn, for what such a file cannot hold (discs, boxes, lines, weights
// that change, objects outside of the scene's time), and where a tolerance takes too many samples.
WrittenFeatures write_moving_features(const Scene& scene, const std::string& file,
                                      const MovingFeaturesForm& form);

}  // namespace kinex::formats

#endif
