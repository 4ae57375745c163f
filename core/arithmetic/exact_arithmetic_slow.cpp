// SPDX-License-Identifier: GPL-3.0-or-later
// The exact stage of ExactArithmetic: integers, isolating intervals, gcds.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic/exact_arithmetic.h"
#include "core/numbers/exactly.h"
#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/rounded_instant.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The most refinements of an exact root for its enclosure in doubles.
constexpr int kEnclosureBits = 60;

bool is_tight(const RealRoot& root) {
  const double lo = root.lower_double(), hi = root.upper_double();
  return hi - lo <= 0x1p-50 * std::max(std::fabs(lo), std::fabs(hi)) || hi - lo <= 0x1p-1000 ||
         !(hi - lo < kInfinity);
}

}  // namespace

Polynomial ExactArithmetic::exact_polynomial(const Query& query) const {
  const PredicateModel& model = models_[query.predicate];
  if (!model.narrow || !all_narrow(query)) {
    return motions_.exact(*predicates_[query.predicate], query.ids.data());
  }
  Int128 out[kMaxFixedCoefficients];
  wide_coefficients(query, out);
  std::vector<Integer> coefficients;
  coefficients.reserve(static_cast<std::size_t>(model.degree) + 1);
  for (int i = 0; i <= model.degree; ++i) coefficients.emplace_back(out[i]);
  return Polynomial(std::move(coefficients));
}

void ExactArithmetic::update_counters() {
  counters_.refinements = root_counters_.refinements;
  counters_.gcds = root_counters_.gcds;
  counters_.max_bits = std::max(counters_.max_bits, root_counters_.max_bits);
}

void ExactArithmetic::set_now(const Rational& t) {
  roots_.release(now_.root);
  now_ = Now{};
  now_.lo = t.lower_double();
  now_.hi = t.upper_double();
  now_.root = roots_.add(t);
  begin_name(Query(), &t);
  update_origin();
}

void ExactArithmetic::advance(const Query& query, FailureTime& time) {
  const bool another_instant = time.lo > now_.hi || compare_with_now(query, time) != 0;
  roots_.release(now_.root);
  now_.lo = time.lo;
  now_.hi = time.hi;
  now_.query = query;
  now_.sum_of_ids = query.arity == 2 ? query.ids[0] + query.ids[1] : sum_of_ids(query);
  now_.own = (time.root & kBornFailing) == 0;
  now_.isolated = (time.root & kFlags) == 0;
  now_.root = time.root & ~kFlags;
  time.root = 0;
  if (another_instant) begin_name(query, nullptr);
  update_origin();
}

void ExactArithmetic::visit(const Query& query, const FailureTime& time) {
  home_ = now_;
  now_.lo = time.lo;
  now_.hi = time.hi;
  now_.query = query;
  now_.sum_of_ids = sum_of_ids(query);
  now_.own = (time.root & kBornFailing) == 0;
  now_.isolated = (time.root & kFlags) == 0;
  now_.root = roots_.share(time.root & ~kFlags);
  update_origin();
}

void ExactArithmetic::leave() {
  roots_.release(now_.root);
  now_ = home_;
  update_origin();
}

// The root that [lo, hi] isolates: the filter has proved opposite signs at the ends and one root.
std::uint32_t ExactArithmetic::make_root(const Query& query, const FailureTime& time) {
  ++counters_.roots_made_exact;
  if (const auto t = shortest_dyadic(time.lo, time.hi); t && vanishes_at(query, *t)) {
    t->assign_to(short_value_);
    return roots_.add(short_value_);
  }
  Polynomial p = exact_polynomial(query);
  root_counters_.max_bits = std::max<std::uint64_t>(root_counters_.max_bits, p.max_bits());
  if (p.degree() == 1) return roots_.add(Rational(-p[0], p[1]));
  // A comparison has found it to be this number, and its root has been released since.
  if (time.lo == time.hi) return roots_.add(exactly(time.lo));
  return roots_.add(RealRoot(std::move(p), exactly(time.lo), exactly(time.hi)));
}

std::uint32_t ExactArithmetic::root_of(const Query& query, FailureTime& time) {
  if (time.root == 0) time.root = make_root(query, time);
  return time.root & ~kFlags;
}

std::uint32_t ExactArithmetic::now_root() {
  if (now_.root == 0) now_.root = make_root(now_.query, {now_.lo, now_.hi, 0});
  return now_.root;
}

Outlook ExactArithmetic::fails_now(FailureTime& time) {
  time = {now_.lo, now_.hi, roots_.share(now_root()) | kBornFailing};
  return Outlook::kFailsNow;
}

Sign ExactArithmetic::exact_sign_after(const Query& query) {
  const Polynomial p = exact_polynomial(query);
  const Sign sign =
      p.is_zero() ? Sign::kZero : kinex::sign_after(p, roots_[now_root()], root_counters_);
  update_counters();
  return sign;
}

Sign ExactArithmetic::sign_now(const Query& query) {
  StageCounts& counts = count(query).signs;
  if (relation_to_now(query) != 0) {  // now is a root of it
    ++counts[static_cast<int>(Stage::kDouble)];
    return Sign::kZero;
  }
  if (const auto sign = form_over_now(query)) {
    ++counts[static_cast<int>(Stage::kDouble)];
    return *sign;
  }
  Approximation a;
  if (approximate(query, Stage::kDouble, a)) {
    const auto sign = a.degree < 0 ? std::optional<Sign>(Sign::kZero) : sign_over_now(a);
    if (sign) {
      ++counts[static_cast<int>(Stage::kDouble)];
      return *sign;
    }
  }
  ++counts[static_cast<int>(Stage::kExact)];
  const Polynomial p = exact_polynomial(query);
  const Sign sign =
      p.is_zero() ? Sign::kZero : kinex::sign_at(p, roots_[now_root()], root_counters_);
  update_counters();
  return sign;
}

Outlook ExactArithmetic::exact_failure(const Query& query, FailureTime& time) {
  const Polynomial p = exact_polynomial(query);
  if (p.is_zero()) return Outlook::kIdenticallyZero;
  solved_degree_ = p.degree();
  root_counters_.max_bits = std::max<std::uint64_t>(root_counters_.max_bits, p.max_bits());
  RealRoot& now = roots_[now_root()];
  Outlook outlook = Outlook::kNever;
  if (kinex::sign_after(p, now, root_counters_) == Sign::kNegative) {
    outlook = fails_now(time);
  } else if (auto root =
                 first_sign_change_after(
                     models_[query.predicate].touches ? square_free_part(p, deadline_) : p, now,
                     end_, root_counters_)) {
    for (int bits = 0; !is_tight(*root) && bits < kEnclosureBits; ++bits)
      root->refine(root_counters_);
    time.lo = root->lower_double();
    time.hi = root->upper_double();
    time.root = roots_.add(std::move(*root)) | kLoose;
    ++counters_.roots_made_exact;
    outlook = Outlook::kFails;
  }
  update_counters();
  return outlook;
}

// c0 + c1 t in machine integers of at most 63 bits, so that cross products fit.
bool ExactArithmetic::linear_narrow(const Query& query, Int128& c0, Int128& c1) const {
  const PredicateModel& model = models_[query.predicate];
  if (!model.narrow || model.degree != 1 || model.homogeneity != 1) return false;
  if (!all_narrow(query)) return false;
  Int128 out[kMaxFixedCoefficients];
  wide_coefficients(query, out);
  c0 = out[0];
  c1 = out[1];
  return true;  // a predicate of degree 1 is computed in 64 bits: |c| < 2^62
}

void ExactArithmetic::shrink(FailureTime& time) {
  if (time.root == 0) return;
  const RealRoot& root = roots_[time.root & ~kFlags];
  time.lo = std::max(time.lo, root.lower_double());
  time.hi = std::min(time.hi, root.upper_double());
}

// Equal instants get one number and one enclosure.
void ExactArithmetic::merge(FailureTime& a, FailureTime& b) {
  const std::uint32_t ra = a.root & ~kFlags;
  const std::uint32_t rb = b.root & ~kFlags;
  if (ra != rb) {
    // Keep the rational form where there is one: it is compared fastest.
    const bool keep_b = roots_[rb].is_rational() && !roots_[ra].is_rational();
    const std::uint32_t kept = keep_b ? rb : ra;
    FailureTime& changed = keep_b ? a : b;
    const std::uint32_t flags = changed.root & kFlags;
    roots_.release(changed.root & ~kFlags);
    changed.root = roots_.share(kept) | flags;
  }
  shrink(a);
  shrink(b);
}

int ExactArithmetic::compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) {
  if (ta.hi < tb.lo) return -1;
  if (tb.hi < ta.lo) return 1;
  if (ta.lo == kInfinity || tb.lo == kInfinity) {
    return ta.lo == tb.lo ? 0 : ta.lo == kInfinity ? 1 : -1;
  }
  Int128 a0, a1, b0, b1;
  if (ta.root == 0 && tb.root == 0 && linear_narrow(a, a0, a1) && linear_narrow(b, b0, b1)) {
    count_comparison(a, Stage::kDouble);
    // Both slopes are negative: -a0/a1 < -b0/b1  <=>  a0 b1 - b0 a1 > 0 after multiplying by a1 b1
    // > 0 and by -1.
    const Int128 cross = a0 * b1 - b0 * a1;
    return cross > 0 ? -1 : cross < 0 ? 1 : 0;
  }
  if (ta.root != 0 && (ta.root & ~kFlags) == (tb.root & ~kFlags)) return 0;
  if (share_short_root(a, ta, b, tb)) {
    count_comparison(a, Stage::kDouble);
    return 0;
  }
  const std::uint32_t ra = root_of(a, ta);
  const std::uint32_t rb = root_of(b, tb);
  count_comparison(a, Stage::kExact);
  const int order = kinex::compare(roots_[ra], roots_[rb], root_counters_);
  if (order == 0) {
    merge(ta, tb);
  } else {
    shrink(ta);
    shrink(tb);
  }
  update_counters();
  return order;
}

// For enclosures that overlap. Each of them has one root of the same polynomial, where that becomes
// negative. Between two such roots there is one where it becomes positive: so they are the same root.
bool ExactArithmetic::is_now(const Query& query, const FailureTime& time) const {
  return time.root == 0 && now_.isolated && relation_to_now(query) > 0;
}

int ExactArithmetic::compare_with_now(const Query& a, FailureTime& ta) {
  if (ta.lo > now_.hi) return 1;
  if (ta.hi < now_.lo) return -1;
  if (is_now(a, ta)) {
    count_comparison(a, Stage::kDouble);
    ta.lo = now_.lo = std::max(ta.lo, now_.lo);
    ta.hi = now_.hi = std::min(ta.hi, now_.hi);
    return 0;
  }
  Int128 a0, a1, b0, b1;
  if (ta.root == 0 && now_.own && linear_narrow(a, a0, a1) && linear_narrow(now_.query, b0, b1)) {
    count_comparison(a, Stage::kDouble);
    // As in compare().
    const Int128 cross = a0 * b1 - b0 * a1;
    return cross > 0 ? -1 : cross < 0 ? 1 : 0;
  }
  if (ta.root != 0 && (ta.root & ~kFlags) == now_.root) return 0;
  FailureTime now{now_.lo, now_.hi, now_.root};
  int order = 0;
  if (share_short_root(a, ta, now_.query, now)) {
    count_comparison(a, Stage::kDouble);
  } else {
    now.root = now_root();
    count_comparison(a, Stage::kExact);
    order = kinex::compare(roots_[root_of(a, ta)], roots_[now.root], root_counters_);
    if (order == 0) {
      merge(ta, now);
    } else {
      shrink(ta);
      shrink(now);
    }
  }
  now_.lo = now.lo;
  now_.hi = now.hi;
  now_.root = now.root;
  update_counters();
  return order;
}

int ExactArithmetic::compare(const Query& a, FailureTime& ta, const Rational& t) {
  if (ta.lo == kInfinity) return 1;
  if (ta.lo > t.upper_double()) return 1;
  if (ta.hi < t.lower_double()) return -1;
  count_comparison(a, Stage::kExact);
  const int order = kinex::compare(roots_[root_of(a, ta)], t, root_counters_);
  shrink(ta);
  update_counters();
  return order;
}

void ExactArithmetic::release(FailureTime& time) {
  roots_.release(time.root & ~kFlags);
  time.root = 0;
}

std::optional<Rational> ExactArithmetic::rational_between(const Query* query, FailureTime* time) {
  if (query == nullptr || time == nullptr || time->lo == kInfinity) {
    const auto now = Rational::from_double(now_.hi);  // nullopt if now overflows doubles
    return (now ? *now : roots_[now_root()].upper()) + Rational(1);
  }
  if (!(now_.hi < time->lo)) {
    if (compare_with_now(*query, *time) <= 0) return std::nullopt;
    RealRoot& now = roots_[now_root()];
    RealRoot& next = roots_[root_of(*query, *time)];
    while (now.upper() >= next.lower()) {
      now.refine(root_counters_);
      next.refine(root_counters_);
    }
    return (now.upper() + next.lower()) / Rational(2);
  }
  return (exactly(now_.hi) + exactly(time->lo)) / Rational(2);
}

double ExactArithmetic::now_rounded() {
  const double low = rounded_down(now_.lo);
  if (low == rounded_down(now_.hi)) return low;
  RealRoot& now = roots_[now_root()];
  const double result = rounded_down(
      now, [&](const Rational& t) { return kinex::compare(now, t, root_counters_); },
      [&] { now.refine(root_counters_); });
  update_counters();
  return result;
}

std::size_t ExactArithmetic::bytes() const {
  return motions_.bytes() + roots_.bytes() + until_.capacity() * sizeof(double);
}

std::string ExactArithmetic::number_model() const {
  const NumberModel& numbers = motions_.model();
  if (!numbers.narrow) return "integers of any size, and doubles with error bounds";
  double largest = 0;
  for (const double m : numbers.magnitude) largest = std::max(largest, m);
  const int bits = largest < 1 ? 1 : std::ilogb(largest) + 1;
  return "integers of at most " + std::to_string(bits) + " bits over the denominator " +
         numbers.scale.to_string() + ", in doubles";
}

std::string ExactArithmetic::polynomial_model(PredicateId id) const {
  const PredicateModel& model = models_[id];
  if (model.linear) return "exact in doubles";
  std::string text = "doubles with proved error bounds";
  if (model.narrow) text += ", then 128-bit integers";
  return text + ", then integers of any size";
}

}  // namespace kinex
