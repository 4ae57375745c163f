// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are no text are named as what they are.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/formats/file_io.h"
#include "experiments/formats/scene_reader.h"
#include "tests/experiments/expect_input_error.h"

namespace kinex::formats {
namespace binary_files_test {

class BinaryFiles : public testing::Test {
 protected:
  ~BinaryFiles() override { std::filesystem::remove(path_); }
  void write(const std::string& bytes) { std::ofstream(path_, std::ios::binary) << bytes; }
  const std::string path_ = testing::TempDir() + "kinex_binary_file";
};

TEST_F(BinaryFiles, AreNamed) {
  write(std::string("SQLite format 3\0\x10", 17));
  EXPECT_INPUT_ERROR(read_scene(path_), path_ +
                                            ": it is a SQLite database, not a text; sqlite3 and "
                                            "experiments/python/kinex_results.py read");
  for (const auto& [begin, name] : {std::pair("\x1f\x8b\x08", "compressed by gzip"),
                                    {"\xfd"
                                     "7zXZ",
                                     "compressed by xz"},
                                    {"\x28\xb5\x2f\xfd", "compressed by zstd"},
                                    {"BZh9", "compressed by bzip2"},
                                    {"PK\x03\x04", "a zip archive"}}) {
    write(std::string(begin) + "\xff\x01");
    EXPECT_INPUT_ERROR(read_text_file(path_), path_ + ": it is " + name +
                                                  "; unpack it, and give the file that was packed");
  }
  write("{}");
  EXPECT_EQ(read_text_file(path_), "{}");
}

}  // namespace binary_files_test
}  // namespace kinex::formats
