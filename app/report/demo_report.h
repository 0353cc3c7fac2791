// The report of `tactus demo`: the paper's tables and figures recomputed beside the published numbers, in one page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/claims.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"
#include "experiments/published_tables.h"

namespace tactus::report {

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

/// The page as HTML. Captions mark everything simulated. Refused: an averaged model without the four inputs of the
/// study or without the published expert.
base::Result<std::string> demoReport(const DemoReportInputs& inputs);

}  // namespace tactus::report
