// SPDX-License-Identifier: GPL-3.0-or-later
// Question: which priority queue serves kinetic runs best?
// Workload: the queue operations of real runs (uniform-square, exact, lazy scheduling), replayed on
//   Boost's binary and 4-ary heaps with positions, Boost's pairing heap, and kinex's EventQueue (a
//   4-ary heap of the near future, unsorted buckets behind it). All compare enclosures in the same
//   way. Rounds are interleaved; the best of each counts; thread CPU time.
// Output: see result_table.h; options: see options.h.
#include <boost/heap/d_ary_heap.hpp>
#include <boost/heap/pairing_heap.hpp>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "core/engine/event_queue.h"
#include "experiments/bench/options.h"
#include "experiments/bench/queue_trace.h"
#include "experiments/bench/result_table.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/workload.h"
#include "predicates/predicates.h"

namespace {

using namespace kinex;
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

struct Result {
  double seconds = 0;
  std::uint64_t astray = 0;  // pops of another certificate than in the run
};

template <class Queue>
Result replay(const QueueTrace& trace) {
  Queue queue(trace.certificates);
  Result result;
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
          ++result.astray;
        }
        break;
    }
  }
  result.seconds = lab::cpu_seconds() - begin;
  return result;
}

struct Candidate {
  const char* name;
  Result (*run)(const QueueTrace&);
};

struct Contest {
  const char* structure;
  int degree;
  int n;
};

void run_contest(const Contest& contest, std::uint64_t events, int rounds, ResultTable& table) {
  static constexpr Candidate kCandidates[] = {
      {"boost binary", replay<BoostQueue<DAryHeap<2>>>},
      {"boost 4-ary", replay<BoostQueue<DAryHeap<4>>>},
      {"boost pairing", replay<BoostQueue<PairingHeap>>},
      {"kinex buckets", replay<BucketQueue>},
  };
  lab::WorkloadParameters parameters;
  parameters.n = contest.n;
  parameters.degree = contest.degree;
  const QueueTrace trace = record_queue(
      lab::generate_scene(*lab::find_workload("uniform-square"), parameters), contest.structure, events);
  Result best[std::size(kCandidates)];
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < std::size(kCandidates); ++i) {
      const Result r = kCandidates[i].run(trace);
      if (r.astray > trace.events / 100) throw std::logic_error("this is not the order of the run");
      if (round == 0 || r.seconds < best[i].seconds) best[i] = r;
    }
  }
  const double operations = static_cast<double>(trace.operations.size());
  for (std::size_t i = 0; i < std::size(kCandidates); ++i) {
    const double ratio = best[i].seconds / best[0].seconds;
    const double each = best[i].seconds / operations * 1e9;
    table.row({contest.structure, contest.degree, contest.n, kCandidates[i].name, trace.events,
               trace.operations.size(), each, ratio});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  const bool smoke = options->smoke;
  ResultTable table(*options, "queue",
                    "Priority queues on the operations of real runs: time over a binary heap.",
                    {{"structure", ResultTable::kText, 19},
                     {"degree", 0},
                     {"n", 0, 7},
                     {"queue", ResultTable::kText, 14},
                     {"events", 0, 9},
                     {"operations", 0, 11},
                     {"ns_per_operation", 1},
                     {"time_over_binary", 3}});
  const int scale = smoke ? 100 : 1;
  const std::uint64_t events = smoke ? 500 : 30000;
  for (const Contest& contest :
       {Contest{"sorted_list", 1, 1000}, Contest{"sorted_list", 1, 10000},
        Contest{"delaunay_2", 1, 1000}, Contest{"delaunay_2", 1, 10000},
        Contest{"delaunay_2", 3, 1000}, Contest{"maximum_heap", 1, 10000}}) {
    run_contest({contest.structure, contest.degree, contest.n / scale}, events, smoke ? 1 : 5,
                table);
  }
  return 0;
}
