// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/csv_import.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "experiments/csv_table.h"
#include "experiments/input_error.h"
#include "experiments/json_value.h"
#include "experiments/scene_reader.h"
#include "experiments/utf8.h"

namespace kinex {

namespace {

constexpr const char* kColumns =
    "name the columns id,t,x[,y[,z]] (traces) or id,x[,y[,z]],vx[,vy[,vz]] (velocities)";

constexpr const char* kNumberRemedy = "write an integer, a fraction 1/3 or a decimal";

std::optional<Rational> parse_number(const std::string& field) {
  if (field.size() > kMaxNumberLength) return std::nullopt;
  return Rational::parse(field);
}

std::string place(const CsvRow& row) { return "line " + std::to_string(row.line); }

// What is an id in a table must be one in a scene.
void check_id(const std::string& id, const std::string& file, const std::string& where) {
  if (id.empty()) throw InputError(file, where, "an empty id", "write a name");
  if (id.size() > kMaxIdBytes) {
    throw InputError(file, where, "an id of " + std::to_string(id.size()) + " bytes",
                     "write at most 1000");
  }
  if (!is_utf8(id)) {
    throw InputError(file, where, "the id " + show_text(id) + " is not UTF-8",
                     "convert the file to UTF-8");
  }
}

class Importer {
 public:
  Importer(CsvTable table, const std::string& file) : table_(std::move(table)), file_(file) {
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
    const std::size_t used = 1 + (time_ ? 1 : 0) + coordinates_.size() + velocities_.size();
    if (table_.columns.size() != used) {
      throw InputError(file_, "line 1", "there are columns that mean nothing here", kColumns);
    }
  }

  ImportReport import(const ImportOptions& options) {
    if (table_.rows.empty()) throw InputError(file_, "", "there are no rows", "write one per fix");
    report_.rows = table_.rows.size();
    report_.scene.dimension = static_cast<int>(coordinates_.size());
    if (time_) {
      import_traces(options);
    } else {
      import_velocities(options);
    }
    if (report_.scene.objects.empty()) {
      throw InputError(file_, "", "no object has two fixes", "write at least two fixes of one id");
    }
    return std::move(report_);
  }

 private:
  struct Fix {
    Rational t;
    std::vector<Rational> position;
    const CsvRow* row;
  };

  std::size_t required(const std::string& name) const {
    const auto column = table_.column(name);
    if (!column) {
      throw InputError(file_, "line 1", "there is no column " + show_text(name), kColumns);
    }
    return *column;
  }

  Rational number(const CsvRow& row, std::size_t column) const {
    const std::string& field = row.fields[column];
    if (std::optional<Rational> value = parse_number(field)) return *std::move(value);
    throw InputError(
        file_, place(row),
        show_text(field) + " in column " + show_text(table_.columns[column]) + " is not a number",
        kNumberRemedy);
  }

  const std::string& id(const CsvRow& row) const {
    check_id(row.fields[id_], file_, place(row));
    return row.fields[id_];
  }

  void import_velocities(const ImportOptions& options) {
    Scene& scene = report_.scene;
    scene.start = options.start.value_or(Rational(0));
    scene.end = options.end;
    std::unordered_map<std::string, std::size_t> lines;
    for (const CsvRow& row : table_.rows) {
      const auto [other, is_new] = lines.emplace(id(row), row.line);
      if (!is_new) {
        throw InputError(file_, place(row),
                         "the id " + show_text(id(row)) + " is that of line " +
                             std::to_string(other->second) + " too",
                         "ids are unique");
      }
      Trajectory trajectory;
      for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
        trajectory.coordinates.push_back(
            {number(row, coordinates_[axis]), number(row, velocities_[axis])});
      }
      trajectory.normalise();
      Motion motion;
      motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
      scene.objects.push_back({id(row), std::move(motion)});
    }
  }

  void import_traces(const ImportOptions& options) {
    std::vector<std::pair<std::string, std::vector<Fix>>> traces;  // in order of first rows
    std::unordered_map<std::string, std::size_t> numbers;
    for (const CsvRow& row : table_.rows) {
      const auto [entry, is_new] = numbers.emplace(id(row), traces.size());
      if (is_new) traces.emplace_back(id(row), std::vector<Fix>{});
      Fix fix{number(row, *time_), {}, &row};
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
    report_.scene.start = options.start.value_or(*first);
    report_.scene.end = options.end ? options.end : last;
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
      if (kept.back().position != fix.position) {
        throw InputError(file_, place(*fix.row),
                         show_text(id(*fix.row)) +
                             " is at another place at the same time in line " +
                             std::to_string(kept.back().row->line),
                         "remove one of the two fixes");
      }
      ++report_.repeated_fixes;
    }
    fixes = std::move(kept);
  }

  // Linear between fixes; fixes on one straight flight at one speed are one piece.
  static Motion motion_through(const std::vector<Fix>& fixes) {
    Motion motion;
    for (std::size_t i = 0; i + 1 < fixes.size(); ++i) {
      const Fix& from = fixes[i];
      const Fix& to = fixes[i + 1];
      Trajectory trajectory;
      for (std::size_t axis = 0; axis < from.position.size(); ++axis) {
        const Rational velocity = (to.position[axis] - from.position[axis]) / (to.t - from.t);
        trajectory.coordinates.push_back({from.position[axis] - velocity * from.t, velocity});
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

  CsvTable table_;
  const std::string& file_;
  std::size_t id_;
  std::optional<std::size_t> time_;
  std::vector<std::size_t> coordinates_, velocities_;
  ImportReport report_;
};

// An object that stands still, at all times.
void add_fixed(const std::string& text, Scene& scene) {
  const std::string option = "--fixed";
  const std::vector<std::string> fields = parse_csv_row(text, option);
  const auto axes = static_cast<std::size_t>(scene.dimension);
  if (fields.size() != axes + 1) {
    throw InputError(option, "",
                     show_text(text) + " has " + std::to_string(fields.size()) + " fields, not " +
                         std::to_string(axes + 1),
                     "write " + std::string("ID,X,Y,Z").substr(0, 2 + 2 * axes));
  }
  check_id(fields[0], option, "");
  for (const SceneObject& object : scene.objects) {
    if (object.id != fields[0]) continue;
    throw InputError(option, "", "there is an object " + show_text(fields[0]) + " already",
                     "ids are unique; give another name");
  }
  Trajectory trajectory;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::optional<Rational> value = parse_number(fields[axis + 1]);
    if (!value) {
      throw InputError(option, "",
                       show_text(fields[axis + 1]) + " in " + show_text(text) + " is not a number",
                       kNumberRemedy);
    }
    trajectory.coordinates.push_back({*std::move(value)});
  }
  trajectory.normalise();
  Motion motion;
  motion.pieces.push_back({std::nullopt, std::nullopt, std::move(trajectory)});
  scene.objects.push_back({fields[0], std::move(motion)});
}

}  // namespace

ImportReport import_csv(std::string_view text, const std::string& file,
                        const ImportOptions& options) {
  ImportReport report = Importer(parse_csv(text, file), file).import(options);
  Scene& scene = report.scene;
  for (const std::string& row : options.fixed) add_fixed(row, scene);
  if (scene.end && *scene.end <= scene.start) {
    throw InputError(file, "",
                     "the scene would end at " + scene.end->to_string() +
                         ", not after its start at " + scene.start.to_string(),
                     "give --start and --end");
  }
  return report;
}

}  // namespace kinex
