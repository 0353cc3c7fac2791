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

/// The published rules in one of their readings, as a model of their expert alone.
struct S4Reading {
  std::string title;    ///< e.g. `As printed`
  std::string assumes;  ///< one sentence
  fuzzy::ForceModel model;
};

/// Everything the report shows. It computes curves, claims and summaries itself and reads no file.
struct DemoReportInputs {
  const study::Study& study;                       ///< with the simulated data
  const elicitation::BuiltModel& built;            ///< from that study
  elicitation::BuildSettings build_settings = {};  ///< with these
  std::vector<experiments::PublishedSpeed> published_speeds = experiments::publishedSpeeds();  ///< Table 1
  std::vector<experiments::PublishedVotes> published_votes = experiments::publishedVotes();    ///< Table 2
  std::vector<S4Reading> readings;
  std::vector<study::Form> forms = {};                        ///< those that the answers are about
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value: versions, seed, parameters
  std::string published_expert = "S4";                        ///< whose rules are published
  std::string highest_peak_expert = "S2";                     ///< whose peak the paper calls the highest
};

/// The page, as HTML. Everything simulated is marked so in its caption. Refused: an averaged model without the four
/// inputs of the study or without the published expert.
base::Result<std::string> demoReport(const DemoReportInputs& inputs);

}  // namespace tactus::report
