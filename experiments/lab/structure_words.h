// SPDX-License-Identifier: GPL-3.0-or-later
// What the descriptors of structures say, in words: for `kinex explain`, help texts and the tables
// of the documents.
#ifndef KINEX_EXPERIMENTS_LAB_STRUCTURE_WORDS_H
#define KINEX_EXPERIMENTS_LAB_STRUCTURE_WORDS_H

#include <string>
#include <string_view>
#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex::lab {

// "a set of pairs of ids"
std::string attribute_in_words(const StructureInfo& info);
// The scenes that it is for: "points in 2 axes or more, linear motions".
std::string domain_in_words(const StructureInfo& info);
// What it reads, a line each, with all choices that "over" has.
std::vector<std::string> readings_in_words(const StructureInfo& info);
// Its parameters with range and default, a line each.
std::vector<std::string> parameters_in_words(const StructureInfo& info);

// The names of all structures, a paragraph for each family, each line with a break at its end.
std::string structure_names_by_family();
// A table in Markdown with a row for each structure of the family; empty: of all families, each
// after a row with its name.
std::string structure_table(std::string_view family);

}  // namespace kinex::lab

#endif
