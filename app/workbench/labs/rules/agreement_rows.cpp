#include "app/workbench/labs/rules/agreement_rows.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "elicitation/agreement/agreement_data.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {
namespace {

struct AgreementWords {
  Q_DECLARE_TR_FUNCTIONS(AgreementWords)
};

std::optional<double> meanConsensus(const elicitation::Agreement& measures) {
  double sum = 0;
  int count = 0;
  for (const auto& item : measures.items) {
    if (!item) continue;
    sum += item->consensus;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

AgreementRow rowOf(const QString& ratings, const base::Result<elicitation::AgreementData>& data,
                   const std::stop_token& stop) {
  AgreementRow row;
  row.ratings = ratings;
  if (!data) {
    row.refusal = text(data.error().message());
    return row;
  }
  row.units = data->units.size();
  row.raters = data->raters.size();
  row.measures = elicitation::agreement(*data);
  row.consensus = meanConsensus(row.measures);
  row.interval = elicitation::alphaInterval(data->counts, elicitation::AlphaLevel::kOrdinal, {.stop = stop});
  return row;
}

}  // namespace

std::vector<AgreementRow> agreementRows(const LabStudy& study, const std::stop_token& stop) {
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : elicitation::ngtOutput().terms) ids.push_back(term.id);
  return {rowOf(AgreementWords::tr("Judged forces"),
                elicitation::agreementData(study.study.judgements, "ascending", ids), stop),
          rowOf(AgreementWords::tr("Answers to the form"),
                elicitation::agreementData(study.study.answers, {}, study.forms, ids), stop)};
}

std::vector<UsabilityRow> usabilityRows(const LabStudy& study) {
  const questionnaires::ScaleForm form = questionnaires::usabilityForm();
  const auto here = questionnaires::summarize(form, study.answers);
  const auto published = questionnaires::publishedUsability();
  std::vector<UsabilityRow> rows;
  for (std::size_t i = 0; i < form.items.size(); ++i) {
    UsabilityRow row{text(form.items[i].text), here[i], {}};
    if (i < published.size()) row.published = published[i];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace tactus::workbench
