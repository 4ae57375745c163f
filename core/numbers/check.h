// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of preconditions that stay on in every build.
#ifndef KINEX_CORE_NUMBERS_CHECK_H
#define KINEX_CORE_NUMBERS_CHECK_H

#include <stdexcept>

namespace kinex {

// Throws std::logic_error(message) unless `condition` holds: the caller broke a contract.
inline void require(bool condition, const char* message) {
  if (!condition) throw std::logic_error(message);
}

}  // namespace kinex

#endif
