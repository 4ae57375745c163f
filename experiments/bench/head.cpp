// SPDX-License-Identifier: GPL-3.0-or-later
// The head of bench.md: build and machine, and the cost of exact arithmetic, from the rows of
// `speed`.
//   kinex_bench_head COMMAND FILE
//     FILE: JSON lines of the benchmarks, with or without `speed`
#include <cstdio>
#include <exception>
#include <string>

#include "experiments/bench/ratios.h"
#include "experiments/formats/file_io.h"
#include "experiments/lab/machine.h"

int main(int argc, char** argv) {
  using namespace kinex;
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s COMMAND FILE\n", argv[0]);
    return 2;
  }
  try {
    const std::string text =
        "# Benchmarks\n\nMade by " +
        lab::provenance(argv[1], lab::build_facts(), lab::machine_facts()) +
        ". One core; CPU seconds; ratios within one process.\n" +
        bench::ratios_text(bench::exact_over_double(formats::read_text_file(argv[2]), argv[2]));
    std::fwrite(text.data(), 1, text.size(), stdout);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
  return 0;
}
