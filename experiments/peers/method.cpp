// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/peers/method.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace kinex::peers {

namespace {

PeerAnswer by_steps(Peer& peer, const PeerMethod& method, const PeerCase& question) {
  PeerAnswer answer;
  answer.reply = PeerReply::kMiss;
  for (int i = 0; i <= method.steps; ++i) {
    const double t = static_cast<double>(i) / method.steps;
    const PeerFrame frame = question.at(t);
    const PeerReply reply = peer.overlap(method.variant, frame.a, frame.b);
    if (reply != PeerReply::kMiss) return {reply, t, {}, 0, 0};
  }
  return answer;
}

// A bound on the speed at which two points of the bodies approach each other after frame i.
double speed_bound(const PeerCase& question, std::size_t i) {
  const PeerFrame& from = question.frames[i];
  const PeerFrame& to = question.frames[i + 1];
  const double way = std::hypot((to.b.x - from.b.x) - (to.a.x - from.a.x),
                                (to.b.y - from.b.y) - (to.a.y - from.a.y));
  const double turns = std::abs(to.a.angle - from.a.angle) * outer_radius(question.a) +
                       std::abs(to.b.angle - from.b.angle) * outer_radius(question.b);
  return (way + turns) * static_cast<double>(question.frames.size() - 1);
}

PeerAnswer by_advancing(Peer& peer, const PeerMethod& method, const PeerCase& question) {
  const std::size_t spans = question.frames.size() - 1;
  std::uint64_t steps = 0;
  double t = 0;
  for (std::size_t i = 0; i < spans; ++i) {
    const double speed = speed_bound(question, i);
    const double end = static_cast<double>(i + 1) / static_cast<double>(spans);
    for (;;) {
      const PeerFrame frame = question.at(t);
      const double distance = peer.distance(method.variant, frame.a, frame.b);
      if (std::isnan(distance)) return {PeerReply::kNotANumber, t, {}, 0, 0};
      if (distance <= method.stop) return {PeerReply::kHit, t, {}, 0, 0};
      if (++steps > kMostAdvances) return {PeerReply::kFailed, t, {}, 0, 0};
      if (distance >= speed * (end - t)) break;
      t += distance / speed;
    }
    t = end;
  }
  return {PeerReply::kMiss, 1, {}, 0, 0};
}

PeerAnswer by_casting(Peer& peer, const PeerMethod& method, const PeerCase& question) {
  const std::size_t spans = question.frames.size() - 1;
  const int parts =
      std::max(1, static_cast<int>(std::ceil(question.largest_turn() / method.most_turn)));
  const double count = static_cast<double>(spans) * parts;
  for (std::size_t k = 0; k < spans * static_cast<std::size_t>(parts); ++k) {
    const double begin = static_cast<double>(k) / count;
    const double end = static_cast<double>(k + 1) / count;
    const PeerFrame from = question.at(begin), to = question.at(end);
    const Peer::Cast cast = peer.cast(method.variant, from.a, to.a, from.b, to.b);
    if (cast.reply != PeerReply::kMiss) {
      return {cast.reply, begin + (end - begin) * cast.time, {}, 0, 0};
    }
  }
  return {PeerReply::kMiss, 1, {}, 0, 0};
}

std::string short_number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.0e", x);
  return text;
}

bool is_single(const std::string& module) { return module == "box2d" || module == "bullet"; }

}  // namespace

PeerAnswer ask(Peer& peer, const PeerMethod& method, const PeerCase& question) {
  peer.forget();
  peer.work = {};
  PeerAnswer answer;
  switch (method.kind) {
    case PeerMethod::Kind::kSteps:
      answer = by_steps(peer, method, question);
      break;
    case PeerMethod::Kind::kAdvance:
      answer = by_advancing(peer, method, question);
      break;
    case PeerMethod::Kind::kCast:
      answer = by_casting(peer, method, question);
      break;
    case PeerMethod::Kind::kDistance:
      answer.time = peer.distance(method.variant, question.frames[0].a, question.frames[0].b);
      answer.reply = std::isnan(answer.time) ? PeerReply::kNotANumber : PeerReply::kHit;
      break;
  }
  answer.work = peer.work;
  return answer;
}

std::string module_path(const std::string& module) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path() / ("kinex_peer_" + module + ".so");
}

bool has_module(const std::string& module) { return std::filesystem::exists(module_path(module)); }

PeerMethod steps_method(const std::string& module, int steps) {
  PeerMethod method;
  method.name = module + " " + std::to_string(steps) + " steps";
  method.module = module;
  method.kind = PeerMethod::Kind::kSteps;
  method.steps = steps;
  method.single = is_single(module);
  method.certifies = "samples";
  return method;
}

PeerMethod advance_method(const std::string& module, double stop) {
  PeerMethod method;
  method.name = module + " advance " + short_number(stop);
  method.module = module;
  method.kind = PeerMethod::Kind::kAdvance;
  method.stop = method.tolerance = stop;
  method.single = is_single(module);
  method.certifies = "all, up to rounding";
  return method;
}

std::vector<PeerMethod> peer_methods() {
  using Kind = PeerMethod::Kind;
  constexpr int kSteps = 64;
  std::vector<PeerMethod> all;
  // Bullet clamps a turn at 45 degrees: larger turns are divided.
  constexpr double kBulletTurn = 0.78;
  // FCL's tolerance is in time, 1e-4 of the step: a distance of 0.002 at a speed of 20.
  all.push_back({"box2d toi", "box2d", Kind::kCast, 0, 0, 0, 0.00625, true, 1e9, "most: may miss"});
  all.push_back({"bullet cast", "bullet", Kind::kCast, 0, 0, 0, 0.001, true, kBulletTurn,
                 "all, up to rounding"});
  all.push_back({"bullet64 cast", "bullet64", Kind::kCast, 0, 0, 0, 0.001, false, kBulletTurn,
                 "all, up to rounding"});
  all.push_back({"fcl default", "fcl", Kind::kCast, 0, 0, 0, 0, false, 3, "10 samples"});
  all.push_back(
      {"fcl advance", "fcl", Kind::kCast, 1, 0, 0, 0.002, false, 3, "all, up to rounding"});
  all.push_back(
      {"fcl advance, mesh", "fcl", Kind::kCast, 2, 0, 0, 0.002, false, 3, "all, up to rounding"});
  for (const char* module : {"box2d", "bullet64", "fcl"}) {
    for (const double stop : {5e-3, 1e-3, 1e-9}) all.push_back(advance_method(module, stop));
  }
  for (const char* module : {"box2d", "bullet64", "fcl", "libccd"}) {
    all.push_back(steps_method(module, kSteps));
  }
  PeerMethod mpr = steps_method("libccd", kSteps);
  mpr.name = "libccd mpr " + std::to_string(kSteps) + " steps";
  mpr.variant = 1;
  mpr.tolerance = 1e-4;
  all.push_back(mpr);
  PeerMethod depth = steps_method("libccd", kSteps);
  depth.name = "libccd epa " + std::to_string(kSteps) + " steps";
  depth.variant = 2;
  all.push_back(depth);
  std::erase_if(all, [](const PeerMethod& method) { return !has_module(method.module); });
  return all;
}

}  // namespace kinex::peers
