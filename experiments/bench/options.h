// SPDX-License-Identifier: GPL-3.0-or-later
// The options of all benchmarks.
#ifndef KINEX_EXPERIMENTS_BENCH_OPTIONS_H
#define KINEX_EXPERIMENTS_BENCH_OPTIONS_H

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace kinex {

struct BenchOptions {
  std::string json;      // a file to which rows are appended as JSON lines; empty: none
  std::string markdown;  // a file to which tables are appended; empty: none
  bool smoke = false;    // tiny sizes, for the test suite
  std::string rows;      // speed: only rows with this in "structure scene degree n"; empty: all
};

// nullopt, and a line on stderr, for any other argument.
inline std::optional<BenchOptions> bench_options(int argc, char** argv) {
  BenchOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--json" && i + 1 < argc) {
      options.json = argv[++i];
    } else if (argument == "--markdown" && i + 1 < argc) {
      options.markdown = argv[++i];
    } else if (argument == "--rows" && i + 1 < argc) {
      options.rows = argv[++i];
    } else if (argument == "--smoke") {
      options.smoke = true;
    } else {
      std::fprintf(stderr, "usage: %s [--json FILE] [--markdown FILE] [--smoke] [--rows TEXT]\n", argv[0]);
      return std::nullopt;
    }
  }
  return options;
}

}  // namespace kinex

#endif
