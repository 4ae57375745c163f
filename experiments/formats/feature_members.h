// SPDX-License-Identifier: GPL-3.0-or-later
// FeatureMembers: what kinex writes into "properties"."kinex" of a feature, beside the standard's members.
//
// Places and times of an object are those of the standard's members. These here are the rest of it, each
// left out where it is as usual:
//   "weight": NUMBER, "colour": NAME, "ends": [VERTEX, VERTEX]    as in a scene
//   "polygon": [[X, Y], ..]    of a body, in its frame; without it the frame is at the first vertex
//   "rotors": [[P, Q], ..]     of its pieces, or one for all; without it the frame is not turned
//   "from", "to": NUMBER       the first piece's and the last one's; null: none. Without them: those of the
//                              places, and none for an object that is there for the whole time
//   "cuts": [NUMBER, ..]       where one piece ends and another begins with the same motion
#ifndef KINEX_EXPERIMENTS_FORMATS_FEATURE_MEMBERS_H
#define KINEX_EXPERIMENTS_FORMATS_FEATURE_MEMBERS_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"

namespace kinex::formats {

struct FeatureMembers {
  using Bound = std::optional<Rational>;  // nullopt: none

  std::optional<Rational> weight;
  std::string colour;
  std::vector<std::string> ends;
  std::vector<Vertex2> polygon;
  std::vector<std::array<Rational, 2>> rotors;
  std::optional<Bound> from, to;
  std::vector<Rational> cuts;
  std::string file, path;  // of a file that was read, for messages
};

// Throws InputError, as those below do.
FeatureMembers read_members(const JsonNode& node, const std::string& file);
// Writes them into the open object.
void write_members(JsonWriter& json, const FeatureMembers& members);

// The polygon turned by the rotor (p, q).
std::vector<Vertex2> turned(const std::vector<Vertex2>& polygon, const Rational& p,
                            const Rational& q);

// The pieces as they are found in places and times: those that go on with the same motion are one, and
// what is there from the scene's start to its end has no ends.
void join_pieces(Motion& motion);
void open_ends(Motion& motion, const Rational& start, const Rational& end);

// "from", "to" and "cuts" that make `wanted` of the pieces `found`. Requires the same motion in both.
void note_pieces(const Motion& found, const Motion& wanted, FeatureMembers& members);
// Does what "from", "to" and "cuts" say, in the time from `start` to `end`; their times are `shift` later.
void restore_pieces(const FeatureMembers& members, const Rational& start, const Rational& end,
                    const Rational& shift, Motion& motion);
// Puts the frame of a body where "polygon" and "rotors" say. `polygon`: as it was found, with its first
// vertex at the origin.
void restore_frame(const FeatureMembers& members, std::vector<Vertex2>& polygon, Motion& motion);
void restore_rotors(const FeatureMembers& members, Motion& motion);

}  // namespace kinex::formats

#endif
