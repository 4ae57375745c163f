// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of structures: names to descriptors and makers. It walks over the families and knows
// none of them.
#ifndef KINEX_STRUCTURES_REGISTRY_H
#define KINEX_STRUCTURES_REGISTRY_H

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex {

// All structures, in the order of lists and help texts: family by family.
const std::vector<StructureInfo>& structure_infos();
// nullptr if there is no such structure.
const StructureInfo* find_structure_info(std::string_view name);
// The name of the family that a registered structure belongs to.
std::string_view family_of(std::string_view structure);
// An event of this kind in words, without a full stop: the descriptor's text, or that of a common
// event (CommonEvent). Empty: the structure has no such kind.
std::string_view meaning_of_kind(const StructureInfo& info, std::string_view kind);
// The groups of structures that maintain one attribute, in the order of their first structures.
std::vector<std::string_view> structure_groups();

// Why the structure cannot be maintained in the scene, whatever its key; nullopt: it can be. The
// problem begins with a verb: "needs 2 axes, the scene has 1". A scene without objects may be of
// points or of bodies.
std::optional<Refusal> refusal_of(const StructureInfo& info, const Scene& scene);
// Likewise for the key of a structure that uses one.
std::optional<Refusal> refusal_of_key(const StructureInfo& info, const Key& key);

// Likewise for a parameter, and (refusal_of_over) for the structure that it is to read.
std::optional<Refusal> refusal_of_parameter(const StructureInfo& info, const Parameter& parameter);
// The reading that "over" replaces: the structure's, or that of a structure it reads; nullptr: none.
const Reading* reading_of_choice(const StructureInfo& info);
// The structure that a reading names in a scene of `dimension` axes. In space a structure of the
// plane is replaced by its namesake, if there is one ("delaunay_3" for "delaunay_2").
std::string usual_structure(const Reading& reading, int dimension);
std::optional<Refusal> refusal_of_over(const StructureInfo& info, const Request& over);
// Likewise for the objects that a request names: "of", "query" and "colours".
std::optional<Refusal> refusal_of_objects(const StructureInfo& info, const Request& request,
                                          const Scene& scene);
// The value of a parameter in a request; its default if it is not given.
Rational parameter_of(const StructureInfo& info, const Request& request, std::string_view name);
// The vectors along which the structure's certificates order objects and extents
// (StructureInfo::directions), in a scene of `axes` axes; empty: it orders along none.
std::vector<std::vector<Rational>> directions_of(const StructureInfo& info, const Request& request,
                                                 int axes);
// The number of ids in a tuple of the attribute; 0 if the attribute is no set of tuples.
std::size_t width_of(const StructureInfo& info, const Request& request);

// Makes the requested structure, with id `id` in `kernel`. `watched`: the structures
// that it reads, in the order of StructureInfo::reads, and after them the one that it shares, if any
// (StructureInfo::shares); they outlive it. Throws std::invalid_argument, with problem and remedy,
// for what the functions above refuse.
std::unique_ptr<Structure> make_structure(const Request& request, const Scene& scene,
                                          Kernel& kernel, StructureId id,
                                          std::span<const Structure* const> watched = {},
                                          std::span<const StructureId> watched_ids = {});

}  // namespace kinex

#endif
