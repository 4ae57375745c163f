// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the polygons of bodies: a table with the columns id,x,y, a row for each vertex.
#ifndef KINEX_EXPERIMENTS_FORMATS_CSV_POLYGONS_H
#define KINEX_EXPERIMENTS_FORMATS_CSV_POLYGONS_H

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/motion/scene.h"

namespace kinex::formats {

// The id of the polygon of all objects without one of their own.
inline constexpr const char* kEveryId = "*";

struct PolygonTable {
  struct Entry {
    std::string id;
    std::size_t line;  // of its first vertex
    std::vector<Vertex2> vertices;
  };

  std::string file;
  std::vector<Entry> entries;                           // in order of first rows
  std::unordered_map<std::string, std::size_t> number;  // of an id's entry

  // The polygon of `id`, else that of kEveryId; nullptr if there is neither.
  const std::vector<Vertex2>* find(const std::string& id) const;
};

// The rows of one id are its vertices in their order, in the frame of the body; rows of other ids
// may stand between them. A polygon must be valid in a scene: convex, counter-clockwise, no vertex
// repeated, no three consecutive vertices on a line. Throws InputError that names the line.
PolygonTable parse_polygons(std::string_view text, const std::string& file);

// The table that the objects of a scene come from.
struct ObjectTable {
  const std::string& file;
  const std::unordered_map<std::string, std::size_t>& lines;  // of the first row of every id
};

// Gives every object its polygon; the scene's motions are already those of bodies. Objects that are
// not in the table are those of --fixed. Throws InputError for an object without a polygon, for a
// polygon without an object, and for bodies in contact at the start, as the scene reader does.
void make_bodies(Scene& scene, const PolygonTable& polygons, const ObjectTable& objects);

// Throws InputError if the option --overlapping-starts was given for points.
void refuse_overlapping_points(const Scene& scene);

}  // namespace kinex::formats

#endif
