// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/id_index.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace kinex {
namespace id_index_test {

TEST(IdIndex, NumbersWhatIsNew) {
  std::vector<std::string> ids;
  for (int i = 0; i < 5000; ++i) ids.push_back("p" + std::to_string(i * 7));
  formats::IdIndex index(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(index.add(ids[i]), i);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(index.add(std::string(ids[i])), i);
}

TEST(IdIndex, HasRoomForNone) {
  formats::IdIndex index(1);
  EXPECT_EQ(index.add(""), 0u);
  EXPECT_EQ(index.add(""), 0u);
}

}  // namespace id_index_test
}  // namespace kinex
