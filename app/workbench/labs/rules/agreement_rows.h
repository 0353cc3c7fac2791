// How far the experts agree, and how a scale was answered, as rows for the screen.
#pragma once

#include <QString>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/agreement/agreement.h"
#include "elicitation/agreement/krippendorff_alpha.h"
#include "questionnaires/scale_summary.h"

namespace tactus::workbench {

/// The measures of one set of ratings.
struct AgreementRow {
  QString ratings;        ///< `Judgements, rising forces`, `Answers to the form`
  std::size_t units = 0;  ///< forces or items
  std::size_t raters = 0;
  elicitation::Agreement measures;
  std::optional<elicitation::AlphaInterval> interval;  ///< of the ordinal alpha
  QString refusal;                                     ///< why there are no measures; empty if there are
};

/// Of the ascending judgements and of the form with the most answers. An interval that takes too long ends with `stop`.
std::vector<AgreementRow> agreementRows(const LabStudy& study, const std::stop_token& stop);

/// One item of the usability scale (Table 3): of this study, and as the paper printed it.
struct UsabilityRow {
  QString statement;
  questionnaires::ScaleSummary here;  ///< n = 0: no answers
  questionnaires::ScaleSummary published;
};

std::vector<UsabilityRow> usabilityRows(const LabStudy& study);

std::vector<Column<AgreementRow>> agreementColumns();
std::vector<Column<UsabilityRow>> usabilityColumns();

}  // namespace tactus::workbench
