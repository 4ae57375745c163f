// SPDX-License-Identifier: GPL-3.0-or-later
// The options of all benchmarks, and the frame of their programs.
#ifndef KINEX_EXPERIMENTS_LAB_BENCH_OPTIONS_H
#define KINEX_EXPERIMENTS_LAB_BENCH_OPTIONS_H

#include <optional>
#include <string>

namespace kinex::lab {

struct BenchOptions {
  std::string json;      // a file to which rows are appended as JSON lines; empty: none
  std::string markdown;  // a file to which tables are appended; empty: none
  bool smoke = false;    // tiny sizes, for the test suite
  std::string rows;      // only rows whose text (BenchRow::text) contains this; empty: all

  // By which the sizes of rows are divided.
  int scale() const { return smoke ? 100 : 1; }
  // `rounds`, or a single one.
  int rounds(int rounds) const { return smoke ? 1 : rounds; }
};

// nullopt, and a line on stderr, for any other argument.
std::optional<BenchOptions> bench_options(int argc, char** argv);

// main() of a benchmark: runs it with the options of the command line. Returns the exit code: 2 for
// wrong options and for files that cannot be written.
int bench_main(int argc, char** argv, void (*benchmark)(const BenchOptions&));

}  // namespace kinex::lab

#endif
