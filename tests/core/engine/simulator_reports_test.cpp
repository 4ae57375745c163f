// SPDX-License-Identifier: GPL-3.0-or-later
// Audits after every event hold the external events of a structure to its attribute.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/engine/simulator_fixture.h"

namespace kinex::test {
namespace simulator_reports_test {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

// Says of every swap that it changes nothing, or says nothing at all.
template <bool kReports>
class Silent final : public PlainList {
 public:
  using PlainList::PlainList;
  void certificate_failed(CertificateId failed) override {
    const std::uint32_t i = kernel_->tag(failed);
    std::swap(order_[i], order_[i + 1]);
    certify();
    if (kReports) kernel_->report(id_, 0, {order_[i + 1], order_[i]}, false);
  }
};

// 0 passes 1 at t = 1 and 2 at t = 2.
Scene passing() { return scene_of({path({{0, 1}}), path({{1}}), path({{2}})}, 0, Rational(6)); }

TEST(SimulatorReports, AChangeWithoutAnExternalEventIsAViolation) {
  const Scene scene = passing();
  Fixture<Silent<true>> said(scene);
  said.simulator.run_until(std::nullopt);
  EXPECT_THAT(said.simulator.violations(), SizeIs(2));
  EXPECT_THAT(
      said.simulator.violations(),
      Each(HasSubstr("list: the attribute changed, and no external event was reported (t = ")));
  Fixture<Silent<false>> silent(scene);
  silent.simulator.run_until(std::nullopt);
  EXPECT_EQ(silent.simulator.violations(), said.simulator.violations());
  Fixture<PlainList> right(scene);
  right.simulator.run_until(std::nullopt);
  right.expect_clean();
}

// What comes and goes changes the attribute without an event of its own.
TEST(SimulatorReports, ObjectsThatComeAndGoChangeIt) {
  const Scene scene = passing();
  Fixture<PlainList> run(scene);
  run.simulator.schedule_erasure(*Rational::parse("1/2"), 2);
  run.simulator.schedule_insertion(Rational(4), 2, path({{9}}));
  run.simulator.run_until(std::nullopt);
  run.expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{1, 0, 2}));
}

// The audit at the end alone compares with nothing.
TEST(SimulatorReports, OnlyAuditsAfterEveryEventLook) {
  const Scene scene = passing();
  SimulatorOptions options;
  options.audit = AuditLevel::kEnd;
  Fixture<Silent<true>> run(scene, options);
  run.simulator.run_until(std::nullopt);
  run.expect_clean();
}

}  // namespace simulator_reports_test
}  // namespace kinex::test
