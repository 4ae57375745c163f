// SPDX-License-Identifier: GPL-3.0-or-later
// Input and output of an audit.
#ifndef KINEX_CORE_ENGINE_AUDIT_H
#define KINEX_CORE_ENGINE_AUDIT_H

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/rational.h"

namespace kinex {

// A box in the plane: per axis the least and the largest coordinate.
using ExactBox = std::array<std::array<Rational, 2>, 2>;

// Exact positions of all living objects at one rational time: the first dimension() axes. Behind
// them are a body's rotor, the extents or the weight (Scene::extents); in runs that read weights there
// is one such axis at least, 0 in scenes of plain points.
class Snapshot {
 public:
  Snapshot(Rational time, int dimension, int axes, std::size_t objects)
      : time_(std::move(time)),
        dimension_(dimension),
        axes_(axes),
        alive_(objects, false),
        positions_(objects * static_cast<std::size_t>(axes)) {}

  const Rational& time() const { return time_; }
  int dimension() const { return dimension_; }
  // The number of the scene's objects, alive or not.
  std::size_t objects() const { return alive_.size(); }
  bool alive(ObjectId id) const { return alive_[id]; }
  // Requires alive(id).
  const Rational& position(ObjectId id, int axis) const {
    return positions_[id * static_cast<std::size_t>(axes_) + static_cast<std::size_t>(axis)];
  }
  // The same with these objects alone: by object; empty: all.
  Snapshot of(const std::vector<bool>& members) const {
    Snapshot result = *this;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (!members[i]) result.alive_[i] = false;
    }
    return result;
  }
  void set(ObjectId id, int axis, Rational value) {
    alive_[id] = true;
    positions_[id * static_cast<std::size_t>(axes_) + static_cast<std::size_t>(axis)] =
        std::move(value);
  }

 private:
  Rational time_;
  int dimension_, axes_;
  std::vector<bool> alive_;
  std::vector<Rational> positions_;
};

// Violations are collected, never thrown.
struct AuditReport {
  std::uint64_t checks = 0;
  std::vector<std::string> violations;

  // Counts one check; the message is taken only when it fails.
  template <class Message>
  void check(bool holds, Message&& message) {
    ++checks;
    if (!holds) violations.push_back(std::forward<Message>(message)());
  }
};

}  // namespace kinex

#endif
