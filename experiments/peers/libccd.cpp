// SPDX-License-Identifier: GPL-3.0-or-later
// libccd 2.1: double precision; yes or no for fixed poses, no distance and no continuous test.
// Variants of overlap: 0 GJK, 1 MPR, 2 GJK with penetration by EPA. Its default is no limit on
// iterations; here it is 10,000, beyond which the query has failed.
#include <ccd/ccd.h>
#include <ccd/vec3.h>

#include <cmath>
#include <limits>

#include "experiments/peers/peer.h"

namespace {

using namespace kinex;
using namespace kinex::peers;

constexpr unsigned long kMostIterations = 10000;

struct Prism {
  const PeerShape* shape = nullptr;
  double half = 1;  // height
  double x = 0, y = 0, cos = 1, sin = 0;
  std::uint64_t* supports = nullptr;

  void place(const PeerPose& pose) {
    x = pose.x;
    y = pose.y;
    cos = std::cos(pose.angle);
    sin = std::sin(pose.angle);
  }
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Prism& prism = *static_cast<const Prism*>(object);
  ++*prism.supports;
  const double dx = ccdVec3X(direction), dy = ccdVec3Y(direction), dz = ccdVec3Z(direction);
  const double u = prism.cos * dx + prism.sin * dy, v = prism.cos * dy - prism.sin * dx;
  const std::array<double, 2>* best = nullptr;
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& p : *prism.shape) {
    const double value = u * p[0] + v * p[1];
    if (value > most) {
      most = value;
      best = &p;
    }
  }
  if (best == nullptr) best = &prism.shape->front();  // the direction is NaN
  ccdVec3Set(out, prism.x + prism.cos * (*best)[0] - prism.sin * (*best)[1],
             prism.y + prism.sin * (*best)[0] + prism.cos * (*best)[1],
             dz < 0 ? -prism.half : prism.half);
}

void center(const void* object, ccd_vec3_t* out) {
  const Prism& prism = *static_cast<const Prism*>(object);
  ccdVec3Set(out, prism.x, prism.y, 0);
}

class Libccd final : public Peer {
 public:
  Libccd() {
    CCD_INIT(&ccd_);
    ccd_.support1 = ccd_.support2 = support;
    ccd_.center1 = ccd_.center2 = center;
    ccd_.max_iterations = kMostIterations;
    a_.half = 1;
    b_.half = 0.5;
    a_.supports = b_.supports = &work.supports;
  }

  bool load(const PeerShape& a, const PeerShape& b) override {
    shape_a_ = a;
    shape_b_ = b;
    a_.shape = &shape_a_;
    b_.shape = &shape_b_;
    return true;
  }

  PeerReply overlap(int variant, const PeerPose& a, const PeerPose& b) override {
    a_.place(a);
    b_.place(b);
    ++work.steps;
    const std::uint64_t before = work.supports;
    PeerReply reply = PeerReply::kMiss;
    if (variant == 2) {
      ccd_real_t depth = 0;
      ccd_vec3_t direction, position;
      ccdVec3Set(&direction, 0, 0, 0);
      if (ccdGJKPenetration(&a_, &b_, &ccd_, &depth, &direction, &position) == 0) {
        reply = PeerReply::kHit;
        const double sum = depth + ccdVec3X(&direction) + ccdVec3Y(&direction);
        if (std::isnan(sum)) reply = PeerReply::kNotANumber;
      }
    } else if (variant == 1 ? ccdMPRIntersect(&a_, &b_, &ccd_) != 0
                            : ccdGJKIntersect(&a_, &b_, &ccd_) != 0) {
      reply = PeerReply::kHit;
    }
    const std::uint64_t iterations = (work.supports - before) / 2;
    work.iterations += iterations;
    return iterations >= kMostIterations ? PeerReply::kFailed : reply;
  }

  double distance(int, const PeerPose&, const PeerPose&) override {
    return std::numeric_limits<double>::quiet_NaN();
  }
  Cast cast(int, const PeerPose&, const PeerPose&, const PeerPose&, const PeerPose&) override {
    return {};
  }

 private:
  PeerShape shape_a_, shape_b_;
  Prism a_, b_;
  ccd_t ccd_;
};

}  // namespace

extern "C" kinex::peers::Peer* kinex_make_peer() { return new Libccd; }
