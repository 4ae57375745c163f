// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/root_finder.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/close_pair.h"
#include "core/numbers/dyadic.h"

namespace kinex {

namespace {

// Successive bisections with exactly two sign variations before the derivative is tried.
constexpr int kLevelsBeforePair = 4;

// lcm of the binomials C(d, 0..d) = lcm(1..d+1) / (d+1), for all d where it fits a word easily.
constexpr int kTableDegree = 32;
constexpr std::array<std::uint64_t, kTableDegree + 1> binomial_lcm_table() {
  std::array<std::uint64_t, kTableDegree + 1> table{};
  std::uint64_t l = 1;
  for (std::uint64_t d = 0; d <= kTableDegree; ++d) {
    l = std::lcm(l, d + 1);
    table[d] = l / (d + 1);
  }
  return table;
}
constexpr std::array<std::uint64_t, kTableDegree + 1> kBinomialLcm = binomial_lcm_table();

// c[i] *= lcm of the binomials / C(d, i).
void divide_by_binomials(std::vector<Integer>& c) {
  const auto d = static_cast<unsigned long>(c.size() - 1);
  if (d <= kTableDegree) {
    std::uint64_t binomial = 1;
    for (unsigned long i = 0; i <= d; ++i) {
      mpz_mul_ui(c[i].raw(), c[i].raw(), kBinomialLcm[d] / binomial);
      binomial = binomial * (d - i) / (i + 1);
    }
    return;
  }
  Integer multiple(1);
  for (unsigned long i = 2; i <= d + 1; ++i) mpz_lcm_ui(multiple.raw(), multiple.raw(), i);
  mpz_divexact_ui(multiple.raw(), multiple.raw(), d + 1);
  Integer binomial(1);
  Integer factor;
  for (unsigned long i = 0; i <= d; ++i) {
    mpz_divexact(factor.raw(), multiple.raw(), binomial.raw());
    c[i] *= factor;
    mpz_mul_ui(binomial.raw(), binomial.raw(), d - i);
    mpz_divexact_ui(binomial.raw(), binomial.raw(), i + 1);
  }
}

void remove_common_power(std::vector<Integer>& c) {
  std::size_t common = 0;
  bool first = true;
  for (const Integer& x : c) {
    if (x.is_zero()) continue;
    common = first ? x.trailing_zeros() : std::min(common, x.trailing_zeros());
    first = false;
    if (common == 0) return;
  }
  for (Integer& x : c) mpz_tdiv_q_2exp(x.raw(), x.raw(), common);
}

// Coefficients of 2^(ed) p((origin + y) / 2^e) in y.
std::vector<Integer> shifted(const Polynomial& p, const Integer& origin, long exponent) {
  std::vector<Integer> c = p.coefficients();
  const std::size_t d = c.size() - 1;
  for (std::size_t i = 0; i < d && exponent > 0; ++i) {
    c[i] <<= static_cast<unsigned long>(exponent) * (d - i);
  }
  if (origin.is_zero()) return c;
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = d; j-- > i;) c[j].add_product(origin, c[j + 1]);
  }
  return c;
}

long ceil_divide(long a, long b) { return a >= 0 ? (a + b - 1) / b : -((-a) / b); }

// k such that all positive roots are below 2^k; nullopt if there is no positive root. With b = max
// of |c_i / c_d|^(1/(d-i)) over the i of sign opposite to c_d, all are below 2b (Kioustelidis
// 1986).
std::optional<long> positive_root_bound(const std::vector<Integer>& c) {
  const std::size_t d = c.size() - 1;
  const int lead_sign = c[d].sign();
  const long lead_bits = static_cast<long>(c[d].bit_length());
  std::optional<long> bound;
  for (std::size_t i = 0; i < d; ++i) {
    if (c[i].sign() * lead_sign >= 0) continue;
    const long ratio_bits = static_cast<long>(c[i].bit_length()) - lead_bits + 1;
    const long k = 1 + ceil_divide(ratio_bits, static_cast<long>(d - i));
    bound = bound ? std::max(*bound, k) : k;
  }
  return bound;
}

// Sign variations, stopping at `enough`.
int count_variations(const std::vector<Integer>& b, int enough) {
  int count = 0;
  int last = 0;
  for (const Integer& x : b) {
    const int s = x.sign();
    if (s == 0) continue;
    if (s == -last && ++count == enough) return count;
    last = s;
  }
  return count;
}

}  // namespace

RootFinder::RootFinder(std::shared_ptr<const Polynomial> p, Integer origin, long exponent,
                       std::optional<Integer> limit, RootCounters& counters)
    : p_(std::move(p)),
      origin_(std::move(origin)),
      exponent_(exponent),
      limit_(std::move(limit)),
      counters_(counters) {
  require(p_->degree() > 0 && exponent_ >= 0, "RootFinder: constant polynomial or bad exponent");
  if (limit_) *limit_ -= origin_;
  start(*p_);
}

void RootFinder::start(const Polynomial& p) {
  if (limit_ && limit_->sign() < 0) return;
  Node node;
  node.b = shifted(p, origin_, exponent_);
  const std::optional<long> bound = positive_root_bound(node.b);
  if (!bound) return;
  width_ = *bound;
  // Up to the limit inclusively: the end of the cell is above it.
  if (limit_) width_ = std::min(width_, static_cast<long>(limit_->bit_length()));
  const std::size_t d = node.b.size() - 1;
  for (std::size_t i = 0; i <= d; ++i) {
    const std::size_t power = width_ >= 0 ? i : d - i;
    node.b[i] <<= static_cast<unsigned long>(std::labs(width_)) * power;
  }
  divide_by_binomials(node.b);
  // The coefficients are now the blossom at (0, .., 0, infinity, .., infinity), scaled; replacing
  // infinity by the end of the cell is one triangle of additions.
  for (std::size_t r = d; r > 0; --r) {
    look(counters_.deadline);
    for (std::size_t i = d; i > d - r; --i) node.b[i] += node.b[i - 1];
  }
  remove_common_power(node.b);
  node.lower_done = true;
  stack_.push_back(std::move(node));
}

void RootFinder::split(Node&& node) {
  const std::size_t d = node.b.size() - 1;
  Node left;
  left.b.reserve(d + 1);
  std::vector<Integer>& w = node.b;
  left.b.push_back(w[0]);
  for (std::size_t r = 1; r <= d; ++r) {
    for (std::size_t i = 0; i + r <= d; ++i) w[i] += w[i + 1];
    left.b.push_back(w[0]);
  }
  // left.b[r] and w[d - r] are sums with weight 2^r.
  for (std::size_t r = 0; r < d; ++r) left.b[r] <<= d - r;
  for (std::size_t j = 1; j <= d; ++j) w[j] <<= j;
  remove_common_power(left.b);
  remove_common_power(w);
  left.cell = node.cell << 1;
  left.depth = node.depth + 1;
  left.levels_with_two = node.levels_with_two;
  left.lower_done = true;
  node.cell = left.cell + Integer(1);
  node.depth = left.depth;
  node.lower_done = false;
  stack_.push_back(std::move(node));
  stack_.push_back(std::move(left));
}

bool RootFinder::beyond_limit(const Node& node) const {
  if (!limit_) return false;
  return compare_dyadic(node.cell, node.depth - width_, *limit_, 0) > 0;
}

RootFinder::Status RootFinder::next() {
  multiplicity_ = 1;
  if (pending_) {
    found_ = std::move(*pending_);
    pending_.reset();
    return Status::kInterval;
  }
  while (!stack_.empty()) {
    look(counters_.deadline);
    Node& top = stack_.back();
    if (!top.lower_done) {
      top.lower_done = true;
      if (beyond_limit(top)) {
        stack_.clear();
        break;
      }
      int zeros = 0;
      while (top.b[static_cast<std::size_t>(zeros)].is_zero()) ++zeros;
      if (zeros > 0) {
        found_.lower = end_of(top.cell, top.depth);
        found_.exponent = exponent_at(top.depth);
        multiplicity_ = zeros;
        return Status::kPoint;
      }
    }
    const int variations = count_variations(top.b, 3);
    if (variations == 0) {
      stack_.pop_back();
      continue;
    }
    const bool ends_are_roots = top.b.front().is_zero() || top.b.back().is_zero();
    if (variations == 1 && !ends_are_roots) {
      found_ = {end_of(top.cell, top.depth), end_of(top.cell + Integer(1), top.depth),
                exponent_at(top.depth), to_sign(top.b.front().sign())};
      stack_.pop_back();
      return Status::kInterval;
    }
    if (variations > 1 && depth_limit_ >= 0 && top.depth >= depth_limit_) return Status::kStuck;
    Node node = std::move(top);
    stack_.pop_back();
    node.levels_with_two = variations == 2 ? node.levels_with_two + 1 : 0;
    if (depth_limit_ < 0 && node.levels_with_two > kLevelsBeforePair && !ends_are_roots &&
        settle_pair(node)) {
      if (!pending_) continue;
      return Status::kInterval;
    }
    split(std::move(node));
  }
  return Status::kFinished;
}

bool RootFinder::settle_pair(const Node& node) {
  std::vector<Integer> differences;
  for (std::size_t i = 1; i < node.b.size(); ++i) differences.push_back(node.b[i] - node.b[i - 1]);
  if (differences.front().is_zero() || differences.back().is_zero() ||
      count_variations(differences, 2) != 1) {
    return false;
  }
  const std::optional<ClosePair> pair = separate_close_pair(
      *p_, dyadic(end_of(node.cell, node.depth), exponent_at(node.depth)),
      dyadic(end_of(node.cell + Integer(1), node.depth), exponent_at(node.depth)), counters_);
  if (!pair) return true;
  const Sign outside = to_sign(node.b.front().sign());
  const auto interval = [](const Rational& lower, const Rational& upper, Sign sign) {
    const long exponent = std::max(dyadic_exponent(lower), dyadic_exponent(upper));
    const auto up = [exponent](const Rational& x) {
      return x.numerator() << static_cast<unsigned long>(exponent - dyadic_exponent(x));
    };
    return Interval{up(lower), up(upper), exponent, sign};
  };
  found_ = interval(pair->first_lower, pair->first_upper, outside);
  pending_ = interval(pair->second_lower, pair->second_upper, -outside);
  return true;
}

// The lower end of the cell, in units of 2^-exponent_at(depth).
Integer RootFinder::end_of(const Integer& cell, long depth) const {
  const long scale = width_ - depth;
  if (scale >= 0) return origin_ + (cell << static_cast<unsigned long>(scale));
  return (origin_ << static_cast<unsigned long>(-scale)) + cell;
}

long RootFinder::exponent_at(long depth) const { return exponent_ + std::max(0L, depth - width_); }

Rational RootFinder::point() const { return dyadic(found_.lower, found_.exponent); }

RealRoot RootFinder::root() const {
  return RealRoot(p_, found_.lower, found_.upper, found_.exponent, found_.sign_at_lower);
}

RealRoot RootFinder::mirrored_root(const std::shared_ptr<const Polynomial>& mirrored) const {
  Integer lower = -found_.upper;
  const Sign sign = sign_at_dyadic(*mirrored, lower, found_.exponent);
  return RealRoot(mirrored, std::move(lower), -found_.lower, found_.exponent, sign);
}

}  // namespace kinex
