// SPDX-License-Identifier: GPL-3.0-or-later
// kinex_families: runs families of random scenes.
//   kinex_families FAMILY COUNT [FIRST_SEED]
//   kinex_families --list
// Prints one line of counts and one of CPU time, every problem with its scene, and every scene that
// takes long. Exit code 0: no problem; 1: problems; 2: usage.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

#include "experiments/lab/cpu_clock.h"
#include "tests/families/family.h"

namespace {

using kinex::lab::cpu_seconds;
using kinex::families::Family;
using kinex::families::Tally;

bool read(const char* text, std::uint64_t& value) {
  const char* end = text + std::strlen(text);
  const auto result = std::from_chars(text, end, value);
  return result.ec == std::errc() && result.ptr == end;
}

int usage() {
  std::fputs("usage: kinex_families FAMILY COUNT [FIRST_SEED], or --list\n", stderr);
  return 2;
}

constexpr double kLong = 5;  // CPU seconds of a scene, in all its runs

struct Slowest {
  std::uint64_t seed = 0;
  double seconds = 0;
};

int run(const Family& family, std::uint64_t count, std::uint64_t first) {
  Tally tally;
  Slowest slowest;
  const double begin = kinex::lab::cpu_seconds();
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::size_t before = tally.problems.size();
    const double began = kinex::lab::cpu_seconds();
    tally.slowest = 0;
    try {
      family.check(seed, tally);
    } catch (const std::exception& error) {
      tally.problem(std::string("the family has thrown: ") + error.what(), "");
    }
    for (std::size_t i = before; i < tally.problems.size(); ++i) {
      std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed),
                  tally.problems[i].c_str());
    }
    const double seconds = kinex::lab::cpu_seconds() - began;
    if (seconds > slowest.seconds) slowest = {seed, seconds};
    if (seconds > kLong) {
      std::printf("seed %llu: took %.1f s, %s %.1f s of it\n",
                  static_cast<unsigned long long>(seed), seconds, tally.slowest_run.c_str(),
                  tally.slowest);
    }
    std::fflush(stdout);
  }
  std::printf(
      "%s: %llu scenes, %llu runs, %llu events in exact; %llu refused by name, %llu corrupt "
      "and reported, %llu at a limit; %zu problems\n",
      std::string(family.name).c_str(), static_cast<unsigned long long>(tally.scenes),
      static_cast<unsigned long long>(tally.runs), static_cast<unsigned long long>(tally.events),
      static_cast<unsigned long long>(tally.refused),
      static_cast<unsigned long long>(tally.corrupt), static_cast<unsigned long long>(tally.limits),
      tally.problems.size());
  std::printf("%.1f s; the slowest scene is of seed %llu, %.2f s\n", kinex::lab::cpu_seconds() - begin,
              static_cast<unsigned long long>(slowest.seed), slowest.seconds);
  return tally.problems.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0) {
    for (const Family& family : kinex::families::families()) {
      std::printf("%s  %s\n", std::string(family.name).c_str(),
                  std::string(family.summary).c_str());
    }
    return 0;
  }
  std::uint64_t count = 0, first = 1;
  if (argc < 3 || argc > 4 || !read(argv[2], count) || (argc == 4 && !read(argv[3], first))) {
    return usage();
  }
  for (const Family& family : kinex::families::families()) {
    if (family.name == argv[1]) return run(family, count, first);
  }
  return usage();
}
