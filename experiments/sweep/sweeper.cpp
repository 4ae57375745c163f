// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/sweeper.h"

#include <poll.h>
#include <unistd.h>

#include <list>
#include <memory>

namespace kinex::sweep {

namespace {

constexpr int kLook = 20;  // milliseconds

struct Running {
  std::size_t place;
  std::unique_ptr<lab::ChildProcess> child;
};

std::unique_ptr<lab::ChildProcess> start(const PlanCell& cell, const SweepOptions& options) {
  std::vector<std::string> arguments{"sweep", "cell", cell.text, "--parent",
                                     std::to_string(::getpid())};
  const auto add = [&](const char* option, int value) {
    if (value == 0) return;
    arguments.push_back(option);
    arguments.push_back(std::to_string(value));
  };
  add("--seconds", options.limits.seconds);
  add("--megabytes", options.limits.megabytes);
  return std::make_unique<lab::ChildProcess>(options.program, arguments);
}

void wait_for_output(const std::list<Running>& running) {
  std::vector<pollfd> ends;
  for (const Running& one : running) {
    for (const int end : one.child->descriptors()) {
      if (end >= 0) ends.push_back({end, POLLIN, 0});
    }
  }
  // An interruption is seen by go_on().
  static_cast<void>(::poll(ends.data(), ends.size(), kLook));
}

}  // namespace

bool run_cells(const std::vector<PlanCell>& cells, const SweepOptions& options) {
  std::list<Running> running;
  std::size_t next = 0;
  while (next < cells.size() || !running.empty()) {
    if (!options.go_on()) return false;
    while (next < cells.size() && running.size() < static_cast<std::size_t>(options.jobs)) {
      if (options.on_start) options.on_start(next);
      running.push_back({next, start(cells[next], options)});
      ++next;
    }
    wait_for_output(running);
    for (auto one = running.begin(); one != running.end();) {
      if (one->child->read()) {
        ++one;
        continue;
      }
      const lab::ChildEnd end = one->child->wait();
      const Record record = record_of(cells[one->place], options.limits, *one->child, end);
      // A sweep that is asked to end may see its children end first.
      if (record.outcome == Outcome::kKilled && !options.go_on()) return false;
      options.on_end(one->place, record);
      one = running.erase(one);
    }
  }
  return true;
}

}  // namespace kinex::sweep
