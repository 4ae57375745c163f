// SPDX-License-Identifier: GPL-3.0-or-later
// The standard streams of a program that was started without them, as by `kinex run scene.json >&-`.
#ifndef KINEX_EXPERIMENTS_LAB_STANDARD_STREAMS_H
#define KINEX_EXPERIMENTS_LAB_STANDARD_STREAMS_H

namespace kinex::lab {

// Takes those of the descriptors 0, 1 and 2 that are closed: the next file to be opened would be given one of them, and get
// what is meant for that stream. Reading standard input, and writing to standard output or standard error, fails as before
// (EBADF). Call it before anything is opened.
void hold_standard_streams();

}  // namespace kinex::lab

#endif
