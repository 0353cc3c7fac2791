// The report of a study: its data, every step to the averaged model, and what is missing, in one page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/claims.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/data_finding.h"
#include "core/study/records.h"
#include "elicitation/model/evidence.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/speed_bootstrap.h"
#include "experiments/duel_run.h"
#include "experiments/order_effects.h"
#include "experiments/published_tables.h"
#include "questionnaires/scale_summary.h"

namespace tactus::report {

// The report of `tactus demo`: the paper's tables and figures recomputed beside the published numbers, in one page.

/// The published rules in one of their readings, as a model with only their expert.
struct S4Reading {
  std::string title;    ///< e.g. `As printed`
  std::string assumes;  ///< one sentence
  fuzzy::ForceModel model;
};

/// The input of the report. The report computes curves, claims and summaries itself and reads no file.
struct DemoReportInputs {
  const study::Study& study;                       ///< including the simulated data
  const elicitation::BuiltModel& built;            ///< built from that study
  elicitation::BuildSettings build_settings = {};  ///< the settings of that build
  std::vector<experiments::PublishedSpeed> published_speeds = experiments::publishedSpeeds();  ///< Table 1
  std::vector<experiments::PublishedVotes> published_votes = experiments::publishedVotes();    ///< Table 2
  std::vector<S4Reading> readings;
  std::vector<study::Form> forms = {};                        ///< forms of the answers
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value: versions, seed, parameters
  std::string published_expert = "S4";                        ///< the expert whose rules are published
  std::string highest_peak_expert = "S2";                     ///< the expert whose peak is the highest according to the
                                                              ///< paper
};

/// The page as HTML. Captions mark everything simulated. Refused: an averaged model without the paper's inputs or
/// without the published expert.
base::Result<std::string> demoReport(const DemoReportInputs& inputs);

/// The input of the report. The report computes curves and summaries itself and reads no file.
struct StudyReportInputs {
  const study::Study& study;
  /// Built from that study. Without rules: elicitation::buildTerms, a model without experts.
  const elicitation::BuiltModel& built;
  elicitation::BuildSettings build_settings = {};              ///< the settings of that build
  std::vector<study::Form> forms = {};                         ///< forms of the answers
  std::vector<study::DataFinding> data = {};                   ///< what to look at in the data
  std::vector<std::pair<std::string, std::string>> settings;   ///< further names and values: file, versions
  std::size_t replicates = elicitation::kBootstrapReplicates;  ///< draws of strokes for intervals; 0: no intervals
  std::vector<questionnaires::ScaleSummary> usability = {};    ///< of the usability scale; empty without answers
  bool usability_simulated = false;                            ///< a simulated person gave one of these answers
  std::vector<experiments::DoneInOrder> in_order = {};         ///< for catch trials and effects of the order
  std::vector<experiments::JudgedDuel> duels = {};             ///< blind comparisons of models by hand
  std::vector<elicitation::SealedCurve> sealed = {};           ///< references that are or were under seal
};

/// The page as HTML: self-contained, numbered tables and figures, for screen and paper. Each picture with data of a
/// simulated person says so. What the study lacks (speeds, judgements, answers, a second participant) is named, and
/// the sections that need it are left out. With many participants only some are drawn one by one; tables hold all.
/// What is the paper's own appears only for its procedure. Refused: a model without a way.
base::Result<std::string> studyReport(const StudyReportInputs& inputs);

}  // namespace tactus::report
