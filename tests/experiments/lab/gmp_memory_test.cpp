// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/gmp_memory.h"

#include <gmp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "experiments/lab/own_process.h"

namespace kinex::lab {
namespace gmp_memory_test {

// A deadline that is due, its grace passed.
Deadline passed(const std::atomic<bool>& interrupt) {
  Deadline deadline(0, &interrupt);
  static_cast<void>(deadline.due());
  for (int i = 0; i < 100 && !deadline.due(); ++i) {
  }
  std::this_thread::sleep_for(2 * Deadline::kGrace);
  return deadline;
}

// A product notes the size of its result before it asks for the memory. Where that is refused, the number
// has the memory of before, of one limb or of two, and is destroyed like any other.
TEST(GmpMemory, NumbersThatWereBeingWrittenCanBeDestroyed) {
  struct Counts {
    int stopped, done;
  };
  const auto counts = in_own_process([] {
    install_gmp_memory();
    const std::atomic<bool> interrupt{true};
    Counts result{};
    mpz_t big;
    mpz_init(big);
    mpz_ui_pow_ui(big, 7, 1'000'000);
    for (const unsigned long limbs : {1ul, 2ul}) {
      for (int i = 0; i < 3; ++i) {
        Deadline deadline = passed(interrupt);
        mpz_t product;
        mpz_init2(product, 64 * limbs);
        mpz_set_ui(product, 5);
        try {
          const GmpGuard guard(&deadline);
          mpz_mul(product, big, big);
        } catch (const Stopped&) {
          ++result.stopped;
        }
        mpz_clear(product);
      }
    }
    // What was given back is used again.
    mpz_t numbers[100];
    for (mpz_t& x : numbers) mpz_init_set_ui(x, 1);
    for (mpz_t& x : numbers) result.done += static_cast<int>(mpz_get_ui(x));
    for (mpz_t& x : numbers) mpz_clear(x);
    mpz_clear(big);
    return result;
  });
  EXPECT_EQ(counts.stopped, 6);
  EXPECT_EQ(counts.done, 100);
}

}  // namespace gmp_memory_test
}  // namespace kinex::lab
