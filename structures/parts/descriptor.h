// SPDX-License-Identifier: GPL-3.0-or-later
// StructureInfo: the descriptor of a structure: all that the rest of the program knows about it
// before it is made, and the function that makes it. Each family lists its structures in its
// family.cpp. The reader of scenes, the help, the tables of the README and the tests use these
// lists.
#ifndef KINEX_STRUCTURES_PARTS_DESCRIPTOR_H
#define KINEX_STRUCTURES_PARTS_DESCRIPTOR_H

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/arithmetic/number_needs.h"
#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"

namespace kinex {

struct StructureInfo;

// Why a structure cannot be maintained in a scene, and what to do about it. No full stops.
struct Refusal {
  std::string problem, remedy;
};

// The arguments of a maker. `request` is valid for `scene`. `watched`: the structures that the new
// one reads, in the order of StructureInfo::reads, and the one that it shares, if any; they outlive
// it.
struct MakerInput {
  const Request& request;
  const Scene& scene;
  Kernel& kernel;
  StructureId id;
  std::span<const Structure* const> watched;
  std::span<const StructureId> watched_ids = {};  // of the same

  // The descriptor of the new structure, which lives as long as the program.
  const StructureInfo& info() const;
  // The value of a parameter of the descriptor.
  Rational parameter(std::string_view name) const;
};

// A structure that another one watches.
struct Reading {
  std::string_view structure;      // the usual one
  std::string_view role = {};      // "over" may name any structure that plays this role instead
  std::optional<int> axis = {};    // it orders by this coordinate; none: by the reader's key
  bool passes_over = false;        // the reader's "over" is meant for what this one reads
};

// A part that structures can share. Each has its own unless a scene maintains two or more that
// could share it over the same structure (their first reading). Then all of them watch one structure
// in its place, after what they read.
struct Sharing {
  std::string_view structure = {};  // whose first reading is theirs; empty: nothing is shared
  std::string_view parameter = {};  // of it, an integer: the largest that a reader needs
  int needs = 0;                    // this reader
};

// A parameter of a structure: a member of its entry in "maintain". Numbers are written as in scenes.
struct ParameterInfo {
  std::string_view name, summary;
  std::string_view usual;       // the value if none is given
  std::string_view least;       // allowed
  std::string_view most = {};   // allowed; empty: no limit
  bool most_is_allowed = true;  // false: values are less than `most`
  bool whole = true;            // an integer
  std::string_view step = {};   // values are `least` plus a multiple of it; empty: any
};

// Does an event of a kind change the attribute?
enum class Effect { kNever, kSometimes, kAlways };

struct KindRule {  // what events of a kind do
  std::string_view kind;
  Effect effect;
  std::string_view text = {};  // the event in words, without a full stop
};

// The lines of a scene (SceneObject::line), for a structure.
enum class LineUse : std::uint8_t {
  kNone,        // it is for scenes without lines
  kAlone,       // it is built from the lines alone
  kWithPoints,  // it is built from lines and points
};

struct StructureInfo {
  std::string_view name;     // as in "maintain"
  std::string_view summary;  // one line
  // The name of the structures that maintain the same attribute and report it alike; empty if there
  // is only this one. `kinex verify` takes it.
  std::string_view group = {};
  int min_dimension = 1;            // axes that a scene must have
  bool any_dimension = false;       // or more; otherwise a scene of more axes is refused
  bool uses_key = false;            // it compares objects by the request's "key"
  int largest_degree = kAnyDegree;  // of the motions and of the key that it can maintain
  bool bodies = false;              // for rigid bodies; otherwise for points
  bool fails_at_touch = false;      // some of its certificates do (core/arithmetic/touch.h)
  bool has_events = true;           // false: it checks constants of the scene and follows no motion
  Attribute::Shape shape = Attribute::Shape::kSequence;
  std::uint8_t width = 2;         // of the tuples of a set; or kWidthOfParameter
  // The kinds of its events by rank (Structure::event_kinds), without the common ones.
  std::vector<KindRule> kinds = {};
  std::vector<Reading> reads = {};  // the structures that it watches
  Sharing shares = {};
  // What it can be read as ("hull"), or drawn as ("strip"); empty: by its name only.
  std::string_view role = {};
  std::vector<ParameterInfo> parameters = {};
  std::string_view instead = {};    // a structure of its group that takes every scene; empty: itself
  bool weights = false;  // it reads the weights of points, or the radii of discs
  bool query = false;               // it is about one object, the request's "query"
  bool query_is_site = false;       // and that one is among the others: for structures with a query
  bool colours = false;             // it is about two classes of objects, the request's "colours"
  bool graph = false;               // for edges of graphs ("ends"), and only these
  // For objects with these extents; boxes are about discs, too, so that kHalfExtents takes either.
  Extents extents = Extents::kNone;
  LineUse lines = LineUse::kNone;
  // Of its first parameter and the number of axes: the vectors along which its certificates order
  // objects and extents, one of each two opposite ones; nullptr: it has no vectors of its own.
  std::vector<std::vector<Rational>> (*directions)(int parameter, int axes) = nullptr;
  // The objects that those structures are built from which it reads; nullptr: they are the request's.
  Subset (*sample)(const Request& request, const Scene& scene) = nullptr;
  // Adds the objects that it derives in the scene; nullptr: it derives none.
  void (*derives)(const Scene& scene, NumberNeeds& needs) = nullptr;
  // Refuses scenes that it cannot maintain for another reason; nullptr: there is none. Called only
  // for scenes that all fields above allow.
  std::optional<Refusal> (*refuse)(const Scene& scene) = nullptr;
  std::unique_ptr<Structure> (*make)(const MakerInput& input) = nullptr;
  // For people (kinex explain): lines without a full stop.
  std::string_view certificates = {};  // how many there are, and of what; n objects
  std::string_view ties = {};          // what it does with what is identically equal
  std::string_view source = {};        // where it is described

  static constexpr int kAnyDegree = 1 << 30;
  static constexpr std::uint8_t kWidthOfParameter = 0;  // the value of its first parameter
  bool linear() const { return largest_degree == 1; }
  // What points are given to make them objects that it is about.
  Extents usual_extents() const { return weights ? Extents::kWeight : extents; }
  // It maintains an attribute of bodies that changes as they move.
  bool follows_bodies() const { return bodies && has_events; }
};

// The structures of one subject, in the order in which they are listed to people.
struct StructureFamily {
  std::string_view name;  // "maximum": also the name of its folders
  std::vector<StructureInfo> structures;
};

// The maker of most structures: constructs S from the kernel, the id and the scene.
template <class S>
std::unique_ptr<Structure> make_plain(const MakerInput& input) {
  return std::make_unique<S>(input.kernel, input.id, input.scene);
}

}  // namespace kinex

#endif
