// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `kinex view` as text: its data, and that nothing in a scene can break it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "experiments/view/page.h"
#include "experiments/view/page_data.h"
#include "tests/experiments/view/fixture.h"

namespace kinex {
namespace page_test {

using nlohmann::json;
using test::busy_scene;
using test::record;
using test::workload;
using testing::HasSubstr;
using testing::Not;

json data_of(const Scene& scene, const std::vector<view::RecordedRun>& runs) {
  return json::parse(view::page_data(scene, formats::scene_hash(scene), runs));
}

TEST(ViewPage, DataHoldsWhatWasRecorded) {
  const Scene scene = workload("uniform-square", 9, "sorted_list,delaunay_2,maximum_tournament");
  const view::RecordedRun run = record(scene);
  const json data = data_of(scene, {run});
  EXPECT_EQ(data["format"], "kinex-view");
  EXPECT_EQ(data["scene"]["hash"], formats::scene_hash(scene));
  EXPECT_EQ(data["ids"].size(), 9u);
  const json& first = data["runs"][0];
  for (const char* column : {"u", "s", "k", "x", "ids", "certificates", "i", "p", "g"}) {
    EXPECT_EQ(first[column].size(), run.events.size()) << column;
  }
  double last = 0;
  for (const json& u : first["u"]) {
    EXPECT_GE(u.get<double>(), last);
    last = u.get<double>();
  }
  EXPECT_LE(last, 1.0);
  const char* const shapes[] = {"sequence", "tuples", "object"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(data["structures"][i]["shape"], shapes[i]);
    EXPECT_EQ(data["structures"][i]["key"].is_null(), i == 1);
    EXPECT_EQ(first["states"][i]["initial"].get<std::vector<ObjectId>>(),
              run.structures[i].initial.ids);
    EXPECT_EQ(first["states"][i]["changes"].size(), run.structures[i].changes.size());
  }
  for (std::size_t e = 0; e < run.events.size(); ++e) {
    const json& certificate = first["certificates"][e];
    EXPECT_EQ(certificate[1].size(), run.events[e].event.certificate.arity);
    const json& instant = first["instants"][run.events[e].instant];
    EXPECT_EQ(instant[0], run.instants[run.events[e].instant].name.decimal);
    EXPECT_EQ(instant.size(), 5u);
  }
}

// Certificates of lines are about slopes, not about the points that stand for lines.
TEST(ViewPage, CertificatesOfLinesAreInTheirWords) {
  const auto words_of_order_x = [](const Scene& scene) -> std::string {
    const json data = data_of(scene, {record(scene)});
    const json& run = data["runs"][0];
    for (std::size_t i = 0; i < run["predicates"].size(); ++i) {
      if (run["predicates"][i] == "order_x") return run["forms"][i][2];
    }
    return "";
  };
  EXPECT_EQ(words_of_order_x(workload("random-lines", 4, "line_arrangement_2")),
            "the slope of {0} is at most that of {1}");
  EXPECT_EQ(words_of_order_x(workload("uniform-square", 4, "sorted_list")),
            "{0} is not beyond {1} on the axis");
}

// Drawn positions agree with exact ones.
TEST(ViewPage, MotionsAreThoseOfTheScene) {
  const Scene scene = busy_scene("delaunay_2");
  const json data = data_of(scene, {record(scene)});
  const double scale = data["scale"].get<double>();
  for (int i = 0; i < 40; ++i) {
    const Rational t(Integer(i), Integer(10));
    const double u = i / 40.0;
    for (ObjectId object = 0; object < scene.objects.size(); ++object) {
      const MotionPiece* piece = scene.objects[object].motion.piece_after(t);
      const json* drawn = nullptr;
      for (const json& p : data["motions"][object]) {
        const bool from = p[0].is_null() || p[0].get<double>() <= u;
        if (from && (p[1].is_null() || u < p[1].get<double>())) drawn = &p;
      }
      ASSERT_EQ(piece == nullptr, drawn == nullptr) << object << " at " << i;
      if (piece == nullptr) continue;
      for (int axis = 0; axis < 2; ++axis) {
        double value = 0, power = 1;
        for (const json& c : (*drawn)[2][static_cast<std::size_t>(axis)]) {
          value += c.get<double>() * power;
          power *= u;
        }
        EXPECT_NEAR(value * scale, piece->trajectory.position(axis, t).to_double(), 1e-12);
      }
    }
  }
}

TEST(ViewPage, SameInputSameBytes) {
  const Scene scene = workload("grid", 16, "delaunay_2");
  const std::vector<view::RecordedRun> once{record(scene), record(scene, "double")};
  const std::vector<view::RecordedRun> twice{record(scene), record(scene, "double")};
  EXPECT_EQ(view::page_data(scene, "h", once), view::page_data(scene, "h", twice));
}

TEST(ViewPage, NumbersBeyondDoubles) {
  Scene scene = formats::parse_scene(R"({"kinex": 1, "name": "far", "dimension": 2,
    "time": {"start": "1e400", "end": "2e400"},
    "objects": [
      {"id": "a", "motion": [["1e4000"], [0]]},
      {"id": "b", "motion": [[0, "1e3600"], [1]]},
      {"id": "c", "motion": [["1e-3000"], [2, "1e-500"]]}]})",
                            "far");
  formats::set_maintain(scene, {"sorted_list,delaunay_2"});
  const json data = data_of(scene, {record(scene)});  // no inf and no nan: they are no JSON
  EXPECT_TRUE(data["scale"].is_null());
  EXPECT_TRUE(data["time"]["span"].is_null());
  for (const json& pieces : data["motions"]) {
    for (const json& c : pieces[0][2]) {
      for (const json& x : c) EXPECT_LE(std::abs(x.get<double>()), 1.0);
    }
  }
}

TEST(ViewPage, EmptyAndEndlessScenes) {
  Scene nothing = formats::parse_scene(
      R"({"kinex": 1, "name": "n", "dimension": 2, "time": {"start": 0, "end": 1}, "objects": []})",
      "n");
  formats::set_maintain(nothing, {"sorted_list,delaunay_2,maximum_heap"});
  EXPECT_EQ(data_of(nothing, {record(nothing)})["runs"][0]["u"].size(), 0u);
  Scene endless = formats::parse_scene(R"({"kinex": 1, "name": "e", "dimension": 1, "time": {"start": 0},
    "objects": [{"id": "a", "motion": [[0, 1]]}, {"id": "b", "motion": [[8]]}]})",
                              "e");
  formats::set_maintain(endless, {"sorted_list"});
  const json data = data_of(endless, {record(endless)});
  EXPECT_NEAR(data["time"]["span"].get<double>(), 8.4, 1e-9);
  EXPECT_NEAR(data["runs"][0]["u"][0].get<double>(), 1 / 1.05, 1e-9);
}

TEST(ViewPage, NamesCannotBreakThePage) {
  Scene scene = formats::parse_scene(R"({"kinex": 1, "name": "</title>@DATA@<script>", "dimension": 1,
    "time": {"start": 0, "end": 1},
    "objects": [{"id": "</script><img src=x>", "motion": [[0]]}, {"id": "@TITLE@@SCRIPT@",
    "motion": [["-1/2", 1]]}]})",
                            "names");
  formats::set_maintain(scene, {"sorted_list"});
  const std::string page =
      view::view_page("kinex view: " + scene.name, view::page_data(scene, "", {record(scene)}));
  EXPECT_THAT(page, HasSubstr("<title>kinex view: &lt;/title&gt;@DATA@&lt;script&gt;</title>"));
  EXPECT_THAT(page, HasSubstr("\\u003c/script>\\u003cimg src=x>"));
  EXPECT_THAT(page, HasSubstr("\"@TITLE@@SCRIPT@\""));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  const std::string mark = "id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const json data = json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(data["ids"][0], "</script><img src=x>");
}

// No network: nothing in the page's own files names another place.
TEST(ViewPage, LoadsNothing) {
  for (const std::string_view part : {view::kViewFrame, view::kViewStyle, view::kViewScript}) {
    EXPECT_THAT(std::string(part), Not(HasSubstr("http:")));
    EXPECT_THAT(std::string(part), Not(HasSubstr("https:")));
    EXPECT_THAT(std::string(part), Not(HasSubstr("import")));
  }
  EXPECT_THAT(std::string(view::kViewFrame), HasSubstr("default-src 'none'"));
}

}  // namespace page_test
}  // namespace kinex
