// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/parts/binomial.h"

namespace kinex {

Integer binomial(const Integer& n, int k) {
  Integer product = 1;
  for (int i = 0; i < k; ++i) {
    if ((n - Integer(i)).sign() <= 0) return 0;
    product = product * (n - Integer(i));
    product.divide_exactly(Integer(i + 1));
  }
  return product;
}

}  // namespace kinex
