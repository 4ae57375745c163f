// SPDX-License-Identifier: GPL-3.0-or-later
// Exact continuous collision detection. Two bodies move for 0 <= t <= 1: a point and a triangle, or
// two segments, whose corners move linearly. Do they meet, and when first?
//
// All bodies are closed: touching is contact, also at t = 0 and t = 1. Degenerate bodies (a
// triangle that is a segment or a point, a segment that is a point) are the closed sets that they
// span.
//
// Both kinds of query are the same question about one set K(t): the triangle minus the point, or
// the parallelogram of the differences of the two segments.
//
//        q_3                 q_4 .-------. q_3
//        /  \                   /       /           contact at t: the origin lies in K(t)
//   q_1 '----' q_2         q_1 '-------' q_2
//
// The corners of K are linear in t. The contact times are a closed set, so there is a first one.
// The plane of K passes through the origin where a cubic f(t) vanishes. So contact happens only at
// roots of f in [0, 1], unless f is identically zero (contact_exact.cpp has the proof for that
// case).
//
// Identities:
//   (1) in_contact is true iff first_contact returns a time
//   (2) permuting the corners of the triangle, exchanging the ends of a segment, or exchanging the
//       two segments changes no answer and no time
//   (3) exchanging the points at t = 0 with those at t = 1 keeps in_contact
//   (4) a motion linear in t that is added to all points, or a factor other than 0 for all
//       coordinates, changes no answer and no time
//
// Exactness: every answer and every time is exact. A floating-point filter with proven error bounds
// (contact_filter.h) answers nearly all queries; the second stage is exact (contact_exact.h).
// Cost: about a microsecond for a miss, the roots of an integer cubic for a hit.
// Source for the query: Wang, Ferguson, Schneider, Jiang, Attene, Panozzo, A Large Scale Benchmark
// and an Inclusion-Based Algorithm for Continuous Collision Detection, ACM TOG 40(5), 2021.
#ifndef KINEX_PREDICATES_CCD_CONTINUOUS_CONTACT_H
#define KINEX_PREDICATES_CCD_CONTINUOUS_CONTACT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/numbers/ball.h"
#include "core/numbers/real_root.h"

namespace kinex {

enum class ContactKind : std::uint8_t {  // which features may touch
  kVertexFace,  // points: the vertex, then the corners of the triangle
  kEdgeEdge     // points: the ends of one segment, then those of the other
};

// Four points at t = 0 and the same four at t = 1; between them they move linearly.
class ContactQuery {
 public:
  static constexpr std::size_t kPoints = 4;
  static constexpr std::size_t kCoordinates = 2 * kPoints * 3;
  // x, y, z of the first point at t = 0, of the second, ..; then all of them at t = 1.
  using Doubles = std::array<double, kCoordinates>;

  // Requires finite coordinates.
  ContactQuery(ContactKind kind, const Doubles& coordinates);
  // Requires kCoordinates numbers. If every one is a double, only doubles are kept.
  ContactQuery(ContactKind kind, std::vector<Rational> coordinates);

  ContactKind kind() const { return kind_; }
  bool all_doubles() const { return exact_.empty(); }
  // The coordinate of this index (see index()) with a bound on its error, 0 if all are doubles.
  Ball rounded(std::size_t index) const {
    const double value = rounded_[index];
    if (exact_.empty()) return {value, 0};
    return {value, Ball::kUnit * std::fabs(value) + Ball::kTiny};
  }
  Rational coordinate(std::size_t index) const;
  // time: 0 or 1; point: 0 to 3, in the order of ContactKind; axis: 0 to 2.
  static std::size_t index(int time, std::size_t point, std::size_t axis) {
    return ((time == 0 ? 0 : kPoints) + point) * 3 + axis;
  }

 private:
  ContactKind kind_;
  Doubles rounded_;
  std::vector<Rational> exact_;  // empty if all coordinates are doubles
};

// An instant at which a contact begins. `polynomial` vanishes at `root` and is not zero.
struct ContactTime {
  RealRoot root;
  Polynomial polynomial;
};

// Queries answered by each stage; a plain value owned by the caller and passed by reference.
struct ContactCounters {
  std::uint64_t at_once = 0;     // in doubles, from the whole of [0, 1]
  std::uint64_t subdivided = 0;  // in doubles, after [0, 1] was cut
  std::uint64_t exact = 0;
  RootCounters roots;
};

// True if the two bodies are in contact at some t in [0, 1].
bool in_contact(const ContactQuery& query, ContactCounters& counters);

// The first t in [0, 1] at which the two bodies are in contact; nullopt if there is none.
std::optional<ContactTime> first_contact(const ContactQuery& query, ContactCounters& counters);

// The name of the instant, the same whichever stage found it. A rational instant is the root of its
// linear polynomial, with equal ends; any other is a root of the square-free part of `polynomial`.
RootName name_instant(ContactTime& time, RootCounters& counters);

}  // namespace kinex

#endif
