// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/bench_options.h"

#include <cstdio>
#include <stdexcept>
#include <string_view>

namespace kinex::lab {

std::optional<BenchOptions> bench_options(int argc, char** argv) {
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
      std::fprintf(stderr, "usage: %s [--json FILE] [--markdown FILE] [--smoke] [--rows TEXT]\n",
                   argv[0]);
      return std::nullopt;
    }
  }
  return options;
}

int bench_main(int argc, char** argv, void (*benchmark)(const BenchOptions&)) {
  const std::optional<BenchOptions> options = bench_options(argc, argv);
  if (!options) return 2;
  try {
    benchmark(*options);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "kinex: %s\n", error.what());
    return 2;
  }
  return 0;
}

}  // namespace kinex::lab
