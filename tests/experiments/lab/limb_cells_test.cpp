// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/limb_cells.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <set>
#include <thread>
#include <vector>

namespace kinex {
namespace limb_cells_test {

TEST(LimbCells, AreApartAndComeAgain) {
  lab::LimbCells cells;
  std::vector<void*> taken;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    taken.push_back(cells.take());
    std::memcpy(taken.back(), &i, sizeof i);
  }
  for (std::uint64_t i = 0; i < taken.size(); ++i) EXPECT_EQ(std::memcmp(taken[i], &i, sizeof i), 0);
  const std::set<void*> all(taken.begin(), taken.end());
  EXPECT_EQ(all.size(), taken.size());
  for (void* cell : taken) cells.give_back(cell);
  for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_TRUE(all.count(cells.take()));
}

TEST(LimbCells, OfEndedThreadsAreUsedAgain) {
  void* other = nullptr;
  std::thread([&] {
    lab::LimbCells cells;
    other = cells.take();
    cells.give_back(other);
  }).join();
  lab::LimbCells cells;
  std::vector<void*> taken;
  bool again = false;
  for (int i = 0; i < 40000 && !again; ++i) {
    taken.push_back(cells.take());
    again = taken.back() == other;
  }
  EXPECT_TRUE(again);
  for (void* cell : taken) cells.give_back(cell);
}

}  // namespace limb_cells_test
}  // namespace kinex
