// SPDX-License-Identifier: GPL-3.0-or-later
// append_whole: lines of a file that outlive a kill or a power cut, whole or not at all.
#ifndef KINEX_EXPERIMENTS_SWEEP_APPEND_WHOLE_H
#define KINEX_EXPERIMENTS_SWEEP_APPEND_WHOLE_H

#include <cstdint>
#include <string>

namespace kinex::sweep {

// Appends text to an open file of `size` bytes (its descriptor), and has it written to the disk. Where that fails the file is
// cut to what it was, and InputError is thrown, with its name `path`.
void append_whole(int file, const std::string& text, const std::string& path, std::int64_t& size);

}  // namespace kinex::sweep

#endif
