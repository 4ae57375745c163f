// SPDX-License-Identifier: GPL-3.0-or-later
// StageWatch: a decorator of an arithmetic. It forwards every call, and records for each certificate
// the stage that found its failure time and the highest stage that compared it with another instant.
#ifndef KINEX_EXPERIMENTS_VIEW_STAGE_WATCH_H
#define KINEX_EXPERIMENTS_VIEW_STAGE_WATCH_H

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "core/arithmetic/touch.h"

namespace kinex::view {

struct StagesUsed {
  Stage found = Stage::kDouble;    // the failure time
  Stage ordered = Stage::kDouble;  // the highest that a comparison with it needed
};

class StageWatch : public Arithmetic {
 public:
  explicit StageWatch(std::unique_ptr<Arithmetic> arithmetic);

  // The stages used for the failure time last found for this certificate; nullopt if there is none.
  std::optional<StagesUsed> stages(const Query& query) const;

  // The bound predicates, by PredicateId.
  const std::vector<std::shared_ptr<const Predicate>>& bound() const { return predicates_; }

  std::string name() const override { return inner_->name(); }
  bool is_exact() const override { return inner_->is_exact(); }
  long precision() const override { return inner_->precision(); }
  void set_deadline(Deadline* deadline) override { inner_->set_deadline(deadline); }
  void set_motion(ObjectId object, const Trajectory& trajectory,
                  const std::optional<Rational>& until) override {
    inner_->set_motion(object, trajectory, until);
  }
  void set_now(const Rational& t) override { inner_->set_now(t); }
  void advance(const Query& query, FailureTime& time) override { inner_->advance(query, time); }
  void visit(const Query& query, const FailureTime& time) override { inner_->visit(query, time); }
  void leave() override { inner_->leave(); }
  double now_approximate() const override { return inner_->now_approximate(); }
  std::optional<Rational> now_value() const override { return inner_->now_value(); }
  double now_rounded() override { return inner_->now_rounded(); }
  const InstantName& name_now(InstantDetail detail) override { return inner_->name_now(detail); }
  Sign sign_after(const Query& query) override { return inner_->sign_after(query); }
  Outlook failure(const Query& query, FailureTime& time) override;
  Outlook look_ahead(const Query& query, double limit, FailureTime& time) override;
  Outlook look_further(const Query& query, double from, double limit, FailureTime& time) override;
  int compare(const Query& a, FailureTime& ta, const Query& b, FailureTime& tb) override;
  int compare_with_now(const Query& a, FailureTime& ta) override;
  int compare(const Query& a, FailureTime& ta, const Rational& t) override;
  void release(FailureTime& time) override { inner_->release(time); }
  std::optional<Rational> rational_between(const Query* query, FailureTime* time) override {
    return inner_->rational_between(query, time);
  }
  std::size_t bytes() const override { return inner_->bytes(); }
  std::string number_model() const override { return inner_->number_model(); }
  std::string polynomial_model(PredicateId id) const override {
    return inner_->polynomial_model(id);
  }

 protected:
  Arithmetic& inner() { return *inner_; }
  void bound_predicate(PredicateId id) override { inner_->bind(predicates_[id]); }

 private:
  struct Hash {
    std::size_t operator()(const Query& query) const;
  };
  template <class Search>
  Outlook note_search(const Query& query, const Search& search);
  template <class Comparison>
  int note_order(const Query& a, const Query* b, const Comparison& comparison);
  void raise(const Query& query, Stage stage);

  std::unique_ptr<Arithmetic> inner_;
  std::unordered_map<Query, StagesUsed, Hash> stages_;
};

// StageWatch for an arithmetic that also gives signs at now.
class ExactStageWatch final : public StageWatch, public SignNow {
 public:
  // Requires a SignNow.
  explicit ExactStageWatch(std::unique_ptr<Arithmetic> arithmetic);
  Sign sign_now(const Query& query) override { return signs_->sign_now(query); }

 private:
  SignNow* signs_;
};

// An ExactStageWatch if `arithmetic` is a SignNow, else a StageWatch.
std::unique_ptr<StageWatch> make_stage_watch(std::unique_ptr<Arithmetic> arithmetic);

// "double", "128-bit integers", "MPFR", "exact integers".
std::string_view stage_name(Stage stage);

}  // namespace kinex::view

#endif
