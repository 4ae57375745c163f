// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are polynomials or refused; isolated roots agree with Sturm's theorem.
#include <string_view>

#include "core/numbers/real_root.h"
#include "core/numbers/sturm_sequence.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/polynomial_file.h"
#include "tests/fuzz/harness.h"

namespace {

// Larger polynomials are read, but not solved: a fuzzer wants many inputs.
constexpr int kMaxDegree = 24;
constexpr std::size_t kMaxBits = 2000;
constexpr std::size_t kMaxPolynomials = 8;

void check_roots(const kinex::Polynomial& p) {
  using namespace kinex;
  RootCounters counters;
  std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
  const SturmSequence sturm(p);
  fuzz_require(sturm.count_all() == static_cast<int>(roots.size()), "the number of roots");
  int with_multiplicity = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    RealRoot& root = roots[i].root;
    with_multiplicity += roots[i].multiplicity;
    fuzz_require(sign_at(p, root, counters) == Sign::kZero, "a root is no root");
    if (root.is_rational()) continue;
    fuzz_require(sturm.count_between(root.lower(), root.upper()) == 1, "an interval");
    root.refine_to(64, counters);
    if (root.is_rational()) {
      fuzz_require(p.sign_at(root.value()) == Sign::kZero, "a rational root");
      continue;
    }
    fuzz_require(sturm.count_between(root.lower(), root.upper()) == 1, "a refined interval");
  }
  for (std::size_t i = 1; i < roots.size(); ++i) {
    fuzz_require(compare(roots[i - 1].root, roots[i].root, counters) < 0, "the order of roots");
  }
  fuzz_require(with_multiplicity <= p.degree(), "the multiplicities");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kinex;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    std::size_t solved = 0;
    for (const formats::PolynomialLine& entry : formats::parse_polynomials(text, "fuzz")) {
      const Polynomial& p = entry.polynomial;
      if (p.degree() > kMaxDegree || p.max_bits() > kMaxBits) continue;
      if (++solved > kMaxPolynomials) break;
      check_roots(p);
    }
  } catch (const formats::InputError& error) {
    fuzz_require(!error.problem().empty() && !error.remedy().empty(), "an error without a remedy");
  }
  return 0;
}
