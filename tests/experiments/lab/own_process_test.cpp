// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/own_process.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace kinex::lab {
namespace own_process_test {

TEST(OwnProcess, GivesTheResultAndKeepsAllElse) {
  struct Result {
    std::array<std::uint64_t, 20'000> squares;  // more than a pipe holds
    std::string_view text;
  };
  std::uint64_t calls = 0;
  const auto result = in_own_process([&] {
    Result made{};
    ++calls;
    for (std::size_t i = 0; i < made.squares.size(); ++i) made.squares[i] = i * i + calls;
    made.text = "lives before";
    return made;
  });
  EXPECT_EQ(calls, 0u);
  for (std::size_t i = 0; i < result.squares.size(); ++i) ASSERT_EQ(result.squares[i], i * i + 1);
  EXPECT_EQ(result.text, "lives before");
}

TEST(OwnProcess, ThrowsWhatTheWorkThrows) {
  const auto message = [](const auto& work) -> std::string {
    try {
      in_own_process(work);
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "nothing";
  };
  EXPECT_EQ(message([]() -> int { throw std::invalid_argument("no such row"); }), "no such row");
  EXPECT_EQ(message([]() -> int { throw std::runtime_error(""); }), "");
  EXPECT_EQ(message([]() -> int {
              std::signal(SIGTERM, SIG_DFL);
              std::raise(SIGTERM);
              return 1;
            }),
            "a process of its own has ended before its work was done");
  EXPECT_EQ(message([] { return 1; }), "nothing");
}

}  // namespace own_process_test
}  // namespace kinex::lab
