// SPDX-License-Identifier: GPL-3.0-or-later
// LineNumbers: the lines that a structure may be given, numbered from 0 in the order of their ids. Tables by line and line
// are as large as the lines ask for, however many points the scene has, and other lines.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_NUMBERS_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/engine/kernel.h"

namespace kinex {

class LineNumbers {
 public:
  // `is_line`: by object.
  explicit LineNumbers(const std::vector<bool>& is_line) : numbers_(is_line.size()) {
    for (ObjectId id = 0; id < is_line.size(); ++id) {
      if (!is_line[id]) continue;
      numbers_[id] = static_cast<std::uint32_t>(lines_.size());
      lines_.push_back(id);
    }
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(lines_.size()); }
  std::uint32_t operator[](ObjectId line) const { return numbers_[line]; }
  ObjectId line(std::size_t number) const { return lines_[number]; }
  std::size_t bytes() const {
    return numbers_.capacity() * sizeof(std::uint32_t) + lines_.capacity() * sizeof(ObjectId);
  }

 private:
  std::vector<std::uint32_t> numbers_;  // by object
  std::vector<ObjectId> lines_;
};

}  // namespace kinex

#endif
