// SPDX-License-Identifier: GPL-3.0-or-later
// Progress: on a terminal one line that changes, elsewhere a new line, not too often.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

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

}  // namespace progress_test
}  // namespace kinex
