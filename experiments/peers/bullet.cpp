// SPDX-License-Identifier: GPL-3.0-or-later
// Bullet 3.24, in single and in double precision: this file is built twice. Prisms as convex hulls
// without margin. overlap and distance: btGjkPairDetector with EPA for depth, started from the
// last separating axis. cast: btContinuousConvexCollision, which stops at a gap of 0.001.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "experiments/peers/peer.h"

namespace {

using namespace kinex;
using namespace kinex::peers;

// A convex hull that counts. As a custom shape its virtual functions are called.
class CountingHull final : public btConvexHullShape {
 public:
  explicit CountingHull(std::uint64_t* calls) : calls_(calls) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
  }
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override {
    ++*calls_;
    return btConvexHullShape::localGetSupportingVertexWithoutMargin(direction);
  }

 private:
  std::uint64_t* calls_;
};

struct Report final : btConvexCast::CastResult {
  void reportFailure(int, int) override { failed = true; }
  bool failed = false;
};

class Bullet final : public Peer {
 public:
  bool load(const PeerShape& a, const PeerShape& b) override {
    a_ = hull(a, 1);
    b_ = hull(b, 0.5);
    detector_ = std::make_unique<btGjkPairDetector>(a_.get(), b_.get(), &simplex_, &depth_);
    first_axis_ = detector_->getCachedSeparatingAxis();
    return true;
  }

  PeerReply overlap(int, const PeerPose& a, const PeerPose& b) override {
    const double d = distance(0, a, b);
    if (d != d) return PeerReply::kNotANumber;
    return d <= 0 ? PeerReply::kHit : PeerReply::kMiss;
  }

  double distance(int, const PeerPose& a, const PeerPose& b) override {
    ++work.steps;
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = transform(a);
    input.m_transformB = transform(b);
    btPointCollector closest;
    const std::uint64_t before = work.supports;
    detector_->getClosestPoints(input, closest, nullptr);
    work.iterations += (work.supports - before) / 2;
    return closest.m_hasResult ? static_cast<double>(closest.m_distance) : -1;
  }

  Cast cast(int, const PeerPose& a0, const PeerPose& a1, const PeerPose& b0,
            const PeerPose& b1) override {
    btContinuousConvexCollision test(a_.get(), b_.get(), &simplex_, &depth_);
    Report report;
    report.m_fraction = 1;
    const std::uint64_t before = work.supports;
    const bool hit =
        test.calcTimeOfImpact(transform(a0), transform(a1), transform(b0), transform(b1), report);
    work.iterations += (work.supports - before) / 2;
    const double time = static_cast<double>(report.m_fraction);
    if (time != time) return {PeerReply::kNotANumber, 0};
    if (hit) return {PeerReply::kHit, time};
    return {report.failed ? PeerReply::kFailed : PeerReply::kMiss, time};
  }

  void forget() override { detector_->setCachedSeparatingAxis(first_axis_); }

 private:
  std::unique_ptr<CountingHull> hull(const PeerShape& shape, double half) {
    auto result = std::make_unique<CountingHull>(&work.supports);
    for (const double z : {-half, half}) {
      for (const auto& v : shape) {
        result->addPoint(btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]),
                                   static_cast<btScalar>(z)),
                         false);
      }
    }
    result->setMargin(0);
    result->recalcLocalAabb();
    return result;
  }
  static btTransform transform(const PeerPose& pose) {
    return btTransform(btQuaternion(btVector3(0, 0, 1), static_cast<btScalar>(pose.angle)),
                       btVector3(static_cast<btScalar>(pose.x), static_cast<btScalar>(pose.y), 0));
  }

  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
  std::unique_ptr<CountingHull> a_, b_;
  std::unique_ptr<btGjkPairDetector> detector_;
  btVector3 first_axis_{0, 1, 0};
};

}  // namespace

extern "C" kinex::peers::Peer* kinex_make_peer() { return new Bullet; }
