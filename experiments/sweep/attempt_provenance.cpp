// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/attempt_provenance.h"

#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/sweep/record.h"

namespace kinex::sweep {

namespace {

constexpr int kVersion = 1;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Of Slurm: "JOB", "JOB_TASK", or "JOB_TASK, restart 1".
std::string job_text() {
  std::string text = environment("SLURM_ARRAY_JOB_ID");
  if (text.empty()) return environment("SLURM_JOB_ID");
  text += "_" + environment("SLURM_ARRAY_TASK_ID");
  const std::string restarts = environment("SLURM_RESTART_COUNT");
  return restarts.empty() ? text : text + ", restart " + restarts;
}

}  // namespace

AttemptProvenance provenance_of(const PlanText& plan, std::string command, std::string shard) {
  AttemptProvenance provenance;
  provenance.plan_name = plan.name;
  provenance.plan_hash = plan.hash;
  provenance.plan = plan.text;
  provenance.program = lab::program_identity();
  provenance.build = lab::build_facts();
  provenance.machine = lab::machine_facts();
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) provenance.host = host.data();
  provenance.command = std::move(command);
  provenance.shard = std::move(shard);
  provenance.job = job_text();
  provenance.started = utc_text("%Y-%m-%dT%H:%M:%SZ");
  return provenance;
}

std::string provenance_line(const AttemptProvenance& provenance) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("kinex_sweep").number(kVersion);
  json.key("plan_name").string(provenance.plan_name);
  json.key("plan_hash").string(provenance.plan_hash).key("program").string(provenance.program);
  json.key("version").string(provenance.build.program);
  json.key("commit").string(provenance.build.commit).key("dirty").boolean(provenance.build.dirty);
  json.key("compiler").string(provenance.build.compiler);
  json.key("flags").string(provenance.build.flags);
  json.key("libraries").string(provenance.build.libraries);
  json.key("cpu").string(provenance.machine.cpu);
  json.key("cores").number(static_cast<std::uint64_t>(provenance.machine.cores));
  json.key("memory_kb").number(static_cast<std::uint64_t>(provenance.machine.memory_kb));
  json.key("kernel").string(provenance.machine.kernel).key("host").string(provenance.host);
  json.key("command").string(provenance.command).key("shard").string(provenance.shard);
  json.key("job").string(provenance.job).key("started").string(provenance.started);
  json.key("plan").raw(provenance.plan).end_object();
  return text;
}

AttemptProvenance parse_provenance(std::string_view line, const std::string& file) {
  const formats::JsonDocument document = formats::parse_json(line, file);
  const formats::JsonValue& value = *document;
  const LineFields fields(value, file, 1);
  if (fields.whole("kinex_sweep") != kVersion) {
    throw formats::InputError(file, "line 1", "it was written in another version of this format",
                              "use the program that wrote it, or another folder");
  }
  AttemptProvenance provenance;
  provenance.plan_name = fields.text("plan_name");
  provenance.plan_hash = fields.text("plan_hash");
  provenance.plan = formats::canonical_json(fields.member("plan"));
  provenance.program = fields.text("program");
  provenance.build.program = fields.text("version");
  provenance.build.commit = fields.text("commit");
  provenance.build.dirty = fields.boolean("dirty");
  provenance.build.compiler = fields.text("compiler");
  provenance.build.flags = fields.text("flags");
  provenance.build.libraries = fields.text("libraries");
  provenance.machine.cpu = fields.text("cpu");
  provenance.machine.cores = fields.whole("cores");
  provenance.machine.memory_kb = fields.whole("memory_kb");
  provenance.machine.kernel = fields.text("kernel");
  provenance.host = fields.text("host");
  provenance.command = fields.text("command");
  provenance.shard = fields.text("shard");
  provenance.job = fields.text("job");
  provenance.started = fields.text("started");
  return provenance;
}

}  // namespace kinex::sweep
