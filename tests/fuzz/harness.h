// SPDX-License-Identifier: GPL-3.0-or-later
// The entry point that libFuzzer, afl++ and mutation_driver.cpp call; each fuzz_*.cpp defines it.
#ifndef KINEX_TESTS_FUZZ_HARNESS_H
#define KINEX_TESTS_FUZZ_HARNESS_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// Ends the program so that a fuzzer keeps the input.
inline void fuzz_require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

#endif
