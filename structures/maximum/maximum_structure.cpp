// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_structure.h"

#include <string>

#include "structures/parts/key_value.h"

namespace kinex {

Attribute MaximumStructure::attribute() const {
  Attribute result{Attribute::Shape::kObject, {}};
  if (winner() != kNoObject) result.ids.push_back(winner());
  return result;
}

void MaximumStructure::check_told(AuditReport& report) const {
  report.check(events_.object() == winner(),
               [] { return std::string("a change of the maximum was not reported"); });
}

void MaximumStructure::audit(const Snapshot& snapshot, AuditReport& report) const {
  audit_extremum(contest_.order().key(), contest_.extremum(), objects_, attribute(), snapshot,
                 report);
}

void audit_extremum(const Key& key, Extremum extremum, std::size_t objects,
                    const Attribute& attribute, const Snapshot& snapshot, AuditReport& report) {
  const bool maximum = extremum == Extremum::kMaximum;
  const auto keys = sorted_keys(key, snapshot, objects);
  Attribute expected{Attribute::Shape::kObject, {}};
  if (!keys.empty()) {
    std::size_t best = 0;
    if (maximum) {
      best = keys.size() - 1;
      while (best > 0 && keys[best - 1].first == keys[best].first) --best;
    }
    expected.ids.push_back(keys[best].second);
  }
  report.check(expected == attribute, [&] {
    const auto text = [](const Attribute& a) {
      return a.ids.empty() ? std::string("none") : std::to_string(a.ids[0]);
    };
    return "the " + std::string(maximum ? "maximum" : "minimum") + " is object " + text(expected) +
           ", not " + text(attribute);
  });
}

}  // namespace kinex
