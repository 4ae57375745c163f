// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of events and the predicates that a log may contain.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_RULES_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_RULES_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex::formats {

// The kinds of a structure (by its registered name) in the order of their rank, without those that
// all structures have; nullptr for an unknown structure.
const std::vector<KindRule>* own_kinds(std::string_view structure);

// The number of arguments of a predicate; nullopt if there is no predicate of that name.
std::optional<std::size_t> arity_of(std::string_view predicate);

// All of them, without forms for shared arguments ("order_strip/012123").
std::vector<std::string> predicate_names();

}  // namespace kinex::formats

#endif
