// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic: the interface behind which all numbers of a run are kept.
//
// An arithmetic owns the motions in force, the present instant "now", and the exact form of failure
// times. Statements about now are about the open interval just after it (the right-hand rule).
#ifndef KINEX_CORE_ARITHMETIC_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_ARITHMETIC_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arithmetic/arithmetic_counters.h"
#include "core/arithmetic/coordinate_table.h"
#include "core/arithmetic/number_needs.h"
#include "core/arithmetic/predicate.h"
#include "core/arithmetic/query.h"
#include "core/motion/scene.h"
#include "core/numbers/instant_name.h"
#include "core/numbers/sign.h"
#include "core/numbers/stop.h"

namespace kinex {

// What is known about a certificate's future.
enum class Outlook : std::uint8_t {
  kNever,            // no failure up to the horizon
  kFails,            // fails at a later instant
  kFailsNow,         // negative right after now
  kIdenticallyZero,  // identically zero (under the motions in force): never fails, a tie
  kLater,            // proved not to fail up to a limit; unknown beyond it
};

class Arithmetic {
 public:
  explicit Arithmetic(NumberNeeds needs = {}) : needs_(std::move(needs)) {}
  virtual ~Arithmetic() = default;

  // The needs that it was made for.
  const NumberNeeds& needs() const { return needs_; }

  virtual std::string name() const = 0;
  // True if every answer is exact (`exact`, `sturm`).
  virtual bool is_exact() const = 0;
  // The number of bits of an inexact arithmetic's significands.
  virtual long precision() const { return 53; }

  // Registers a predicate. The arithmetic keeps the pointer as long as it lives. Throws
  // std::logic_error, with the predicate's name and the numbers, if the predicate takes more than
  // kMaxArity objects or reads more axes than the arithmetic was made for: its structure has not
  // declared its needs.
  PredicateId bind(std::shared_ptr<const Predicate> predicate);
  const Predicate& predicate(PredicateId id) const { return *predicates_[id]; }

  // The motion of `object` from now on. Failure times under the old motion must be computed again.
  // `until`: no query goes beyond it (the end of the piece); nullopt: valid for all time.
  virtual void set_motion(ObjectId object, const Trajectory& trajectory,
                          const std::optional<Rational>& until) = 0;

  // Prefetches the motions of objects that queries will name soon. Changes nothing.
  virtual void prefetch(std::span<const ObjectId> objects) const { static_cast<void>(objects); }

  // now := t. Moving back is allowed (samples are not taken this way; see Simulator).
  virtual void set_now(const Rational& t) = 0;
  // now := the failure time of `query`. The arithmetic takes its number (time.root becomes 0).
  virtual void advance(const Query& query, FailureTime& time) = 0;
  // Moves now temporarily to a later instant, the failure time of `query`; leave() moves it back.
  // Meanwhile only signs and failure times may be queried. `time` keeps its number. See Foresight.
  virtual void visit(const Query& query, const FailureTime& time);
  virtual void leave();
  // A double near now, for progress reports and messages.
  virtual double now_approximate() const = 0;
  // now as the number that an inexact arithmetic holds; nullopt where that is not finite. (In an
  // exact one now has a name, not a number: name_now.)
  virtual std::optional<Rational> now_value() const {
    return Rational::from_double(now_approximate());
  }
  // now, rounded down to 40 significant bits: the same in every exact arithmetic, for structures
  // whose choices may depend on it.
  virtual double now_rounded();
  // The present instant in the given detail; valid until now moves or another detail is requested.
  // An instant is named once, by the certificate that fails there first: the name and its number
  // stay the same as long as now is the same instant. Naming changes no answer and no counter.
  virtual const InstantName& name_now(InstantDetail detail) = 0;
  // The exact name of now, in words.
  InstantText describe_now() { return to_text(name_now(InstantDetail::kName)); }

  // Sign on (now, now + eps); kZero only if identically zero there.
  // In an inexact arithmetic the certificate whose failure is being handled is negative and its
  // opposite positive, wherever the root was rounded to.
  virtual Sign sign_after(const Query& query) = 0;
  // Copies of the motions of these objects, for signs_after() of this predicate of two objects, in
  // their order. They are valid until one of the objects gets another motion. An arithmetic that
  // gains nothing by them leaves the table empty.
  virtual void fill(PredicateId predicate, std::span<const ObjectId> objects,
                    CoordinateTable& table) const;
  // The signs of the predicate over (first[i], second), into signs[i]. `first` are objects of the
  // table from the one at `place` on. Answers and counters are those of separate calls.
  virtual void signs_after(PredicateId predicate, const CoordinateTable& table, std::size_t place,
                           std::span<const ObjectId> first, ObjectId second, Sign* signs);
  // Which of `first`, objects of the table as in signs_after(), OutOfInterval::kMost at most, are out
  // of the interval: before if the sign over (first[i], low) is positive, after if the sign over
  // (first[i], high) is negative. Answers and counters are those of separate calls, two an object.
  virtual OutOfInterval out_of_interval(PredicateId predicate, const CoordinateTable& table,
                                        std::size_t place, std::span<const ObjectId> first,
                                        ObjectId low, ObjectId high);
  // The first instant >= now right after which the value is negative. `time` is filled for kFails
  // and kFailsNow and else set to never.
  virtual Outlook failure(const Query& query, FailureTime& time) = 0;
  // As `failure`, but the answer is not needed beyond `limit` (+infinity: no limit). May answer
  // kLater, with time = {limit, limit, 0}, for a proof that the certificate does not fail in (now,
  // limit]. An arithmetic that gains nothing by the limit ignores it.
  virtual Outlook look_ahead(const Query& query, double limit, FailureTime& time) {
    static_cast<void>(limit);
    return failure(query, time);
  }
  // Continues from a kLater at `from`; now <= from unless the arithmetic is inexact.
  virtual Outlook look_further(const Query& query, double from, double limit, FailureTime& time) {
    static_cast<void>(from);
    return look_ahead(query, limit, time);
  }
  // Announces the next queries, at least one and at most kMostInGroup; motions and now do not change until
  // they are answered. Answers and counters are those of separate calls: of failure() if there is no limit,
  // else of look_ahead().
  static constexpr std::size_t kMostInGroup = 4;
  enum class Grouped : std::uint8_t {
    kNot,       // they have to be called
    kPrepared,  // each is passed to look_ahead_in_group() once, in this order and with the same limit
    kAnswered,  // all are answered, in `answers`
  };
  struct GroupAnswers {  // of the queries of a group, in their order
    std::array<Outlook, kMostInGroup> outlooks;
    std::array<FailureTime, kMostInGroup> times;
  };
  virtual Grouped begin_group(std::span<const Query> group, double limit, GroupAnswers& answers) {
    static_cast<void>(group), static_cast<void>(limit), static_cast<void>(answers);
    return Grouped::kNot;
  }
  // `query` is the i-th of the group.
  virtual Outlook look_ahead_in_group(std::size_t i, const Query& query, double limit,
                                      FailureTime& time);
  // Order of two failure times: -1, 0, +1. May refine both (enclosures only ever shrink).
  virtual int compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) = 0;
  // Order of a failure time and now.
  virtual int compare_with_now(const Query& a, FailureTime& ta) = 0;
  // Order of a failure time and a rational instant.
  virtual int compare(const Query& a, FailureTime& ta, const Rational& t) = 0;
  // The number of `time` is no longer needed.
  virtual void release(FailureTime& time) = 0;
  // A rational strictly between now and `time` (or now + 1 if `time` is never), for audits; nullopt
  // if there is none (equal instants) or, in an inexact arithmetic, none that is representable.
  virtual std::optional<Rational> rational_between(const Query* query, FailureTime* time) = 0;

  // Long computations poll it (core/numbers/stop.h); it outlives the arithmetic. Null: none.
  virtual void set_deadline(Deadline* deadline) { deadline_ = deadline; }

  virtual std::size_t bytes() const = 0;

  // For people: the number type of the scene's motions, and that of a predicate's polynomials.
  virtual std::string number_model() const { return name(); }
  virtual std::string polynomial_model(PredicateId id) const;
  std::size_t predicates() const { return predicates_.size(); }
  // Certificates of the predicate fail at touches, too (touch.h).
  bool fails_at_touch(PredicateId id) const { return fails_at_touch_[id]; }
  // True if they differ at most in whether they fail at touches.
  bool have_same_value(PredicateId a, PredicateId b) const { return plain_[a] == plain_[b]; }

  const ArithmeticCounters& counters() const { return counters_; }
  // The number of failure times requested so far of certificates that may be zero at now: it counts
  // all that are zero, and few others. A structure notices a degenerate instant by its growth.
  // Exact arithmetics only; 0 in others.
  std::uint64_t possible_zeros() const { return possible_zeros_; }

 protected:
  // +1 or -1: the polynomial of `a` is that of `b` times this sign (arguments permuted, or opposite
  // predicates, whether they fail at touches or not); 0: neither.
  int related(const Query& a, const Query& b) const;
  // Called by bind, after the predicate has been stored.
  virtual void bound_predicate(PredicateId) {}

  void count_comparison(const Query& query, Stage stage) {
    ++counters_.comparisons[static_cast<std::size_t>(stage)];
    ++counters_.by_predicate[query.predicate].comparisons[static_cast<std::size_t>(stage)];
  }

  // The name of an instant that is known only as a decimal.
  const InstantName& inexact_name(InstantDetail detail, std::string decimal);

  NumberNeeds needs_;
  ArithmeticCounters counters_;
  std::uint64_t possible_zeros_ = 0;
  std::vector<std::shared_ptr<const Predicate>> predicates_;
  InstantName name_of_now_;
  Deadline* deadline_ = nullptr;

 private:
  std::vector<PredicateId> opposite_;  // of every predicate; itself: none
  std::vector<bool> fails_at_touch_;   // by predicate
  std::vector<PredicateId> plain_;     // the same polynomial without FailsAtTouch (touch.h)
};

// "exact", "sturm", "double", "gsl", "mpfr:P" (2 <= P <= 100000). `needs` and the scene's
// coefficients decide on axes, degree and number types; the scene's end is the horizon. Throws
// std::invalid_argument, with the choices, for any other name.
std::unique_ptr<Arithmetic> make_arithmetic(std::string_view name, const Scene& scene,
                                            const NumberNeeds& needs);
// The same for structures that derive no objects and read no weights. For others, see
// structures/plan.h.
std::unique_ptr<Arithmetic> make_arithmetic(std::string_view name, const Scene& scene);

}  // namespace kinex

#endif
