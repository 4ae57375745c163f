// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/event_log.h"

#include <optional>

#include "experiments/json_writer.h"
#include "experiments/scene_run.h"
#include "experiments/scene_writer.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex {

namespace {

void set_instant_json(std::string& text, const InstantName& name) {
  text.clear();
  JsonWriter json(text);
  json.begin_object();
  if (name.exact && name.detail == InstantDetail::kName) {
    json.key("polynomial").begin_array();
    for (const Integer& c : name.polynomial.coefficients()) json.quoted(c);
    json.end_array().key("root").number(name.root);
  }
  if (name.exact) {
    json.key("interval").begin_array().quoted(name.lower).quoted(name.upper).end_array();
  }
  json.key("decimal").string(name.decimal).end_object();
}

// What the structure with this label orders by; nullopt for one that has no key.
std::optional<Key> key_of(const DigestedStructure& structure, const Scene& scene) {
  const StructureInfo* info = find_structure_info(structure.structure);
  if (info == nullptr || !info->uses_key) return std::nullopt;
  for (const PlannedStructure& planned : plan_structures(scene)) {
    if (planned.request.label == structure.label) return planned.request.key;
  }
  return std::nullopt;
}

}  // namespace

std::string build_name() { return "kinex " KINEX_VERSION; }

std::string_view detail_name(InstantDetail detail) {
  switch (detail) {
    case InstantDetail::kName:
      return "names";
    case InstantDetail::kInterval:
      return "intervals";
    case InstantDetail::kNone:
      return "none";
  }
  return "";
}

EventLog::EventLog(const Simulator& simulator, std::string_view scene_hash, OutputFile* file,
                   InstantDetail instants)
    : simulator_(simulator),
      file_(file),
      structures_(digested_structures(simulator)),
      digest_(simulator),
      instants_(instants) {
  digest_.hold();
  for (const DigestedStructure& structure : structures_) {
    const StructureInfo* info = find_structure_info(structure.structure);
    is_edges_.push_back(info != nullptr && info->attribute_shape() == Attribute::Shape::kEdges);
  }
  if (file_ != nullptr) write_header(scene_hash);
}

void EventLog::write_header(std::string_view scene_hash) {
  const Arithmetic& arithmetic = simulator_.kernel().arithmetic();
  const Scene& scene = simulator_.scene();
  JsonWriter json(line_);
  json.begin_object().key("format").string(kLogFormat).key("version").number(kLogVersion);
  json.key("scene").string(scene.name).key("scene_hash").string(scene_hash);
  json.key("arithmetic").string(arithmetic.name()).key("exact").boolean(arithmetic.is_exact());
  json.key("instants").string(detail_name(instants_)).key("build").string(build_name());
  json.key("structures").begin_array();
  for (const DigestedStructure& structure : structures_) {
    json.begin_object().key("label").string(structure.label);
    json.key("structure").string(structure.structure);
    if (const std::optional<Key> key = key_of(structure, scene)) {
      json.key("key").raw(key_json(*key, scene));
    }
    json.key("kinds").begin_array();
    for (const std::string& kind : structure.kinds) json.string(kind);
    json.end_array().end_object();
  }
  json.end_array().key("objects").begin_array();
  for (const SceneObject& object : scene.objects) json.string(object.id);
  json.end_array().end_object();
  write_line();
}

void EventLog::write_line() {
  line_ += '\n';
  seal_.add(line_);
  file_->write(line_);
}

void EventLog::event(const Event& event, Arithmetic& arithmetic) {
  ++records_;
  if (event.external) ++external_;
  digest_.add(event, simulator_);
  if (file_ != nullptr) write_record(event, arithmetic);
}

void EventLog::write_ids(JsonWriter& json, std::span<const ObjectId> ids) {
  json.begin_array();
  for (const ObjectId id : ids) json.string(simulator_.object_name(id));
  json.end_array();
}

// Edges as pairs, everything else as ids.
void EventLog::write_side(JsonWriter& json, std::span<const ObjectId> ids, StructureId structure) {
  if (!is_edges_[structure]) return write_ids(json, ids);
  json.begin_array();
  for (std::size_t i = 0; i + 1 < ids.size(); i += 2) write_ids(json, ids.subspan(i, 2));
  json.end_array();
}

void EventLog::write_record(const Event& event, Arithmetic& arithmetic) {
  const DigestedStructure& structure = structures_[event.structure];
  line_.clear();
  JsonWriter json(line_);
  json.begin_object().key("seq").number(records_).key("structure").string(structure.label);
  json.key("kind").string(structure.kinds[event.kind]).key("ids");
  write_ids(json, {event.ids.data(), event.count});
  json.key("certificate");
  const Query& certificate = event.certificate;
  if (certificate.arity == 0) {
    json.null();
  } else {
    json.begin_object().key("predicate");
    json.string(arithmetic.predicate(certificate.predicate).name()).key("ids");
    write_ids(json, {certificate.ids.data(), certificate.arity});
    json.end_object();
  }
  json.key("external").boolean(event.external);
  if (!event.reason.empty()) json.key("reason").string(event.reason);
  if (event.has_difference()) {
    write_side(json.key("gone"), event.gone, event.structure);
    write_side(json.key("came"), event.came, event.structure);
  }
  if (instants_ != InstantDetail::kNone) write_instant(json.key("time"), arithmetic);
  json.end_object();
  line_ += '\n';
  pending_ += line_;
}

void EventLog::instant_ended() {
  if (records_ == settled_records_) return;
  settled_records_ = records_;
  settled_external_ = external_;
  digest_.settle();
  if (file_ == nullptr) return;
  seal_.add(pending_);
  file_->write(pending_);
  pending_.clear();
}

void EventLog::instant_abandoned() {
  records_ = settled_records_;
  external_ = settled_external_;
  digest_.take_back();
  pending_.clear();
}

void EventLog::write_instant(JsonWriter& json, Arithmetic& arithmetic) {
  const InstantName& name = arithmetic.name_now(instants_);
  if (name.number == 0 || name.number != instant_number_) {
    set_instant_json(instant_, name);
    instant_number_ = name.number;
  }
  json.raw(instant_);
}

void EventLog::finish(RunStatus status) {
  instant_ended();
  if (file_ == nullptr) return;
  line_.clear();
  JsonWriter json(line_);
  json.begin_object().key("end").string(status_name(status)).key("reached");
  if (status == RunStatus::kDone && !simulator_.scene().end) {
    json.null();
  } else {
    json.string(simulator_.reached().to_string());
  }
  json.key("records").number(records_).key("external").number(external_);
  json.key("digest").string(digest()).key("seal");
  seal_.add(line_ + '"');
  json.string(seal_.hex()).end_object();
  line_ += '\n';
  file_->write(line_);
  file_->commit();
}

}  // namespace kinex
