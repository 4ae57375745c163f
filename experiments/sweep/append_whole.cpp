// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/append_whole.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "experiments/formats/input_error.h"

namespace kinex::sweep {

void append_whole(int file, const std::string& text, const std::string& path, std::int64_t& size) {
  const ssize_t written = ::write(file, text.data(), text.size());
  int error = written < 0 ? errno : ENOSPC;
  if (written == static_cast<ssize_t>(text.size())) {
    // A pipe or a special file system may have nothing to flush.
    if (::fdatasync(file) == 0 || errno == EINVAL || errno == ENOTSUP) {
      size += written;
      return;
    }
    error = errno;
  }
  if (::ftruncate(file, static_cast<off_t>(size)) != 0) error = errno;
  throw formats::InputError(path, "", std::string("cannot be written: ") + std::strerror(error),
                            "make room on the disk; the same command goes on from here");
}

}  // namespace kinex::sweep
