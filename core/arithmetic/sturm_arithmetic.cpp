// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/sturm_arithmetic.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/arithmetic/sturm_instant.h"
#include "core/arithmetic/sturm_name.h"
#include "core/arithmetic/touch.h"
#include "core/numbers/check.h"
#include "core/numbers/exactly.h"
#include "core/numbers/rounded_instant.h"

namespace kinex {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Bisections of an instant that becomes now, for a useful now_approximate.
constexpr int kRefinementsOfNow = 20;

// The instants in use: handles from 1, reference counted; freed places are reused.
class InstantPool {
 public:
  std::uint32_t add(SturmInstant instant) {
    if (free_.empty()) {
      slots_.emplace_back();
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
    }
    const std::uint32_t handle = free_.back();
    free_.pop_back();
    slots_[handle - 1] = {std::make_unique<SturmInstant>(std::move(instant)), 1};
    return handle;
  }
  std::uint32_t share(std::uint32_t handle) {
    ++slots_[handle - 1].references;
    return handle;
  }
  void release(std::uint32_t handle) {
    if (handle == 0) return;
    Slot& slot = slots_[handle - 1];
    require(slot.references > 0, "an instant was released twice");
    if (--slot.references > 0) return;
    slot.instant.reset();
    free_.push_back(handle);
  }
  SturmInstant& operator[](std::uint32_t handle) { return *slots_[handle - 1].instant; }
  const SturmInstant& operator[](std::uint32_t handle) const { return *slots_[handle - 1].instant; }
  // Estimated: GMP's limbs are not counted.
  std::size_t bytes() const {
    const std::size_t live = slots_.size() - free_.size();
    return slots_.capacity() * sizeof(Slot) + free_.capacity() * sizeof(std::uint32_t) +
           live * (sizeof(SturmInstant) + 8 * sizeof(Rational) * 2);
  }

 private:
  struct Slot {
    std::unique_ptr<SturmInstant> instant;
    std::uint32_t references = 0;
  };
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
};

class SturmArithmetic final : public Arithmetic, public SignNow {
 public:
  SturmArithmetic(const Scene& scene, const NumberNeeds& needs)
      : Arithmetic(needs),
        degree_(std::max(1, needs.degree)),
        axes_(static_cast<std::size_t>(std::max(1, needs.axes))),
        coefficients_(scene.objects.size() * stride()),
        until_(scene.objects.size()),
        end_(scene.end),
        now_(instants_.add(SturmInstant(scene.start))),
        name_(instants_[now_].polynomial()) {}

  std::string name() const override { return "sturm"; }
  bool is_exact() const override { return true; }

  void set_deadline(Deadline* deadline) override {
    Arithmetic::set_deadline(deadline);
    work_.deadline = deadline;
  }
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override;
  void set_now(const Rational& t) override;
  void advance(const Query& query, FailureTime& time) override;
  void visit(const Query&, const FailureTime& time) override {
    home_ = now_;
    now_ = instants_.share(handle(time));
  }
  void leave() override {
    instants_.release(now_);
    now_ = home_;
  }
  double now_approximate() const override {
    return ((now().lower() + now().upper()) / Rational(2)).to_double();
  }
  double now_rounded() override {
    return rounded_down(
        now(), [&](const Rational& t) { return now().compare(t); }, [&] { now().refine(work_); });
  }
  const InstantName& name_now(InstantDetail detail) override;
  Sign sign_after(const Query& query) override;
  Sign sign_now(const Query& query) override;
  Outlook failure(const Query& query, FailureTime& time) override {
    return look_ahead(query, kInfinity, time);
  }
  Outlook look_ahead(const Query& query, double limit, FailureTime& time) override;
  Outlook look_further(const Query& query, double from, double limit, FailureTime& time) override;
  int compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) override;
  int compare_with_now(const Query& a, FailureTime& ta) override;
  int compare(const Query& a, FailureTime& ta, const Rational& t) override;
  void release(FailureTime& time) override {
    instants_.release(handle(time));
    time.root = 0;
  }
  std::optional<Rational> rational_between(const Query* query, FailureTime* time) override;
  std::size_t bytes() const override {
    // A rational of a word needs two limbs beside its header.
    return coefficients_.capacity() * (sizeof(Rational) + 16) +
           until_.capacity() * sizeof(std::optional<Rational>) + instants_.bytes();
  }

 private:
  // Set in FailureTime::root of a certificate that was negative when created: its polynomial need
  // not vanish at that instant.
  static constexpr std::uint32_t kBornFailing = 0x80000000u;

  static std::uint32_t handle(const FailureTime& time) { return time.root & ~kBornFailing; }
  std::size_t powers() const { return static_cast<std::size_t>(degree_) + 1; }
  std::size_t stride() const { return axes_ * powers(); }
  SturmInstant& now() { return instants_[now_]; }
  const SturmInstant& now() const { return instants_[now_]; }

  void begin_name(RationalPolynomial polynomial) {
    name_ = std::move(polynomial);
    name_of_now_.detail = InstantDetail::kNone;
  }
  void widen(int degree);
  RationalPolynomial polynomial(const Query& query) const;
  std::optional<Rational> horizon(const Query& query) const;
  // The first failure after `from`, where p is positive, up to the limit.
  Outlook first_failure(const Query& query, const RationalPolynomial& p, const RationalSturm& sturm,
                        const Rational& from, double limit, FailureTime& time);
  // Makes the enclosure that the queue sees as narrow as that of the instant.
  void enclose(FailureTime& time) const;
  void update_counters();

  int degree_;
  std::size_t axes_;
  std::vector<Rational>
      coefficients_;  // of t^k on axis a of object i at [(i * axes + a) * powers + k]
  std::vector<std::optional<Rational>> until_;  // per object
  std::optional<Rational> end_;
  InstantPool instants_;
  std::uint32_t now_;        // never 0
  std::uint32_t home_ = 0;   // where leave() goes back to
  RationalPolynomial name_;  // of the certificate whose failure time now is: vanishes there
  SturmWork work_;
};

void SturmArithmetic::widen(int degree) {
  const std::size_t from = powers();
  degree_ = degree;
  std::vector<Rational> wider(until_.size() * stride());
  for (std::size_t row = 0; row < until_.size() * axes_; ++row) {
    for (std::size_t k = 0; k < from; ++k) {
      wider[row * powers() + k] = std::move(coefficients_[row * from + k]);
    }
  }
  coefficients_ = std::move(wider);
}

void SturmArithmetic::set_motion(ObjectId object, const Trajectory& trajectory,
                                 const std::optional<Rational>& until) {
  const int degree = trajectory.degree_of_axes(0, static_cast<int>(axes_));
  if (degree > degree_) widen(degree);
  if (object >= until_.size()) {
    until_.resize(object + std::size_t{1});
    coefficients_.resize(until_.size() * stride());
  }
  until_[object] = until;
  for (std::size_t a = 0; a < axes_; ++a) {
    for (std::size_t k = 0; k < powers(); ++k) {
      const bool given = a < trajectory.coordinates.size() && k < trajectory.coordinates[a].size();
      coefficients_[object * stride() + a * powers() + k] =
          given ? trajectory.coordinates[a][k] : Rational();
    }
  }
}

RationalPolynomial SturmArithmetic::polynomial(const Query& query) const {
  const Rational one(1);
  std::array<MotionView<Rational>, kMaxViews> points{};
  for (std::size_t i = 0; i < query.arity; ++i) {
    points[i] = &coefficients_[query.ids[i] * stride()];
  }
  points[query.arity] = &one;
  return RationalPolynomial(predicates_[query.predicate]->rational(degree_, points.data()));
}

std::optional<Rational> SturmArithmetic::horizon(const Query& query) const {
  std::optional<Rational> first = end_;
  for (std::size_t i = 0; i < query.arity; ++i) {
    const std::optional<Rational>& until = until_[query.ids[i]];
    if (until && (!first || *until < *first)) first = until;
  }
  return first;
}

void SturmArithmetic::enclose(FailureTime& time) const {
  const SturmInstant& instant = instants_[handle(time)];
  time.lo = std::max(time.lo, instant.lower().lower_double());
  time.hi = std::min(time.hi, instant.upper().upper_double());
}

void SturmArithmetic::update_counters() {
  counters_.refinements = work_.refinements;
  counters_.gcds = work_.gcds;
  counters_.max_bits = work_.max_bits;
}

void SturmArithmetic::set_now(const Rational& t) {
  instants_.release(now_);
  now_ = instants_.add(SturmInstant(t));
  begin_name(now().polynomial());
}

void SturmArithmetic::advance(const Query& query, FailureTime& time) {
  require(time.root != 0, "now cannot advance to never");
  const std::uint32_t next = handle(time);
  const bool another_instant = next != now_ && kinex::compare(instants_[next], now(), work_) != 0;
  instants_.release(now_);
  now_ = next;
  time.root = 0;
  for (int i = 0; i < kRefinementsOfNow && !now().is_rational(); ++i) now().refine(work_);
  if (another_instant) begin_name(polynomial(query));
  update_counters();
}

Sign SturmArithmetic::sign_after(const Query& query) {
  ++counters_.by_predicate[query.predicate].signs[static_cast<int>(Stage::kExact)];
  const RationalPolynomial p = polynomial(query);
  if (p.is_zero()) return Sign::kZero;
  const Sign sign = kinex::sign_after(p, RationalSturm(p, work_), now(), work_);
  update_counters();
  return sign;
}

Sign SturmArithmetic::sign_now(const Query& query) {
  const RationalPolynomial p = polynomial(query);
  if (!p.is_zero() && vanishes_at(p, now(), work_)) {
    ++counters_.by_predicate[query.predicate].signs[static_cast<int>(Stage::kExact)];
    update_counters();
    return Sign::kZero;
  }
  return sign_after(query);
}

Outlook SturmArithmetic::look_ahead(const Query& query, double limit, FailureTime& time) {
  time = {kInfinity, kInfinity, 0};
  ++counters_.by_predicate[query.predicate].failures[static_cast<int>(Stage::kExact)];
  const RationalPolynomial p = polynomial(query);
  if (p.is_zero()) return Outlook::kIdenticallyZero;
  const std::size_t degree = static_cast<std::size_t>(p.degree());
  if (degree >= counters_.polynomials_solved.size()) {
    counters_.polynomials_solved.resize(degree + 1);
  }
  ++counters_.polynomials_solved[degree];
  const RationalSturm sturm(p, work_);
  if (vanishes_at(p, now(), work_)) ++possible_zeros_;
  Outlook outlook = Outlook::kFailsNow;
  if (kinex::sign_after(p, sturm, now(), work_) == Sign::kNegative) {
    time = {-kInfinity, kInfinity, instants_.share(now_) | kBornFailing};
    enclose(time);
  } else {
    outlook = first_failure(query, p, sturm, now().upper(), limit, time);
  }
  update_counters();
  return outlook;
}

Outlook SturmArithmetic::look_further(const Query& query, double from, double limit,
                                      FailureTime& time) {
  time = {kInfinity, kInfinity, 0};
  ++counters_.by_predicate[query.predicate].looks[static_cast<int>(Stage::kExact)];
  const RationalPolynomial p = polynomial(query);
  const RationalSturm sturm(p, work_);
  const Outlook outlook = first_failure(query, p, sturm, exactly(from), limit, time);
  update_counters();
  return outlook;
}

Outlook SturmArithmetic::first_failure(const Query& query, const RationalPolynomial& p,
                                       const RationalSturm& sturm, const Rational& from,
                                       double limit, FailureTime& time) {
  const std::optional<Rational> end = horizon(query);
  if (p.degree() > 1 && limit < kInfinity) {
    const Rational t = exactly(limit);
    if (from < t && (!end || t < *end) && sturm.count(from, t) == 0) {
      time = {limit, limit, 0};
      return Outlook::kLater;
    }
  }
  std::optional<SturmInstant> first;
  if (fails_at_touch(query.predicate)) {
    // Where the square-free part, made positive right after `from`, changes sign next.
    RationalPolynomial simple = sturm.square_free();
    Sign sign = simple.sign_at(from);
    if (sign == Sign::kZero) sign = simple.derivative().sign_at(from);
    if (sign == Sign::kNegative) simple = -simple;
    if (simple.degree() < 1) return Outlook::kNever;
    first = first_failure_after(simple, RationalSturm(simple, work_), from, end, work_);
  } else {
    first = first_failure_after(p, sturm, from, end, work_);
  }
  if (!first) return Outlook::kNever;
  time = {-kInfinity, kInfinity, instants_.add(std::move(*first))};
  ++counters_.roots_made_exact;
  enclose(time);
  return Outlook::kFails;
}

int SturmArithmetic::compare(const Query& query, FailureTime& ta, const Query&, FailureTime& tb) {
  if (ta.root == 0 || tb.root == 0) return (ta.root == 0 ? 1 : 0) - (tb.root == 0 ? 1 : 0);
  count_comparison(query, Stage::kExact);
  const std::uint32_t a = handle(ta);
  const std::uint32_t b = handle(tb);
  const int order = a == b ? 0 : kinex::compare(instants_[a], instants_[b], work_);
  if (order == 0 && a != b) {
    // Equal instants share one form: a rational one, if there is one.
    const bool keep_b = instants_[b].is_rational();
    FailureTime& changed = keep_b ? ta : tb;
    const std::uint32_t kept = instants_.share(keep_b ? b : a);
    instants_.release(keep_b ? a : b);
    changed.root = kept | (changed.root & kBornFailing);
  }
  enclose(ta);
  enclose(tb);
  update_counters();
  return order;
}

int SturmArithmetic::compare_with_now(const Query& query, FailureTime& ta) {
  if (ta.root == 0) return 1;
  count_comparison(query, Stage::kExact);
  const std::uint32_t a = handle(ta);
  const int order = a == now_ ? 0 : kinex::compare(instants_[a], now(), work_);
  if (order == 0 && a != now_) {
    const std::uint32_t shared = instants_.share(now_);
    instants_.release(a);
    ta.root = shared | (ta.root & kBornFailing);
  }
  enclose(ta);
  update_counters();
  return order;
}

int SturmArithmetic::compare(const Query& query, FailureTime& ta, const Rational& t) {
  if (ta.root == 0) return 1;
  count_comparison(query, Stage::kExact);
  const int order = instants_[handle(ta)].compare(t);
  enclose(ta);
  return order;
}

std::optional<Rational> SturmArithmetic::rational_between(const Query* query, FailureTime* time) {
  if (query == nullptr || time == nullptr || time->root == 0) return now().upper() + Rational(1);
  if (compare_with_now(*query, *time) <= 0) return std::nullopt;
  SturmInstant& next = instants_[handle(*time)];
  while (now().upper() >= next.lower()) {
    now().refine(work_);
    next.refine(work_);
  }
  enclose(*time);
  update_counters();
  return dyadic_near_middle(now().upper(), next.lower());
}

const InstantName& SturmArithmetic::name_now(InstantDetail detail) {
  InstantName& name = name_of_now_;
  if (detail == InstantDetail::kNone || detail == name.detail) return name;
  ++name.number;
  name.detail = detail;
  name.exact = true;
  if (detail == InstantDetail::kName) {
    name_by_sturm(name_, now(), name);
  } else {
    enclose_by_sturm(now(), name);
  }
  return name;
}

}  // namespace

std::unique_ptr<Arithmetic> make_sturm_arithmetic(const Scene& scene,
                                                  const NumberNeeds& needs) {
  return std::make_unique<SturmArithmetic>(scene, needs);
}

}  // namespace kinex
