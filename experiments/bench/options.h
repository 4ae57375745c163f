// SPDX-License-Identifier: GPL-3.0-or-later
// The options that all benchmarks have.
#ifndef KINEX_EXPERIMENTS_BENCH_OPTIONS_H
#define KINEX_EXPERIMENTS_BENCH_OPTIONS_H

#include <cstdio>
#include <optional>
#include <string_view>

namespace kinex {

struct BenchOptions {
  bool json = false;   // JSON lines instead of a table
  bool smoke = false;  // tiny sizes, for the test suite
};

// nullopt, and a line on stderr, if there is anything else among the arguments.
inline std::optional<BenchOptions> bench_options(int argc, char** argv) {
  BenchOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--json") {
      options.json = true;
    } else if (argument == "--smoke") {
      options.smoke = true;
    } else {
      std::fprintf(stderr, "usage: %s [--json] [--smoke]\n", argv[0]);
      return std::nullopt;
    }
  }
  return options;
}

}  // namespace kinex

#endif
