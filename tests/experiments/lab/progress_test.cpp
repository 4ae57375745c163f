// SPDX-License-Identifier: GPL-3.0-or-later
// Progress: on a terminal one line that changes, elsewhere a new line, not too often.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/progress.h"

namespace kinex {
namespace progress_test {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// What is shown of three texts, in a file that is, or is not, taken for a terminal.
std::string shown(bool terminal, double interval) {
  const File file(std::tmpfile(), std::fclose);
  {
    lab::Progress progress(file.get(), terminal, interval);
    for (const char* text : {"one", "two", "three"}) {
      progress.show([text](double seconds) { return seconds < 0 ? "" : text; });
    }
    progress.wipe();
  }
  std::rewind(file.get());
  std::string text;
  for (int c = std::fgetc(file.get()); c != EOF; c = std::fgetc(file.get())) text += static_cast<char>(c);
  return text;
}

TEST(Progress, LinesWhereThereIsNoTerminal) {
  EXPECT_EQ(shown(false, 0), "kinex: one\nkinex: two\nkinex: three\n");
  EXPECT_EQ(shown(false, 60), "");  // the first one after a minute
}

TEST(Progress, OneLineOnATerminal) {
  EXPECT_EQ(shown(true, 0), "\r\x1b[Kone\r\x1b[Ktwo\r\x1b[Kthree\r\x1b[K");
}

TEST(Progress, NothingWhereItIsNotWanted) {
  lab::Progress progress(false);
  progress.show([](double) -> std::string {
    ADD_FAILURE();
    return "";
  });
}

// Pieces that take their costs, one after the other: the time left is the rest of the costs.
TEST(PiecesDone, RightWhereCostsAreRight) {
  double now = 0;
  lab::PiecesDone pieces({1, 100, 1, 50, 2, 200}, [&now] { return now; });
  for (const auto& [piece, seconds] : {std::pair<std::size_t, double>(0, 2), {1, 200}, {2, 2}}) {
    pieces.started(piece);
    EXPECT_EQ(pieces.left(), "");  // too few to know how far costs are off
    now += seconds;
    pieces.finished(piece);
  }
  EXPECT_EQ(pieces.left(), "about 8 min left");  // 2 (50 + 2 + 200) s
  pieces.started(5);
  now += 240;
  EXPECT_EQ(pieces.text(5, "n = 200"),
            "cell 6 of 6: n = 200; about 4 min left");  // running pieces count, too
  now += 3000;
  EXPECT_EQ(pieces.left(), "about 2 min left");  // it takes longer than expected: the others remain
}

// Pieces that are far off their costs: a range, which is wide where one large piece remains, narrow for many small ones.
TEST(PiecesDone, ARangeWhereCostsAreOff) {
  const auto left = [](std::vector<double> rest) {
    std::vector<double> costs(40, 1);
    costs.insert(costs.end(), rest.begin(), rest.end());
    double now = 0;
    lab::PiecesDone pieces(costs, [&now] { return now; });
    for (std::size_t i = 0; i < 40; ++i) {
      pieces.started(i);
      now += i % 4 == 0 ? 19 : 7;  // 10 s on average
      pieces.finished(i);
    }
    return pieces.left();
  };
  EXPECT_EQ(left({60}), "5 to 21 min left");
  EXPECT_EQ(left(std::vector<double>(60, 1)), "8 to 12 min left");
}

TEST(PiecesDone, SeveralAtOnceAndWhatWasFinishedBefore) {
  double now = 0;
  lab::PiecesDone pieces(std::vector<double>(100, 1), [&now] { return now; });
  for (std::size_t i = 0; i < 50; ++i) {  // of an earlier command: they take no time
    pieces.started(i);
    pieces.finished(i);
  }
  EXPECT_EQ(pieces.left(), "");
  for (std::size_t i = 50; i < 60; i += 2) {
    pieces.started(i);
    pieces.started(i + 1);
    now += 10;
    pieces.finished(i);
    pieces.finished(i + 1);
  }
  EXPECT_EQ(pieces.left(), "about 3 min left");  // 40 of 10 s, two at once
}

}  // namespace progress_test
}  // namespace kinex
