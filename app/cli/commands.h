// The commands of `tactus`: plain functions from options to output. The command line itself: program.cpp.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/centroid_bound.h"
#include "core/base/error.h"
#include "elicitation/depth/depth_measurement.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::cli {

/// The output of a command that succeeded.
struct Output {
  std::string text;                   ///< for standard output
  std::vector<std::string> warnings;  ///< one line each, for standard error
  /// The text is a table for another program, not a message: it is printed without escaping.
  bool is_table = false;
  /// Set if a verification failed: the text is printed, this sentence goes to standard error, and the exit status is 1.
  std::string failure = {};
};

struct EvalOptions {
  std::string model;
  std::string points;                          ///< CSV with one column per input id
  std::string out;                             ///< empty: standard output
  std::string expert;                          ///< empty: the mean
  std::optional<analysis::Sampling> sampling;  ///< nothing: exact
};
/// Evaluates the points. The output has their rows and the columns `force` and `fired`.
base::Result<Output> eval(const EvalOptions& options);

struct CheckOptions {
  std::string model;
  std::vector<std::string> contracts;  ///< sentences to check beside those of the model
  bool json = false;
};
/// Validates and lints a model file, and checks its contracts. Findings are results, not failures; a violated contract
/// is a failure.
base::Result<Output> check(const CheckOptions& options);

struct ClusterOptions {
  std::string speeds;
  std::string column = "speed_mm_s";
  int clusters = 3;
  double m = 2;
  bool json = false;
};
/// Runs Fuzzy C-Means on one column.
base::Result<Output> cluster(const ClusterOptions& options);

struct VoteOptions {
  std::string judgements;  ///< judgements.csv, or a table of counts like Table 2
  std::string series = "ascending";
  std::string pack;  ///< the procedure of a single table; empty: the pack beside it, or the default one
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  std::optional<double> force_end_n;
  bool json = false;
};
/// Votes on each force, and gives the resulting terms.
base::Result<Output> vote(const VoteOptions& options);

struct AgreementOptions {
  std::string file;                  ///< answers.csv, judgements.csv, or a table of counts like Table 2
  std::string series = "ascending";  ///< for judgements
  std::string form;                  ///< for answers; empty: the form with the most ratings
  std::string pack;                  ///< the procedure; empty: the pack beside the table, or the default one
  bool json = false;
};
/// Computes the agreement of the raters.
base::Result<Output> agreement(const AgreementOptions& options);

struct BuildOptions {
  std::string study;  ///< a study file or a folder of CSV tables
  std::string out;
  std::string weights = "equal";  ///< equal, years, category, column, or a file
  double alpha = elicitation::kDefaultAlpha;
  double trim = 0;
  elicitation::SpeedCentres centres = elicitation::SpeedCentres::kClusters;
  elicitation::Averaging averaging = elicitation::Averaging::kMean;
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  std::optional<double> force_end_n;
  elicitation::DepthsFrom depths = elicitation::DepthsFrom::kTemplate;
  std::vector<std::string> accept;  ///< kinds of findings that do not stop the build (study_build.h)
  std::size_t replicates = 2000;    ///< of the strokes, for intervals; 0: none
  bool own_terms = false;
  bool json = false;
};
/// Elicits the averaged model file from a study.
base::Result<Output> build(const BuildOptions& options);

/// The options of `build`; `out` is the page.
struct ReportOptions : BuildOptions {};
/// Writes the report of a study (app/report/study_report.h). The report names what the study lacks.
base::Result<Output> writeReport(const ReportOptions& options);

struct WhyOptions {
  std::string model;
  std::vector<std::string> at;  ///< `INPUT=VALUE`, each input once
  std::string expert;           ///< id of one expert; empty: the mean
  bool json = false;
};
/// Why the force at a point is what it is, and what would change it.
base::Result<Output> why(const WhyOptions& options);

struct TellOptions {
  std::string first;
  std::string second;
  std::string first_expert;  ///< id of one expert; empty: the mean
  std::string second_expert;
  std::string strokes;  ///< file for the stroke; empty: none
  bool json = false;
};
/// The insertion in which a hand feels the largest difference between two models, and a bound on all others.
base::Result<Output> tellApart(const TellOptions& options);

struct ReplayOptions {
  std::string study;            ///< or a file of strokes
  std::string model;            ///< the model after
  std::string before;           ///< model file to compare with; empty: the last version in the study
  bool last_sign_off = false;   ///< compares with the version that was signed off last
  std::vector<std::string> at;  ///< `INPUT=VALUE` of conditions that strokes have no recorded value for
  bool json = false;
};
/// Runs the recorded strokes of a study through two models: what would feel different.
base::Result<Output> replayStrokes(const ReplayOptions& options);
struct DuelPlanOptions {
  std::vector<std::string> models;  ///< two model files to compare; empty: `jnd` alone
  std::vector<std::string> at;      ///< `INPUT=VALUE`, each input of the models but the depth
  std::optional<double> from_mm;    ///< the stroke
  std::optional<double> to_mm;
  std::optional<double> jnd;  ///< the difference that is looked for; by default the one along the stroke
  double power = 0.8;
  bool json = false;
};
/// How many trials a blind comparison by hand takes.
base::Result<Output> duelPlan(const DuelPlanOptions& options);

struct DuelSimulateOptions {
  std::string rule = "fixed";  ///< fixed, sequential or own-jnd
  int trials = 23;
  double sought_jnd = 1;
  double jnd = 0;         ///< the difference that the simulated persons feel
  double own_jnd = 1;     ///< of the persons, as a multiple of the usual one
  double cant_tell = 0;   ///< share of answers
  double order_bias = 0;  ///< in JND, toward the first stroke
  int runs = 2000;
  std::uint64_t seed = 1;
  bool json = false;
};
/// What simulated persons do in a blind comparison, beside the exact chances.
base::Result<Output> duelSimulate(const DuelSimulateOptions& options);

struct DuelResultsOptions {
  std::string study;
  std::string out;  ///< CSV file of the trials; empty: none
  bool json = false;
};
/// The blind comparisons of a study. An unfinished one says nothing of its answers.
base::Result<Output> duelResults(const DuelResultsOptions& options);

struct PullOptions {
  std::string model;
  std::vector<std::string> at;       ///< `INPUT=VALUE`, each input once
  std::optional<double> force_n;     ///< wanted at the point; needed unless there is a curve
  std::string curve;                 ///< CSV file of a reference curve or band; empty: none
  std::string expert;                ///< id of one expert; empty: the mean
  std::vector<std::string> locked;   ///< ids of variables whose terms must not change; `rules`: no rule changes
  std::vector<std::string> pins;     ///< `INPUT=VALUE,…` each: points whose force stays; the other inputs as in `at`
  std::string study;                 ///< study file whose history may hold sign-offs on the model; empty: none
  std::optional<std::size_t> apply;  ///< candidate to write, from 1
  std::string out;                   ///< model file for it
  bool json = false;
};
/// The smallest edits that give a wanted force at a point; writes one of them as a model.
base::Result<Output> pull(const PullOptions& options);

struct BenchOptions {
  std::string model;
  double seconds = 0.2;  ///< for each row
  bool json = false;
};
/// Run time against error on this machine: one point, a batch and a scene beside sampled centroids.
base::Result<Output> bench(const BenchOptions& options);

struct SimulateOptions {
  std::string model;
  std::string scenario;  ///< docs/scenario.md
  std::string out;       ///< CSV file for the trace
  bool json = false;
};
/// Runs the servo on a simulated device with a simulated hand, in simulated time.
base::Result<Output> simulate(const SimulateOptions& options);

struct DemoOptions {
  std::string folder;
  std::optional<std::uint64_t> seed;
  std::string reading;  ///< reading of Table A2; empty: the default
  std::string pack;     ///< of another procedure, with experts that are invented from its pack; empty: the paper's
  bool json = false;
};
/// Runs the whole elicitation on the published data, or on simulated experts of another procedure.
base::Result<Output> demo(const DemoOptions& options);

struct BundleOptions {
  std::string model;
  std::string out;                        ///< folder, or a zip file
  std::vector<std::string> accept_holes;  ///< names of holes that may stay
  std::optional<double> table_error_n;    ///< that the look-up table may have anywhere; nothing: the usual one
  std::string study;                      ///< study file whose sign-offs and pack go along; empty: none
  std::string sign;                       ///< file of a private key of OpenSSH; empty: no signature
  bool json = false;
};
/// Writes the bundle of a model, whole or not at all.
base::Result<Output> bundle(const BundleOptions& options);

struct VerifyOptions {
  std::string folder;  ///< or its manifest, or a zip file; empty: the present folder
  std::string expect;  ///< the fingerprint that the sender told, spaces in it or not; empty: any
  std::string key;     ///< file of the sender's public key, whose signature there must be; empty: any or none
  bool json = false;
};
/// Reads a bundle back, and checks the contracts of its model. A file that is missing, altered or beyond its tolerance
/// is a failure, and so is a violated contract.
base::Result<Output> verify(const VerifyOptions& options);

struct CertifyOptions {
  std::string target;                  ///< certify::Target
  std::vector<std::string> arguments;  ///< of a program that is started
  std::string model;                   ///< model file, folder of a bundle, or its manifest
  std::string out;                     ///< page to write; empty: none
  std::optional<std::size_t> points;   ///< at most; nothing: all
  double tolerance = 1e-9;             ///< N, and mm for depths
  double timeout_s = 2;                ///< of an answer
  bool json = false;
};
/// Asks a foreign program for the forces of a model. An answer that is wrong, late or missing is a failure.
base::Result<Output> certifyProgram(const CertifyOptions& options);

struct ConvertOptions {
  std::string model;
  std::string to;                  ///< fll, fcl, fcl-fuzzylite, fis, fml or c
  std::string out;                 ///< folder
  std::vector<std::string> fixed;  ///< `INPUT=VALUE`, for c: inputs that stay at a value
  bool json = false;
};
/// Writes a model for other programs: one file per expert, or C source.
base::Result<Output> convert(const ConvertOptions& options);

struct ImportOptions {
  std::string file;    ///< FLL, FCL or FIS
  std::string out;     ///< model file
  std::string from;    ///< fll, fcl or fis; empty: told from the content
  std::string output;  ///< name of the output to take; empty: the only one
  bool json = false;
};
/// Writes a model file from the model of another fuzzy program.
base::Result<Output> import(const ImportOptions& options);

struct DiffOptions {
  std::string first;
  std::string second;
  bool json = false;
};
/// The difference of two models: terms and rules, and newtons.
base::Result<Output> diff(const DiffOptions& options);

struct RebaseOptions {
  std::string base;               ///< the model that was tuned, as it was built
  std::string tuned;              ///< its tuned version
  std::string target;             ///< the model that was built anew
  std::vector<std::size_t> only;  ///< numbers of the edits to carry over, from 1; empty: all that apply
  std::string out;                ///< model file; empty: none is written
  bool json = false;
};
/// The edits between two models, tried on a third one: what each moves, or why it does not apply.
base::Result<Output> rebase(const RebaseOptions& options);

struct ServeOptions {
  std::string model;
  std::uint16_t port = 0;  ///< of the loopback; 0: a free one
  std::string socket;      ///< socket file; empty: none
  std::string token_file;  ///< empty: one in a private folder, removed at the end
  bool watch = false;      ///< serve the file again when it changes
};
/// Serves a model over the live link until SIGINT or SIGTERM. Writes one line with its address to `out`, and to `err`
/// one sentence each time the file has changed and is no model.
base::Result<Output> serve(const ServeOptions& options, std::ostream& out, std::ostream& err);

struct EmulateHaplyOptions {
  std::uint16_t port = 10001;  ///< of the loopback; 0: a free one
  int devices = 1;
  std::string hand = "strokes";  ///< strokes, still, self-test
  bool without_grip = false;
  double rate_hz = 3000;
  double late_ms = 0;
  double late_share = 1;
  std::optional<double> dead_after_s;
  std::optional<double> silent_after_s;
  std::string trace;  ///< CSV file to write at the end; empty: none
};
/// Simulates the Haply Inverse Service until SIGINT or SIGTERM, or until it is dead as asked. Writes one line with its
/// address to `out`; returns a summary of what was commanded.
base::Result<Output> emulateHaply(const EmulateHaplyOptions& options, std::ostream& out);

// The commands of `tactus devices`. Two of them hold a dialog with the person at the device.

/// The streams of the dialog. Both outlive the command.
struct Terminal {
  std::istream* in = nullptr;
  std::ostream* out = nullptr;
};

struct DevicesOptions {
  bool json = false;
};
/// Lists the connected devices, with the reason if one cannot be used.
base::Result<Output> devices(const DevicesOptions& options);

struct DeviceTestOptions {
  std::string id;  ///< empty: the first usable device; hardware before the virtual device
  Terminal terminal;
  bool json = false;
  std::ostream* results = nullptr;  ///< stream for the JSON of a failed test
};
/// Runs the guided self-test. A failed check is an error.
base::Result<Output> testDevice(const DeviceTestOptions& options);

struct DeviceCalibrateOptions {
  std::string id;
  std::string method = "spring";  ///< `spring` or `weight`
  std::string inwards;            ///< `x,y,z`: only stores this insertion axis; empty: calibrates
  Terminal terminal;
};
/// Runs the guided calibration of a HID device and stores the result for this computer. Or stores the insertion axis of
/// an OpenHaptics device.
base::Result<Output> calibrateDevice(const DeviceCalibrateOptions& options);

}  // namespace tactus::cli
