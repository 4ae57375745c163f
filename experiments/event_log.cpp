// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/event_log.h"

#include "experiments/json_writer.h"
#include "experiments/scene_run.h"

namespace kinex {

namespace {

void write_ids(JsonWriter& json, const Simulator& simulator, const ObjectId* ids, std::size_t count) {
  json.begin_array();
  for (std::size_t i = 0; i < count; ++i) json.string(simulator.object_name(ids[i]));
  json.end_array();
}

void write_instant(JsonWriter& json, const InstantText& instant) {
  json.begin_object();
  if (instant.exact) {
    json.key("polynomial").begin_array();
    for (const std::string& coefficient : instant.polynomial) json.string(coefficient);
    json.end_array();
    json.key("root").number(instant.root);
    json.key("interval").begin_array().string(instant.lower).string(instant.upper).end_array();
  }
  json.key("decimal").string(instant.approximate).end_object();
}

}  // namespace

std::string build_name() { return "kinex " KINEX_VERSION; }

std::string digest_line(std::string_view label, std::string_view kind,
                        const std::vector<std::string_view>& ids) {
  std::string line;
  JsonWriter json(line);
  json.begin_array().string(label).string(kind);
  for (const std::string_view id : ids) json.string(id);
  json.end_array();
  line += '\n';
  return line;
}

EventLog::EventLog(const Simulator& simulator, std::string_view scene_hash, OutputFile* file)
    : simulator_(simulator), file_(file) {
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    std::vector<std::string>& kinds = kinds_.emplace_back();
    for (const std::string_view kind : simulator.event_kinds(id)) kinds.emplace_back(kind);
  }
  if (file_ == nullptr) return;
  const Arithmetic& arithmetic = simulator.kernel().arithmetic();
  JsonWriter json(line_);
  json.begin_object().key("format").string(kLogFormat).key("version").number(kLogVersion);
  json.key("scene").string(simulator.scene().name).key("scene_hash").string(scene_hash);
  json.key("arithmetic").string(arithmetic.name()).key("exact").boolean(arithmetic.is_exact());
  json.key("build").string(build_name()).key("structures").begin_array();
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    json.begin_object().key("label").string(simulator.label(id));
    json.key("structure").string(simulator.structure(id).name()).key("kinds").begin_array();
    for (const std::string& kind : kinds_[id]) json.string(kind);
    json.end_array().end_object();
  }
  json.end_array().end_object();
  line_ += '\n';
  file_->write(line_);
}

void EventLog::event(const Event& event, Arithmetic& arithmetic) {
  ++events_;
  const std::vector<std::string>& kinds = kinds_[event.structure];
  const std::string kind = event.kind < kinds.size() ? kinds[event.kind] : "?";
  std::vector<std::string_view> ids;
  for (std::size_t i = 0; i < event.count; ++i) {
    ids.push_back(simulator_.object_name(event.ids[i]));
  }
  digest_.add(digest_line(simulator_.label(event.structure), kind, ids));
  if (file_ != nullptr) write_line(event, kind, arithmetic);
}

void EventLog::write_line(const Event& event, std::string_view kind, Arithmetic& arithmetic) {
  line_.clear();
  JsonWriter json(line_);
  json.begin_object().key("seq").number(events_);
  json.key("structure").string(simulator_.label(event.structure)).key("kind").string(kind);
  json.key("ids");
  write_ids(json, simulator_, event.ids.data(), event.count);
  json.key("certificate");
  const Query& certificate = event.certificate;
  if (certificate.arity == 0) {
    json.null();
  } else {
    json.begin_object().key("predicate");
    json.string(arithmetic.predicate(certificate.predicate).name()).key("ids");
    write_ids(json, simulator_, certificate.ids.data(), certificate.arity);
    json.end_object();
  }
  json.key("external").boolean(event.external);
  if (!event.reason.empty()) json.key("reason").string(event.reason);
  json.key("time");
  write_instant(json, arithmetic.describe_now());
  json.end_object();
  line_ += '\n';
  file_->write(line_);
}

void EventLog::finish(RunStatus status) {
  if (file_ == nullptr) return;
  line_.clear();
  JsonWriter json(line_);
  json.begin_object().key("end").string(status_name(status)).key("events").number(events_);
  json.key("digest").string(digest()).end_object();
  line_ += '\n';
  file_->write(line_);
  file_->commit();
}

}  // namespace kinex
