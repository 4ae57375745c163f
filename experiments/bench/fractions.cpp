// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do fractions of two machine words save, which audits compute with, against GMP's mpq?
// Workload: the squared distances of points and their order, as in audits of closest pairs: coordinates k / d with
//   random |k| <= 10^6, for one d in each row, since the positions of an instant have one denominator. The squares of the
//   last one do not fit words, so Rational falls back on GMP for them.
// Both compute the same order, or the benchmark fails. Rounds are interleaved; the best of each counts; thread CPU time.
// Output: see result_table.h; options: see bench_options.h.
#include <gmp.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/numbers/rational.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

// GMP's fractions alone, as a class of the same operators.
class Fraction {
 public:
  Fraction() { mpq_init(q_); }
  explicit Fraction(const Rational& value) : Fraction() { mpq_set(q_, value.raw()); }
  Fraction(const Fraction& other) : Fraction() { mpq_set(q_, other.q_); }
  Fraction(Fraction&& other) noexcept : Fraction() { mpq_swap(q_, other.q_); }
  Fraction& operator=(Fraction&& other) noexcept {
    mpq_swap(q_, other.q_);
    return *this;
  }
  Fraction& operator=(const Fraction&) = delete;
  ~Fraction() { mpq_clear(q_); }
  friend Fraction operator+(const Fraction& a, const Fraction& b) { return by(mpq_add, a, b); }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return by(mpq_sub, a, b); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) { return by(mpq_mul, a, b); }
  friend bool operator<(const Fraction& a, const Fraction& b) { return mpq_cmp(a.q_, b.q_) < 0; }

 private:
  static Fraction by(void (*f)(mpq_ptr, mpq_srcptr, mpq_srcptr), const Fraction& a,
                     const Fraction& b) {
    Fraction result;
    f(result.q_, a.q_, b.q_);
    return result;
  }
  mpq_t q_;
};

constexpr std::size_t kPoints = 64;

std::vector<Rational> coordinates(std::int64_t denominator) {
  std::mt19937_64 random(1);
  std::vector<Rational> result;
  for (std::size_t i = 0; i < 2 * kPoints; ++i) {
    const std::int64_t k = static_cast<std::int64_t>(random() % 2000001) - 1000000;
    result.emplace_back(Integer(k), Integer(denominator));
  }
  return result;
}

// The nearest of each point, added up: `times` times. Operations: three of rings and two more, and a comparison.
template <class Number>
lab::BenchRun nearest(const std::vector<Number>& c, int times, std::size_t& sum) {
  std::uint64_t distances = 0;
  sum = 0;
  const double begin = lab::cpu_seconds();
  for (int round = 0; round < times; ++round) {
    for (std::size_t a = 0; a < kPoints; ++a) {
      std::size_t best = a;
      Number least;
      for (std::size_t b = 0; b < kPoints; ++b) {
        if (b == a) continue;
        const Number x = c[2 * a] - c[2 * b], y = c[2 * a + 1] - c[2 * b + 1];
        Number square = x * x + y * y;
        ++distances;
        if (best != a && !(square < least)) continue;
        best = b;
        least = std::move(square);
      }
      sum += best;
    }
  }
  return {.seconds = lab::cpu_seconds() - begin, .events = distances};
}

void fractions(const lab::BenchOptions& options) {
  lab::ResultTable table(
      options, "fractions", "A squared distance and its comparison: fractions of words, and GMP's.",
      {{"denominator", 0, 20}, {"ns_words", 1, 10}, {"ns_gmp", 1, 10}, {"gmp_over_words", 2}});
  const int times = options.smoke ? 1 : 40;
  for (const std::int64_t denominator :
       {std::int64_t{1}, std::int64_t{12}, std::int64_t{1} << 20, std::int64_t{1048573},
        (std::int64_t{1} << 30) - 35, (std::int64_t{1} << 61) - 1}) {
    const std::vector<Rational> ours = coordinates(denominator);
    std::vector<Fraction> theirs;
    for (const Rational& value : ours) theirs.emplace_back(value);
    std::size_t by_words = 0, by_gmp = 0;
    const std::vector<lab::BenchRun> best =
        lab::best_of_rounds({[&] { return nearest(ours, times, by_words); },
                             [&] { return nearest(theirs, times, by_gmp); }},
                            {.count = options.rounds(5)});
    if (by_words != by_gmp) throw std::logic_error("fractions of words and GMP's differ");
    const auto each = [](const lab::BenchRun& run) {
      return run.seconds / static_cast<double>(run.events) * 1e9;
    };
    table.row({static_cast<double>(denominator), each(best[0]), each(best[1]),
               best[1].seconds / best[0].seconds});
  }
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, fractions); }
