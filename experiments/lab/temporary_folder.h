// SPDX-License-Identifier: GPL-3.0-or-later
// TemporaryFolder: a new folder under the system's temporary folder, removed with its contents by
// the destructor.
#ifndef KINEX_EXPERIMENTS_LAB_TEMPORARY_FOLDER_H
#define KINEX_EXPERIMENTS_LAB_TEMPORARY_FOLDER_H

#include <filesystem>

namespace kinex::lab {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  // Empty if no folder could be made. The name needs no quotes in a shell unless that of the
  // system's temporary folder does.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace kinex::lab

#endif
