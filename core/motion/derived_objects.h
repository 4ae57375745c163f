// SPDX-License-Identifier: GPL-3.0-or-later
// DerivedObjects: objects that a structure needs and the scene does not have: a tangent line, a
// vertex in its body's frame, one body as seen from another.
//
// A structure requests one by a construction over ids (Kernel::derive) or by exact constants
// (Kernel::constant) and gets an id beyond those of the scene. When the motion of an object
// changes, those derived from it follow, and their certificates are scheduled anew.
#ifndef KINEX_CORE_MOTION_DERIVED_OBJECTS_H
#define KINEX_CORE_MOTION_DERIVED_OBJECTS_H

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/motion.h"
#include "core/motion/scene.h"

namespace kinex {

// The axes of the widest derived object, a pose (predicates/bodies/pose_2.h).
inline constexpr int kMostDerivedAxes = 7;

// The motion of a derived object as a function of the motions of its bases. Exact.
class Construction {
 public:
  virtual ~Construction() = default;
  virtual std::string_view name() const = 0;
  virtual Trajectory derive(std::span<const Trajectory* const> bases) const = 0;
};

class DerivedObjects {
 public:
  // The scene's objects have the ids below `objects`.
  explicit DerivedObjects(std::size_t objects) : first_(static_cast<ObjectId>(objects)) {}

  struct Object {
    std::string name;
    std::shared_ptr<const Construction> construction;  // nullptr: a constant
    std::vector<ObjectId> bases;
    Trajectory trajectory;
    std::optional<Rational> until;
  };

  // The motions of the scene's objects are remembered from now on.
  void keep_motions() { keeps_ = true; }
  bool keeps_motions() const { return keeps_; }
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until);
  // The bases must have motions. The new object's trajectory is made at once.
  ObjectId add(std::string name, std::shared_ptr<const Construction> construction,
               std::span<const ObjectId> bases);
  ObjectId add(std::string name, Trajectory constant);
  // Makes the object into another constant.
  void redefine(ObjectId id, std::string name, Trajectory constant);
  // Makes the object into that of other bases, by the same construction.
  void rebase(ObjectId id, std::string name, std::span<const ObjectId> bases);
  // Makes the trajectory from the bases' present ones.
  const Object& renew(ObjectId id);
  bool is_derived(ObjectId id) const { return id >= first_; }
  const Object& object(ObjectId id) const { return derived_[id - first_]; }
  const Trajectory& trajectory(ObjectId id) const {
    return is_derived(id) ? object(id).trajectory : motions_[id].trajectory;
  }
  // The objects derived from `object`, in the order of their ids.
  std::span<const ObjectId> dependents(ObjectId object) const;
  std::size_t size() const { return derived_.size(); }
  std::size_t bytes() const;

 private:
  struct Known {
    Trajectory trajectory;
    std::optional<Rational> until;
    std::vector<ObjectId> dependents;
  };
  Known& known(ObjectId object);

  ObjectId first_;
  bool keeps_ = false;
  std::vector<Known> motions_;  // of the scene's objects
  std::vector<Object> derived_;
};

}  // namespace kinex

#endif
