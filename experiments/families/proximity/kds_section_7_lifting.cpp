// SPDX-License-Identifier: GPL-3.0-or-later
// Question: do two discs meet if and only if the points (x, y, x^2 + y^2 - r^2) see each other past the
//   paraboloid z = x^2 + y^2? (Guibas 1998, section 7.)
// Scenes: discs of small integers, discs in random motion, discs through one point, at rational times.
// Expected: yes, for every pair at every time, in exact arithmetic. The pairs that meet are those that
//   disc_pairs_all maintains.
// Cost: seconds.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/families/proximity/experiments.h"
#include "experiments/lab/claim_check.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/study_runs.h"
#include "experiments/lab/workload.h"
#include "experiments/lab/workload_parts.h"
#include "structures/plan.h"

namespace kinex::families {

namespace {

constexpr const char* kLiftedDiscs = "disc_pairs_all";

struct Lifted {
  Rational x, y, z;
};

Lifted lifted(const Snapshot& now, ObjectId disc) {
  const Rational x = now.position(disc, 0), y = now.position(disc, 1), r = now.position(disc, 2);
  return {x, y, x * x + y * y - r * r};
}

// The height of the segment's point at the share s, over the paraboloid.
Rational height(const Lifted& a, const Lifted& b, const Rational& s) {
  const Rational rest = Rational(1) - s;
  const Rational x = rest * a.x + s * b.x, y = rest * a.y + s * b.y;
  return rest * a.z + s * b.z - x * x - y * y;
}

// No point of the segment is strictly above the paraboloid. The height is a quadratic in s, concave:
// h(0) + s (h(1) - h(0) + c) - c s^2 with c = |b - a|^2, highest where its derivative is zero.
bool see_each_other(const Lifted& a, const Lifted& b) {
  const Rational first = height(a, b, Rational(0)), last = height(a, b, Rational(1));
  const Rational middle = height(a, b, lab::fraction(1, 2));
  const Rational c = Rational(4) * middle - Rational(2) * (first + last);
  Rational s(0);
  if (c.sign() > 0) s = (last - first + c) / (Rational(2) * c);
  s = std::min(std::max(s, Rational(0)), Rational(1));
  return height(a, b, s).sign() <= 0;
}

struct LiftedPairs {
  std::size_t pairs = 0, meeting = 0, different = 0;
};

LiftedPairs compare_lifted(const char* workload, int n, int times,
                           const std::function<bool()>& go_on, lab::StudyResult& study) {
  const Scene scene = lab::generate_scene(workload, {.n = n}, kLiftedDiscs);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, "exact", options);
  const StructureId id = asked_structure(scene);
  simulator->start();
  LiftedPairs result;
  for (int i = 1; i <= times && go_on(); ++i) {
    const Rational t = scene.start + (*scene.end - scene.start) * lab::fraction(2 * i - 1, 2 * times + 1);
    simulator->run_until(t);
    const Snapshot now = simulator->snapshot(t);
    const std::vector<ObjectId> ids = simulator->structure(id).attribute().ids;
    std::vector<std::pair<ObjectId, ObjectId>> meeting;  // ascending
    for (std::size_t k = 0; k + 1 < ids.size(); k += 2) meeting.emplace_back(ids[k], ids[k + 1]);
    for (ObjectId a = 0; a < now.objects(); ++a) {
      for (ObjectId b = a + 1; b < now.objects(); ++b) {
        const bool meet = std::binary_search(meeting.begin(), meeting.end(), std::pair(a, b));
        ++result.pairs;
        result.meeting += meet ? 1 : 0;
        result.different += meet == see_each_other(lifted(now, a), lifted(now, b)) ? 0 : 1;
      }
    }
  }
  lab::check_run(*simulator, scene.name, study);
  return result;
}

// Columns of the study's table.
constexpr std::size_t kAtPairs = 3, kAtMeeting = 4, kAtDifferent = 5;

}  // namespace

lab::StudyResult study_lifted_discs(bool quick, const std::function<bool()>& go_on) {
  lab::StudyResult result;
  result.name = "section-7-lifting";
  result.table.title = "discs that meet, and lifted points that see each other";
  result.table.header = {"scenes", "discs", "times", "pairs", "of them meeting", "different"};
  const int times = quick ? 20 : 100;
  for (const auto& [workload, n] : {std::pair("small-discs", 24), std::pair("random-discs", 24),
                                    std::pair("fan-of-discs", 12)}) {
    if (!go_on()) return result;
    const LiftedPairs compared = compare_lifted(workload, n, times, go_on, result);
    result.table.rows.push_back({workload, std::to_string(n), std::to_string(times),
                                 std::to_string(compared.pairs), std::to_string(compared.meeting),
                                 std::to_string(compared.different)});
  }
  return result;
}

lab::PartReport kds_section_7_lifting_report(const lab::StudyResult& result,
                                             const std::string& command) {
  lab::PartReport report;
  if (result.table.rows.empty()) return report;
  std::size_t pairs = 0, meeting = 0, different = 0;
  for (const std::vector<std::string>& row : result.table.rows) {
    pairs += std::stoul(row[kAtPairs]);
    meeting += std::stoul(row[kAtMeeting]);
    different += std::stoul(row[kAtDifferent]);
  }
  lab::PaperClaim claim;
  claim.id = "7.15.lifting";
  claim.place = "section 7";
  claim.kind = "finding";
  claim.command = command;
  claim.statement =
      "Two discs meet if and only if the points (x, y, x^2 + y^2 - r^2) see each other past the "
      "paraboloid z = x^2 + y^2.";
  claim.expected = "no pair of discs for which it is otherwise, at any time";
  claim.tolerance = "none";
  claim.observed = fmt::format("{} pairs of a time and two discs, of which {} meet: {} otherwise", pairs,
                               meeting, different);
  // Of pairs of one kind only nothing is learned.
  claim.verdict = different > 0                       ? lab::Verdict::kRefuted
                  : meeting > 0 && meeting < pairs    ? lab::Verdict::kConfirmed
                                                      : lab::Verdict::kOpen;
  claim.assumptions = {
      "proof: at the share s of the segment the height over the paraboloid is s(1 - s) D^2 - (1 - s) r^2 - "
      "s R^2 for the distance D and the radii r, R, at most 0 for all s if and only if D <= r + R"};
  lab::refute_by_checks(result, claim);
  claim.small_run.structure = kLiftedDiscs;
  claim.small_run.workload = "small-discs";
  claim.small_run = lab::small_run(std::move(claim.small_run));
  report.claims.push_back(std::move(claim));
  report.tables = lab::markdown(result.table);
  return report;
}

}  // namespace kinex::families
