// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/peers/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/families/collision/contact_witness.h"

namespace kinex::peers {

namespace {

constexpr double kPieceTurn = 0.1;
// The limit on vertices times edges times pieces for the witness: without turns, with turns.
constexpr std::size_t kWitnessWork[] = {20000, 2000};

Rational exactly(double x) { return *Rational::from_double(x); }

std::vector<Vertex2> polygon_of(const PeerShape& shape, const Rational& scale) {
  std::vector<Vertex2> polygon;
  for (const auto& v : shape) polygon.push_back({scale * exactly(v[0]), scale * exactly(v[1])});
  return polygon;
}

// c(from) = value, c(to) = next, linear in t.
std::vector<Rational> line(const Rational& from, const Rational& to, const Rational& value,
                           const Rational& next) {
  const Rational rate = (next - value) / (to - from);
  return {value - rate * from, rate};
}

std::int64_t parts_of(const PeerCase& question) {
  if (question.turns_alike()) return 1;
  return std::max<std::int64_t>(1, std::llround(std::ceil(question.largest_turn() / kPieceTurn)));
}

Motion motion_of(const PeerCase& question, PeerPose PeerFrame::*body) {
  const std::int64_t spans = static_cast<std::int64_t>(question.frames.size()) - 1;
  const std::int64_t parts = parts_of(question);
  Motion motion;
  for (std::int64_t k = 0; k < spans; ++k) {
    const PeerPose& p = question.frames[static_cast<std::size_t>(k)].*body;
    const PeerPose& q = question.frames[static_cast<std::size_t>(k) + 1].*body;
    const Rational begin = Rational(k) / Rational(spans), end = Rational(k + 1) / Rational(spans);
    for (std::int64_t j = 0; j < parts; ++j) {
      const auto at = [&](std::int64_t i) {
        return begin + (end - begin) * Rational(i) / Rational(parts);
      };
      const auto half = [&](std::int64_t i) {
        if (i == parts) return q.angle / 2;
        return (p.angle +
                (q.angle - p.angle) * static_cast<double>(i) / static_cast<double>(parts)) /
               2;
      };
      Trajectory trajectory{
          {line(begin, end, exactly(p.x), exactly(q.x)),
           line(begin, end, exactly(p.y), exactly(q.y)),
           line(at(j), at(j + 1), exactly(std::cos(half(j))), exactly(std::cos(half(j + 1)))),
           line(at(j), at(j + 1), exactly(std::sin(half(j))), exactly(std::sin(half(j + 1))))}};
      trajectory.normalise();
      MotionPiece piece{at(j), at(j + 1), std::move(trajectory)};
      if (motion.pieces.empty()) piece.from = std::nullopt;
      if (k + 1 == spans && j + 1 == parts) piece.to = std::nullopt;
      motion.pieces.push_back(std::move(piece));
    }
  }
  return motion;
}

double nearly(RealRoot root) {
  RootCounters counters;
  while ((root.upper() - root.lower()).to_double() > 1e-14) root.refine(counters);
  return root.lower().to_double();
}

std::optional<double> first_overlap(const Scene& scene, bool turns, bool& by_witness) {
  const std::optional<double> contact = run_ours(scene, "separation_mixed", "exact").contact;
  const SceneObject& a = scene.objects[0];
  const SceneObject& b = scene.objects[1];
  by_witness =
      a.polygon.size() * b.polygon.size() * b.motion.pieces.size() <= kWitnessWork[turns ? 1 : 0];
  std::optional<double> other;
  if (by_witness) {
    const families::CollisionWitness witness = families::find_contacts(a, b, scene.start, scene.end);
    if (witness.penetration() != nullptr) {
      other = nearly(witness.penetration()->instant);
    }
  } else {
    const char* structure = turns ? "separation_hysteresis" : "separation_minkowski";
    other = run_ours(scene, structure, "exact").contact;
  }
  if (contact.has_value() != other.has_value() ||
      (contact && std::abs(*contact - *other) > 1e-12)) {
    throw std::logic_error(scene.name + ": separation_mixed and its check disagree");
  }
  return contact;
}

// For bodies that never overlap: the exact witness runs only if slightly enlarged bodies do.
bool touches(const PeerCase& question) {
  const Rational larger = Rational(1) + Rational(1, Integer::power_of_two(60));
  if (!run_ours(scene_of(question, larger), "separation_mixed", "exact").contact) return false;
  const Scene scene = scene_of(question);
  return !families::find_contacts(scene.objects[0], scene.objects[1], scene.start, scene.end).grazes.empty();
}

}  // namespace

Scene scene_of(const PeerCase& question, const Rational& scale) {
  Scene scene;
  scene.name = question.family + ", " + question.name;
  scene.dimension = 2;
  scene.start = 0;
  scene.end = 1;
  scene.objects.push_back({"a", motion_of(question, &PeerFrame::a), polygon_of(question.a, 1)});
  scene.objects.push_back({"b", motion_of(question, &PeerFrame::b), polygon_of(question.b, scale)});
  return scene;
}

Truth find_truth(const PeerCase& question) {
  Truth truth;
  if (!question.turns() || question.turns_alike()) {
    const Scene scene = scene_of(question);
    const auto contact = first_overlap(scene, question.turns(), truth.by_witness);
    truth.kind = contact             ? TruthKind::kOverlap
                 : touches(question) ? TruthKind::kTouch
                                     : TruthKind::kApart;
    truth.earliest = truth.latest = contact.value_or(0);
    if (contact && question.turns()) truth.latest = 1;
    return truth;
  }
  const double part = question.largest_turn() / static_cast<double>(parts_of(question));
  const double off =
      (0.0042 * part * part * part + 1e-15) * (outer_radius(question.a) + outer_radius(question.b));
  const Rational grow = exactly(1.001 * off / inner_radius(question.b));
  bool second = false;
  const auto larger = first_overlap(scene_of(question, Rational(1) + grow), true, truth.by_witness);
  const auto smaller =
      larger ? first_overlap(scene_of(question, Rational(1) - grow), true, second) : std::nullopt;
  truth.kind = !larger ? TruthKind::kApart : smaller ? TruthKind::kOverlap : TruthKind::kUnknown;
  truth.earliest = larger.value_or(0);
  truth.latest = smaller.value_or(1);
  return truth;
}

}  // namespace kinex::peers
