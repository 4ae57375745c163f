// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace kinex::lab {

void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // All below are open, so that this is the one that open() gives. Each is opened for what it is not used for.
    const int mode = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    [[maybe_unused]] const int opened = ::open("/dev/null", mode);
  }
}

}  // namespace kinex::lab
