// SPDX-License-Identifier: GPL-3.0-or-later
// A folder for the results of a test, removed at its end.
#ifndef KINEX_TESTS_EXPERIMENTS_VERIFY_FOLDER_H
#define KINEX_TESTS_EXPERIMENTS_VERIFY_FOLDER_H

#include <unistd.h>

#include <filesystem>
#include <string>

namespace kinex::test {

class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("kinex-verify-test-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace kinex::test

#endif
