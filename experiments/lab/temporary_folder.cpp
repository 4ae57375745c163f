// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace kinex::lab {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  fs::path base = fs::temp_directory_path(error);
  if (error) base = "/tmp";
  std::string name = (base / "kinex-XXXXXX").string();
  if (::mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace kinex::lab
