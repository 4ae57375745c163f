// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a scene, each read from its own JSON node. For the readers of scenes and features only.
#ifndef KINEX_EXPERIMENTS_FORMATS_SCENE_PARTS_H
#define KINEX_EXPERIMENTS_FORMATS_SCENE_PARTS_H

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/json_node.h"

namespace kinex {
struct StructureInfo;
}

namespace kinex::formats {

// Fills `motion`, which must be empty, with the "motion" of an object: [[c0, c1, ..], ..], or a
// list of pieces {"from", "to", "coordinates"}, which must be ascending, not overlapping, and
// continuous where two pieces meet unless the scene jumps. A gap between two pieces is a time
// without the object. The motion of a body has kBodyAxes axes: the "rotor" stands beside "motion"
// or inside each piece. The scene's dimension and time must have been read.
void read_motion(const JsonNode& object, const Scene& scene, bool body, Motion& motion);

// The coefficients of one axis, of a polynomial that `what` names in messages.
std::vector<Rational> read_coefficients(const JsonNode& list, int max_degree,
                                        std::string_view what);

// "radius" or "half extents", for messages.
std::string_view name_of(Extents extents);
// The extents of the first object of a scene, and so of all: it has a "radius", or "half_extents",
// beside its motion or in its first piece. None if it is a body or a line.
Extents read_kind_of_extents(const JsonNode& object);
// Refuses an object that has other extents than the first one of the scene, or has a polygon,
// a weight or vertices beside them.
void check_kind_of_extents(const JsonNode& object, const Scene& scene);
void refuse_extents_beside_pieces(const JsonNode& object);
// Appends the extents of `owner`, the scene's last object or one of its pieces, to its trajectory, if the
// scene has some.
void add_extents(const JsonNode& owner, const Scene& scene, MotionPiece& piece);
// Refuses extents that are negative at a time of the piece that is in the scene's time, or right
// after it; `goes_on`: another piece begins where this one ends, so the time after its end is not
// looked at.
void check_extents(const JsonNode& owner, const Scene& scene, const MotionPiece& piece,
                   bool goes_on);

// The two coefficient lists of a rotor; (1, 0), no turn, if there is no node.
std::vector<std::vector<Rational>> read_rotor(const std::optional<JsonNode>& node);
// Refuses a rotor whose two parts vanish together in [from, to].
void check_rotor(const JsonNode& node, const Trajectory& trajectory, const Rational& from,
                 const std::optional<Rational>& to);
// A convex polygon, vertices counter-clockwise, no three consecutive ones on a line.
std::vector<Vertex2> read_polygon(const JsonNode& node);
// The end of a remedy for bodies that start overlapping.
inline constexpr const char* kOverlappingStartsRemedy =
    ", or say \"overlapping_starts\": \"contact\" (not \"refused\", the default) in the scene";
// Refuses two bodies that are not apart at the scene's start.
void check_apart(const JsonNode& objects, const Scene& scene);
// Refuses a body that overlaps another when it appears, or jumps, after the start. A mere touch is
// left to the run, since the bodies may part at once.
void check_appearances(const JsonNode& objects, const Scene& scene);

// Fills scene.maintain; the objects must have been read.
void read_maintain(const JsonNode& node, Scene& scene);

// The object of this id.
ObjectId read_object(const JsonNode& node, const Scene& scene);
// The members "of", "query" and "colours" of an entry of "maintain".
void read_object_sets(const JsonNode& node, const StructureInfo& info, const Scene& scene,
                      Request& request);

// "overlapping_starts".
void read_overlapping_starts(const JsonNode& node, Scene& scene);

// Fills scene.queries; the time and "maintain" must have been read.
void read_queries(const JsonNode& node, Scene& scene, const std::string& file);

// True if the object exists at every instant of the scene's time.
bool lives_throughout(const Motion& motion, const Scene& scene);

}  // namespace kinex::formats

#endif
