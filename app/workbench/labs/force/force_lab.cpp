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
      work_(data, [this](const LabWork::Run& run) -> LabWork::Deliver {
        auto found = std::make_shared<Found>();
        found->study = run.study;
        found->votes = forceVotes(run.study->study, run.settings.series, run.settings.force_end_n);
        found->series = seriesOf(run.study->study);
        found->checks = judgementChecks(found->votes.words, run.study->judged);
        return [this, found] {
          found_ = std::move(*found);
          emit changed();
        };
      }) {
  connect(&data_, &LabData::settingsChanged, this, &ForceLab::changed);
  connect(&model_, &LabModel::builtChanged, this, &ForceLab::compareAsked);
  connect(&data_, &LabData::studyChanged, this, [this] {
    if (data_.study() != nullptr || found_.study == nullptr) return;
    found_ = {};
    asked_.reset();
    setInfluence({});
    emit changed();
  });
}

const std::vector<session::JudgedForce>& ForceLab::judgements() const {
  static const std::vector<session::JudgedForce> kNone;
  return found_.study == nullptr ? kNone : found_.study->judged;
}

void ForceLab::setWanted(bool wanted) {
  data_.setWanted(*this, wanted);
  model_.setWanted(*this, wanted);
  work_.setWanted(wanted);
}

void ForceLab::askInfluence(const session::JudgedForce& judged) {
  asked_ = judged;
  compareAsked();
}

void ForceLab::compareAsked() {
  if (!asked_) return;
  const session::JudgedForce& judged = *asked_;
  const auto built = model_.built();
  const auto study = model_.builtFrom();
  if (!judged.counts || built == nullptr) return setInfluence({});
  const auto& judgements = study->study.judgements;
  const auto found = std::find_if(judgements.begin(), judgements.end(), [&](const study::ForceJudgement& one) {
    return one.participant == judged.participant && one.series == judged.record.series &&
           one.step == judged.record.step;
  });
  if (found == judgements.end()) return setInfluence({});
  const auto index = static_cast<std::size_t>(found - judgements.begin());
  const QString who =
      tr("%1 at %2")
          .arg(harmless(text(judged.participant)), quantityText(judged.record.commanded_n, found_.votes.words.unit));
  influence_work_.run([this, built, study, with = model_.builtWith(), index, who](const std::stop_token&) {
    const auto moved = elicitation::withoutJudgement(*built, study->study, with, index);
    return [this, sentence = influenceText(who, moved, built->model)] { setInfluence(sentence); };
  });
}

void ForceLab::setInfluence(const QString& sentence) {
  influence_ = sentence;
  emit influenceChanged();
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
          .arg(harmless(text(judged.participant)), quantityText(judged.record.commanded_n, found_.votes.words.unit),
               judgedText(found_.votes.words, word), judgedText(found_.votes.words, judgedWord(judged.record))));
}

}  // namespace tactus::workbench
