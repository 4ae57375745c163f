// SPDX-License-Identifier: GPL-3.0-or-later
// Question: which priority queue serves kinetic runs best?
// Workload: the queue operations of real runs (random motion, exact, lazy scheduling), replayed on
//   Boost's binary and 4-ary heaps with positions, Boost's pairing heap, and kinex's EventQueue (a
//   4-ary heap of the near future, unsorted buckets behind it). All compare enclosures in the same
//   way. Rounds are interleaved; the best of each counts; thread CPU time.
// Output: see result_table.h; options: see bench_options.h.
#include <boost/heap/d_ary_heap.hpp>
#include <boost/heap/pairing_heap.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/engine/event_queue.h"
#include "experiments/bench/queue_trace.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/result_table.h"
#include "predicates/predicates.h"

namespace {

using namespace kinex;
using bench::QueueOperation;
using bench::QueueTrace;
using Kind = QueueOperation::Kind;

struct Entry {
  double lo, hi;
  std::uint32_t id;
};

// Overlapping enclosures are ordered by their lower ends: the real instants are not known here.
bool before(const Entry& a, const Entry& b) {
  if (a.hi < b.lo) return true;
  if (b.hi < a.lo) return false;
  return a.lo != b.lo ? a.lo < b.lo : a.id < b.id;
}

struct Later {
  bool operator()(const Entry& a, const Entry& b) const { return before(b, a); }
};

// A Boost heap with handles by certificate.
template <class Heap>
class BoostQueue {
 public:
  explicit BoostQueue(std::size_t certificates) : handles_(certificates) {}
  void push(const QueueOperation& o) { handles_[o.id] = heap_.push({o.lo, o.hi, o.id}); }
  void reset(const QueueOperation& o) { heap_.update(handles_[o.id], {o.lo, o.hi, o.id}); }
  void remove(std::uint32_t id) { heap_.erase(handles_[id]); }
  std::uint32_t top() const { return heap_.top().id; }
  void pop() { heap_.pop(); }

 private:
  Heap heap_;
  std::vector<typename Heap::handle_type> handles_;
};

template <int Arity>
using DAryHeap = boost::heap::d_ary_heap<Entry, boost::heap::arity<Arity>,
                                         boost::heap::mutable_<true>, boost::heap::compare<Later>>;
using PairingHeap = boost::heap::pairing_heap<Entry, boost::heap::compare<Later>>;

// The part of an arithmetic that EventQueue needs: the order of two enclosures that overlap.
class LowerEnds final : public Arithmetic {
 public:
  LowerEnds() { bind(make_coordinate_order(0)); }
  std::string name() const override { return "lower ends"; }
  bool is_exact() const override { return false; }
  void set_motion(ObjectId, const Trajectory&, const std::optional<Rational>&) override {}
  void set_now(const Rational&) override {}
  void advance(const Query&, FailureTime&) override {}
  double now_approximate() const override { return 0; }
  const InstantName& name_now(InstantDetail) override { return name_of_now_; }
  Sign sign_after(const Query&) override { return Sign::kZero; }
  Outlook failure(const Query&, FailureTime&) override { return Outlook::kNever; }
  int compare(const Query&, FailureTime& a, const Query&, FailureTime& b) override {
    return a.lo < b.lo ? -1 : a.lo > b.lo ? 1 : 0;
  }
  int compare_with_now(const Query&, FailureTime&) override { return 1; }
  int compare(const Query&, FailureTime&, const Rational&) override { return 1; }
  void release(FailureTime&) override {}
  std::optional<Rational> rational_between(const Query*, FailureTime*) override { return {}; }
  std::size_t bytes() const override { return 0; }
};

class BucketQueue {
 public:
  explicit BucketQueue(std::size_t certificates) : queue_(order_) {
    for (std::uint32_t id = 0; id < certificates; ++id) {
      Query query;
      query.arity = 1;
      query.ids[0] = id;
      queue_.certificate(queue_.allocate(0, query, 0)).outlook = Outlook::kFails;
    }
  }
  void push(const QueueOperation& o) { queue_.push(o.id, {o.lo, o.hi, 0}); }
  void reset(const QueueOperation& o) { queue_.reset(o.id, {o.lo, o.hi, 0}); }
  void remove(std::uint32_t id) { queue_.remove(id); }
  std::uint32_t top() const { return queue_.top(); }
  void pop() { queue_.pop(); }

 private:
  LowerEnds order_;
  EventQueue queue_;
};

template <class Queue>
lab::BenchRun replay(const QueueTrace& trace) {
  Queue queue(trace.certificates);
  std::uint64_t astray = 0;  // pops of another certificate than in the run
  const double begin = lab::cpu_seconds();
  for (const QueueOperation& o : trace.operations) {
    switch (o.kind) {
      case Kind::kPush:
        queue.push(o);
        break;
      case Kind::kReset:
        queue.reset(o);
        break;
      case Kind::kRemove:
        queue.remove(o.id);
        break;
      case Kind::kPop:
        if (queue.top() == o.id) {
          queue.pop();
        } else {  // enclosures overlap
          queue.remove(o.id);
          ++astray;
        }
        break;
    }
  }
  const double seconds = lab::cpu_seconds() - begin;
  if (astray > trace.events / 100) throw std::logic_error("this is not the order of the run");
  return {.seconds = seconds, .events = trace.events};
}

struct Candidate {
  const char* name;
  lab::BenchRun (*run)(const QueueTrace&);
};

void add_rows(const lab::BenchRow& row, lab::ResultTable& table) {
  static constexpr Candidate kCandidates[] = {
      {"boost binary", replay<BoostQueue<DAryHeap<2>>>},
      {"boost 4-ary", replay<BoostQueue<DAryHeap<4>>>},
      {"boost pairing", replay<BoostQueue<PairingHeap>>},
      {"kinex buckets", replay<BucketQueue>},
  };
  const QueueTrace trace = bench::record_queue(lab::scene_of(row), row.events);
  std::vector<std::function<lab::BenchRun()>> ways;
  for (const Candidate& candidate : kCandidates) {
    ways.emplace_back([&trace, &candidate] { return candidate.run(trace); });
  }
  const std::vector<lab::BenchRun> best = lab::best_of_rounds(ways, {.count = row.rounds});
  const double operations = static_cast<double>(trace.operations.size());
  for (std::size_t i = 0; i < best.size(); ++i) {
    table.row({row.structure, row.parameters.degree, row.parameters.n, kCandidates[i].name,
               trace.events, trace.operations.size(), best[i].seconds / operations * 1e9,
               best[i].seconds / best[0].seconds});
  }
}

void queue(const lab::BenchOptions& options) {
  lab::ResultTable table(options, "queue",
                         "Priority queues on the operations of real runs: time over a binary heap.",
                         {{"structure", lab::ResultTable::kText, 19},
                          {"degree", 0},
                          {"n", 0, 7},
                          {"queue", lab::ResultTable::kText, 14},
                          {"events", 0, 9},
                          {"operations", 0, 11},
                          {"ns_per_operation", 1},
                          {"time_over_binary", 3}});
  for (const lab::BenchRow& row : lab::bench_rows("queue", options)) add_rows(row, table);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, queue); }
