// SPDX-License-Identifier: GPL-3.0-or-later
// Peer: a collision library that answers the same queries as kinex. One module a library, loaded on
// demand: two builds of one library cannot share a process.
//
// Two convex polygons, vertices counter-clockwise around an origin inside of them, are placed by
// poses. Libraries that work in space are given prisms over them, of heights 2 and 1, so that their
// distance is that of the polygons and no two faces are in one plane.
#ifndef KINEX_EXPERIMENTS_PEERS_PEER_H
#define KINEX_EXPERIMENTS_PEERS_PEER_H

#include <array>
#include <cstdint>
#include <vector>

namespace kinex::peers {

using PeerShape = std::vector<std::array<double, 2>>;

struct PeerPose {
  double x = 0, y = 0, angle = 0;
};

enum class PeerReply : std::uint8_t {
  kMiss,
  kHit,
  kFailed,       // the library reports failure, or it or its caller gave up at a limit
  kNotANumber,   // a time, distance or direction that is none
  kNoEnd,        // stopped from outside
  kCrash,        // died
  kUnsupported,  // the library does not take this query
};

struct PeerWork {
  std::uint64_t steps = 0;       // poses looked at, or outer steps of the library
  std::uint64_t iterations = 0;  // of GJK or MPR
  std::uint64_t supports = 0;    // calls for a farthest vertex
};

class Peer {
 public:
  virtual ~Peer() = default;
  // Makes the library's shapes; false if it does not take them.
  virtual bool load(const PeerShape& a, const PeerShape& b) = 0;
  // Do the bodies overlap in these poses? `variant`: of the library's tests.
  virtual PeerReply overlap(int variant, const PeerPose& a, const PeerPose& b) = 0;
  // Their distance; 0 or less if they overlap, NaN if the library knows none. `variant`: of the
  // library's solvers.
  virtual double distance(int variant, const PeerPose& a, const PeerPose& b) = 0;
  struct Cast {
    PeerReply reply = PeerReply::kUnsupported;
    double time = 0;  // of the contact, in [0, 1]
  };
  // The library's own continuous test, from one pose to the other.
  virtual Cast cast(int variant, const PeerPose& a0, const PeerPose& a1, const PeerPose& b0,
                    const PeerPose& b1) = 0;
  // The next query is about a new motion: drops cached starting points.
  virtual void forget() {}

  PeerWork work;
};

}  // namespace kinex::peers

// What a module exports; the caller deletes the peer.
extern "C" __attribute__((visibility("default"))) kinex::peers::Peer* kinex_make_peer();

#endif
