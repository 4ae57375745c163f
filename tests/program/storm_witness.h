// SPDX-License-Identifier: GPL-3.0-or-later
// Storms: an independent reading of hurricanes.csv, and brute-force answers about it. Integers of
// 128 bits and GMP's rationals only: nothing of kinex.
#ifndef KINEX_TESTS_PROGRAM_STORM_WITNESS_H
#define KINEX_TESTS_PROGRAM_STORM_WITNESS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kinex {

class Storms {
 public:
  // All times are integers in units of 1 / kUnits hours.
  static constexpr std::int64_t kUnits = 420;

  // Throws std::runtime_error for text that is not of the expected form.
  explicit Storms(const std::string& file);

  // Storms with at least two fixes at different times: the others have no duration.
  std::size_t count() const { return storms_.size(); }
  std::int64_t start() const { return start_; }
  std::int64_t end() const { return end_; }

  // Right after `time`, from west to east; equal for a while: in the order of the file.
  std::vector<std::string> west_to_east(std::int64_t time) const;
  // How often two storms change places in that order, over all pairs and the whole year.
  std::uint64_t exchanges() const;
  // Changes of velocity of one storm at a fix; storms that appear after the start; storms that are
  // gone before the end.
  std::uint64_t turns() const;
  std::uint64_t arrivals() const;
  std::uint64_t departures() const;

  // "" if `edges` is a Delaunay triangulation of the storms alive at `time`, else what is wrong.
  // At `time` no two storms may be at one place, all on one line, or four neighbours cocircular.
  std::string delaunay_complaint(
      std::int64_t time, const std::vector<std::pair<std::string, std::string>>& edges) const;
  std::size_t alive_count(std::int64_t time) const;
  // "" if no two storms alive at `time` are strictly closer to each other than this pair.
  std::string closest_pair_complaint(std::int64_t time,
                                     const std::pair<std::string, std::string>& pair) const;
  // "" if `edges` is a spanning tree of the storms alive at `time`, and no other pair of storms is
  // strictly closer than two neighbours on the way between them in the tree.
  std::string tree_complaint(std::int64_t time,
                             const std::vector<std::pair<std::string, std::string>>& edges) const;

 private:
  struct Fix {
    std::int64_t time;
    std::array<std::int64_t, 2> position;  // tenths of a degree
  };
  struct Storm {
    std::string id;
    std::vector<Fix> fixes;
  };

  // A storm's place: in tenths of a degree, over the denominator.
  struct Place {
    std::string id;
    std::array<std::int64_t, 2> numerators;
    std::int64_t denominator;
  };
  std::vector<Place> places_at(std::int64_t time) const;
  std::vector<const Storm*> alive(std::int64_t time) const;
  static std::size_t piece_of(const Storm& storm, std::int64_t time);
  static int order_after(const Storm& a, const Storm& b, std::int64_t time);
  static std::uint64_t exchanges_of(const Storm& a, const Storm& b);

  std::vector<Storm> storms_;
  std::int64_t start_ = 0, end_ = 0;
};

}  // namespace kinex

#endif
