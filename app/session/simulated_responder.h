// A simulated nurse's judgement of a force. For tests and demonstrations only; it is not a model of a real person.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/study/records.h"

namespace tactus::session {

/// The just noticeable difference of a force, N: sqrt(0.04² + (0.12 F)²), from the absolute threshold (0.04 N;
/// Feyzabadi 2013, King 2010) and a Weber fraction of 0.12 (Feyzabadi 2013 gives .08 to .13). `force_n` >= 0.
double justNoticeableN(double force_n);

/// The person, and the noise of the judgements.
struct ResponderTraits {
  std::string code;                 ///< participant
  std::vector<double> threshold_n;  ///< ascending thresholds between the terms, from the smallest term
  double felt_from_n = 0.04;        ///< a smaller percept is judged `not_felt`
  double beyond_from_n = 1.15;      ///< a percept of this size or more is judged `beyond_practice`
  double noise = 1;                 ///< noise of the percept in just-noticeable differences; 0: none
  double lapse = 0.02;              ///< probability of a random term, 0 to 1
  double assimilation = 0;          ///< share by which a percept moves toward the previous one, 0 to 1; 0.1 is usual
};

/// The four persons of simulatedJudgements(), whose votes are those of Table 2. A threshold is the middle between the
/// last force of a term and the first force of the next term; the lowest one is the middle between the first force and
/// 0 N. With `noise` and `lapse` 0 they reproduce Table 2, as one of many possible splits of its votes.
std::vector<ResponderTraits> respondersOfTable2();

struct Response {
  study::ForceJudgement::Kind kind = study::ForceJudgement::Kind::kNoAnswer;
  std::string term;
  double percept_n = 0;
};

/// Judges forces one after another. The order matters if `assimilation` is above 0.
class SimulatedResponder {
 public:
  /// `terms`: ids from the smallest term, one more than thresholds.
  SimulatedResponder(ResponderTraits traits, std::vector<std::string> terms);

  /// The judgement of a force that the moving hand feels, N.
  Response judge(double felt_n, base::Random& random);

 private:
  ResponderTraits traits_;
  std::vector<std::string> terms_;
  std::optional<double> before_n_;
};

}  // namespace tactus::session
