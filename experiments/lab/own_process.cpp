// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/own_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace kinex::lab {
namespace {

// All of it, unless the other end is closed.
void write_all(int to, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(to, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

std::vector<std::byte> read_all(int from) {
  std::vector<std::byte> all;
  std::byte part[4096];
  for (;;) {
    const ssize_t got = ::read(from, part, sizeof part);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return all;
    all.insert(all.end(), part, part + got);
  }
}

enum Status : int { kDone = 0, kThrew = 1 };

[[noreturn]] void be_child(int to, std::span<std::byte> result, const std::function<void()>& work) {
  try {
    work();
    write_all(to, result);
    ::_exit(kDone);
  } catch (const std::exception& e) {
    const std::string text = e.what();
    write_all(to, std::as_bytes(std::span(text)));
  }
  ::_exit(kThrew);
}

}  // namespace

void fill_in_own_process(std::span<std::byte> result, const std::function<void()>& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe to a process of its own");
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    be_child(ends[1], result, work);
  }
  ::close(ends[1]);
  const std::vector<std::byte> said = child < 0 ? std::vector<std::byte>{} : read_all(ends[0]);
  ::close(ends[0]);
  if (child < 0) throw std::runtime_error("no process of its own can be started");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kThrew) {
    throw std::runtime_error(std::string(reinterpret_cast<const char*>(said.data()), said.size()));
  }
  if (!WIFEXITED(status) || said.size() != result.size()) {
    throw std::runtime_error("a process of its own has ended before its work was done");
  }
  std::copy(said.begin(), said.end(), result.begin());
}

}  // namespace kinex::lab
