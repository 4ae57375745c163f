// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/ccd/continuous_contact.h"

#include <cmath>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/exactly.h"
#include "core/numbers/rational_value.h"
#include "predicates/ccd/contact_exact.h"
#include "predicates/ccd/contact_filter.h"

namespace kinex {

namespace {

ContactVerdict ask_filter(const ContactQuery& query, ContactCounters& counters) {
  const ContactVerdict verdict = filter_contact(query);
  if (verdict.kind == ContactVerdict::Kind::kUnknown) {
    ++counters.exact;
  } else {
    ++(verdict.cuts == 0 ? counters.at_once : counters.subdivided);
  }
  return verdict;
}

}  // namespace

ContactQuery::ContactQuery(ContactKind kind, const Doubles& coordinates)
    : kind_(kind), rounded_(coordinates) {
  for (const double value : coordinates) {
    require(std::isfinite(value), "ContactQuery: a coordinate is not finite");
  }
}

ContactQuery::ContactQuery(ContactKind kind, std::vector<Rational> coordinates) : kind_(kind) {
  require(coordinates.size() == kCoordinates, "ContactQuery: wrong number of coordinates");
  bool doubles = true;
  for (std::size_t i = 0; i < kCoordinates; ++i) {
    rounded_[i] = coordinates[i].to_double();
    const std::optional<Rational> back = Rational::from_double(rounded_[i]);
    doubles = doubles && back && *back == coordinates[i];
  }
  if (!doubles) exact_ = std::move(coordinates);
}

Rational ContactQuery::coordinate(std::size_t index) const {
  return exact_.empty() ? exactly(rounded_[index]) : exact_[index];
}

bool in_contact(const ContactQuery& query, ContactCounters& counters) {
  const ContactVerdict verdict = ask_filter(query, counters);
  if (verdict.kind != ContactVerdict::Kind::kUnknown) {
    return verdict.kind == ContactVerdict::Kind::kFirst;
  }
  return first_contact_exactly(query, counters.roots).has_value();
}

std::optional<ContactTime> first_contact(const ContactQuery& query, ContactCounters& counters) {
  const ContactVerdict verdict = ask_filter(query, counters);
  switch (verdict.kind) {
    case ContactVerdict::Kind::kNone:
      return std::nullopt;
    case ContactVerdict::Kind::kFirst:
      return contact_between(query, verdict.lower, verdict.upper);
    case ContactVerdict::Kind::kUnknown:
      break;
  }
  return first_contact_exactly(query, counters.roots);
}

RootName name_instant(ContactTime& time, RootCounters& counters) {
  if (const std::optional<Rational> value = rational_value(time.root, counters)) {
    return {Polynomial({-value->numerator(), value->denominator()}), 1, *value, *value};
  }
  return name_root(time.polynomial, time.root, counters);
}

}  // namespace kinex
