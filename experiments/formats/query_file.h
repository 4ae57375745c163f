// SPDX-License-Identifier: GPL-3.0-or-later
// Files of continuous collision queries, in the format of the sample queries of Wang, Ferguson,
// Schneider, Jiang, Attene and Panozzo (ACM TOG 40(5), 2021).
//
// No header line; eight lines a query: four points at t = 0 (a vertex and the corners of a
// triangle, or the ends of one edge and those of another), then the same four at t = 1. A line is
//   x_num,x_den,y_num,y_den,z_num,z_den[,truth]
// with integers of any size, denominators not zero, and truth 0 or 1, the same in all eight lines.
// Either every line of the file has the truth column, or none. Blank lines are skipped.
#ifndef KINEX_EXPERIMENTS_FORMATS_QUERY_FILE_H
#define KINEX_EXPERIMENTS_FORMATS_QUERY_FILE_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numbers/stop.h"
#include "predicates/ccd/continuous_contact.h"

namespace kinex::formats {

struct FileQuery {
  std::size_t line;  // the first of the eight, from 1
  ContactQuery query;
  bool truth;  // the truth column; false if there is none
};

struct QueryFile {
  std::vector<FileQuery> queries;
  bool has_truth = false;
};

// Throws InputError that names the line.
QueryFile parse_queries(std::string_view text, const std::string& file, ContactKind kind,
                        Deadline* deadline = nullptr);

// "vertex-face" and "edge-edge".
std::string_view contact_kind_name(ContactKind kind);
std::optional<ContactKind> find_contact_kind(std::string_view name);
// The kind named by a path: by its last part that contains the name of a kind, for example
// edge-edge-7.csv, or a folder edge-edge. nullopt if no part does, or if that part has both names.
std::optional<ContactKind> contact_kind_of_path(std::string_view path);

}  // namespace kinex::formats

#endif
