// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are an event log, true or not, or refused with InputError; a log equals itself.
#include <string_view>

#include "experiments/formats/input_error.h"
#include "experiments/formats/log_check.h"
#include "experiments/formats/log_diff.h"
#include "tests/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kinex;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const formats::LogVerdict verdict = formats::check_log(text, "fuzz");
    const formats::LogDifference difference = formats::diff_logs(text, "a", text, "b");
    fuzz_require(difference.equal() && difference.events_a <= verdict.records &&
                     difference.missing + difference.invented + difference.out_of_order == 0,
                 "a log differs from itself");
  } catch (const formats::InputError& error) {
    fuzz_require(!error.problem().empty() && !error.remedy().empty(), "an error without a remedy");
  }
  return 0;
}
