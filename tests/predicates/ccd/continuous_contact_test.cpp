// SPDX-License-Identifier: GPL-3.0-or-later
// Continuous contact: constructed queries whose first time is known.
#include "predicates/ccd/continuous_contact.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "core/numbers/rational_value.h"
#include "predicates/ccd/contact_exact.h"
#include "predicates/ccd/contact_filter.h"
#include "tests/predicates/ccd/contact_support.h"

namespace kinex {
namespace continuous_contact_test {

using test::Point;
using test::Points;

constexpr ContactKind kFace = ContactKind::kVertexFace;
constexpr ContactKind kEdges = ContactKind::kEdgeEdge;

Rational number(const char* text) { return Rational::parse(text).value(); }
Point at(const char* x, const char* y, const char* z) { return {number(x), number(y), number(z)}; }
// Four points at t = 0, the same at t = 1, each "x y z".
Point at(const std::string& text) {
  const std::size_t a = text.find(' '), b = text.rfind(' ');
  return at(text.substr(0, a).c_str(), text.substr(a + 1, b - a - 1).c_str(),
            text.substr(b + 1).c_str());
}
Points moving(const std::array<const char*, 8>& texts) {
  Points points;
  for (std::size_t i = 0; i < 8; ++i) points[i] = at(texts[i]);
  return points;
}
Points resting(const std::array<const char*, 4>& texts) {
  return moving({texts[0], texts[1], texts[2], texts[3], texts[0], texts[1], texts[2], texts[3]});
}

// The first time in the form of the event log: a fraction, or "polynomial, root k"; "none".
std::string name_of(const RootName& name) {
  if (name.lower == name.upper) return name.lower.to_string();
  return name.polynomial.to_string() + ", root " + std::to_string(name.index);
}
std::string name_of(std::optional<ContactTime> time) {
  if (!time) return "none";
  RootCounters counters;
  return name_of(name_instant(*time, counters));
}

// Through both stages, and the exact one alone.
void expect_first(ContactKind kind, const Points& points, const std::string& expected) {
  const ContactQuery query = test::query_of(kind, points);
  ContactCounters counters;
  EXPECT_EQ(name_of(first_contact(query, counters)), expected) << test::show(kind, points);
  EXPECT_EQ(in_contact(query, counters), expected != "none") << test::show(kind, points);
  EXPECT_EQ(name_of(first_contact_exactly(query, counters.roots)), expected)
      << test::show(kind, points);
}

// The triangle (-1,-1,0), (2,-1,0), (-1,2,0) at rest, and a vertex that moves.
Points vertex(const char* from, const char* to) {
  return moving({from, "-1 -1 0", "2 -1 0", "-1 2 0", to, "-1 -1 0", "2 -1 0", "-1 2 0"});
}
// The segment from (-1,0,0) to (1,0,0) at rest, and another that moves.
Points edge(const char* c0, const char* d0, const char* c1, const char* d1) {
  return moving({"-1 0 0", "1 0 0", c0, d0, "-1 0 0", "1 0 0", c1, d1});
}

TEST(ContinuousContact, VertexPassesThroughTriangle) {
  expect_first(kFace, vertex("0 0 1", "0 0 -1"), "1/2");
  expect_first(kFace, vertex("0 0 1", "0 0 -2"), "1/3");
  expect_first(kFace, vertex("0 0 -1", "1/7 0 4"), "1/5");
  expect_first(kFace, vertex("5 0 1", "5 0 -1"), "none");
  expect_first(kFace, vertex("0 0 3", "0 0 1"), "none");
}

TEST(ContinuousContact, EdgesCross) {
  expect_first(kEdges, edge("0 -1 1", "0 1 1", "0 -1 -1", "0 1 -1"), "1/2");
  expect_first(kEdges, edge("0 -1 1", "0 1 1", "0 -1 -2", "0 1 -2"), "1/3");
  expect_first(kEdges, edge("3 -1 1", "3 1 1", "3 -1 -1", "3 1 -1"), "none");
  expect_first(kEdges, edge("0 1 1", "0 3 1", "0 1 -1", "0 3 -1"), "none");
}

TEST(ContinuousContact, GrazesAtTheBorder) {
  expect_first(kFace, vertex("1/2 1/2 1", "1/2 1/2 -1"), "1/2");  // an edge
  expect_first(kFace, vertex("0 -1 1", "0 -1 -1"), "1/2");
  expect_first(kFace, vertex("2 -1 1", "2 -1 -3"), "1/4");  // a corner
  expect_first(kFace, vertex("2.0000000000000001 -1 1", "2.0000000000000001 -1 -3"), "none");
  expect_first(kEdges, edge("1 -1 1", "1 1 1", "1 -1 -1", "1 1 -1"), "1/2");  // an end
  expect_first(kEdges, edge("1 0 1", "1 1 1", "1 0 -1", "1 1 -1"), "1/2");    // two ends
  expect_first(kEdges, edge("1 1e-30 1", "1 1 1", "1 1e-30 -1", "1 1 -1"), "none");
}

TEST(ContinuousContact, AtTheFirstAndTheLastInstant) {
  expect_first(kFace, vertex("0 0 0", "0 0 1"), "0");
  expect_first(kFace, vertex("2 -1 0", "9 9 9"), "0");
  expect_first(kFace, vertex("0 0 1", "0 0 0"), "1");
  expect_first(kFace, vertex("7 7 7", "2 -1 0"), "1");
  expect_first(kFace, vertex("0 0 1", "0 0 1e-300"), "none");
  expect_first(kFace, vertex("0 0 -1e-300", "0 0 -1"), "none");
  expect_first(kEdges, edge("0 -1 0", "0 1 0", "0 -1 5", "0 1 5"), "0");
  expect_first(kEdges, edge("0 -1 5", "0 1 5", "0 -1 0", "0 1 0"), "1");
}

TEST(ContinuousContact, AllAtRest) {
  expect_first(kFace, resting({"0 0 0", "-1 -1 0", "2 -1 0", "-1 2 0"}), "0");
  expect_first(kFace, resting({"1/2 1/2 0", "-1 -1 0", "2 -1 0", "-1 2 0"}), "0");
  expect_first(kFace, resting({"1 1 0", "-1 -1 0", "2 -1 0", "-1 2 0"}), "none");
  expect_first(kFace, resting({"0 0 1", "-1 -1 0", "2 -1 0", "-1 2 0"}), "none");
  expect_first(kEdges, resting({"-1 0 0", "1 0 0", "0 -1 0", "0 1 0"}), "0");
  expect_first(kEdges, resting({"-1 0 0", "1 0 0", "0 1 0", "0 2 0"}), "none");
  expect_first(kEdges, resting({"-1 0 0", "1 0 0", "0 -1 1", "0 1 1"}), "none");
}

TEST(ContinuousContact, InOnePlaneForAllTime) {
  expect_first(kFace, vertex("-3 0 0", "1 0 0"), "1/2");     // enters across an edge
  expect_first(kFace, vertex("-3 -1 0", "1 -1 0"), "1/2");   // slides onto an edge from its end
  expect_first(kFace, vertex("0 0 0", "9 0 0"), "0");        // leaves
  expect_first(kFace, vertex("-3 -2 0", "9 -2 0"), "none");  // passes by
  expect_first(kFace, vertex("1 1 0", "2 -1 0"), "1");       // reaches a corner
  expect_first(kFace, vertex("3 -2 0", "1 0 0"), "1/2");  // touches it, and passes on along an edge
  // Reaches a corner and slides along an edge from there; passes a corner and touches only it.
  expect_first(kFace, vertex("-2 3 0", "0 1 0"), "1/2");
  expect_first(kFace, vertex("-2 2 0", "0 2 0"), "1/2");
  expect_first(kEdges, edge("0 1 0", "0 3 0", "0 -1 0", "0 1 0"), "1/2");
  expect_first(kEdges, edge("3 -1 0", "3 1 0", "-3 -1 0", "-3 1 0"), "1/3");
  expect_first(kEdges, edge("0 1 0", "0 3 0", "0 3 0", "0 9 0"), "none");
  expect_first(kEdges, edge("3 1 0", "3 2 0", "-3 1 0", "-3 2 0"), "none");
  expect_first(kEdges, edge("0 -1 0", "0 1 0", "7 -1 0", "7 1 0"), "0");
  // The plane itself moves.
  expect_first(
      kFace,
      moving({"-3 0 1", "-1 -1 1", "2 -1 1", "-1 2 1", "1 0 7", "-1 -1 7", "2 -1 7", "-1 2 7"}),
      "1/2");
  // A triangle that grows from a point: (-1-2t, ..), reaches (-2,-2) when its corner does.
  expect_first(
      kFace, moving({"-2 -2 0", "0 0 0", "0 0 0", "0 0 0", "-2 -2 0", "-3 -3 0", "3 0 0", "0 3 0"}),
      "2/3");
}

TEST(ContinuousContact, ParallelEdges) {
  expect_first(kEdges, edge("-1/2 1 0", "3 1 0", "-1/2 -1 0", "3 -1 0"), "1/2");  // sideways
  expect_first(kEdges, edge("1 1 0", "3 1 0", "1 -1 0", "3 -1 0"), "1/2");        // end to end
  expect_first(kEdges, edge("2 1 0", "3 1 0", "2 -1 0", "3 -1 0"), "none");
  expect_first(kEdges, edge("3 0 0", "5 0 0", "-1 0 0", "1 0 0"), "1/2");  // along one line
  expect_first(kEdges, edge("5 0 0", "3 0 0", "5/2 0 0", "3/2 0 0"), "none");
  expect_first(kEdges, edge("-5 0 0", "5 0 0", "-6 0 0", "6 0 0"), "0");  // one holds the other
  expect_first(kEdges, edge("-5 2 1", "5 2 1", "-5 -1 -1/2", "5 -1 -1/2"), "2/3");
  expect_first(kEdges, edge("-5 2 1", "5 2 1", "-5 -1 -1", "5 -1 -1"), "none");
  // Parallel at one instant only, at which they overlap; and the same with a gap.
  expect_first(kEdges, edge("-1 0 1", "2 0 2", "-1 0 -1", "2 0 -2"), "1/2");
  expect_first(kEdges, edge("2 0 1", "3 0 2", "2 0 -1", "3 0 -2"), "none");
}

TEST(ContinuousContact, DegenerateTriangle) {
  const char* from = "0 0 1";
  const char* to = "0 0 -1";
  const auto with = [&](const char* a, const char* b, const char* c) {
    return moving({from, a, b, c, to, a, b, c});
  };
  expect_first(kFace, with("-1 0 0", "1 0 0", "1/2 0 0"), "1/2");  // a segment
  expect_first(kFace, with("1 0 0", "2 0 0", "3 0 0"), "none");
  expect_first(kFace, with("1 0 0", "2 0 0", "0 0 0"), "1/2");  // at its end
  expect_first(kFace, with("-1 0 0", "-1 0 0", "3 0 0"), "1/2");
  expect_first(kFace, with("0 0 0", "0 0 0", "0 0 0"), "1/2");  // a point
  expect_first(kFace, with("0 1e-300 0", "0 1e-300 0", "0 1e-300 0"), "none");
  expect_first(kFace, with("0 0 1/2", "0 0 -1/2", "0 0 0"), "1/4");  // along the line of motion
  // Flat at t = 1/2 only, when the vertex passes.
  expect_first(kFace,
               moving({"0 0 1", "-1 0 0", "1 0 0", "0 -1 0", "0 0 -1", "-1 0 0", "1 0 0", "0 1 0"}),
               "1/2");
  expect_first(kFace,
               moving({"2 0 1", "-1 0 0", "1 0 0", "0 -1 0", "2 0 -1", "-1 0 0", "1 0 0", "0 1 0"}),
               "none");
}

TEST(ContinuousContact, DegenerateEdge) {
  expect_first(kEdges, edge("0 0 1", "0 0 1", "0 0 -1", "0 0 -1"), "1/2");
  expect_first(kEdges, edge("2 0 1", "2 0 1", "2 0 -1", "2 0 -1"), "none");
  expect_first(kEdges, edge("4 0 0", "4 0 0", "-4 0 0", "-4 0 0"), "3/8");
  expect_first(kEdges,
               moving({"0 0 0", "0 0 0", "1 1 1", "1 1 1", "2 2 2", "2 2 2", "1 1 1", "1 1 1"}),
               "1/2");
  expect_first(kEdges,
               moving({"0 0 0", "0 0 0", "1 1 1", "1 1 1", "2 2 3", "2 2 3", "1 1 1", "1 1 1"}),
               "none");
}

TEST(ContinuousContact, VertexMovesWithTheFace) {
  expect_first(kFace,
               moving({"0 0 0", "-1 -1 0", "2 -1 0", "-1 2 0", "5 6 7", "4 5 7", "7 5 7", "4 8 7"}),
               "0");
  expect_first(
      kFace, moving({"9 9 0", "-1 -1 0", "2 -1 0", "-1 2 0", "14 15 7", "4 5 7", "7 5 7", "4 8 7"}),
      "none");
}

// A triangle that turns about its side y = -4: the height of its plane over (0, 4t - 4) is 4 t^2.
Points turning(const char* from, const char* to) {
  const std::string start = std::string("0 -4 ") + from, end = std::string("0 0 ") + to;
  return moving(
      {start.c_str(), "-9 -4 0", "9 -4 0", "0 4 0", end.c_str(), "-9 -4 0", "9 -4 0", "0 4 8"});
}

TEST(ContinuousContact, IrrationalAndDoubleRoots) {
  expect_first(kFace, turning("2", "2"), "-1 0 2, root 2");  // 4 t^2 = 2
  expect_first(kFace, turning("1", "1"), "1/2");
  expect_first(kFace, turning("5", "5"), "none");
  // 4 t^2 = 4t - 1: a double root; the vertex touches the triangle from above and leaves upwards.
  expect_first(kFace, turning("-1", "3"), "1/2");
  expect_first(kFace, turning("-1.000000000000000000000000000001", "3"), "none");
  // (2t - 1)(2t - 1 + 1e-30): two roots, 5e-31 apart.
  expect_first(kFace,
               turning("-0.999999999999999999999999999999", "2.999999999999999999999999999999"),
               "999999999999999999999999999999/2000000000000000000000000000000");
  // 4 (t - 49/100)(t - 51/100)
  expect_first(kFace, turning("-0.9996", "3.0004"), "49/100");
}

// The vertex at the origin; corners (l1, c, 0), (0, l2, 0), (e, 0, l3) with l_i linear in t: the
// cubic is l1 l2 l3.
Points three_roots(const char* c, const char* second, const char* e) {
  const std::string after = (number(second) + Rational(1)).to_string();
  const std::string q1 = "-1/4 " + std::string(c) + " 0", p1 = "3/4 " + std::string(c) + " 0";
  const std::string q2 = "0 " + std::string(second) + " 0", p2 = "0 " + after + " 0";
  const std::string q3 = std::string(e) + " 0 -3/4", p3 = std::string(e) + " 0 1/4";
  return moving(
      {"0 0 0", q1.c_str(), q2.c_str(), q3.c_str(), "0 0 0", p1.c_str(), p2.c_str(), p3.c_str()});
}

TEST(ContinuousContact, FirstOfThreeRootsThatIsAContact) {
  expect_first(kFace, three_roots("1", "-1/2", "1"), "1/4");   // on a side
  expect_first(kFace, three_roots("-1", "-1/2", "1"), "1/2");  // passes the first one, a corner
  expect_first(kFace, three_roots("1", "1", "0"), "3/4");
  expect_first(kFace, three_roots("1", "1", "1"), "none");
}

TEST(ContinuousContact, HugeAndTinyNumbers) {
  const Points crossing = vertex("1/3 0 1", "1/3 0 -2");
  const Points irrational = turning("2", "2");
  for (const char* x : {"1e300", "1e-300", "1e-2000", "1"}) {
    for (const char* z : {"1e300", "1e-300", "1e3000", "7"}) {
      for (const auto& [points, expected] :
           {std::pair(crossing, "1/3"), std::pair(irrational, "-1 0 2, root 2")}) {
        Points scaled = points;
        for (Point& p : scaled) {
          p[0] *= number(x);
          p[2] *= number(z);
        }
        expect_first(kFace, scaled, expected);
      }
    }
  }
  // Far from the origin, and fast.
  Points far = vertex("0 0 1e300", "0 0 -2e300");
  for (Point& p : far) p[1] += number("123456789e200");
  expect_first(kFace, far, "1/3");
  // Doubles at both ends of their range.
  const double big = std::numeric_limits<double>::max(),
               small = std::numeric_limits<double>::denorm_min();
  ContactQuery::Doubles c{0, 0, big,  -1, -1, 0, 2, -1, 0, -1, 2, 0,
                          0, 0, -big, -1, -1, 0, 2, -1, 0, -1, 2, 0};
  ContactCounters counters;
  EXPECT_EQ(name_of(first_contact(ContactQuery(kFace, c), counters)), "1/2");
  c[2] = small;
  c[14] = -2 * small;
  EXPECT_EQ(name_of(first_contact(ContactQuery(kFace, c), counters)), "1/3");
  c[14] = small;
  EXPECT_EQ(name_of(first_contact(ContactQuery(kFace, c), counters)), "none");
}

TEST(ContinuousContact, RefusesWhatIsNoNumber) {
  ContactQuery::Doubles c{};
  c[5] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ContactQuery(kFace, c), std::logic_error);
  c[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ContactQuery(kFace, c), std::logic_error);
  EXPECT_THROW(ContactQuery(kFace, std::vector<Rational>(23)), std::logic_error);
}

TEST(ContinuousContact, PlainQueriesAreAnsweredInDoubles) {
  const auto verdict = [](ContactKind kind, const Points& points) {
    return filter_contact(test::query_of(kind, points)).kind;
  };
  using Kind = ContactVerdict::Kind;
  EXPECT_EQ(verdict(kFace, vertex("0 0 1", "0 0 -2")), Kind::kFirst);
  EXPECT_EQ(verdict(kFace, vertex("5 0 1", "5 0 -1")), Kind::kNone);
  EXPECT_EQ(verdict(kFace, vertex("2.0001 -1 1", "2.0001 -1 -1")), Kind::kNone);
  EXPECT_EQ(verdict(kFace, turning("2", "2")), Kind::kFirst);
  EXPECT_EQ(verdict(kEdges, edge("0 -1 1", "0 1 1", "0 -1 -2", "0 1 -2")), Kind::kFirst);
  EXPECT_EQ(verdict(kEdges, edge("2 1 0", "3 1 0", "2 -1 0", "3 -1 0")), Kind::kNone);
  // It cannot prove a touch.
  EXPECT_EQ(verdict(kFace, vertex("0 0 0", "0 0 1")), Kind::kUnknown);
  EXPECT_EQ(verdict(kFace, turning("-1", "3")), Kind::kUnknown);
}

TEST(RationalValue, FindsFractionsAmongRoots) {
  RootCounters counters;
  // (3t - 1)(7t - 5)(t^2 - 2)
  const Polynomial p = Polynomial({Integer(-1), Integer(3)}) *
                       Polynomial({Integer(-5), Integer(7)}) *
                       Polynomial({Integer(-2), Integer(0), Integer(1)});
  std::vector<std::string> found;
  for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
    const std::optional<Rational> value = rational_value(entry.root, counters);
    found.push_back(value ? value->to_string() : "irrational");
  }
  EXPECT_EQ(found, (std::vector<std::string>{"irrational", "1/3", "5/7", "irrational"}));
  // Close to a rational number, not equal to it.
  const Rational third(Integer(1), Integer(3));
  for (const char* c : {"-1e30", "1e30"}) {
    const Polynomial q = Polynomial::from_rationals({number(c), Rational(0), number("3e60")});
    for (RootWithMultiplicity& entry : isolate_real_roots(q, counters)) {
      EXPECT_FALSE(rational_value(entry.root, counters).has_value());
    }
  }
  // (t - 1)(10 t^2 - 11): a rational root less than 1/10 below an irrational one.
  const Polynomial close =
      Polynomial({Integer(-1), Integer(1)}) * Polynomial({Integer(-11), Integer(0), Integer(10)});
  RealRoot last = isolate_real_roots(close, counters).back().root;
  EXPECT_FALSE(rational_value(last, counters).has_value());
  RealRoot exact(third);
  EXPECT_EQ(rational_value(exact, counters), third);
}

}  // namespace continuous_contact_test
}  // namespace kinex
