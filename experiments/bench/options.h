// SPDX-License-Identifier: GPL-3.0-or-later
// The options that all benchmarks have.
#ifndef KINEX_EXPERIMENTS_BENCH_OPTIONS_H
#define KINEX_EXPERIMENTS_BENCH_OPTIONS_H

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace kinex {

struct BenchOptions {
  std::string json;      // a file that rows are added to as JSON lines; none if empty
  std::string markdown;  // a file that tables are added to; none if empty
  bool smoke = false;    // tiny sizes, for the test suite
};

// nullopt, and a line on stderr, if there is anything else among the arguments.
inline std::optional<BenchOptions> bench_options(int argc, char** argv) {
  BenchOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--json" && i + 1 < argc) {
      options.json = argv[++i];
    } else if (argument == "--markdown" && i + 1 < argc) {
      options.markdown = argv[++i];
    } else if (argument == "--smoke") {
      options.smoke = true;
    } else {
      std::fprintf(stderr, "usage: %s [--json FILE] [--markdown FILE] [--smoke]\n", argv[0]);
      return std::nullopt;
    }
  }
  return options;
}

}  // namespace kinex

#endif
