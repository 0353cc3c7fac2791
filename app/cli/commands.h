// The commands of `tactus`: plain functions from options to what is printed. The command line itself: program.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/sampled_centroid.h"
#include "core/base/error.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::cli {

/// What a command prints once it has succeeded.
struct Output {
  std::string text;                   ///< to standard output
  std::vector<std::string> warnings;  ///< one line each, to standard error
  /// The text is a table for another program, not a message: no character of it is escaped.
  bool is_table = false;
};

struct EvalOptions {
  std::string model;
  std::string points;                          ///< CSV with a column per input id
  std::string out;                             ///< empty: standard output
  std::string expert;                          ///< empty: the mean
  std::optional<analysis::Sampling> sampling;  ///< absent: exact
};
/// The rows of the points with the columns `force` and `fired` added.
base::Result<Output> eval(const EvalOptions& options);

struct CheckOptions {
  std::string model;
  bool json = false;
};
/// Validation and lint of a model file. Findings are results, not failures.
base::Result<Output> check(const CheckOptions& options);

struct ClusterOptions {
  std::string speeds;
  std::string column = "speed_mm_s";
  int clusters = 3;
  double m = 2;
  bool json = false;
};
/// Fuzzy C-Means of one column.
base::Result<Output> cluster(const ClusterOptions& options);

struct VoteOptions {
  std::string judgements;  ///< judgements.csv or a table of counts as in Table 2
  std::string series = "ascending";
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  std::optional<double> force_end_n;
  bool json = false;
};
/// The vote on each force and the terms that follow from it.
base::Result<Output> vote(const VoteOptions& options);

struct AgreementOptions {
  std::string file;                  ///< answers.csv, judgements.csv or a table of counts as in Table 2
  std::string series = "ascending";  ///< of judgements
  std::string form;                  ///< of answers; empty: the one with the most ratings
  bool json = false;
};
/// How far the raters agree.
base::Result<Output> agreement(const AgreementOptions& options);

struct BuildOptions {
  std::string study;  ///< a study file, or a folder with the CSV tables
  std::string out;
  std::string weights = "equal";  ///< equal, years, category, column, or a file
  double alpha = elicitation::kDefaultAlpha;
  double trim = 0;
  elicitation::SpeedCentres centres = elicitation::SpeedCentres::kClusters;
  elicitation::Averaging averaging = elicitation::Averaging::kMean;
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  std::optional<double> force_end_n;
  std::vector<std::string> accept;  ///< kinds of findings that do not stop the build (accepted_data.h)
  std::size_t replicates = 2000;    ///< of the strokes, for intervals; 0: none
  bool own_terms = false;
  bool json = false;
};
/// Elicitation: from a study to the averaged model file.
base::Result<Output> build(const BuildOptions& options);

struct SimulateOptions {
  std::string model;
  std::string scenario;  ///< docs/scenario.md
  std::string out;       ///< CSV file of the trace
  bool json = false;
};
/// The servo on a simulated device with a simulated hand, in simulated time.
base::Result<Output> simulate(const SimulateOptions& options);

struct DemoOptions {
  std::string folder;
  std::optional<std::uint64_t> seed;
  std::string reading;  ///< of Table A2; empty: the default
  bool json = false;
};
/// The whole main job on the published data.
base::Result<Output> demo(const DemoOptions& options);

}  // namespace tactus::cli
