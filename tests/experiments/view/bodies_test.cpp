// SPDX-License-Identifier: GPL-3.0-or-later
// What `kinex view` records and writes of scenes of rigid polygons: the proofs of the run itself,
// after every event, and what their lines and points are on the polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/numbers/real_root.h"
#include "experiments/view/page_data.h"
#include "tests/experiments/view/fixture.h"

namespace kinex {
namespace bodies_test {

using nlohmann::json;
using test::plain_run;
using test::record;

Scene family(const char* name, int n, int m, const std::string& maintain) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  parameters.seed = 3;
  Scene scene = lab::generate_scene(*lab::find_workload(name), parameters);
  formats::set_maintain(scene, {maintain});
  return scene;
}

const char* const kBoth = "separation_mixed,closest_features";

// Two unit squares that meet, part and meet again; `turning`: the second one turns.
Scene meeting(bool turning, const std::string& maintain) {
  const std::string square = R"("polygon": [[0, 0], [1, 0], [1, 1], [0, 1]])";
  Scene scene = formats::parse_scene(
      R"({"kinex": 1, "name": "meet-again", "dimension": 2, "time": {"start": 0, "end": 6},
      "objects": [{"id": "a", )" +
          square + R"(, "motion": [[0], [0]]}, {"id": "b", )" + square +
          R"(, "motion": [[6, -6, 1], ["1/3"]])" +
          (turning ? R"(, "rotor": [[1], [0, "1/3"]])" : "") + "}]}",
      "meet-again");
  formats::set_maintain(scene, {maintain});
  return scene;
}

const char* const kAll =
    "separation_mixed,separation_hysteresis,closest_features,inner_tangents,bounding_volumes";

std::vector<Scene> scenes() {
  return {meeting(true, kAll),
          meeting(false, std::string("separation_minkowski,") + kAll),
          family("polygon-fan", 3, 3, kBoth),
          family("polygon-random", 9, 8, "separation_hysteresis,separation_mixed,inner_tangents"),
          family("polygon-spin-orbit", 6, 5, kBoth),
          family("polygon-approach", 6, 0, "separation_minkowski,bounding_volumes"),
          family("polygons-in-box", 5, 4, "separation_mixed,separation_hysteresis")};
}

// Odd parts of the scene's time, so that no event is at one of them.
std::vector<Rational> times_in(const Scene& scene, int count) {
  std::vector<Rational> times;
  for (int i = 1; i < count; ++i) {
    times.push_back(scene.start + (*scene.end - scene.start) *
                                      Rational(Integer(1009 * i + 1), Integer(1009 * count)));
  }
  return times;
}

std::string name_of(const Scene& scene, const view::RecordedRun& run, ObjectId id) {
  return id < scene.objects.size() ? scene.objects[id].id
                                   : run.things[id - scene.objects.size()].name;
}

TEST(ViewBodies, RunsAreThoseWithoutARecorder) {
  for (const Scene& scene : scenes()) {
    for (const char* arithmetic : {"exact", "double"}) {
      const view::RecordedRun recorded = record(scene, arithmetic);
      EXPECT_EQ(recorded.digest, plain_run(scene, arithmetic, {}).digest)
          << scene.name << " " << arithmetic;
      const auto plain = plain_run(scene, arithmetic, times_in(scene, 20));
      // In doubles a stop on the way can change what follows.
      EXPECT_TRUE(recorded.digest == plain.digest || !recorded.exact) << scene.name;
      if (recorded.digest != plain.digest) continue;
      for (const auto& sample : plain.samples) {
        for (std::size_t i = 0; i < recorded.structures.size(); ++i) {
          const auto value = view::attribute_after(recorded.structures[i], sample.events);
          if (!value) continue;  // corrupt
          EXPECT_EQ(*value, sample.values[i]) << scene.name << " " << arithmetic;
        }
      }
    }
  }
}

// The certificates of another run, which is stopped between two events.
TEST(ViewBodies, ProofsAreTheLiveCertificates) {
  std::size_t compared = 0;
  std::vector<Scene> all = scenes();
  all.push_back(test::busy_scene("sorted_list,delaunay_2,convex_hull_2,maximum_heap"));
  all.push_back(test::workload("uniform-square", 14, "convex_hull_2_brute_force,maximum_hanger"));
  for (const Scene& scene : all) {
    const view::RecordedRun run = record(scene);
    SimulatorOptions options;
    options.audit = AuditLevel::kNone;
    const auto simulator = lab::make_simulator(scene, "exact", options);
    formats::EventLog log(*simulator, "", nullptr);
    simulator->set_sink(&log);
    simulator->start();
    for (const Rational& t : times_in(scene, 30)) {
      simulator->run_until(t);
      const EventQueue& queue = simulator->queue();
      for (StructureId id = 0; id < simulator->structures(); ++id) {
        std::multiset<std::string> live, recorded;
        for (CertificateId c = 0; c < queue.capacity(); ++c) {
          const Certificate& certificate = queue.certificate(c);
          if (!certificate.live || certificate.structure != id) continue;
          const Query query = queue.query(c);
          std::string text(simulator->arithmetic().predicate(query.predicate).name());
          for (std::size_t i = 0; i < query.arity; ++i) {
            text += " " + simulator->object_name(query.ids[i]);
          }
          live.insert(text);
        }
        const view::RecordedProof& proof = run.structures[id].proof;
        for (const std::uint32_t c : view::certificates_after(proof, log.records())) {
          const view::RecordedClaim& claim = run.claims[proof.certificates[c].claim];
          std::string text = run.predicates[claim.predicate];
          for (const ObjectId object : claim.arguments) text += " " + name_of(scene, run, object);
          recorded.insert(text);
        }
        EXPECT_EQ(live, recorded) << scene.name << " " << run.structures[id].label << " at "
                                  << t.to_string();
        compared += live.size();
      }
    }
  }
  EXPECT_GT(compared, 5000u);
}

// A proof that is too large is recorded up to an event, and the run goes on.
TEST(ViewBodies, LargeProofsEnd) {
  const Scene scene = test::workload("uniform-square", 12, "delaunay_2");
  const view::RecordedRun whole = record(scene);
  EXPECT_FALSE(whole.structures[0].proof.ends);
  view::RecordOptions options;
  options.most_visits = 200;
  const view::RecordedRun part = view::record_run(scene, options);
  EXPECT_EQ(part.digest, whole.digest);
  ASSERT_TRUE(part.structures[0].proof.ends);
  const std::uint64_t ends = *part.structures[0].proof.ends;
  EXPECT_LT(ends, whole.events.size());
  EXPECT_EQ(view::certificates_after(part.structures[0].proof, ends),
            view::certificates_after(whole.structures[0].proof, ends));
}

constexpr std::array<ObjectId, 2> kPair{0, 1};

// What the five certificates of a pair in contact are about: an edge of one body at a vertex of the
// other, and the edges at that vertex; of the sum's hierarchy nothing.
void expect_overlap(const view::RecordedRun& run, const view::GroupProof& proof) {
  using Kind = view::FrameFeature::Kind;
  ASSERT_EQ(proof.claims.size(), 5u);
  EXPECT_EQ(proof.state.kind, "overlap");
  const auto claim = [&](std::size_t slot) -> const view::RecordedClaim& {
    return run.claims[proof.claims[slot]];
  };
  const std::string inside = run.predicates[claim(0).predicate];
  EXPECT_TRUE(inside == "inside_a" || inside == "inside_b") << inside;
  const std::size_t z = inside == "inside_a" ? 0 : 1;  // whose edge it is
  const view::FrameFeature line = claim(0).features[1], vertex = claim(0).features[2];
  EXPECT_EQ(line, (view::FrameFeature{Kind::kEdge, line.first, line.first}));
  EXPECT_EQ(vertex, (view::FrameFeature{Kind::kVertex, vertex.first, vertex.first}));
  const std::array<std::uint32_t, 2> ends{line.first, (line.first + 1) % 4};
  for (const std::size_t slot : {1, 2}) {
    EXPECT_EQ(run.predicates[claim(slot).predicate], slot == 1 ? "left_of_ray" : "right_of_ray");
    ASSERT_EQ(claim(slot).features.size(), 5u);
    for (const std::size_t i : {0, 1, 2}) EXPECT_EQ(claim(slot).features[i], view::FrameFeature{});
    const std::uint32_t end = ends[slot - 1];
    EXPECT_EQ(claim(slot).features[3 + z], (view::FrameFeature{Kind::kVertex, end, end}));
    EXPECT_EQ(claim(slot).features[3 + (1 - z)], vertex);
  }
  std::multiset<std::uint32_t> others;
  for (const std::size_t slot : {3, 4}) {
    EXPECT_TRUE(run.predicates[claim(slot).predicate].starts_with("normal_order"));
    EXPECT_EQ(claim(slot).features[1 + z], line);
    EXPECT_EQ(claim(slot).features[1 + (1 - z)].kind, Kind::kEdge);
    others.insert(claim(slot).features[1 + (1 - z)].first);
  }
  EXPECT_EQ(others, (std::multiset<std::uint32_t>{vertex.first, (vertex.first + 3) % 4}));
}

TEST(ViewBodies, FromContactToContact) {
  for (const Scene& scene : {scenes()[0], scenes()[1]}) {
    const view::RecordedRun run = record(scene);
    for (StructureId id = 0; id < run.structures.size(); ++id) {
      const view::RecordedStructure& structure = run.structures[id];
      SCOPED_TRACE(structure.label);
      std::vector<std::string> external;
      std::size_t in_contact = 0;
      bool meet = false;
      for (std::uint64_t k = 1; k <= run.events.size(); ++k) {
        const Event& event = run.events[k - 1].event;
        if (event.structure != id) continue;
        const std::string& kind = structure.kinds[event.kind];
        if (event.external) external.push_back(kind);
        EXPECT_EQ(event.external, kind == "contact" || kind == "separation") << kind;
        if (event.external) meet = kind == "contact";
        EXPECT_EQ(view::attribute_after(structure, k)->ids.empty(), !meet);
        const std::optional<view::GroupProof> proof = view::group_after(structure.proof, kPair, k);
        ASSERT_TRUE(proof);
        if (meet) {
          ++in_contact;
          expect_overlap(run, *proof);
          continue;
        }
        for (const std::uint32_t c : proof->claims) {
          EXPECT_EQ(run.predicates[run.claims[c].predicate].find("_of_ray"), std::string::npos);
        }
      }
      EXPECT_EQ(external,
                (std::vector<std::string>{"contact", "separation", "contact", "separation"}));
      EXPECT_GT(in_contact, 2u);
    }
  }
}

// The same certificate, about a line of the sum before a contact, and about that of an edge in it.
TEST(ViewBodies, LinesOfASumAndOfABody) {
  Scene scene = formats::parse_scene(
      R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 3}, "objects": [
      {"id": "a", "polygon": [[0, 0], [1, 0], [1, 1], [0, 1]], "motion": [[0], [0]]},
      {"id": "b", "polygon": [[0, 0], [1, -1], [1, 0]], "motion": [[3, -3, 1], ["2.1", "-0.6"]]}]})",
      "corner");
  formats::set_maintain(scene, {"separation_minkowski"});
  const view::RecordedRun run = record(scene);
  // What the lines are on the polygons, by predicate and arguments.
  std::map<std::pair<PredicateId, std::vector<ObjectId>>, std::set<view::FrameFeature::Kind>> kinds;
  for (const view::RecordedClaim& claim : run.claims) {
    kinds[{claim.predicate, claim.arguments}].insert(claim.features.at(1).kind);
  }
  const std::set<view::FrameFeature::Kind> both{view::FrameFeature::Kind::kEdge, view::FrameFeature::Kind::kSupport};
  EXPECT_TRUE(std::any_of(kinds.begin(), kinds.end(),
                          [&](const auto& entry) { return entry.second == both; }));
  for (std::uint64_t k = 0; k <= run.events.size(); ++k) {
    const std::optional<view::GroupProof> proof = view::group_after(run.structures[0].proof, kPair, k);
    const view::RecordedClaim& first = run.claims[proof.value().claims.at(0)];
    const bool overlap = proof->state.kind == "overlap";
    EXPECT_EQ(first.features[1].kind,
              overlap ? view::FrameFeature::Kind::kEdge : view::FrameFeature::Kind::kSupport);
  }
}

// The certificate of an event is one of the proof before it.
TEST(ViewBodies, WhatFailsWasPartOfTheProof) {
  for (const Scene& scene : scenes()) {
    const view::RecordedRun run = record(scene);
    for (std::size_t k = 1; k <= run.events.size(); ++k) {
      const Event& event = run.events[k - 1].event;
      if (event.certificate.arity == 0) continue;
      const auto& ids = event.certificate.ids;
      const std::vector<ObjectId> arguments(ids.begin(), ids.begin() + event.certificate.arity);
      const view::RecordedProof& proof = run.structures[event.structure].proof;
      const auto is_it = [&](std::uint32_t c) {
        const view::RecordedClaim& claim = run.claims[proof.certificates[c].claim];
        return claim.predicate == event.certificate.predicate && claim.arguments == arguments;
      };
      const std::vector<std::uint32_t> before = view::certificates_after(proof, k - 1);
      EXPECT_TRUE(std::any_of(before.begin(), before.end(), is_it)) << scene.name << " event " << k;
    }
  }
}

TEST(ViewBodies, PolynomialsVanishAtTheirInstants) {
  const Scene scene = family("polygon-random", 7, 6, kBoth);
  const view::RecordedRun run = record(scene);
  RootCounters counters;
  int seen = 0;
  for (const view::RecordedEvent& event : run.events) {
    if (event.event.certificate.arity == 0) continue;
    const InstantName& name = run.instants[event.instant].name;
    RealRoot root = name.lower == name.upper ? RealRoot(name.lower)
                                             : RealRoot(name.polynomial, name.lower, name.upper);
    const Polynomial& own = event.sign != 0 ? name.polynomial : event.polynomial;
    EXPECT_GT(own.degree(), 0);
    EXPECT_EQ(sign_at(own, root, counters), Sign::kZero) << name.decimal;
    EXPECT_TRUE(event.stages.has_value());
    ++seen;
  }
  EXPECT_GT(seen, 3);
}

TEST(ViewBodies, APartOfARun) {
  const Scene scene = family("polygon-fan", 3, 3, kBoth);
  const view::RecordedRun whole = record(scene);
  view::RecordOptions options;
  options.from = Rational(Integer(2), Integer(3));
  options.max_events = 9;
  const view::RecordedRun part = view::record_run(scene, options);
  ASSERT_GT(part.before, 0u);
  const auto names = [&](const view::RecordedRun& run, std::size_t structure, std::uint64_t k) {
    std::vector<std::string> result;
    const std::optional<view::GroupProof> proof = view::group_after(run.structures[structure].proof, kPair, k);
    for (const std::uint32_t c : proof->claims) {
      for (const ObjectId id : run.claims[c].arguments) result.push_back(name_of(scene, run, id));
    }
    return result;
  };
  for (std::uint64_t k = part.before; k <= part.before + 9; ++k) {
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(names(part, i, k), names(whole, i, k)) << k;
  }
}

TEST(ViewBodies, RunsOfTwoArithmeticsHaveTheSameEvents) {
  const Scene scene = family("polygon-random", 9, 8, kBoth);  // the bodies meet
  const view::RecordedRun exact = record(scene), sturm = record(scene, "sturm");
  EXPECT_EQ(view::first_divergence(exact, sturm), 0u);
  view::RecordedRun other = sturm;
  // A contact or a separation.
  const auto meeting = std::find_if(other.all.rbegin(), other.all.rend(),
                                    [](const Event& event) { return event.count == 4; });
  ASSERT_NE(meeting, other.all.rend());
  // Under another number the same name is the same object.
  other.things.push_back(other.things[meeting->ids[3] - other.objects]);
  meeting->ids[3] = static_cast<ObjectId>(other.objects + other.things.size() - 1);
  EXPECT_EQ(view::first_divergence(exact, other), 0u);
  // The same bodies meet by another feature.
  other.things.push_back({"b.v99", {}, {}});
  meeting->ids[3] = static_cast<ObjectId>(other.objects + other.things.size() - 1);
  EXPECT_EQ(view::first_divergence(exact, other), static_cast<std::uint64_t>(other.all.rend() - meeting));
}

// Drawn poses agree with exact ones.
TEST(ViewBodies, PosesAreThoseOfTheScene) {
  for (const Scene& scene : scenes()) {
    const json data = json::parse(view::page_data(scene, "hash", {record(scene)}));
    const double scale = data["scale"].get<double>();
    for (const Rational& t : times_in(scene, 12)) {
      const double u = ((t - scene.start) / (*scene.end - scene.start)).to_double();
      for (ObjectId body = 0; body < scene.objects.size(); ++body) {
        const MotionPiece* piece = scene.objects[body].motion.piece_after(t);
        std::vector<double> drawn;
        for (const json& p : data["motions"][body]) {
          const bool holds = (p[0].is_null() || p[0].get<double>() <= u) &&
                             (p[1].is_null() || u < p[1].get<double>());
          if (!holds) continue;
          drawn.clear();
          for (const json& c : p[2]) {
            double value = 0, power = 1;
            for (const json& x : c) {
              value += x.get<double>() * power;
              power *= u;
            }
            drawn.push_back(value);
          }
        }
        ASSERT_EQ(drawn.size(), 4u);
        const auto exact = [&](int axis) {
          return piece->trajectory.position(axis, t).to_double();
        };
        EXPECT_NEAR(drawn[0] * scale, exact(0), 1e-9 * scale);
        EXPECT_NEAR(drawn[1] * scale, exact(1), 1e-9 * scale);
        // The same rotor up to a positive factor.
        EXPECT_NEAR(drawn[2] * exact(3), drawn[3] * exact(2), 1e-9);
        EXPECT_GT(drawn[2] * exact(2) + drawn[3] * exact(3), 0);
        for (std::size_t i = 0; i < scene.objects[body].polygon.size(); ++i) {
          const json& vertex = data["polygons"][body][i];
          EXPECT_NEAR(vertex[0].get<double>() * scale,
                      scene.objects[body].polygon[i][0].to_double(), 1e-12 * scale);
        }
      }
    }
  }
}

// A page of points has a proof, and nothing about polygons.
TEST(ViewBodies, PagesOfPointsHaveProofs) {
  const Scene scene = test::workload("uniform-square", 8, "delaunay_2");
  const json data = json::parse(view::page_data(scene, "hash", {record(scene)}));
  EXPECT_FALSE(data.contains("polygons") || data.contains("things"));
  const json& run = data["runs"][0];
  ASSERT_EQ(run["proofs"].size(), 1u);
  const json& proof = run["proofs"][0];
  EXPECT_EQ(run["forms"].size(), run["predicates"].size());
  EXPECT_EQ(proof["changes"][0][0], 0);
  EXPECT_EQ(proof["changes"][0][2].size(), 3u * 8u - 3u);  // an edge each, and one a hull vertex
  for (const json& certificate : proof["certificates"]) {
    const json& claim = run["claims"][certificate[3].get<std::size_t>()];
    const json& form = run["forms"][claim[0].get<std::size_t>()];
    EXPECT_EQ(claim[1].size(), form[4].size());
    EXPECT_TRUE(form[0] == "circle" || form[0] == "turn") << form;
  }
}

std::vector<Rational> numbers(std::vector<int> values) { return {values.begin(), values.end()}; }

TEST(FrameFeature, LinesOfASquareAndATriangle) {
  using Kind = view::FrameFeature::Kind;
  const std::vector<Vertex2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const auto line = [&](std::vector<int> l, bool negated = false) {
    return view::line_feature(square, negated, numbers(std::move(l)));
  };
  EXPECT_EQ(line({0, -1, 0}), (view::FrameFeature{Kind::kEdge, 0, 0}));
  EXPECT_EQ(line({1, 0, 2}), (view::FrameFeature{Kind::kEdge, 1, 1}));
  EXPECT_EQ(line({-1, 0, 0}), (view::FrameFeature{Kind::kEdge, 3, 3}));  // from the last to the first
  EXPECT_EQ(line({1, 1, 4}), (view::FrameFeature{Kind::kVertex, 2, 2}));
  EXPECT_EQ(line({-3, -1, 0}), (view::FrameFeature{Kind::kVertex, 0, 0}));
  // Across edge 0 at its first end; at its last end that is the line of edge 1.
  EXPECT_EQ(line({1, 0, 0}), (view::FrameFeature{Kind::kAcross, 0, 0}));
  EXPECT_EQ(line({1, 1, 3}), (view::FrameFeature{Kind::kSupport, 2, 2}));
  EXPECT_EQ(line({0, 1, 9}), (view::FrameFeature{Kind::kSupport, 2, 3}));
  // Negated the square lies in [-2, 0]^2, its vertex 2 at (-2, -2).
  EXPECT_EQ(line({-1, -1, 4}, true), (view::FrameFeature{Kind::kVertex, 2, 2}));
  EXPECT_EQ(line({0, 1, 0}, true), (view::FrameFeature{Kind::kEdge, 0, 0}));
  EXPECT_EQ(view::support_feature(square, true, {Rational(1), Rational(0)}),
            (view::FrameFeature{Kind::kSupport, 3, 0}));
}

TEST(FrameFeature, PointsOfASquare) {
  using Kind = view::FrameFeature::Kind;
  const std::vector<Vertex2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const auto point = [&](std::vector<int> p, bool negated = false) {
    return view::point_feature(square, negated, numbers(std::move(p)));
  };
  EXPECT_EQ(point({2, 0, 1}), (view::FrameFeature{Kind::kVertex, 1, 1}));
  EXPECT_EQ(point({6, 6, 3}), (view::FrameFeature{Kind::kVertex, 2, 2}));
  EXPECT_EQ(point({-2, -2, 1}, true), (view::FrameFeature{Kind::kVertex, 2, 2}));
  EXPECT_EQ(point({1, -1, 1}), (view::FrameFeature{Kind::kCorner, 0, 1}));
  EXPECT_EQ(point({3, -1, 1}), (view::FrameFeature{Kind::kCorner, 0, 2}));
  EXPECT_EQ(point({-1, 1, 1}), (view::FrameFeature{Kind::kCorner, 3, 0}));
  EXPECT_EQ(point({-1, -1, 1}), (view::FrameFeature{Kind::kCorner, 3, 1}));
  // On the line of an edge: only what it sees.
  EXPECT_EQ(point({3, 0, 1}), (view::FrameFeature{Kind::kCorner, 1, 2}));
  EXPECT_EQ(point({1, 1, 1}), view::FrameFeature{});
  EXPECT_EQ(point({1, 0, 1}), view::FrameFeature{});
}

// A group that comes, changes, loses a certificate and ends.
TEST(ViewBodies, GroupAfter) {
  view::RecordedProof proof;
  const auto certificate = [&](std::uint32_t group, std::uint32_t slot, std::uint32_t claim) {
    view::RecordedCertificate& made = proof.certificates.emplace_back();
    made.group = group;
    made.slot = slot;
    made.claim = claim;
  };
  const auto state = [&](std::uint32_t group, std::vector<ObjectId> about, const char* text) {
    view::RecordedGroup& made = proof.groups.emplace_back();
    made.group = group;
    made.state.about = std::move(about);
    made.state.text = text;
  };
  certificate(0, 1, 5);
  certificate(0, 0, 4);
  certificate(1, 0, 6);
  state(0, {0, 1}, "first");
  state(1, {0, 2}, "other");
  state(0, {0, 1}, "second");
  proof.changes = {{3, {}, {0, 1, 2}, {0, 1}, {}}, {7, {0}, {}, {2}, {}}, {9, {1}, {}, {}, {0}}};
  const auto at = [&](std::uint64_t event) { return view::group_after(proof, kPair, event); };
  EXPECT_FALSE(at(2));
  EXPECT_EQ(at(3).value().claims, (std::vector<std::uint32_t>{4, 5}));
  EXPECT_EQ(at(6).value().state.text, "first");
  EXPECT_EQ(at(7).value().state.text, "second");
  EXPECT_EQ(at(8).value().claims, (std::vector<std::uint32_t>{4}));
  EXPECT_FALSE(at(100));
  EXPECT_EQ(view::certificates_after(proof, 100), (std::vector<std::uint32_t>{2}));
}

}  // namespace bodies_test
}  // namespace kinex
