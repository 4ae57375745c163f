// SPDX-License-Identifier: GPL-3.0-or-later
// ResultTable: the rows of a benchmark, printed as they come, and written as JSON lines and as
// Markdown if the options request it.
#ifndef KINEX_EXPERIMENTS_LAB_RESULT_TABLE_H
#define KINEX_EXPERIMENTS_LAB_RESULT_TABLE_H

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/lab/bench_options.h"

namespace kinex::lab {

class ResultTable {
 public:
  struct Column {
    std::string key;       // in JSON; its words are the heading
    int decimals = kText;  // of a number
    int width = 0;         // at least; 0: that of the heading
  };
  static constexpr int kText = -1;
  struct Field {
    Field(const char* words) : text(words) {}
    Field(std::string words) : text(std::move(words)) {}
    Field(std::string_view words) : text(words) {}
    Field(double value) : number(value) {}
    Field(int value) : number(value) {}
    Field(std::uint64_t value) : number(static_cast<double>(value)) {}
    std::string text;
    double number = 0;
  };

  // `name`: of the benchmark, in every JSON line; `about`: a line before the table. Throws
  // std::runtime_error if a file cannot be written.
  ResultTable(const BenchOptions& options, std::string name, const std::string& about,
              std::vector<Column> columns);
  // One field for each column: text or number.
  void row(const std::vector<Field>& cells);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  std::string shown(std::size_t column, const Field& cell) const;

  std::string name_;
  std::vector<Column> columns_;
  File json_, markdown_;
};

}  // namespace kinex::lab

#endif
