// SPDX-License-Identifier: GPL-3.0-or-later
// Families of random scenes that every structure has to survive under every arithmetic.
//
// A family draws one scene from a seed. The scene is run by every structure that accepts it, and
// the runs are compared (check_scene.h). A scene that breaks a rule is a problem, and its text is
// kept.
#ifndef KINEX_TESTS_FAMILIES_FAMILY_H
#define KINEX_TESTS_FAMILIES_FAMILY_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kinex::families {

// What a family has seen so far.
struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;  // scenes, or structures for a scene, refused by name
  std::uint64_t runs = 0;
  std::uint64_t events = 0;   // external and internal, in `exact`
  std::uint64_t corrupt = 0;  // runs of inexact arithmetics that have noticed it
  std::uint64_t limits = 0;   // runs that ended at the limit of time
  double slowest = 0;         // CPU seconds of the run that took longest ..
  std::string slowest_run;    // .. and its description; a reader may reset both
  std::vector<std::string> problems;

  // At most kMostProblems are kept with their scenes.
  static constexpr std::size_t kMostProblems = 20;
  void problem(const std::string& what, std::string_view scene);
  void time(const std::string& run, double seconds);
};

struct Family {
  std::string_view name;
  std::string_view summary;
  // Draws the scene of this seed, runs it and adds to the tally.
  void (*check)(std::uint64_t seed, Tally& tally);
};

// In the order in which they are listed; one file each.
const std::vector<Family>& families();
void few_objects(std::uint64_t seed, Tally& tally);
void meeting_pieces(std::uint64_t seed, Tally& tally);
void every_arithmetic(std::uint64_t seed, Tally& tally);
void extreme_bodies(std::uint64_t seed, Tally& tally);
void named_twice(std::uint64_t seed, Tally& tally);

}  // namespace kinex::families

#endif
