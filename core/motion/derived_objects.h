// SPDX-License-Identifier: GPL-3.0-or-later
// DerivedObjects: the motions in force, and the derived objects. A derived object is one that a
// structure needs and the scene does not have: a tangent line, a vertex in its body's frame, one
// body as seen from another, a strip between three points.
//
// A structure requests a derived object by a construction over ids, its bases (Kernel::derive), or
// by exact constants (Kernel::constant). Its id lies beyond those of the scene. Bases may be
// derived objects themselves. When the motion of an object changes, the kernel renews all objects
// derived from it and schedules their certificates anew.
//
//   scene      a     b     c          ids below `objects`
//               \   / \   /
//   derived      m     n     7        each with its bases; 7: a constant, without bases
//                 \   /
//   nested         s                  stands for a, b and c
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

// A vertex of a polygon, or the edge from it to the next one, by its place in the scene's list.
struct PolygonFeature {
  ObjectId body = kNoObject;
  bool edge = false;
  std::uint32_t place = 0;
  friend bool operator==(const PolygonFeature&, const PolygonFeature&) = default;
};

// The motion of a derived object as a function of the motions of its bases. Exact. Every result has
// the same number of axes; its degree is at most that declared in the structure's needs
// (core/arithmetic/number_needs.h).
class Construction {
 public:
  virtual ~Construction() = default;
  virtual std::string_view name() const = 0;
  virtual Trajectory derive(std::span<const Trajectory* const> bases) const = 0;
};

class DerivedObjects {
 public:
  // The scene's objects have the ids below `objects`.
  explicit DerivedObjects(std::size_t objects)
      : first_(static_cast<ObjectId>(objects)), motions_(objects) {}

  struct Object {  // a derived object
    std::string name;
    std::shared_ptr<const Construction> construction;  // nullptr: a constant
    std::vector<ObjectId> bases;
    // The scene's objects that it depends on, ascending, each once.
    std::vector<ObjectId> stands_for;
    Trajectory trajectory;
    std::optional<Rational> until;  // the earliest end of a base's flight plan; nullopt: none ends
    std::optional<PolygonFeature> feature;  // the feature that the object stands for in events
  };

  // "The dependents are left to renew" means: the caller must then renew() all_dependents(), in order.
  //
  // Sets the motion of an object of the scene; the dependents are left to renew. `until`: the end
  // of the flight plan; nullopt: none.
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until);
  // Adds a derived object and computes its trajectory at once; returns its id. The bases must exist
  // and have motions.
  ObjectId add(std::string name, std::shared_ptr<const Construction> construction,
               std::span<const ObjectId> bases);
  // Adds a constant.
  ObjectId add(std::string name, Trajectory constant,
               const std::optional<PolygonFeature>& feature = std::nullopt);
  // Replaces a constant by another one; the dependents are left to renew.
  void redefine(ObjectId id, std::string name, Trajectory constant);
  // Gives the object other bases, under the same construction, and renews it; the dependents are
  // left to renew. Throws std::logic_error if it would be derived from itself.
  void rebase(ObjectId id, std::string name, std::span<const ObjectId> bases);
  // Computes the trajectory and `until` from the present ones of the bases. A constant stays.
  const Object& renew(ObjectId id);
  bool is_derived(ObjectId id) const { return id >= first_; }
  // True for a derived object that no motion of the scene can change.
  bool is_constant(ObjectId id) const { return is_derived(id) && object(id).stands_for.empty(); }
  // Requires is_derived(id).
  const Object& object(ObjectId id) const { return derived_[id - first_]; }
  const Trajectory& trajectory(ObjectId id) const {
    return is_derived(id) ? object(id).trajectory : motions_[id];
  }
  // The objects that have `object` as a base, ascending.
  std::span<const ObjectId> dependents(ObjectId object) const;
  // All objects that depend on `object`, each after its bases: the order of renewal. Cost: linear
  // in their number, and O(size()) once some derived object has been a base.
  std::vector<ObjectId> all_dependents(ObjectId object) const;
  // The number of derived objects.
  std::size_t size() const { return derived_.size(); }
  std::size_t bytes() const;

 private:
  std::vector<ObjectId>& dependents_of(ObjectId object);
  void set_stands_for(Object& object) const;
  const std::optional<Rational>* until_of(ObjectId object) const;

  ObjectId first_;
  std::vector<Trajectory> motions_;             // of the scene's objects
  std::vector<std::optional<Rational>> until_;  // likewise; empty if no flight plan ends
  std::vector<std::vector<ObjectId>> dependents_;  // by object; may be shorter than the objects
  std::vector<Object> derived_;
  bool nested_ = false;  // some derived object has been a base
};

}  // namespace kinex

#endif
