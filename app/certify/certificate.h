// Whether a foreign program has the forces of a model: what it was asked, what it answered, and how fast. The protocol:
// docs/certify.md.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/bundle/sources.h"
#include "app/certify/foreign_program.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::certify {

/// A point of the model and its force.
struct Point {
  std::vector<double> inputs;
  double force_n = 0;
  bool fired = false;
};

/// What is asked.
struct Questions {
  fuzzy::ForceModel model;
  std::string model_sha256;
  std::vector<Point> points;
  bundle::FeltTraces insertions;  ///< none where the model has no tube
};

/// The points of the model's checks with their forces, and scripted insertions.
base::Result<Questions> questionsOf(fuzzy::ForceModel model, std::string sha256);
/// The same of the bundle in `folder`, which must be undamaged: its own points, and its own insertions if it has some.
base::Result<Questions> questionsOfBundle(const std::string& folder);

struct CertifySettings {
  double tolerance = 1e-9;  ///< in N for forces, in mm for depths
  std::string utc;          ///< of the examination
  std::string generator;
};

/// Times of answers, in microseconds.
struct Percentiles {
  double half = 0;
  double p99 = 0;
  double p999 = 0;
  double largest = 0;
};

/// The nearest ranks in `values`, in any order; zeros for none.
Percentiles percentilesOf(std::vector<double> values);

/// The answers to questions of one kind.
struct Answers {
  std::size_t all = 0;      ///< questions
  std::size_t right = 0;    ///< within the tolerance and in time
  std::size_t wrong = 0;    ///< another force, or no force
  std::size_t late = 0;     ///< came after the next question
  std::size_t missing = 0;  ///< never came
  double largest_error_n = 0;
  std::string where;               ///< of the largest error; empty without one
  std::vector<double> latency_us;  ///< from question to answer, in their order

  std::size_t unasked() const { return all - right - wrong - late - missing; }
  Percentiles latency() const { return percentilesOf(latency_us); }
  /// Of the differences between one time and the next.
  Percentiles jitter() const;
};

struct Certificate {
  std::string target;
  std::string program;  ///< what it said it is
  std::string model_name;
  std::string model_sha256;
  std::string utc;
  std::string generator;
  std::string machine;
  double tolerance = 0;
  bool has_tube = false;  ///< the program answers for the tube, and the model has one
  bool program_has_tube = true;
  Answers points;
  Answers steps;
  double largest_depth_error_mm = 0;
  std::string failure;  ///< the first thing that went wrong, in one sentence; empty: nothing

  bool ok() const { return failure.empty() && points.right == points.all && steps.right == steps.all; }
  /// The verdict in one sentence.
  std::string verdict() const;
};

/// Asks the program everything. Refused: one that cannot be started or reached; a request to stop.
base::Result<Certificate> certify(const Target& target, const Questions& questions, const CertifySettings& settings,
                                  const Patience& patience);

/// One printed page.
std::string certificatePage(const Certificate& certificate);

/// A size with two digits: `3.3e-16`, `2.6e-3`, `0`.
std::string scientific(double value);

/// The name of this computer's processor; empty where the system does not tell.
std::string processor();

}  // namespace tactus::certify
