// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of grids, as they stand among the arguments of certificates: "x=3/2", "y=-4", "z=0".
#ifndef KINEX_EXPERIMENTS_FORMATS_GRID_LINE_H
#define KINEX_EXPERIMENTS_FORMATS_GRID_LINE_H

#include <optional>
#include <string>

#include "core/numbers/rational.h"

namespace kinex::formats {

// The place of the line; nullopt if the text names none.
inline std::optional<Rational> grid_line(const std::string& id) {
  if (id.size() < 3 || id[1] != '=' || id[0] < 'x' || 'z' < id[0]) return std::nullopt;
  return Rational::parse(id.substr(2));
}

}  // namespace kinex::formats

#endif
