// SPDX-License-Identifier: GPL-3.0-or-later
// The possible contents of a log: kinds of events with their effects, predicates.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_RULES_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_RULES_H

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "structures/parts/descriptor.h"

namespace kinex {

// The kinds of a structure (by its registered name) in the order of their rank, without those that
// all structures have; nullptr for an unknown structure.
const std::vector<KindRule>* own_kinds(std::string_view structure);

// The number of arguments of a predicate; nullopt: there is none of that name.
std::optional<std::size_t> arity_of(std::string_view predicate);

}  // namespace kinex

#endif
