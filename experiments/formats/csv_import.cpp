// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_import.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/numbers/near_names.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/heading.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/trace.h"

namespace kinex::formats {

namespace {

constexpr const char* kColumns =
    "name the columns id,t,x[,y[,z]] (traces) or id,x[,y[,z]],vx[,vy[,vz]] (velocities)";

class Importer {
 public:
  Importer(CsvTable table, const std::string& file, const ImportOptions& options)
      : table_(std::move(table)), file_(file), options_(options) {
    check_names();
    id_ = required("id");
    time_ = column("t");
    for (const char* axis : {"x", "y", "z"}) {
      const auto coordinate = column(axis);
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
    report_.ignored_columns = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
    if (unused != used.end() && !options_.ignore_columns) {
      fail_unused(table_.columns[static_cast<std::size_t>(unused - used.begin())]);
    }
    tell_columns(used);
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
    for (const std::string& row : options_.fixed)
      add_fixed(report_.scene, row, options_.polygons.has_value());
    check_time(report_.scene, file_);
    report_.scene.overlapping_starts = options_.overlapping_starts;
    if (options_.polygons) make_bodies(report_.scene, *options_.polygons, {file_, lines_});
    return std::move(report_);
  }

 private:
  struct FixOfRow : Fix {
    const CsvRow* row;
  };

  // Those of --column name a meaning and a column of the table, once each.
  void check_names() const {
    for (std::size_t i = 0; i < options_.columns.size(); ++i) {
      const NamedColumn& one = options_.columns[i];
      if (!table_.column(one.column)) {
        throw InputError(
            file_, "line 1",
            "there is no column " + show_text(one.column) + ", that of --column " + one.meaning,
            did_you_mean(one.column, table_.columns, "name a column of the table"));
      }
      for (std::size_t j = 0; j < i; ++j) {
        if (options_.columns[j].meaning != one.meaning && options_.columns[j].column != one.column)
          continue;
        throw InputError("--column", "",
                         one.meaning + "=" + one.column + " after " + options_.columns[j].meaning +
                             "=" + options_.columns[j].column,
                         "give every meaning one column of its own");
      }
    }
  }

  // The column for a meaning: that of --column, else that of this name, if it has no other meaning.
  std::optional<std::size_t> column(const std::string& meaning) const {
    for (const NamedColumn& one : options_.columns) {
      if (one.meaning == meaning) return table_.column(one.column);
    }
    for (const NamedColumn& one : options_.columns) {
      if (one.column == meaning) return std::nullopt;
    }
    return table_.column(meaning);
  }

  // " --column t=T" for every meaning whose column differs by capitals alone.
  std::string capitals() const {
    std::string options;
    for (const char* meaning : {"id", "t", "x", "y", "z", "vx", "vy", "vz"}) {
      if (column(meaning)) continue;
      for (const std::string& name : table_.columns) {
        std::string small = name;
        std::transform(small.begin(), small.end(), small.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        const auto is_taken = [&](const NamedColumn& one) { return one.column == name; };
        if (small != meaning || std::any_of(options_.columns.begin(), options_.columns.end(), is_taken)) continue;
        options += std::string(" --column ") + meaning + "=" + name;
        break;
      }
    }
    return options;
  }

  std::size_t required(const std::string& name) const {
    const auto found = column(name);
    if (!found) {
      if (const std::string options = capitals(); !options.empty()) {
        throw InputError(file_, "line 1",
                         "there is no column " + show_text(name == "vx" ? "t" : name) + " in small letters; capitals matter",
                         "write the names in small letters, or give" + options);
      }
      throw InputError(
          file_, "line 1",
          "there is no column " + (name == "vx" ? "\"t\", and none \"vx\"" : show_text(name)),
          std::string(kColumns) + ", or say which they are: --column " + (name == "vx" ? "t" : name) +
              "=NAME");
    }
    return *found;
  }

  // "columns: id from trackId, t, x, y", "ignored: speed", "fields are separated by semicolons".
  void tell_columns(const std::vector<bool>& used) {
    std::string meanings, ignored;
    const auto tell = [&](const std::string& meaning, std::size_t column) {
      meanings += (meanings.empty() ? "" : ", ") + meaning;
      if (table_.columns[column] != meaning) meanings += " from " + table_.columns[column];
    };
    tell("id", id_);
    if (time_) tell("t", *time_);
    for (std::size_t axis = 0; axis < coordinates_.size(); ++axis)
      tell(std::string(1, "xyz"[axis]), coordinates_[axis]);
    for (std::size_t axis = 0; axis < velocities_.size(); ++axis)
      tell(std::string("v") + "xyz"[axis], velocities_[axis]);
    if (heading_) tell(options_.heading->compass ? "bearing" : "heading", *heading_);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) ignored += (ignored.empty() ? "" : ", ") + table_.columns[i];
    }
    report_.details.push_back("columns: " + meanings);
    if (!ignored.empty()) report_.details.push_back("ignored: " + ignored);
    if (table_.separator == ',') return;
    report_.details.push_back(std::string("fields are separated by ") +
                              (table_.separator == ';' ? "semicolons" : "tabs"));
  }

  std::optional<Rational> start() const {
    return options_.start_time ? scale_.read(*options_.start_time) : options_.start;
  }
  std::optional<Rational> end() const {
    return options_.end_time ? scale_.read(*options_.end_time) : options_.end;
  }

  Rational time(const CsvRow& row) {
    const std::string& field = row.fields[*time_];
    return scale_.read(field, file_, place_of_row(row),
                       show_text(field) + " in column " + show_text(table_.columns[*time_]));
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
    if (const std::string options = capitals(); !options.empty()) {
      throw InputError(file_, "line 1", problem + "; capitals matter",
                       "write the names in small letters, or give" + options + ", or --ignore-columns");
    }
    if (!options_.polygons) {
      throw InputError(file_, "line 1", problem,
                       std::string(kColumns) + ", or give --ignore-columns for the others");
    }
    throw InputError(file_, "line 1", problem,
                     "remove it, or name it with --heading or --bearing, or give --ignore-columns; "
                     "a body that turns is "
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
    scale_.settle(options_.time_zero);
    scene.start = start().value_or(Rational(0));
    scene.end = end();
    for (const CsvRow& row : table_.rows) {
      const auto [other, is_new] = lines_.emplace(id(row), row.line);
      if (!is_new) {
        throw InputError(file_, place_of_row(row),
                         "the id " + show_text(id(row)) + " is that of line " +
                             std::to_string(other->second) + " too",
                         "give one of the two another id, or leave one of the rows out");
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
    std::vector<std::pair<std::string, std::vector<FixOfRow>>> traces;  // in order of first rows
    std::unordered_map<std::string, std::size_t> numbers;
    for (const CsvRow& row : table_.rows) {
      const auto [entry, is_new] = numbers.emplace(id(row), traces.size());
      if (is_new) {
        traces.emplace_back(id(row), std::vector<FixOfRow>{});
        lines_.emplace(id(row), row.line);
      }
      FixOfRow fix{{time(row), {}, heading(row)}, &row};
      for (const std::size_t column : coordinates_) fix.position.push_back(number(row, column));
      traces[entry->second].second.push_back(std::move(fix));
    }
    const Rational zero = scale_.settle(options_.time_zero);
    report_.time_zero = scale_.zero_text();
    std::optional<Rational> first, last;
    for (auto& [name, fixes] : traces) {
      for (FixOfRow& fix : fixes) fix.t -= zero;
      sort_fixes(fixes);
      if (!first || fixes.front().t < *first) first = fixes.front().t;
      if (!last || fixes.back().t > *last) last = fixes.back().t;
      if (fixes.size() == 1) {
        ++report_.single_fixes;
        continue;
      }
      Motion motion;
      append_linear(motion, {fixes.begin(), fixes.end()}, options_.polygons.has_value());
      report_.scene.objects.push_back({name, std::move(motion)});
    }
    report_.scene.start = start().value_or(*first);
    const std::optional<Rational> until = end();
    report_.scene.end = until ? until : last;
  }

  // Ascending in time, each time once.
  void sort_fixes(std::vector<FixOfRow>& fixes) {
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const FixOfRow& a, const FixOfRow& b) { return a.t < b.t; });
    std::vector<FixOfRow> kept;
    for (FixOfRow& fix : fixes) {
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

  CsvTable table_;
  const std::string& file_;
  const ImportOptions& options_;
  std::size_t id_;
  std::optional<std::size_t> time_, heading_;
  std::vector<std::size_t> coordinates_, velocities_;
  TimeScale scale_;
  std::unordered_map<std::string, std::size_t> lines_;  // of the first row of each id
  ImportReport report_;
};

}  // namespace

ImportReport import_csv(std::string_view text, const std::string& file,
                        const ImportOptions& options) {
  return Importer(parse_csv(text, file, options.separator), file, options).import();
}

}  // namespace kinex::formats
