// SPDX-License-Identifier: GPL-3.0-or-later
// Checks an event log against its scene: level 2 of log_check.h.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_SCENE_CHECK_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_SCENE_CHECK_H

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/arithmetic/predicate.h"
#include "core/motion/scene.h"
#include "core/numbers/real_root.h"
#include "experiments/formats/certificate_polynomial.h"
#include "experiments/formats/direction_meanings.h"
#include "experiments/formats/log_reader.h"
#include "experiments/formats/unchecked_certificates.h"

namespace kinex::formats {

class LogSceneCheck {
 public:
  // `hash`: of the scene's file. Defects of the header are added to `problems`.
  LogSceneCheck(const LogHeader& header, const Scene& scene, const std::string& hash,
                std::vector<std::string>& problems);

  // The log is of this scene, by its hash. Records and the last line of another one need no check.
  bool is_of_scene() const { return is_of_scene_; }
  // The defect of the next record's certificate, or of the features of bodies that it names; empty
  // if there is none. `instant`: its time, if that is known exactly.
  std::string check(const LogRecord& record, RealRoot* instant);
  // The defect of the last line.
  std::string check(const LogEnd& end) const;
  // Defects of records before the last one that were checked, which are known by now: whether a
  // certificate may be negative in the midst of an instant depends on all that happens then. Each is
  // returned once. `at_end`: no record follows.
  struct LateProblem {
    std::size_t line;
    std::string problem;
  };
  std::vector<LateProblem> late_problems(bool at_end = false);

  std::uint64_t certificates() const { return certificates_; }
  const UncheckedCertificates& unchecked() const { return unchecked_; }

 private:
  void note_change(const LogRecord& record, RealRoot* instant);
  std::shared_ptr<const Predicate> order_on_grid(const LogCertificate& said) const;
  std::string check_certificate(const LogRecord& record, RealRoot& instant);
  // Puts the problem off, if an event of the structure at the instant of the record can still explain it.
  std::string put_off(const LogRecord& record, const std::string& problem);
  // What a certificate must be like at an instant.
  struct Failure {
    bool vanishes = true, negative_after = true;
  };
  std::string polynomial_problem(const Polynomial& polynomial, const Failure& failure, RealRoot& instant);
  std::string direction_problem(const DirectionMeanings& meanings, const std::string& predicate,
                                std::span<const Trajectory* const> of, const Failure& failure,
                                RealRoot& instant);
  std::string feature_problem(const std::vector<std::string>& ids) const;
  void note_instant(const LogRecord& record);
  bool may_be_made_negative(const LogRecord& record) const;
  std::shared_ptr<const Predicate> make_predicate(const std::string& label,
                                                  const std::string& name) const;
  const Predicate* predicate(const std::string& label, const std::string& name);

  const Scene& scene_;
  bool is_of_scene_;
  std::unordered_map<std::string, ObjectId> objects_;
  std::map<std::string, Key> keys_;  // by label, of structures that have one
  std::map<std::string, DirectionMeanings> directions_;  // by label, of structures that have some
  std::set<std::string> touching_;   // labels of structures whose certificates fail at touches, too
  std::set<std::string>
      turned_;  // labels of structures that certify an order after a turn where lengths are level
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const Predicate>> predicates_;
  MotionsInForce motions_;
  // Objects that appeared, and that got new motions, at the last such time: a certificate of the first,
  // and one of a tie that the second have made, can be negative without having been zero.
  std::vector<std::string> appeared_, moved_;
  std::optional<Rational> appeared_at_;
  bool lost_ = false;  // a change of motion at an unknown time
  // By label: what the structure watches, and what that watches.
  std::map<std::string, std::set<std::string>> watched_;
  // The instant of the last record, and the labels of the structures that have repaired something at it
  // in a way that may leave negative certificates for later events of the same instant.
  Polynomial instant_polynomial_;
  int instant_root_ = 0;
  std::set<std::string> changed_, rearranged_;
  bool again_ = false;  // its structure has another record at the instant before it
  std::multimap<std::string, LateProblem> doubts_;  // by label, at the instant
  std::vector<LateProblem> late_;
  std::uint64_t certificates_ = 0;
  UncheckedCertificates unchecked_;
  RootCounters counters_;
};

}  // namespace kinex::formats

#endif
