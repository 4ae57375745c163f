// SPDX-License-Identifier: GPL-3.0-or-later
// Real data that some tests read. They are too large for the sources; a test is skipped if its data
// are missing.
#ifndef KINEX_TESTS_SHARED_DATA_H
#define KINEX_TESTS_SHARED_DATA_H

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/places.h"

namespace kinex {

// The file in the folder that KINEX_SHARED_DATA names, by default beside the sources.
inline std::string shared_data(const std::string& file) {
  const char* folder = std::getenv("KINEX_SHARED_DATA");
  const std::filesystem::path path =
      folder != nullptr ? std::filesystem::path(folder)
                        : std::filesystem::path(KINEX_SOURCE_DIR).parent_path() / "shared" / "data";
  return (path / file).string();
}

}  // namespace kinex

// Skips the test if the file is not there.
#define KINEX_REQUIRE_DATA(path)                                           \
  if (!std::filesystem::exists(path)) {                                    \
    GTEST_SKIP() << "there is no " << (path) << "; set KINEX_SHARED_DATA"; \
  }

#endif
