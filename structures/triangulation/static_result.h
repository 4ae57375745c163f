// SPDX-License-Identifier: GPL-3.0-or-later
// StaticResult: how the static construction of a triangulation ended.
#ifndef KINEX_STRUCTURES_TRIANGULATION_STATIC_RESULT_H
#define KINEX_STRUCTURES_TRIANGULATION_STATIC_RESULT_H

namespace kinex {

// What there is after a static construction.
enum class StaticResult {
  kBuilt,
  kFlat,    // all points are identically in one plane, or on one line: there are no cells
  kFailed,  // signs contradict each other (inexact arithmetics)
};

}  // namespace kinex

#endif
