// How a simulated nurse judges a force. Not a model of anybody: for tests and demonstrations only.
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

/// Who answers, and how noisily.
struct ResponderTraits {
  std::string code;                 ///< participant
  std::vector<double> threshold_n;  ///< ascending; between the terms, from the least
  double felt_from_n = 0.04;        ///< a smaller percept is `not_felt`
  double beyond_from_n = 1.15;      ///< a percept from here on is `beyond_practice`
  double noise = 1;                 ///< of the percept, in just noticeable differences; 0 = none
  double lapse = 0.02;              ///< probability of a random term, 0 to 1
  double assimilation = 0;          ///< share by which a percept is drawn to the one before, 0 to 1; 0.1 is usual
};

/// The four persons of simulatedJudgements(), whose votes are those of Table 2: their thresholds lie in the middle
/// between the last force of a term and the first of the next one; below the first force, in the middle to 0 N. With
/// `noise` and `lapse` 0 they give Table 2 again, one of many possible splits of its votes.
std::vector<ResponderTraits> respondersOfTable2();

struct Response {
  study::ForceJudgement::Kind kind = study::ForceJudgement::Kind::kNoAnswer;
  std::string term;
  double percept_n = 0;
};

/// Judges forces one after another.
class SimulatedResponder {
 public:
  /// `terms`: ids from the least, one more than there are thresholds.
  SimulatedResponder(ResponderTraits traits, std::vector<std::string> terms);

  /// The answer to a force as the moving hand feels it, N.
  Response judge(double felt_n, base::Random& random);

 private:
  ResponderTraits traits_;
  std::vector<std::string> terms_;
  std::optional<double> before_n_;
};

}  // namespace tactus::session
