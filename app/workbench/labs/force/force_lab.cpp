#include "app/workbench/labs/force/force_lab.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {

ForceVotes forceVotes(const study::Study& study, const std::string& series, std::optional<double> end_n) {
  ForceVotes out;
  out.words = elicitation::ngtOutput();
  out.enrolled = static_cast<int>(study.participants.size());
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : out.words.terms) ids.push_back(term.id);
  const auto counts = elicitation::countVotes(study.judgements, series, ids);
  if (!counts) {
    out.refusal = text(counts.error().message());
    return out;
  }
  out.steps = elicitation::vote(*counts, out.enrolled);
  for (std::size_t i = 0; i < kForceMethods.size(); ++i) {
    ForceMethod& method = out.methods[i];
    method.from = kForceMethods[i];
    auto terms = elicitation::forceTermsFrom(method.from, out.words, study.judgements, series, out.steps, end_n);
    if (terms) {
      method.terms = std::move(*terms);
    } else {
      method.refusal = text(terms.error().message());
    }
  }
  return out;
}

std::vector<std::string> seriesOf(const study::Study& study) {
  constexpr auto kFirst = "ascending";
  std::set<std::string> names;
  for (const study::ForceJudgement& judgement : study.judgements) names.insert(judgement.series);
  std::vector<std::string> out;
  if (names.erase(kFirst) > 0) out.emplace_back(kFirst);
  out.insert(out.end(), names.begin(), names.end());
  return out;
}

ForceLab::ForceLab(LabData& data, LabModel& model, Corrections& corrections, QObject* parent)
    : QObject(parent),
      data_(data),
      model_(model),
      corrections_(corrections),
      found_([&data] { return data.inputs(); },
             [](const LabInputs& from, const RunOf<Found>&) {
               auto found = std::make_shared<Found>();
               found->votes = forceVotes(from.study->study, from.settings.series, from.settings.force_end_n);
               found->series = seriesOf(from.study->study);
               found->checks = judgementChecks(found->votes.words, from.study->judged);
               return found;
             }),
      influence_([this] { return asked(); },
                 [](const Asked& asked, const RunOf<QString>&) {
                   const auto& [built, study, settings] = asked.built;
                   const auto moved = elicitation::withoutJudgement(*built, study->study, settings, asked.index);
                   return std::make_shared<const QString>(influenceText(asked.who, moved, built->model));
                 }) {
  followLabData(found_, data_);
  influence_.needs(model_);
  connect(&found_, &Computation::valueChanged, this, &ForceLab::changed);
  connect(&influence_, &Computation::valueChanged, this, &ForceLab::influenceChanged);
  connect(&data_, &LabData::settingsChanged, this, &ForceLab::changed);
  connect(&model_, &Computation::valueChanged, &influence_, &Computation::refresh);
}

const ForceLab::Found& ForceLab::found() const {
  static const Found kNothing;
  return found_.value() == nullptr ? kNothing : *found_.value();
}

const std::vector<session::JudgedForce>& ForceLab::judgements() const {
  static const std::vector<session::JudgedForce> kNone;
  return found_.of() == nullptr ? kNone : found_.of()->study->judged;
}

void ForceLab::setWanted(bool wanted) {
  found_.hold(*this, wanted);
  influence_.hold(*this, wanted);
}

void ForceLab::askInfluence(const session::JudgedForce& judged) {
  asked_ = judged;
  influence_.refresh();
}

std::optional<ForceLab::Asked> ForceLab::asked() const {
  const auto built = model_.inputs();
  if (!asked_ || !asked_->counts || !built) return std::nullopt;
  const auto& judgements = built->study->study.judgements;
  const auto found = std::find_if(judgements.begin(), judgements.end(), [&](const study::ForceJudgement& one) {
    return one.participant == asked_->participant && one.series == asked_->record.series &&
           one.step == asked_->record.step;
  });
  if (found == judgements.end()) return std::nullopt;
  return Asked{
      *built, static_cast<std::size_t>(found - judgements.begin()),
      tr("%1 at %2")
          .arg(harmless(text(asked_->participant)), quantityText(asked_->record.commanded_n, votes().words.unit))};
}

void ForceLab::setMethod(elicitation::ForceTermsFrom from) {
  elicitation::BuildSettings settings = data_.settings();
  settings.force_terms = from;
  data_.setSettings(std::move(settings));
}

void ForceLab::setSeries(const std::string& series) {
  elicitation::BuildSettings settings = data_.settings();
  settings.series = series;
  data_.setSettings(std::move(settings));
}

void ForceLab::correct(const session::JudgedForce& judged, const session::JudgedWord& word) {
  study::JudgementRecord wanted = judged.record;
  wanted.kind = word.kind;
  wanted.term = word.term;
  corrections_.correct(
      judged.record, wanted,
      tr("%1 at %2: %3 instead of %4")
          .arg(harmless(text(judged.participant)), quantityText(judged.record.commanded_n, votes().words.unit),
               judgedText(votes().words, word), judgedText(votes().words, judgedWord(judged.record))));
}

}  // namespace tactus::workbench
