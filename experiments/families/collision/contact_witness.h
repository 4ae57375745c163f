// SPDX-License-Identifier: GPL-3.0-or-later
// The independent witness of collision detection: every contact and separation of two bodies, found
// by testing every vertex of one against every edge of the other.
//
// Polygons whose interiors are disjoint meet only where a vertex of one lies on an edge of the
// other. The instants at which a vertex is on the line of an edge are the real roots of a
// polynomial in t; the signs of two more polynomials there decide whether it is between the ends.
// Between two such instants nothing changes, so the bodies are placed at a rational time in between
// and tested for overlap.
//
// Exactness: exact; world coordinates throughout. Cost: O(n_a n_b) polynomials for each pair of
// flight plans, of the degree of the positions, plus four times that of the rotor of the edge's
// body, plus twice that of the vertex's. It shares only polynomials and their roots with the
// structures.
#ifndef KINEX_EXPERIMENTS_FAMILIES_COLLISION_CONTACT_WITNESS_H
#define KINEX_EXPERIMENTS_FAMILIES_COLLISION_CONTACT_WITNESS_H

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/real_root.h"
#include "experiments/formats/placed_body.h"

namespace kinex::families {

// A vertex of one body on an edge of the other, its ends included. Edge k goes from vertex k to
// k+1.
struct FeaturePair {
  bool vertex_of_a;  // otherwise a vertex of b, on an edge of a
  std::uint32_t vertex, edge;
  friend auto operator<=>(const FeaturePair&, const FeaturePair&) = default;
};

struct BodyContact {
  RealRoot instant;
  // All features in contact, in ascending order; none if the bodies overlap, or are apart, because
  // of a jump.
  std::vector<FeaturePair> features;
  // Right after the instant: kApart for a touch of one instant, kTouching if they stay in touch,
  // kOverlapping if they penetrate.
  formats::Contact after;
};

struct CollisionWitness {
  // Instants at which bodies that were apart begin to touch, and do not penetrate at once.
  std::vector<BodyContact> grazes;
  // Instants right after which the interiors overlap, in ascending order; right before, they do not
  // overlap, or one body does not exist. The first is the penetration of bodies that begin apart.
  std::vector<BodyContact> contacts;
  // Instants right after which the interiors no longer overlap.
  std::vector<BodyContact> separations;

  // The first contact; nullptr if there is none.
  const BodyContact* penetration() const { return contacts.empty() ? nullptr : &contacts.front(); }
  // The earliest touch or contact; nullptr if the bodies are apart at all times.
  const BodyContact* first() const;
};

// The contacts from `start` to `end` (nullopt: for all time) while both bodies exist. Bodies that
// touch at the start begin to touch there. At the end, events are decided by extrapolating the
// flight plans that end there.
CollisionWitness find_contacts(const SceneObject& a, const SceneObject& b, const Rational& start,
                               const std::optional<Rational>& end);

}  // namespace kinex::families

#endif
