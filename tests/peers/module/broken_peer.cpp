// SPDX-License-Identifier: GPL-3.0-or-later
// The x of the second body's pose decides: below 1 a miss, below 2 it dies, then it never ends.
#include <unistd.h>
#include <csignal>

#include "experiments/peers/peer.h"

namespace {

class Broken final : public kinex::Peer {
 public:
  bool load(const kinex::PeerShape& a, const kinex::PeerShape&) override { return a.size() < 9; }
  kinex::Verdict overlap(int, const kinex::PeerPose&, const kinex::PeerPose& b) override {
    if (b.x < 1) return kinex::Verdict::kMiss;
    if (b.x < 2) raise(SIGKILL);
    for (;;) pause();
  }
  double distance(int, const kinex::PeerPose&, const kinex::PeerPose&) override { return 0; }
  Cast cast(int, const kinex::PeerPose&, const kinex::PeerPose&, const kinex::PeerPose&,
            const kinex::PeerPose&) override {
    return {};
  }
};

}  // namespace

extern "C" kinex::Peer* kinex_make_peer() { return new Broken; }
