// SPDX-License-Identifier: GPL-3.0-or-later
// CsvProperties: what the objects of a table have beside their places.
#ifndef KINEX_EXPERIMENTS_FORMATS_CSV_PROPERTIES_H
#define KINEX_EXPERIMENTS_FORMATS_CSV_PROPERTIES_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/csv_columns.h"
#include "experiments/formats/csv_table.h"

namespace kinex::formats {

// What the properties depend on.
struct TableForm {
  std::size_t axes;
  bool traces;  // not velocities
  bool bodies;
  bool graph;  // of edges: one axis, the weight
};

//   radius, weight, hx[,hy[,hz]]   one of the three: of all objects, in every row. They change as places do: linearly
//                                  between two fixes; with velocities at the rates vradius, vweight, vhx, .., 0 by default
//   colour                         a word
//   from, to                       the vertices of an edge of a graph
//   line                           true for the line y = a x + b, whose a and b are x and y
// A word is that of the object, and an empty field says nothing, so that it need not stand in every row. Two different
// words of one object are refused.
class CsvProperties {
 public:
  // Takes its columns. Throws InputError for those that do not go together.
  CsvProperties(const CsvTable& table, const std::string& file, CsvColumns& columns,
                const TableForm& form);

  Extents extents() const { return extents_; }
  // Appends the radius, weight or half extents of a row to the place of its fix.
  void append(const CsvRow& row, std::vector<Rational>& position) const;
  // The same to a trajectory, with their rates.
  void append(const CsvRow& row, Trajectory& trajectory) const;
  // Reads the words of a row of the object with this number, counted from 0.
  void read_words(const CsvRow& row, std::size_t object, const std::string& id);
  // Gives the object its words.
  void finish(std::size_t number, SceneObject& object) const;
  // Throws InputError if the radius or a half extent is negative at a time of the scene, or right after the object's
  // last fix, where events at its end are decided. `row`: that of the object's last fix, or its only one.
  void check(const SceneObject& object, const CsvRow& row, const Scene& scene) const;

 private:
  struct Word {
    std::string text;
    std::size_t line = 0;  // 0: none yet
  };
  struct Words {
    Word colour, from, to, line;
  };

  void take_extents(CsvColumns& columns, const TableForm& form);
  void take_graph(CsvColumns& columns);
  Rational number(const CsvRow& row, std::size_t column) const;
  // The number, which must not be negative if it is a radius or a half extent.
  Rational extent(const CsvRow& row, std::size_t column) const;
  // "\"red\" in column \"colour\"".
  std::string field(const CsvRow& row, std::size_t column) const;
  void keep(const CsvRow& row, std::size_t column, const std::string& id, const std::string& what,
            std::string text, Word& word) const;
  // "true", "false", or empty.
  std::string truth(const CsvRow& row) const;
  void check_trace(const SceneObject& object, const CsvRow& row, const Scene& scene) const;
  void check_rates(const SceneObject& object, const CsvRow& row, const Scene& scene) const;
  [[noreturn]] void fail_negative(const SceneObject& object, const CsvRow& row, std::size_t axis,
                                  const std::string& when, const std::string& remedy) const;

  const CsvTable& table_;
  const std::string& file_;
  Extents extents_ = Extents::kNone;
  bool traces_;
  std::size_t axes_;
  std::vector<std::size_t> columns_;               // of the extents
  std::vector<std::string> names_;                 // their meanings
  std::vector<std::optional<std::size_t>> rates_;  // likewise
  std::optional<std::size_t> colour_, from_, to_, line_;
  std::vector<Words> words_;  // by number of the object
};

// Why a column with this meaning has none in a table of this form; empty: for another reason, or none.
std::string why_without_meaning(const std::string& meaning, const TableForm& form);

// "the objects are discs of 2 colours"; empty: they are points, and nothing else.
std::string text_of_kinds(const Scene& scene);

}  // namespace kinex::formats

#endif
