// SPDX-License-Identifier: GPL-3.0-or-later
// TemporaryFolder: a folder of its own under the system's temporary one, removed with all that is
// in it.
#ifndef KINEX_EXPERIMENTS_LAB_TEMPORARY_FOLDER_H
#define KINEX_EXPERIMENTS_LAB_TEMPORARY_FOLDER_H

#include <filesystem>

namespace kinex {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  // Its name has no character that needs quotes, but where the system's temporary folder has some.
  // Empty if none could be made.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace kinex

#endif
