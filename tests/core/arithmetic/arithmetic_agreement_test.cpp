// SPDX-License-Identifier: GPL-3.0-or-later
// `exact` and `sturm` share no root finding. They must give the same outlooks, signs, orders of
// instants and names of instants, on certificates of which many are degenerate.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "core/arithmetic/arithmetic.h"
#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex {
namespace arithmetic_agreement_test {

using test::Coefficients;

std::string to_text(const InstantText& text) {
  std::ostringstream out;
  for (const std::string& c : text.polynomial) out << c << ' ';
  out << '#' << text.root << " [" << text.lower << ", " << text.upper << "] " << text.approximate;
  return out.str();
}

std::string to_text(const Scene& scene, const Query& query) {
  std::ostringstream out;
  out << "predicate " << query.predicate << " of";
  for (std::size_t i = 0; i < query.arity; ++i) {
    out << "\n  " << query.ids[i] << ':';
    for (const auto& axis : scene.objects[query.ids[i]].motion.pieces[0].trajectory.coordinates) {
      for (const Rational& c : axis) out << ' ' << c.to_string();
      out << ';';
    }
  }
  return out.str();
}

// Counts of cases, so that a test can require the interesting ones to have occurred.
struct Tally {
  std::vector<std::string> disagreements;
  std::array<int, 4> outlooks{};
  int equal_pairs = 0, pairs = 0, equal_to_now = 0, advances = 0;  // pairs: of later failures
  std::array<std::uint64_t, kStages> signs{}, failures{}, comparisons{};
  std::uint64_t gcds = 0;
};

struct Failing {
  Query query;
  FailureTime exact, sturm;
  bool now;  // known to be now
};

// The two arithmetics over one scene, with the same queries.
class Rivals {
 public:
  Rivals(const Scene& scene, std::uint64_t seed, Tally& tally)
      : scene_(scene),
        tally_(tally),
        random_(seed),
        exact_(make_arithmetic("exact", scene)),
        sturm_(make_arithmetic("sturm", scene)) {
    for (const auto& predicate :
         {test::make_predicate<test::Order>(), test::make_predicate<test::DistanceOrder>(),
          test::make_predicate<test::Orientation>(), test::make_predicate<test::InCircle>()}) {
      exact_->bind(predicate);
      sturm_->bind(predicate);
    }
    test::set_motions(scene, *exact_);
    test::set_motions(scene, *sturm_);
  }

  Query draw_query(int predicates = 4) {
    static constexpr std::array<std::uint8_t, 4> kArity{2, 3, 3, 4};
    Query q;
    q.predicate = static_cast<PredicateId>(random_() % static_cast<unsigned>(predicates));
    q.arity = kArity[q.predicate];
    std::vector<ObjectId> ids(scene_.objects.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<ObjectId>(i);
    for (std::size_t i = 0; i < q.arity; ++i) {
      std::swap(ids[i], ids[i + random_() % (ids.size() - i)]);
      q.ids[i] = ids[i];
    }
    return q;
  }

  ~Rivals() { release_held(); }

  void set_now(const Rational& t) {
    release_held();
    exact_->set_now(t);
    sturm_->set_now(t);
    check(to_text(exact_->describe_now()) == to_text(sturm_->describe_now()),
          "names of a rational now");
  }

  // Makes all queries about these certificates at the present instant, then advances to the first
  // failure (or, if `stay`, to one that is now). The other failure times are held, as in a queue,
  // and take part in the next step. False if there is none, or the two disagree.
  bool step(std::vector<Query>& queries, bool stay) {
    std::vector<Failing> failing = std::move(held_);
    held_.clear();
    for (const Query& q : queries) ask(q, failing);
    const bool alone_first = random_() % 2 == 0;
    for (std::size_t i = 0; alone_first && i < failing.size(); ++i) ask_instant(failing[i]);
    for (std::size_t i = 0; i < failing.size(); ++i) {
      // Not all, as in a heap: some equal instants meet only when one of them is now.
      for (std::size_t j = 0; j < i; ++j) {
        if (random_() % 2 == 0) ask_order(failing[i], failing[j]);
      }
    }
    for (std::size_t i = 0; !alone_first && i < failing.size(); ++i) ask_instant(failing[i]);
    Failing* next = nullptr;
    for (Failing& a : failing) {
      if (a.now && !stay) continue;
      if (next == nullptr || sturm_->compare(a.query, a.sturm, next->query, next->sturm) < 0) {
        next = &a;
      }
    }
    const bool moves = next != nullptr && tally_.disagreements.empty();
    const bool time_passes = moves && !next->now;
    if (moves) move(*next, queries);
    for (Failing& a : failing) {
      if (&a == next && moves) continue;
      held_.push_back(a);
      if (a.now && time_passes) drop(held_.size() - 1);
    }
    while (held_.size() > 8) drop(static_cast<std::size_t>(random_() % held_.size()));
    return moves;
  }

  // A new flight plan for one object.
  void set_motion(ObjectId object, std::vector<Coefficients> axes,
                  const std::optional<Rational>& until) {
    MotionPiece& piece = scene_.objects[object].motion.pieces[0];
    piece.trajectory.coordinates = std::move(axes);
    piece.trajectory.normalise();
    piece.to = until;
    release_held();
    exact_->set_motion(object, piece.trajectory, until);
    sturm_->set_motion(object, piece.trajectory, until);
  }

  void close() {
    const ArithmeticCounters& c = exact_->counters();
    for (const PredicateCounters& p : c.by_predicate) {
      for (std::size_t s = 0; s < kStages; ++s) {
        tally_.signs[s] += p.signs[s];
        tally_.failures[s] += p.failures[s];
      }
    }
    for (std::size_t s = 0; s < kStages; ++s) tally_.comparisons[s] += c.comparisons[s];
    tally_.gcds += c.gcds;
  }

 private:
  void check(bool holds, const char* what) {
    if (!holds) tally_.disagreements.push_back(what + where());
  }
  void check(bool holds, const char* what, const Query& q) {
    if (!holds) tally_.disagreements.push_back(what + (": " + to_text(scene_, q)) + where());
  }
  void check(bool holds, const char* what, const Query& a, const Query& b) {
    if (holds) return;
    tally_.disagreements.push_back(what + (": " + to_text(scene_, a)) + "\nand " +
                                   to_text(scene_, b) + where());
  }
  std::string where() {
    return "\nnow: exact " + to_text(exact_->describe_now()) + "\nnow: sturm " +
           to_text(sturm_->describe_now());
  }

  void drop(std::size_t i) {
    exact_->release(held_[i].exact);
    sturm_->release(held_[i].sturm);
    held_.erase(held_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  void release_held() {
    while (!held_.empty()) drop(held_.size() - 1);
  }

  std::optional<Rational> horizon_of(const Query& q) const {
    std::optional<Rational> first = scene_.end;
    for (std::size_t i = 0; i < q.arity; ++i) {
      const auto& until = scene_.objects[q.ids[i]].motion.pieces[0].to;
      if (until && (!first || *until < *first)) first = until;
    }
    return first;
  }

  void ask(const Query& q, std::vector<Failing>& failing) {
    const Sign sign = sturm_->sign_after(q);
    check(exact_->sign_after(q) == sign, "signs", q);
    Failing f{q, {}, {}, false};
    const Outlook exact = exact_->failure(q, f.exact);
    const Outlook sturm = sturm_->failure(q, f.sturm);
    ++tally_.outlooks[static_cast<std::size_t>(sturm)];
    const std::optional<Rational> horizon = horizon_of(q);
    if (horizon && exact == Outlook::kFails && sturm == Outlook::kNever) {
      // Beyond the horizon both answers are right.
      check(exact_->compare(q, f.exact, *horizon) > 0, "failures by the horizon", q);
      exact_->release(f.exact);
      return;
    }
    check(exact == sturm, "outlooks", q);
    check((sturm == Outlook::kFailsNow) == (sign == Sign::kNegative), "sign and outlook", q);
    check((sturm == Outlook::kIdenticallyZero) == (sign == Sign::kZero), "zero and outlook", q);
    f.now = sturm == Outlook::kFailsNow;
    if (exact == sturm && (f.now || sturm == Outlook::kFails)) {
      check(f.exact.lo <= f.exact.hi && f.sturm.lo <= f.sturm.hi, "ends of enclosures", q);
      check(f.exact.lo <= f.sturm.hi && f.sturm.lo <= f.exact.hi, "enclosures", q);
      failing.push_back(f);
    } else {
      check(f.sturm.lo == INFINITY && (exact != sturm || f.exact.lo == INFINITY), "never", q);
    }
  }

  // Against now, against rationals near it, and a rational between now and it.
  void ask_instant(Failing& a) {
    const int order = sturm_->compare_with_now(a.query, a.sturm);
    check(exact_->compare_with_now(a.query, a.exact) == order, "order with now", a.query);
    check(order >= 0 && (order == 0 || !a.now), "equality with now", a.query);
    a.now = order == 0;
    if (order == 0) ++tally_.equal_to_now;
    const Rational small = Rational(static_cast<int>(random_() % 9)) / Rational(3);
    const auto near = Rational::from_double(a.exact.lo + 0.5 * (a.exact.hi - a.exact.lo));
    for (const Rational& t : {small, near ? *near : Rational(0)}) {
      check(exact_->compare(a.query, a.exact, t) == sturm_->compare(a.query, a.sturm, t),
            "order with a rational", a.query);
    }
    const auto e = exact_->rational_between(&a.query, &a.exact);
    const auto s = sturm_->rational_between(&a.query, &a.sturm);
    check(e.has_value() != a.now && s.has_value() != a.now, "room behind now", a.query);
    if (!e || !s) return;
    check(sturm_->compare(a.query, a.sturm, *e) == 1, "exact's rational between", a.query);
    check(exact_->compare(a.query, a.exact, *s) == 1, "sturm's rational between", a.query);
  }

  void ask_order(Failing& a, Failing& b) {
    const int order = sturm_->compare(a.query, a.sturm, b.query, b.sturm);
    check(exact_->compare(a.query, a.exact, b.query, b.exact) == order, "order", a.query, b.query);
    check(exact_->compare(b.query, b.exact, a.query, a.exact) == -order &&
              sturm_->compare(b.query, b.sturm, a.query, a.sturm) == -order,
          "order backwards", a.query, b.query);
    if (a.now || b.now) return;
    ++tally_.pairs;
    if (order == 0) ++tally_.equal_pairs;
  }

  // Advances to a failure and replaces the certificate by the permuted one, which now holds.
  void move(Failing& next, std::vector<Query>& queries) {
    ++tally_.advances;
    const Query failed = next.query;
    exact_->advance(failed, next.exact);
    sturm_->advance(failed, next.sturm);
    check(to_text(exact_->describe_now()) == to_text(sturm_->describe_now()), "names of now",
          failed);
    Query permuted = failed;
    std::swap(permuted.ids[0], permuted.ids[1]);
    for (Arithmetic* arithmetic : {exact_.get(), sturm_.get()}) {
      check(arithmetic->sign_after(failed) == Sign::kNegative, "sign of the failed", failed);
      check(arithmetic->sign_after(permuted) == Sign::kPositive, "sign of the permuted", failed);
    }
    std::replace(queries.begin(), queries.end(), failed, permuted);
    queries.push_back(failed);  // fails now
  }

  Scene scene_;
  Tally& tally_;
  std::mt19937_64 random_;
  std::unique_ptr<Arithmetic> exact_, sturm_;
  std::vector<Failing> held_;  // computed at an earlier instant, not before now
};

// An integer of `bits` bits, sometimes a third of one.
Rational draw_number(int bits, std::mt19937_64& random) {
  const std::int64_t bound = std::int64_t{1} << bits;
  const auto v = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * bound + 1));
  const Rational r(v - bound);
  return random() % 16 == 0 ? r / Rational(3) : r;
}

// Some objects repeat another's motion, or move parallel to it, or are at rest.
Scene draw_scene(int degree, int bits, std::mt19937_64& random) {
  std::vector<std::vector<Coefficients>> objects;
  for (int i = 0; i < 7; ++i) {
    std::vector<Coefficients> axes(2);
    const std::vector<Coefficients>* other =
        objects.empty() ? nullptr : &objects[random() % objects.size()];
    const unsigned kind = random() % 8;
    for (std::size_t a = 0; a < 2; ++a) {
      for (int k = 0; k <= degree; ++k) {
        const bool copied = other != nullptr && (kind == 0 || (kind == 1 && k > 0));
        const bool still = kind == 2 && k > 0;
        axes[a].push_back(copied  ? (*other)[a][static_cast<std::size_t>(k)]
                          : still ? Rational(0)
                                  : draw_number(bits, random));
      }
    }
    objects.push_back(axes);
  }
  const Rational start = random() % 4 == 0 ? draw_number(bits, random) / Rational(7) : Rational(0);
  Scene scene = test::make_scene(objects, start);
  if (random() % 4 == 0) scene.end = start + Rational(static_cast<int>(random() % 3) + 1);
  return scene;
}

// A few instants from the start, then from another time, then under a changed motion that may be of
// higher degree, or have larger numbers, than those of the scene.
void run(const Scene& scene, std::uint64_t seed, int certificates, int predicates, Tally& tally) {
  Rivals rivals(scene, seed, tally);
  std::vector<Query> queries;
  for (int i = 0; i < certificates; ++i) queries.push_back(rivals.draw_query(predicates));
  const auto steps = [&](int count) {
    for (int i = 0; i < count && rivals.step(queries, i % 3 == 2); ++i) {
      if (queries.size() > static_cast<std::size_t>(certificates) + 2)
        queries.erase(queries.begin());
    }
  };
  steps(5);
  const Rational now = scene.start + Rational(static_cast<int>(seed % 3));
  rivals.set_now(now);
  steps(2);
  rivals.set_now(now);
  std::mt19937_64 random(seed);
  std::vector<Coefficients> axes(2);
  for (Coefficients& axis : axes) {
    const int degree = 1 + static_cast<int>(random() % 3);
    for (int k = 0; k <= degree; ++k) axis.push_back(draw_number(seed % 5 == 0 ? 60 : 4, random));
  }
  std::optional<Rational> until;
  if (seed % 2 == 0) until = now + Rational(1);
  rivals.set_motion(0, std::move(axes), until);
  steps(2);
  rivals.close();
}

struct Family {
  int degree, bits, scenes, certificates, predicates;
};

class ArithmeticAgreement : public testing::TestWithParam<Family> {};

TEST_P(ArithmeticAgreement, OnRandomCertificates) {
  const Family family = GetParam();
  std::mt19937_64 random(static_cast<std::uint64_t>(1000 * family.degree + family.bits));
  Tally tally;
  for (int i = 0; i < family.scenes && tally.disagreements.empty(); ++i) {
    const Scene scene = draw_scene(family.degree, family.bits, random);
    run(scene, random(), family.certificates, family.predicates, tally);
  }
  ASSERT_TRUE(tally.disagreements.empty()) << tally.disagreements.front();
  for (int count : tally.outlooks) EXPECT_GT(count, 0);
  EXPECT_GT(tally.advances, family.scenes);
  EXPECT_GT(tally.pairs, 5 * family.scenes);
  EXPECT_GT(tally.equal_pairs, 0);
  EXPECT_GT(tally.equal_to_now, 0);
  // Every stage was used.
  const auto kDouble = static_cast<std::size_t>(Stage::kDouble);
  const auto kWide = static_cast<std::size_t>(Stage::kWide);
  const auto kExact = static_cast<std::size_t>(Stage::kExact);
  if (family.degree <= kMaxFixedDegree) {
    EXPECT_GT(tally.signs[kWide], 0u);
    EXPECT_GT(tally.failures[kWide], 0u);
  }
  EXPECT_GT(tally.signs[kDouble], 0u);
  EXPECT_GT(tally.signs[kExact], 0u);
  EXPECT_GT(tally.failures[kDouble], 0u);
  EXPECT_GT(tally.failures[kExact], 0u);
  EXPECT_GT(tally.comparisons[kExact], 0u);
  EXPECT_GT(tally.gcds, 0u);
  RecordProperty("certificates",
                 tally.outlooks[0] + tally.outlooks[1] + tally.outlooks[2] + tally.outlooks[3]);
}

INSTANTIATE_TEST_SUITE_P(Random, ArithmeticAgreement,
                         testing::Values(Family{1, 3, 40, 14, 4}, Family{1, 8, 30, 14, 4},
                                         Family{1, 20, 30, 14, 4}, Family{2, 3, 20, 12, 4},
                                         Family{2, 8, 15, 12, 4}, Family{2, 20, 15, 12, 4},
                                         Family{3, 3, 10, 10, 4}, Family{3, 8, 8, 10, 4},
                                         Family{3, 20, 6, 10, 4}, Family{5, 3, 10, 10, 3},
                                         Family{5, 8, 8, 10, 3}, Family{5, 20, 6, 10, 3}),
                         [](const auto& parameter) {
                           return "degree_" + std::to_string(parameter.param.degree) + "_bits_" +
                                  std::to_string(parameter.param.bits);
                         });

// The in-circle certificate of motions of degree 5: degree 20.
TEST(ArithmeticAgreementOnce, DegreeTwenty) {
  std::mt19937_64 random(20);
  Tally tally;
  for (int i = 0; i < 3; ++i) {
    const Scene scene = draw_scene(5, 3, random);
    run(scene, random(), 4, 4, tally);
  }
  ASSERT_TRUE(tally.disagreements.empty()) << tally.disagreements.front();
  EXPECT_GT(tally.advances, 0);
}

// Small integers, so that a failing case shrinks to one that can be worked out by hand.
RC_GTEST_PROP(ArithmeticAgreementOnce, OnSmallIntegers, ()) {
  const int degree = *rc::gen::inRange(1, 4);
  const auto size = static_cast<std::size_t>(degree) + 1;
  const auto numbers = *rc::gen::container<std::vector<int>>(4 * 2 * size, rc::gen::inRange(-3, 4));
  std::vector<std::vector<Coefficients>> objects(4, std::vector<Coefficients>(2));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    objects[i / (2 * size)][i / size % 2].push_back(Rational(numbers[i]));
  }
  const Scene scene = test::make_scene(objects, Rational(*rc::gen::inRange(-2, 3)));
  Tally tally;
  run(scene, *rc::gen::inRange(0, 1000), 6, 4, tally);
  if (!tally.disagreements.empty()) RC_FAIL(tally.disagreements.front());
}

}  // namespace arithmetic_agreement_test
}  // namespace kinex
