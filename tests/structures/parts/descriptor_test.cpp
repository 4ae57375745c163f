// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptors say in words what the rest of the program shows of structures.
#include "structures/parts/descriptor.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "structures/registry.h"

namespace kinex::test {
namespace descriptor_test {

void expect_words(std::string_view text) {
  ASSERT_FALSE(text.empty());
  EXPECT_NE(text.back(), '.') << text;
  EXPECT_LT(text.size(), 80u) << text;
}

TEST(Descriptor, EveryKindOfEventIsExplained) {
  for (const StructureInfo& info : structure_infos()) {
    std::set<std::string_view> texts;
    for (const KindRule& rule : info.kinds) {
      SCOPED_TRACE(std::string(info.name) + ": " + std::string(rule.kind));
      expect_words(rule.text);
      EXPECT_TRUE(texts.insert(rule.text).second) << "two kinds with one meaning";
      EXPECT_EQ(meaning_of_kind(info, rule.kind), rule.text);
    }
    for (const std::string_view kind : common_event_kinds({})) {
      SCOPED_TRACE(kind);
      expect_words(meaning_of_kind(info, kind));
    }
    EXPECT_EQ(meaning_of_kind(info, "no such kind"), "");
  }
}

// The word is the same, what happens is not.
TEST(Descriptor, AKindMeansWhatItsStructureSays) {
  const auto meaning = [](const char* structure, const char* kind) {
    return meaning_of_kind(*find_structure_info(structure), kind);
  };
  EXPECT_NE(meaning("delaunay_2", "flip"), meaning("separation_mixed", "flip"));
  EXPECT_NE(meaning("closest_pair_bins", "cell"), meaning("separation_mixed", "cell"));
}

}  // namespace descriptor_test
}  // namespace kinex::test
