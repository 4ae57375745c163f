// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a scene from a table: traces (id,t,x,y[,z]) or points with velocities
// (id,x,y[,z],vx,vy[,vz]). With polygons the points are the origins of rigid bodies.
#ifndef KINEX_EXPERIMENTS_FORMATS_CSV_IMPORT_H
#define KINEX_EXPERIMENTS_FORMATS_CSV_IMPORT_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/csv_columns.h"
#include "experiments/formats/csv_polygons.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/scene_words.h"
#include "experiments/formats/time_scale.h"

namespace kinex::formats {

struct HeadingColumn {
  std::string column;    // degrees from -360 to 360
  bool compass = false;  // clockwise from the y axis, not counter-clockwise from the x axis
};

struct ImportOptions {
  std::optional<Rational> start, end;              // of the scene; default below
  std::optional<OptionTime> start_time, end_time;  // the same as they are written, dates too
  std::optional<OptionTime> time_zero;             // of dates; default: the first one
  std::vector<NamedColumn> columns;                // of other names than their meanings
  bool ignore_columns = false;                     // others may be there
  char separator = kGuessedSeparator;
  std::vector<std::string> fixed;        // rows "id,x[,y[,z]]" of objects that stand still
  std::optional<PolygonTable> polygons;  // makes every object a body; 2 axes
  std::optional<HeadingColumn> heading;  // of bodies; without it they do not turn
  OverlappingStarts overlapping_starts = OverlappingStarts::kRefused;  // of bodies
};

struct ImportReport {
  Scene scene;  // "maintain" and the name only if the file says so
  std::size_t rows = 0;
  // Traces of one fix: they have no duration, and are left out. Each as "\"a\" (line 7)".
  std::vector<std::string> single_fixes;
  std::size_t repeated_fixes = 0;  // identical rows of one id and time: read once
  std::size_t ignored_columns = 0;
  std::string time_zero;              // of dates: the date at which t = 0; otherwise empty
  std::vector<std::string> notes;     // what the user should know
  std::vector<std::string> details;   // what was read as what
  bool maintains = false, is_named = false;  // the file says so
  SceneWords words;                          // likewise
};

// The first line names the columns, in any order; the coordinates are a prefix of x, y, z. Numbers
// are exact, as in scenes. Fields may be quoted ("a, b"). Objects are in the order of their first
// rows, fixed objects last. Defaults can be overridden by the options.
//   traces      An object exists from its first to its last fix and moves linearly between two
//               fixes; rows need not be in the order of time. Two fixes of one id at one time must
//               be identical. Default time of the scene: that of all fixes together; one that has
//               no trace in it is refused. Times are numbers, or dates (time_scale.h).
//   velocities  x(t) = x + vx t, by default from time 0 on; without an end the scene runs until no
//               event is left.
//   properties  Radii, weights, half extents, colours, vertices, lines: csv_properties.h. In a table of edges of a
//               graph (from, to) the coordinate is the column "x", or "weight".
//   fixed       Objects that exist at all times; behind the place of each its radius, weight or half extents, if the
//               table has them.
//   bodies      The coordinates are those of the origin of a polygon's frame. A heading turns the
//               frame, to the precision of experiments/formats/heading.h. Between two fixes the
//               rotor is linear in t, the short way round, so the motion is continuous. The body of
//               a row with velocities keeps its heading; fixed objects have heading 0. Bodies that
//               overlap when they are first seen are refused by default.
//
// Throws InputError that names the line, or the option.
ImportReport import_csv(std::string_view text, const std::string& file,
                        const ImportOptions& options);

}  // namespace kinex::formats

#endif
