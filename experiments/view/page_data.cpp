// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/page_data.h"

#include <algorithm>
#include <utility>

#include "experiments/formats/event_log.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/binary_scale.h"
#include "experiments/lab/machine.h"
#include "experiments/view/data_writer.h"
#include "experiments/view/drawn_motions.h"
#include "experiments/view/proof_data.h"

namespace kinex::view {

namespace {

std::string_view shape_name(Attribute::Shape shape) {
  switch (shape) {
    case Attribute::Shape::kSequence:
      return "sequence";
    case Attribute::Shape::kObject:
      return "object";
    case Attribute::Shape::kTuples:
      return "tuples";
    case Attribute::Shape::kCycle:
      return "cycle";
    case Attribute::Shape::kOrders:
      return "orders";
  }
  return "";
}

// The time shown: to the end of the scene, or a little beyond the last event.
Rational shown_span(const Scene& scene, const std::vector<RecordedRun>& runs) {
  const Rational& start = runs.front().start;
  const bool complete =
      std::all_of(runs.begin(), runs.end(), [](const RecordedRun& run) { return run.complete; });
  if (scene.end && complete) return *scene.end - start;
  Rational span;
  for (const RecordedRun& run : runs) {
    for (const RecordedInstant& instant : run.instants) {
      if (instant.near && span < *instant.near - start) span = *instant.near - start;
    }
  }
  if (span.is_zero()) return scene.end ? *scene.end - start : Rational(1);
  if (!scene.end) span *= Rational(Integer(21), Integer(20));
  return span;
}

void write_motions(formats::JsonWriter& json, const Scene& scene, const DrawnMotions& motions) {
  json.key("scale");
  write_double(json, motions.scale);
  json.key("ids").begin_array();
  for (const SceneObject& object : scene.objects) json.string(object.id);
  json.end_array().key("motions").begin_array();
  for (const std::vector<DrawnPiece>& pieces : motions.objects) {
    json.begin_array();
    for (const DrawnPiece& piece : pieces) {
      json.begin_array();
      write_double(json, piece.from);
      write_double(json, piece.to);
      json.begin_array();
      for (const std::vector<double>& c : piece.coordinates) {
        json.begin_array();
        for (const double x : c) write_double(json, x);
        json.end_array();
      }
      json.end_array().end_array();
    }
    json.end_array();
  }
  json.end_array();
}

void write_polygons(formats::JsonWriter& json, const DrawnMotions& motions) {
  json.key("polygons").begin_array();
  for (const auto& polygon : motions.polygons) {
    json.begin_array();
    for (const auto& vertex : polygon) {
      json.begin_array();
      for (const double x : vertex) write_double(json, x);
      json.end_array();
    }
    json.end_array();
  }
  json.end_array();
}

// For drawing: {"axis": A}, {"weights": [..]} of largest absolute value 1, {"object": O}.
void write_key(formats::JsonWriter& json, const RecordedStructure& structure, const Scene& scene) {
  if (!structure.has_key) {
    json.null();
    return;
  }
  const Key& key = structure.key;
  json.begin_object().key("text").string(formats::key_json(key, scene));
  switch (key.kind) {
    case Key::Kind::kCoordinate:
      json.key("axis").number(key.axis);
      break;
    case Key::Kind::kDirection: {
      Rational largest(0);
      for (const Rational& x : key.direction) largest = std::max(largest, lab::absolute(x));
      json.key("weights").begin_array();
      for (const Rational& x : key.direction) {
        write_double(json, largest.is_zero() ? 0.0 : (x / largest).to_double());
      }
      json.end_array().key("size");
      write_double(json, largest.to_double());
      break;
    }
    case Key::Kind::kSquaredDistance:
      json.key("object").number(std::uint64_t{key.object});
      break;
  }
  json.end_object();
}

void write_directions(formats::JsonWriter& json, const RecordedStructure& structure) {
  json.key("directions").begin_array();
  for (const std::vector<Rational>& vector : structure.directions) {
    json.begin_array();
    for (const Rational& c : vector) write_double(json, c.to_double());
    json.end_array();
  }
  json.end_array();
}

void write_members(formats::JsonWriter& json, const RecordedStructure& structure) {
  if (structure.members.empty()) return;
  json.key("members").begin_array();
  for (std::size_t object = 0; object < structure.members.size(); ++object) {
    if (structure.members[object]) json.number(std::uint64_t{object});
  }
  json.end_array();
}

// The names of the colours, and of each object the place of its own among them or -1.
void write_colours(formats::JsonWriter& json, const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneObject& object : scene.objects) {
    if (!object.colour.empty()) names.push_back(object.colour);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (names.empty()) return;
  json.key("colours");
  write_texts(json, names);
  json.key("colour_of").begin_array();
  for (const SceneObject& object : scene.objects) {
    const auto place = std::lower_bound(names.begin(), names.end(), object.colour);
    json.number(object.colour.empty() ? -1 : static_cast<int>(place - names.begin()));
  }
  json.end_array();
}

void write_structures(formats::JsonWriter& json, const RecordedRun& run, const Scene& scene) {
  json.key("structures").begin_array();
  for (const RecordedStructure& structure : run.structures) {
    json.begin_object().key("label").string(structure.label).key("name").string(structure.name);
    json.key("role").string(structure.role);
    if (!structure.directions.empty()) write_directions(json, structure);
    write_members(json, structure);
    if (structure.query != kNoObject) json.key("query").number(std::uint64_t{structure.query});
    json.key("shape").string(shape_name(structure.initial.shape));
    json.key("width").number(int{structure.initial.width}).key("key");
    write_key(json, structure, scene);
    json.key("kinds");
    write_texts(json, structure.kinds);
    json.key("meanings");
    write_texts(json, structure.meanings);
    json.key("own").number(std::uint64_t{structure.kinds.size() - kCommonEvents});
    json.end_object();
  }
  json.end_array();
}

// The places of ids in the certificate's, as digits; or the ids, where some are not there.
template <class Range>
void write_places(formats::JsonWriter& json, const Range& ids, const Query& certificate) {
  static_assert(kMaxArity <= 10, "a place is a digit");
  std::string places;
  for (const ObjectId id : ids) {
    const auto end = certificate.ids.begin() + certificate.arity;
    const auto found = std::find(certificate.ids.begin(), end, id);
    if (found == end) return write_ids(json, ids);
    places += static_cast<char>('0' + (found - certificate.ids.begin()));
  }
  if (places.empty()) return write_ids(json, ids);
  json.string(places);
}

void write_states(formats::JsonWriter& json, const RecordedRun& run) {
  json.key("states").begin_array();
  for (const RecordedStructure& structure : run.structures) {
    json.begin_object().key("initial");
    write_ids(json, structure.initial.ids);
    json.key("changes").begin_array();
    for (const AttributeChange& change : structure.changes) {
      json.begin_array().number(change.event).number(std::uint64_t{change.at});
      const bool recorded =
          change.event > run.before && change.event - run.before <= run.events.size();
      const Query none{};
      const Query& certificate =
          recorded ? run.events[change.event - run.before - 1].event.certificate : none;
      write_places(json, change.removed, certificate);
      write_places(json, change.added, certificate);
      json.end_array();
    }
    json.end_array().key("corrupt");
    if (structure.corrupt_after) {
      json.begin_array().number(*structure.corrupt_after).string(structure.corruption).end_array();
    } else {
      json.null();
    }
    json.end_object();
  }
  json.end_array();
}

void write_polynomial(formats::JsonWriter& json, const Polynomial& p) {
  json.begin_array();
  for (const Integer& c : p.coefficients()) json.string(c.to_string());
  json.end_array();
}

void write_instants(formats::JsonWriter& json, const RecordedRun& run) {
  json.key("instants").begin_array();
  for (const auto& [name, near] : run.instants) {
    json.begin_array().string(name.decimal);
    if (name.exact) {
      std::string coefficients;
      for (const Integer& c : name.polynomial.coefficients()) {
        coefficients += (coefficients.empty() ? "" : " ") + c.to_string();
      }
      json.string(coefficients)
          .number(name.root)
          .string(name.lower.to_string())
          .string(name.upper.to_string());
    }
    json.end_array();
  }
  json.end_array();
}

class EventColumns {
 public:
  EventColumns(formats::JsonWriter& json, const RecordedRun& run) : json_(json), run_(run) {}

  template <class Write>
  EventColumns& column(const char* name, const Write& write) {
    json_.key(name).begin_array();
    for (const RecordedEvent& event : run_.events) write(event);
    json_.end_array();
    return *this;
  }

 private:
  formats::JsonWriter& json_;
  const RecordedRun& run_;
};

// Times for drawing, in units of the span, made non-decreasing even for corrupt runs in doubles.
std::vector<double> drawn_times(const RecordedRun& run, const Rational& span) {
  std::vector<double> times;
  double last = 0;
  for (const auto& [name, near] : run.instants) {
    if (near) last = std::max(last, ((*near - run.start) / span).to_double());
    times.push_back(std::min(last, 1.0));
  }
  return times;
}

void write_events(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things, const Rational& span) {
  const std::vector<double> times = drawn_times(run, span);
  const auto ids = [&](const auto& list, std::size_t count) {
    std::vector<ObjectId> shown;
    for (std::size_t i = 0; i < count; ++i) shown.push_back(things.shown(index, list[i]));
    return shown;
  };
  const auto shown_certificate = [&](const RecordedEvent& e) {
    Query shown = e.event.certificate;
    for (std::size_t i = 0; i < shown.arity; ++i) shown.ids[i] = things.shown(index, shown.ids[i]);
    return shown;
  };
  std::uint64_t last = 0;  // instant
  EventColumns(json, run)
      .column("u", [&](const RecordedEvent& e) { write_double(json, times[e.instant]); })
      .column("s", [&](const RecordedEvent& e) { json.number(int{e.event.structure}); })
      .column("k", [&](const RecordedEvent& e) { json.number(int{e.event.kind}); })
      .column("x", [&](const RecordedEvent& e) { json.number(e.event.external ? 1 : 0); })
      .column("ids",
              [&](const RecordedEvent& e) {
                write_places(json, ids(e.event.ids, e.event.count), shown_certificate(e));
              })
      .column("certificates",
              [&](const RecordedEvent& e) {
                const Query& query = e.event.certificate;
                if (query.arity == 0) {
                  json.number(0);
                  return;
                }
                json.begin_array().number(int{query.predicate});
                write_ids(json, ids(query.ids, query.arity));
                json.end_array();
              })
      .column(
          "i",
          [&](const RecordedEvent& e) { json.number(e.instant - std::exchange(last, e.instant)); })
      .column("p",
              [&](const RecordedEvent& e) {
                if (e.event.certificate.arity == 0 || e.sign != 0) {
                  json.number(e.sign);
                } else {
                  write_polynomial(json, e.polynomial);
                }
              })
      .column("g", [&](const RecordedEvent& e) {
        if (!e.stages) {
          json.number(0);
        } else {
          json.begin_array().string(stage_name(e.stages->found));
          json.string(stage_name(e.stages->ordered)).end_array();
        }
      });
  json.key("reasons").begin_object();
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    if (run.events[i].reason.empty()) continue;
    json.key(std::to_string(run.before + i + 1)).string(run.events[i].reason);
  }
  json.end_object().key("differences").begin_object();
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const RecordedEvent& event = run.events[i];
    if (event.gone.empty() && event.came.empty()) continue;
    json.key(std::to_string(run.before + i + 1)).begin_array();
    write_ids(json, ids(event.gone, event.gone.size()));
    write_ids(json, ids(event.came, event.came.size()));
    json.end_array();
  }
  json.end_object();
}

void write_queries(formats::JsonWriter& json, const RecordedRun& run, const Rational& span,
                   const Rational& scale) {
  json.key("queries").begin_array();
  for (const auto& [query, answers] : run.queries) {
    json.begin_object().key("u");
    write_double(json, ((query.at - run.start) / span).to_double());
    json.key("at").string(query.at.to_string()).key("box").begin_array();
    for (const auto& side : query.box) {
      json.begin_array();
      for (const Rational& x : side) write_double(json, (x / scale).to_double());
      json.end_array();
    }
    json.end_array().key("answers").begin_array();
    for (const RecordedQuery::Answer& answer : answers) {
      json.begin_array().number(std::uint64_t{answer.structure});
      write_ids(json, answer.ids);
      json.begin_array();
      for (const NodeLookedAt& node : answer.nodes) {
        json.begin_array().number(static_cast<int>(node.place));
        write_ids(json, node.objects);
        json.end_array();
      }
      json.end_array().number(answer.looked_at).end_array();
    }
    json.end_array().end_object();
  }
  json.end_array();
}

void write_run(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
               const ShownThings& things, const Rational& span, const Rational& scale) {
  json.begin_object().key("arithmetic").string(run.arithmetic).key("exact").boolean(run.exact);
  json.key("before").number(run.before).key("stopped").string(run.stopped).key("predicates");
  write_texts(json, run.predicates);
  write_events(json, run, index, things, span);
  write_instants(json, run);
  write_states(json, run);
  write_queries(json, run, span, scale);
  write_proofs(json, run, index, things, span, scale);
  json.end_object();
}

}  // namespace

std::string page_data(const Scene& scene, const std::string& hash,
                      const std::vector<RecordedRun>& runs) {
  const Rational span = shown_span(scene, runs);
  const Rational& start = runs.front().start;
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("format").string("kinex-view").key("version").number(1);
  json.key("program")
      .string(formats::build_name() + " at " + lab::commit_text(lab::build_facts()))
      .key("scene")
      .begin_object();
  json.key("name").string(scene.name).key("hash").string(hash);
  json.key("dimension").number(scene.dimension);
  if (scene.extents == Extents::kWeight) json.key("weights").boolean(true);
  if (scene.has_lines()) {
    json.key("lines").begin_array();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      if (scene.objects[i].line) json.number(static_cast<int>(i));
    }
    json.end_array();
  }
  write_colours(json, scene);
  json.end_object();
  json.key("time").begin_object().key("start").begin_array().string(start.to_string());
  write_double(json, start.to_double());
  json.end_array().key("span");
  write_double(json, span.to_double());
  json.end_object();
  const DrawnMotions motions = drawn_motions(scene, start, span);
  const ShownThings things(runs);
  write_motions(json, scene, motions);
  if (scene.has_bodies()) write_polygons(json, motions);
  if (scene.has_bodies() || things.size() > 0) things.write(json, motions.exact_scale);
  write_structures(json, runs.front(), scene);
  json.key("runs").begin_array();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    write_run(json, runs[i], i, things, span, motions.exact_scale);
  }

  json.end_array().key("divergence");
  json.number(runs.size() < 2 ? std::uint64_t{0} : first_divergence(runs[0], runs[1]));
  json.end_object();
  return text;
}

}  // namespace kinex::view
