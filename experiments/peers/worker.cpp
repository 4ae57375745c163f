// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/peers/worker.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "experiments/lab/cpu_clock.h"

namespace kinex::peers {

namespace {

constexpr int kMostRounds = 2000;

// In the child: writes the answers to the questions from `first` on to the pipe, one by one.
int answer_into(int pipe, const PeerMethod& method, const std::vector<PeerCase>& questions,
                std::size_t first, const WorkerLimits& limits) {
  // The output of the libraries is discarded.
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  void* module = dlopen(module_path(method.module).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) return 1;
  Peer* (*make)() = nullptr;
  void* symbol = dlsym(module, "kinex_make_peer");
  if (symbol == nullptr) return 1;
  std::memcpy(&make, &symbol, sizeof make);
  const std::unique_ptr<Peer> peer(make());
  for (std::size_t i = first; i < questions.size(); ++i) {
    const PeerCase question = method.single ? questions[i].as_float() : questions[i];
    PeerAnswer answer;
    double begin = lab::cpu_seconds();
    if (peer->load(question.a, question.b)) {
      const double load_seconds = lab::cpu_seconds() - begin;
      answer = ask(*peer, method, question);
      answer.load_seconds = load_seconds;
      if (limits.measure_seconds > 0) {
        std::vector<double> rounds;
        double spent = 0;
        while (spent < limits.measure_seconds && rounds.size() < kMostRounds) {
          begin = lab::cpu_seconds();
          ask(*peer, method, question);
          rounds.push_back(lab::cpu_seconds() - begin);
          spent += rounds.back();
        }
        std::nth_element(rounds.begin(), rounds.begin() + static_cast<long>(rounds.size() / 2),
                         rounds.end());
        answer.seconds = rounds[rounds.size() / 2];
      }
    }
    if (write(pipe, &answer, sizeof answer) != static_cast<ssize_t>(sizeof answer)) return 1;
  }
  return 0;
}

// True if an answer was read; otherwise `ended` says whether the child has ended.
bool receive(int pipe, double seconds, PeerAnswer& answer, bool& ended) {
  char* to = reinterpret_cast<char*>(&answer);
  std::size_t left = sizeof answer;
  while (left > 0) {
    pollfd wait{pipe, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(seconds * 1000));
    if (ready < 0 && errno == EINTR) continue;
    ended = ready != 0;
    if (ready <= 0) return false;
    const ssize_t got = read(pipe, to, left);
    if (got <= 0) return false;
    to += got;
    left -= static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

std::vector<PeerAnswer> ask_all(const PeerMethod& method, const std::vector<PeerCase>& questions,
                                const WorkerLimits& limits) {
  std::vector<PeerAnswer> answers;
  const double patience = limits.seconds + 2 * limits.measure_seconds;
  while (answers.size() < questions.size()) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe to a library's process");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process for a library");
    if (child == 0) {
      close(ends[0]);
      int status = 1;
      try {
        status = answer_into(ends[1], method, questions, answers.size(), limits);
      } catch (...) {
      }
      _exit(status);
    }
    close(ends[1]);
    const std::size_t before = answers.size();
    bool ended = false;
    while (answers.size() < questions.size()) {
      PeerAnswer answer;
      if (!receive(ends[0], patience, answer, ended)) break;
      answers.push_back(answer);
    }
    close(ends[0]);
    if (answers.size() < questions.size() && !ended) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (answers.size() < questions.size()) {
      if (answers.size() == before && ended && WIFEXITED(status) && before == 0) {
        throw std::runtime_error(method.module + ": its module cannot be used");
      }
      PeerAnswer lost;
      lost.reply = ended ? PeerReply::kCrash : PeerReply::kNoEnd;
      answers.push_back(lost);
    }
  }
  return answers;
}

}  // namespace kinex::peers
