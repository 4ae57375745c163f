// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/unchecked_certificates.h"

#include "experiments/formats/counted.h"

namespace kinex::formats {

std::uint64_t UncheckedCertificates::count() const {
  std::uint64_t all = of_bodies + without_instant;
  for (const auto& [predicate, number] : unsaid) all += number;
  return all;
}

std::string UncheckedCertificates::text() const {
  std::string text;
  const auto add = [&text](std::uint64_t number, const std::string& of, const std::string& why) {
    if (number == 0) return;
    text += (text.empty() ? "not checked: " : "; ") +
            counted(number, "certificate", "certificates") + of + ", " + why;
  };
  add(of_bodies, " of bodies",
      "which are about vertices and edges rather than about the scene's objects");
  add(without_instant, "", "since the log does not name their instants exactly");
  std::string predicates;
  std::uint64_t number = 0;
  for (const auto& [predicate, one] : unsaid) {
    predicates += (predicates.empty() ? " of " : ", ") + predicate;
    number += one;
  }
  add(number, predicates,
      "since the log does not say along which directions or lines of a grid they compare objects");
  return text;
}

}  // namespace kinex::formats
