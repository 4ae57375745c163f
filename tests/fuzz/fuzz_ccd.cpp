// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are collision queries or refused; both stages give the same first time of contact, and
// its name is that of one root in [0, 1].
#include <string_view>

#include "core/numbers/sturm_sequence.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/query_file.h"
#include "predicates/ccd/contact_exact.h"
#include "tests/fuzz/harness.h"

namespace {

using namespace kinex;

constexpr std::size_t kMaxQueries = 3;

void check_query(const ContactQuery& query) {
  ContactCounters counters;
  std::optional<ContactTime> time = first_contact(query, counters);
  std::optional<ContactTime> exact = first_contact_exactly(query, counters.roots);
  fuzz_require(time.has_value() == exact.has_value(), "contact or not");
  fuzz_require(time.has_value() == in_contact(query, counters), "contact or not, without the time");
  if (!time) return;
  fuzz_require(compare(time->root, exact->root, counters.roots) == 0, "the first time");
  const RootName name = name_instant(*time, counters.roots);
  fuzz_require(Rational(0) <= name.upper && name.lower <= Rational(1), "the interval");
  fuzz_require(sign_at(name.polynomial, exact->root, counters.roots) == Sign::kZero, "the name");
  if (name.lower == name.upper) return;
  fuzz_require(SturmSequence(name.polynomial).count_between(name.lower, name.upper) == 1,
               "the roots in the interval");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const ContactKind kind : {ContactKind::kVertexFace, ContactKind::kEdgeEdge}) {
    try {
      const formats::QueryFile file = formats::parse_queries(text, "fuzz", kind);
      for (std::size_t i = 0; i < file.queries.size() && i < kMaxQueries; ++i) {
        check_query(file.queries[i].query);
      }
    } catch (const formats::InputError& error) {
      fuzz_require(!error.problem().empty() && !error.remedy().empty(),
                   "an error without a remedy");
    }
  }
  return 0;
}
