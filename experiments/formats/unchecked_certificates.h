// SPDX-License-Identifier: GPL-3.0-or-later
// The certificates of a log whose polynomials were not made anew, by the reason.
#ifndef KINEX_EXPERIMENTS_FORMATS_UNCHECKED_CERTIFICATES_H
#define KINEX_EXPERIMENTS_FORMATS_UNCHECKED_CERTIFICATES_H

#include <cstdint>
#include <map>
#include <string>

namespace kinex::formats {

struct UncheckedCertificates {
  std::uint64_t of_bodies = 0;  // they are about features, not about the scene's objects
  std::uint64_t without_instant =
      0;  // the log does not name the instant, or that of a change of motion before it
  // By predicate: the log names their objects, but not the directions or lines of a grid along which they compare.
  std::map<std::string, std::uint64_t> unsaid;

  std::uint64_t count() const;
  // "not checked: 251 (order_direction), since ..": all reasons; empty if there is none.
  std::string text() const;
};

}  // namespace kinex::formats

#endif
