// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/lanes.h"

namespace kinex {

Vectors best_vectors() {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 ? Vectors::kAvx2 : Vectors::kBase;
#else
  return Vectors::kBase;
#endif
}

}  // namespace kinex
