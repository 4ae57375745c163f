// SPDX-License-Identifier: GPL-3.0-or-later
// ExactArithmetic (`exact`): every answer is exact, and nearly all come from a floating-point
// filter.
//
// Stages, cheapest first. A stage may abstain but is never wrong; the ledger counts their answers.
//   kDouble  The certificate polynomial in doubles; its sign or first root is certified in doubles.
//              Scenes of small integers over a common denominator: plain doubles in t - origin, for
//              an origin of few bits just before now. Shifted motions and their differences are
//              exact; further rounding errors are bounded by the predicate's relative error
//              (Predicate::reach_error) times the reach of the points.
//              Other scenes: doubles with running error bounds.
//              Signs of linear forms (linear_form.h) are first tried without the polynomial, and
//              those of differences of coordinates (coordinate_difference.h) without a formula; many
//              of these from a table of floats (coordinate_table.h), and those of both ends of an
//              interval in floats first (exact_arithmetic_interval.cpp).
//              Failure times of differences of coordinates are found in one function
//              (exact_arithmetic_difference.cpp), and so are signs and failure times of orders of
//              two lengths (exact_arithmetic_length.cpp).
//              Groups of queries (begin_group): the polynomials and the first step of the filter
//              are computed for all of them side by side (exact_arithmetic_group.cpp), and those of
//              differences of coordinates up to their failure times
//              (exact_arithmetic_difference_group.cpp); every result is bit for bit that of a single
//              query.
//   kWide    As kDouble, but the coefficients, in t, are computed exactly in 128-bit integers.
//   kExact   Integers of any size, isolating intervals, gcds. At instants that are short dyadic numbers
//            128-bit integers, before kWide (exact_arithmetic_short.cpp).
#ifndef KINEX_CORE_ARITHMETIC_EXACT_ARITHMETIC_H
#define KINEX_CORE_ARITHMETIC_EXACT_ARITHMETIC_H

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "core/arithmetic/length_order.h"
#include "core/arithmetic/linear_form.h"
#include "core/arithmetic/motion_store.h"
#include "core/arithmetic/root_namer.h"
#include "core/arithmetic/root_table.h"
#include "core/arithmetic/touch.h"
#include "core/numbers/difference_lanes.h"
#include "core/numbers/first_root_lanes.h"
#include "core/numbers/lanes.h"
#include "core/numbers/short_dyadic.h"

namespace kinex {

class ExactArithmetic final : public Arithmetic, public SignNow {
 public:
  ExactArithmetic(const Scene& scene, const NumberNeeds& needs);

  std::string name() const override { return "exact"; }
  bool is_exact() const override { return true; }
  void set_deadline(Deadline* deadline) override {
    Arithmetic::set_deadline(deadline);
    root_counters_.deadline = deadline;
  }
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override;
  void prefetch(std::span<const ObjectId> objects) const override {
    for (const ObjectId object : objects) motions_.prefetch(object);
  }
  void set_now(const Rational& t) override;
  void advance(const Query& query, FailureTime& time) override;
  void visit(const Query& query, const FailureTime& time) override;
  void leave() override;
  double now_approximate() const override { return now_.lo + 0.5 * (now_.hi - now_.lo); }
  double now_rounded() override;
  const InstantName& name_now(InstantDetail detail) override;
  Sign sign_after(const Query& query) override;
  void fill(PredicateId predicate, std::span<const ObjectId> objects,
            CoordinateTable& table) const override;
  void signs_after(PredicateId predicate, const CoordinateTable& table, std::size_t place,
                   std::span<const ObjectId> first, ObjectId second, Sign* signs) override;
  OutOfInterval out_of_interval(PredicateId predicate, const CoordinateTable& table,
                                std::size_t place, std::span<const ObjectId> first, ObjectId low,
                                ObjectId high) override;
  Sign sign_now(const Query& query) override;
  Outlook failure(const Query& query, FailureTime& time) override;
  Outlook look_ahead(const Query& query, double limit, FailureTime& time) override;
  Outlook look_further(const Query& query, double from, double limit, FailureTime& time) override;
  Grouped begin_group(std::span<const Query> group, double limit, GroupAnswers& answers) override;
  Outlook look_ahead_in_group(std::size_t i, const Query& query, double limit,
                              FailureTime& time) override;
  int compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) override;
  int compare_with_now(const Query& a, FailureTime& ta) override;
  int compare(const Query& a, FailureTime& ta, const Rational& t) override;
  void release(FailureTime& time) override;
  std::optional<Rational> rational_between(const Query* query, FailureTime* time) override;
  std::size_t bytes() const override;
  std::string number_model() const override;
  std::string polynomial_model(PredicateId id) const override;

  // The vector instructions by which groups are evaluated. Default: the best of the machine. For
  // tests; the machine must have them.
  void set_vectors(Vectors vectors) { vectors_ = vectors; }

  // Flags in FailureTime::root. Set if [lo, hi] isolates no root of the certificate's own
  // polynomial: it was negative when created, and fails at that instant.
  static constexpr std::uint32_t kBornFailing = 0x80000000u;
  // Set if [lo, hi] contains the root but is not proved to isolate it.
  static constexpr std::uint32_t kLoose = 0x40000000u;
  static constexpr std::uint32_t kFlags = kBornFailing | kLoose;

 protected:
  void bound_predicate(PredicateId id) override;

 private:
  static constexpr int kRoomForCoefficients = 128;
  // The polynomial of one query in the filter's form; see core/numbers/first_root.h for c and m.
  struct Approximation {
    double c[kRoomForCoefficients];
    double m[kRoomForCoefficients];
    double origin;  // the polynomial is in t - origin
    int degree;     // trailing coefficients that are exactly zero are stripped; -1: all are zero
  };
  struct Now {
    double lo = 0, hi = 0;
    Query query;
    ObjectId sum_of_ids = 0;  // of the query
    bool own = false;        // now is a root of the query's polynomial, at which it became negative
    bool isolated = false;   // ... and its only root in [lo, hi]
    std::uint32_t root = 0;  // exact form, if made
  };
  // The function of exact_arithmetic_length.cpp that answers a LengthOrder: by the degree of the motions,
  // and whether the two lengths have an end in common.
  enum class LengthsPath : std::uint8_t {
    kNone,
    kShared1,
    kApart1,
    kShared2,
    kApart2,
    kShared3,
    kApart3
  };
  struct PredicateModel {
    bool fixed = false;   // arrays of fixed size hold the polynomial of any narrow motions
    bool narrow = false;  // ... and 128-bit integers its coefficients
    int degree = 0;
    int homogeneity = 0;
    std::size_t reads = 0;  // the number of coefficients that are read of one argument
    bool linear = false;     // a difference of linear motions: doubles hold the polynomial
    double reach_error = 0;  // Predicate::reach_error divided by gamma (core/numbers/first_root.h)
    bool in_balls = false;   // no reach bounds the errors: doubles with error bounds take their place
    bool touches = false;    // FailsAtTouch
    bool in_lanes = false;   // groups of its queries are evaluated side by side
    const LinearForm* form = nullptr;  // the predicate as a LinearForm, if it is one
    int difference_axis = -1;          // of a CoordinateDifference; -1: it is none
    // A CoordinateDifference that exact_arithmetic_difference.cpp answers: of small integers, of others.
    bool differs = false, differs_in_balls = false;
    bool differs_in_lanes = false;  // groups of its queries are answered in lanes
    LengthEnds lengths;             // of a LengthOrder
    LengthsPath lengths_path = LengthsPath::kNone;
  };

  // The queries of begin_group, one per lane. A query is known if the filter's first step answers
  // it or FirstRoot can continue from it; all others are answered as if there were no group.
  struct Group {
    std::uint32_t known = 0;  // bit i: query i
    int degree = 0;
    double now_lo = 0, now_hi = 0, origin = 0;
    std::array<double, kLanes> horizon, node_end;
    Lanes c[filter::kMaxLaneDegree + 1], m[filter::kMaxLaneDegree + 1];
    filter::LaneNodes nodes;
  };
  // A group of differences of coordinates (exact_arithmetic_difference_group.cpp).
  struct DifferenceGroup {
    filter::DifferenceSpan span;
    filter::DifferenceLanes lanes;
  };

  // True if the polynomial is made from machine integers, in arrays of fixed size.
  bool all_narrow(const Query& query) const {
    if (!models_[query.predicate].fixed) return false;
    if (motions_.all_narrow()) return true;
    for (std::size_t i = 0; i < query.arity; ++i) {
      if (!motions_.is_narrow(query.ids[i])) return false;
    }
    return true;
  }
  // The polynomial in the form of one stage (kDouble or kWide); false if the stage cannot hold it.
  bool approximate(const Query& query, Stage stage, Approximation& p) const;
  void approximate_shifted(const Query& query, Approximation& p) const;
  bool approximate_difference(const Query& query, Approximation& p) const;
  // An object beside a table, at now: what all comparisons with it have in common.
  struct TableProbe {
    const float* table = nullptr;   // its numbers, which move with it
    ObjectId object = kNoObject;
    PredicateId predicate = 0;
    double lo = 0, hi = 0;         // now
    std::uint64_t generation = 0;  // of motions and tables
    double value = 0, error = 0;   // of its coordinate, relative to the table's
    double per_slope = 0;          // error of a coordinate of the table, per unit of its slope
    bool usable = false;
  };
  Ball coefficient(ObjectId object, int axis, int power) const;
  const TableProbe& probe(PredicateId predicate, const CoordinateTable& table, ObjectId object);
  // From the shared anchor of the query's motions to the origin; nullopt if not an exact double.
  std::optional<double> shift_from_anchor(const Query& query) const {
    if (!motions_.model().anchored) return std::nullopt;
    const std::optional<double> anchor = motions_.shared_anchor(query.ids.data(), query.arity);
    if (!anchor) return std::nullopt;
    const double shift = origin_ - *anchor;
    const double back = shift - origin_;
    const double lost = (origin_ - (shift - back)) - (*anchor + back);
    return lost == 0 ? std::optional(shift) : std::nullopt;
  }
  void update_origin();
  bool shift_is_exact(double origin, double step) const;
  void wide_coefficients(const Query& query, Int128* out) const;
  // Tries one stage after the other; returns the one that answered.
  Stage find_failure(const Query& query, double limit, FailureTime& time, Outlook& outlook);
  std::optional<Outlook> failure_in(Stage stage, const Query& query, double limit,
                                    FailureTime& time);
  std::optional<Outlook> first_failure(const Query& query, const double* c, const double* m,
                                       int degree, double origin, double from, double limit,
                                       FailureTime& time) const;
  Polynomial exact_polynomial(const Query& query) const;
  std::uint32_t now_root();
  void begin_name(const Query& query, const Rational* value);
  void keep_now(ObjectId object);
  void set_name_polynomial();
  void set_exact_name(InstantName& name);
  RealRoot copy_of_now();
  std::uint32_t make_root(const Query& query, const FailureTime& time);
  std::uint32_t root_of(const Query& query, FailureTime& time);
  // +1 / -1: query is now_.query up to a permutation of that sign; 0: neither.
  int relation_to_now(const Query& query) const {
    // Nearly all others differ in the sum of their arguments.
    return !now_.own || sum_of_ids(query) != now_.sum_of_ids ? 0 : relation_by_ids(query);
  }
  int relation_by_ids(const Query& query) const;
  bool is_now(const Query& query, const FailureTime& time) const;
  // exact_arithmetic_short.cpp
  std::optional<std::array<Sign, 2>> signs_at(const Query& query, const ShortDyadic& t) const;
  bool vanishes_at(const Query& query, const ShortDyadic& t) const;
  std::optional<ShortDyadic> short_now();
  std::optional<Sign> short_sign_after(const Query& query);
  std::optional<Outlook> short_failure(const Query& query, FailureTime& time);
  bool share_short_root(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb);
  double horizon(const Query& query) const {
    return until_.empty() ? end_upper_ : first_end(query);
  }
  double first_end(const Query& query) const;
  std::optional<Sign> sign_over_now(const Approximation& p) const;
  std::optional<Sign> form_over_now(const Query& query) {
    const LinearForm* const form = models_[query.predicate].form;
    if (form == nullptr || motions_.model().narrow) return std::nullopt;
    return linear_signs_.over(*form, motions_, query, now_.lo, now_.hi);
  }
  // What sign_after and look_ahead do where no path of lengths answers.
  [[gnu::noinline]] Sign filtered_sign_after(const Query& query);
  [[gnu::noinline]] Outlook filtered_look_ahead(const Query& query, double limit,
                                                FailureTime& time);
  Sign exact_sign_after(const Query& query);
  Outlook exact_failure(const Query& query, FailureTime& time);
  std::optional<Outlook> linear_failure(const Query& query, const Approximation& p, int relation,
                                        FailureTime& time);
  std::optional<Outlook> linear_failure(const Query& query, FailureTime& time);
  // nullopt: the general path has to answer.
  std::optional<Outlook> difference_failure(const Query& query, double limit, FailureTime& time);
  std::optional<Outlook> linear_difference_failure(const Query& query, FailureTime& time);
  template <int D>  // of motions of degree D
  bool shifted_difference(const Query& query, double* c, double* m) const;
  template <int D>
  bool shifted_difference_of_balls(const Query& query, double* c, double* m) const;
  template <int D, bool kBalls>
  std::optional<Outlook> difference_failure_of(const Query& query, double limit, FailureTime& time);
  // The same of orders of two lengths. Require all_narrow(query).
  std::optional<Sign> length_sign(const Query& query) const;
  std::optional<Outlook> length_failure(const Query& query, double limit, FailureTime& time);
  template <int D, bool kShared>
  bool shifted_lengths(const Query& query, double* c, double* m) const;
  template <int D, bool kShared>
  std::optional<Sign> length_sign_of(const Query& query) const;
  template <int D, bool kShared>
  std::optional<Outlook> length_failure_of(const Query& query, double limit, FailureTime& time);
  Outlook fails_now(FailureTime& time);
  bool linear_narrow(const Query& query, Int128& c0, Int128& c1) const;
  void shrink(FailureTime& time);
  void merge(FailureTime& a, FailureTime& b);
  bool fits_lanes(std::span<const Query> group) const;
  enum class DifferenceKind : std::uint8_t { kNarrow, kBalls, kOther };
  DifferenceKind kind_of_differences(std::span<const Query> group) const;
  bool relate_differences(std::span<const Query> group);
  bool set_nodes(std::span<const Query> group, double limit);
  template <class Row>
  void find_differences(std::span<const Query> group, const Row& row_of);
  Grouped answer_differences(std::span<const Query> group, double limit, GroupAnswers& answers);
  bool set_horizons(std::span<const Query> group, double limit, Lanes& lengths);
  RootCounters& tally() { return root_counters_; }
  void update_counters();
  PredicateCounters& count(const Query& q) { return counters_.by_predicate[q.predicate]; }
  void count_solved(int degree, std::uint64_t queries = 1) {
    if (static_cast<std::size_t>(degree) >= counters_.polynomials_solved.size()) {
      counters_.polynomials_solved.resize(static_cast<std::size_t>(degree) + 1);
    }
    counters_.polynomials_solved[static_cast<std::size_t>(degree)] += queries;
  }

  Vectors vectors_ = best_vectors();
  Group group_;
  DifferenceGroup differences_;
  int solved_degree_ = -1;  // of the last polynomial; -1: zero
  MotionStore motions_;
  LinearSigns linear_signs_;
  std::vector<PredicateModel> models_;
  bool touches_ = false;       // some predicate is FailsAtTouch
  std::vector<double> until_;  // per object; empty if no motion of the scene ends
  std::optional<Rational> end_;
  double end_upper_;
  Now now_;
  Now home_;  // where leave() goes back to
  // The origin in use for all now_.lo in [origin_, origin_end_).
  double origin_ = 0;
  double origin_end_ = 0;
  // The source of the present instant's name: the query whose root it is; arity 0: a rational.
  struct Naming {
    Query query;
    Rational value;
    double lo = 0, hi = 0;   // as it became now
    bool isolated = false;   // it is the only root of the query's polynomial there
    bool kept = false;       // the polynomial is that of motions no longer in force
    std::vector<Integer> polynomial;
  };
  Naming naming_;
  RootNamer namer_;
  Rational short_value_;  // scratch
  RootTable roots_;
  RootCounters root_counters_;
  // The latest probes, in places by table and object: a search compares few objects with few tables.
  std::array<TableProbe, 32> probes_;
  mutable std::uint64_t table_generation_ = 1;  // grows with every motion that is set and table that is filled
};

}  // namespace kinex

#endif
