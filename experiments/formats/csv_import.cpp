// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_import.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/heading.h"
#include "experiments/formats/input_error.h"

namespace kinex::formats {

namespace {

constexpr const char* kColumns =
    "name the columns id,t,x[,y[,z]] (traces) or id,x[,y[,z]],vx[,vy[,vz]] (velocities)";

// Makes a trajectory that of a body.
void add_rotor(Trajectory& trajectory, RotorMotion rotor) {
  for (std::vector<Rational>& part : rotor) trajectory.coordinates.push_back(std::move(part));
}

class Importer {
 public:
  Importer(CsvTable table, const std::string& file, const ImportOptions& options)
      : table_(std::move(table)), file_(file), options_(options) {
    id_ = required("id");
    time_ = table_.column("t");
    for (const char* axis : {"x", "y", "z"}) {
      const auto coordinate = table_.column(axis);
      if (!coordinate) break;
      coordinates_.push_back(*coordinate);
    }
    if (coordinates_.empty()) required("x");
    if (!time_) {
      for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
        velocities_.push_back(required(std::string("v") + "xyz"[axis]));
      }
    }
    std::vector<bool> used(table_.columns.size());
    used[id_] = true;
    if (time_) used[*time_] = true;
    for (const std::size_t column : coordinates_) used[column] = true;
    for (const std::size_t column : velocities_) used[column] = true;
    if (options_.polygons) check_plane();
    if (options_.heading) find_heading(used);
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) {
      fail_unused(table_.columns[static_cast<std::size_t>(unused - used.begin())]);
    }
  }

  ImportReport import() {
    if (table_.rows.empty()) throw InputError(file_, "", "there are no rows", "write one per fix");
    report_.rows = table_.rows.size();
    report_.scene.dimension = static_cast<int>(coordinates_.size());
    if (time_) {
      import_traces();
    } else {
      import_velocities();
    }
    if (report_.scene.objects.empty()) {
      throw InputError(file_, "", "no object has two fixes", "write at least two fixes of one id");
    }
    for (const std::string& row : options_.fixed) add_fixed(row);
    check_time();
    report_.scene.overlapping_starts = options_.overlapping_starts;
    if (options_.polygons) make_bodies(report_.scene, *options_.polygons, {file_, lines_});
    return std::move(report_);
  }

 private:
  struct Fix {
    Rational t;
    std::vector<Rational> position;
    Rational heading;  // in [0, 360)
    const CsvRow* row;
  };

  std::size_t required(const std::string& name) const {
    const auto column = table_.column(name);
    if (!column) {
      throw InputError(file_, "line 1", "there is no column " + show_text(name), kColumns);
    }
    return *column;
  }

  void check_plane() const {
    if (coordinates_.size() == 2) return;
    throw InputError(file_, "line 1",
                     "bodies have 2 axes, the table has " + std::to_string(coordinates_.size()),
                     "name the columns x and y, or leave --polygons out");
  }

  void find_heading(std::vector<bool>& used) {
    const std::string option = options_.heading->compass ? "--bearing" : "--heading";
    const std::string& name = options_.heading->column;
    if (!options_.polygons) {
      throw InputError(option, "", "points have no heading",
                       "give --polygons too, or leave it out");
    }
    heading_ = table_.column(name);
    if (!heading_) {
      throw InputError(file_, "line 1",
                       "there is no column " + show_text(name) + ", the one of " + option,
                       "name a column of the table");
    }
    if (used[*heading_]) {
      throw InputError(option, "", "the column " + show_text(name) + " has another meaning",
                       "name a column of angles in degrees");
    }
    used[*heading_] = true;
  }

  [[noreturn]] void fail_unused(const std::string& column) const {
    const std::string problem = "the column " + show_text(column) + " means nothing here";
    if (!options_.polygons) throw InputError(file_, "line 1", problem, kColumns);
    throw InputError(file_, "line 1", problem,
                     "remove it, or name it with --heading or --bearing; a body that turns is "
                     "written as traces, for no rotor that is polynomial turns at a constant rate");
  }

  Rational number(const CsvRow& row, std::size_t column) const {
    return csv_number(table_, row, column, file_);
  }

  const std::string& id(const CsvRow& row) const {
    check_csv_id(row.fields[id_], file_, place_of_row(row));
    return row.fields[id_];
  }

  // Counter-clockwise from the x axis, in [0, 360); 0 where the table has none.
  Rational heading(const CsvRow& row) const {
    if (!heading_) return {};
    const Rational degrees = number(row, *heading_);
    if (degrees < Rational(-360) || degrees > Rational(360)) {
      throw InputError(file_, place_of_row(row),
                       show_text(row.fields[*heading_]) + " in column " +
                           show_text(table_.columns[*heading_]) + " is not an angle",
                       "write degrees from -360 to 360; leave out rows without a heading");
    }
    return options_.heading->compass ? heading_of_bearing(degrees) : reduced_heading(degrees);
  }

  void import_velocities() {
    Scene& scene = report_.scene;
    scene.start = options_.start.value_or(Rational(0));
    scene.end = options_.end;
    for (const CsvRow& row : table_.rows) {
      const auto [other, is_new] = lines_.emplace(id(row), row.line);
      if (!is_new) {
        throw InputError(file_, place_of_row(row),
                         "the id " + show_text(id(row)) + " is that of line " +
                             std::to_string(other->second) + " too",
                         "ids are unique");
      }
      Trajectory trajectory;
      for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
        trajectory.coordinates.push_back(
            {number(row, coordinates_[axis]), number(row, velocities_[axis])});
      }
      if (options_.polygons) add_rotor(trajectory, fixed_rotor(heading(row)));
      trajectory.normalise();
      Motion motion;
      motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
      scene.objects.push_back({id(row), std::move(motion)});
    }
  }

  void import_traces() {
    std::vector<std::pair<std::string, std::vector<Fix>>> traces;  // in order of first rows
    std::unordered_map<std::string, std::size_t> numbers;
    for (const CsvRow& row : table_.rows) {
      const auto [entry, is_new] = numbers.emplace(id(row), traces.size());
      if (is_new) {
        traces.emplace_back(id(row), std::vector<Fix>{});
        lines_.emplace(id(row), row.line);
      }
      Fix fix{number(row, *time_), {}, heading(row), &row};
      for (const std::size_t column : coordinates_) fix.position.push_back(number(row, column));
      traces[entry->second].second.push_back(std::move(fix));
    }
    std::optional<Rational> first, last;
    for (auto& [name, fixes] : traces) {
      sort_fixes(fixes);
      if (!first || fixes.front().t < *first) first = fixes.front().t;
      if (!last || fixes.back().t > *last) last = fixes.back().t;
      if (fixes.size() == 1) {
        ++report_.single_fixes;
        continue;
      }
      report_.scene.objects.push_back({name, motion_through(fixes)});
    }
    report_.scene.start = options_.start.value_or(*first);
    report_.scene.end = options_.end ? options_.end : last;
  }

  // Ascending in time, each time once.
  void sort_fixes(std::vector<Fix>& fixes) {
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const Fix& a, const Fix& b) { return a.t < b.t; });
    std::vector<Fix> kept;
    for (Fix& fix : fixes) {
      if (kept.empty() || kept.back().t != fix.t) {
        kept.push_back(std::move(fix));
        continue;
      }
      const bool moved = kept.back().position != fix.position;
      if (moved || kept.back().heading != fix.heading) {
        throw InputError(file_, place_of_row(*fix.row),
                         show_text(id(*fix.row)) +
                             (moved ? " is at another place" : " has another heading") +
                             " at the same time in line " + std::to_string(kept.back().row->line),
                         "remove one of the two fixes");
      }
      ++report_.repeated_fixes;
    }
    fixes = std::move(kept);
  }

  // Linear between fixes; fixes on one straight flight at one speed are one piece.
  Motion motion_through(const std::vector<Fix>& fixes) const {
    Motion motion;
    for (std::size_t i = 0; i + 1 < fixes.size(); ++i) {
      const Fix& from = fixes[i];
      const Fix& to = fixes[i + 1];
      Trajectory trajectory;
      for (std::size_t axis = 0; axis < from.position.size(); ++axis) {
        const Rational velocity = (to.position[axis] - from.position[axis]) / (to.t - from.t);
        trajectory.coordinates.push_back({from.position[axis] - velocity * from.t, velocity});
      }
      if (options_.polygons) {
        add_rotor(trajectory, turning_rotor(from.heading, from.t, to.heading, to.t));
      }
      trajectory.normalise();
      if (!motion.pieces.empty() && motion.pieces.back().trajectory == trajectory) {
        motion.pieces.back().to = to.t;
      } else {
        motion.pieces.push_back({from.t, to.t, std::move(trajectory)});
      }
    }
    return motion;
  }

  // An object at rest, at all times.
  void add_fixed(const std::string& text) {
    const std::string option = "--fixed";
    Scene& scene = report_.scene;
    const std::vector<std::string> fields = parse_csv_row(text, option);
    const auto axes = static_cast<std::size_t>(scene.dimension);
    if (fields.size() != axes + 1) {
      throw InputError(option, "",
                       show_text(text) + " has " + counted(fields.size(), "field", "fields") + ", not " +
                           std::to_string(axes + 1),
                       "write " + std::string("ID,X,Y,Z").substr(0, 2 + 2 * axes));
    }
    check_csv_id(fields[0], option, "");
    for (const SceneObject& object : scene.objects) {
      if (object.id != fields[0]) continue;
      throw InputError(option, "", "there is an object " + show_text(fields[0]) + " already",
                       "ids are unique; give another name");
    }
    Trajectory trajectory;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      std::optional<Rational> value = csv_number(fields[axis + 1]);
      if (!value) {
        throw InputError(
            option, "", show_text(fields[axis + 1]) + " in " + show_text(text) + " is not a number",
            kCsvNumberRemedy);
      }
      trajectory.coordinates.push_back({*std::move(value)});
    }
    if (options_.polygons) add_rotor(trajectory, fixed_rotor(0));
    trajectory.normalise();
    Motion motion;
    motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
    scene.objects.push_back({fields[0], std::move(motion)});
  }

  void check_time() const {
    const Scene& scene = report_.scene;
    if (!scene.end || *scene.end > scene.start) return;
    throw InputError(file_, "",
                     "the scene would end at " + time_text(*scene.end) +
                         ", not after its start at " + time_text(scene.start),
                     "give --start and --end");
  }

  CsvTable table_;
  const std::string& file_;
  const ImportOptions& options_;
  std::size_t id_;
  std::optional<std::size_t> time_, heading_;
  std::vector<std::size_t> coordinates_, velocities_;
  std::unordered_map<std::string, std::size_t> lines_;  // of the first row of each id
  ImportReport report_;
};

}  // namespace

ImportReport import_csv(std::string_view text, const std::string& file,
                        const ImportOptions& options) {
  return Importer(parse_csv(text, file), file, options).import();
}

}  // namespace kinex::formats
