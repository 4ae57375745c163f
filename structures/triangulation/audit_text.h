// SPDX-License-Identifier: GPL-3.0-or-later
// Text of the audits of triangulations: what is wrong, and with which objects.
#ifndef KINEX_STRUCTURES_TRIANGULATION_AUDIT_TEXT_H
#define KINEX_STRUCTURES_TRIANGULATION_AUDIT_TEXT_H

#include <initializer_list>
#include <string>

#include "core/motion/scene.h"

namespace kinex {

// "what id id ..": the ids as decimal numbers, in the given order, each after a blank.
inline std::string named(const char* what, std::initializer_list<ObjectId> ids) {
  std::string text = what;
  for (const ObjectId id : ids) text += " " + std::to_string(id);
  return text;
}

}  // namespace kinex

#endif
