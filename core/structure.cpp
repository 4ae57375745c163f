// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure.h"

namespace kinex {

std::vector<std::string_view> common_event_kinds(std::vector<std::string_view> own) {
  for (const std::string_view kind : {"motion", "insert", "erase", "rebuild"}) own.push_back(kind);
  return own;
}

}  // namespace kinex
