// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/instant_name.h"

namespace kinex {

InstantText to_text(const InstantName& name) {
  InstantText text;
  text.exact = name.exact;
  text.approximate = name.decimal;
  if (!name.exact) return text;
  for (const Integer& c : name.polynomial.coefficients()) text.polynomial.push_back(c.to_string());
  text.root = name.root;
  text.lower = name.lower.to_string();
  text.upper = name.upper.to_string();
  return text;
}

}  // namespace kinex
