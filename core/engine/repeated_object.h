// SPDX-License-Identifier: GPL-3.0-or-later
// RepeatedObject: a structure requested a certificate that names one object twice.
#ifndef KINEX_CORE_ENGINE_REPEATED_OBJECT_H
#define KINEX_CORE_ENGINE_REPEATED_OBJECT_H

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/certificate.h"

namespace kinex {

// In an exact arithmetic this is a bug of the structure. In an inexact one wrong signs may also
// cause it, so the run treats it as corruption. The message names the structure, the predicate and
// the objects.
class RepeatedObject : public std::logic_error {
 public:
  // `objects`: the names of the query's arguments.
  RepeatedObject(StructureId structure, const Query& query, const std::string& structure_name,
                 std::string_view predicate, const std::vector<std::string>& objects)
      : std::logic_error(text(structure_name, predicate, objects)),
        structure_(structure),
        query_(query) {}

  StructureId structure() const { return structure_; }
  const Query& query() const { return query_; }

 private:
  static std::string text(const std::string& structure, std::string_view predicate,
                          const std::vector<std::string>& objects) {
    std::string list;
    for (const std::string& name : objects) list += (list.empty() ? "" : ", ") + name;
    return "structure " + structure + " asks for a certificate " + std::string(predicate) + "(" +
           list + "), which names an object twice";
  }

  StructureId structure_;
  Query query_;
};

}  // namespace kinex

#endif
