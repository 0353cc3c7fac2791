#include "app/workbench/labs/force/force_lab.h"

#include <QCoreApplication>
#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {

ForceVotes forceVotes(const study::Study& study, const std::string& series, std::optional<double> end_n) {
  ForceVotes out;
  out.words = procedure::of(study).output;
  out.enrolled = static_cast<int>(study.participants.size());
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : out.words.terms) ids.push_back(term.id);
  const auto counts = elicitation::countVotes(study.judgements, series, ids);
  if (!counts) {
    out.refusal = text(counts.error().message());
    return out;
  }
  out.steps = elicitation::vote(*counts, out.enrolled);
  out.intervals = elicitation::wordIntervals(study.judgements, series, out.words.terms);
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

namespace {

using Effects = std::map<elicitation::ForceTermsFrom, double>;

Computed<BuiltStudy, Effects>::Answer effectsOf(const BuiltStudy& built, const RunOf<Effects>& run) {
  Effects effects;
  for (const auto from : kForceMethods) {
    if (from == built.settings.force_terms) continue;
    elicitation::BuildSettings settings = stoppable(built.settings, run.stop);
    settings.force_terms = from;
    const auto other = elicitation::buildModel(built.study->study, built.study->forms, settings, &built.model->speeds,
                                               [&run](double /*share*/) { return !run.stop.stop_requested(); });
    if (run.stop.stop_requested()) return nullptr;
    if (!other) continue;  // the column says why
    const auto moved = elicitation::methodDifference(built.model->model, other->model);
    if (moved) effects[from] = moved->largest_n;
  }
  return std::make_shared<const Effects>(std::move(effects));
}

}  // namespace

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
                 }),
      effects_([&model] { return model.inputs(); }, effectsOf) {
  followLabData(found_, data_);
  for (Computation* const cell : {static_cast<Computation*>(&influence_), static_cast<Computation*>(&effects_)}) {
    cell->needs(model_);
    connect(&model_, &Computation::valueChanged, cell, &Computation::refresh);
  }
  connect(&effects_, &Computation::valueChanged, this, &ForceLab::effectsChanged);
  connect(&found_, &Computation::valueChanged, this, &ForceLab::changed);
  connect(&influence_, &Computation::valueChanged, this, &ForceLab::influenceChanged);
  connect(&data_, &LabData::settingsChanged, this, &ForceLab::changed);
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
  effects_.hold(*this, wanted);
}

QString ForceLab::effectOf(elicitation::ForceTermsFrom from) const {
  // Those of another model than the present one are not shown.
  if (effects_.value() == nullptr || effects_.of()->model != model_.built()) return {};
  const auto effect = effects_.value()->find(from);
  if (effect == effects_.value()->end()) return {};
  return effect->second == 0 ? tr("Instead: the force stays")
                             : tr("Instead: at most %1").arg(quantityText(effect->second, "N", 3));
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

namespace {

using elicitation::ForceTermsFrom;
using elicitation::VoteReason;

struct VoteWords {
  Q_DECLARE_TR_FUNCTIONS(VoteWords)
};

QString shortReason(VoteReason reason) {
  switch (reason) {
    case VoteReason::kMajority: return VoteWords::tr("half or more");
    case VoteReason::kTieHigher: return VoteWords::tr("tie, the higher wins");
    case VoteReason::kNextLevel: return VoteWords::tr("no half, next level");
    case VoteReason::kClamped: return VoteWords::tr("next level, limited");
    case VoteReason::kFirstMedian: return VoteWords::tr("median");
    case VoteReason::kNoVotes: return VoteWords::tr("no votes");
  }
  return {};
}

}  // namespace

QString reasonText(const elicitation::VoteStep& step) {
  QString out = shortReason(step.reason);
  if (elicitation::isUnsaid(step)) {
    out += VoteWords::tr(", nobody said it");
  } else if (!elicitation::isMostFrequent(step)) {
    out += VoteWords::tr(", not the most frequent");
  }
  if (step.monotone_raised) out += VoteWords::tr(", raised");
  if (step.below_quorum) out += VoteWords::tr(", below quorum");
  return out;
}

QString reasonRule(const elicitation::VoteStep& step) {
  QString out;
  switch (step.reason) {
    case VoteReason::kMajority: out = VoteWords::tr("One word has half of the votes or more."); break;
    case VoteReason::kTieHigher:
      out = VoteWords::tr("Two words have half of the votes each: the higher one wins.");
      break;
    case VoteReason::kNextLevel:
      out = VoteWords::tr("No word has half. The forces rise, so one word above that of the force before.");
      break;
    case VoteReason::kClamped:
      out =
          VoteWords::tr("No word has half. One word above that of the force before, moved into the words with votes.");
      break;
    case VoteReason::kFirstMedian:
      out = VoteWords::tr("No word has half and no force was decided before: the lower median.");
      break;
    case VoteReason::kNoVotes: out = VoteWords::tr("No participant chose a word."); break;
  }
  if (elicitation::isUnsaid(step)) {
    out += VoteWords::tr(" Nobody said this word here.");
  } else if (!elicitation::isMostFrequent(step)) {
    out += VoteWords::tr(" Another word was said more often.");
  }
  if (step.monotone_raised) out += VoteWords::tr(" Raised to the word of a smaller force: words must not fall.");
  if (step.below_quorum) out += VoteWords::tr(" Fewer than half of the participants voted.");
  return out;
}

QString methodName(ForceTermsFrom from) {
  switch (from) {
    case ForceTermsFrom::kVote: return VoteWords::tr("Vote");
    case ForceTermsFrom::kFrequency: return VoteWords::tr("Frequency");
    case ForceTermsFrom::kThresholds: return VoteWords::tr("Thresholds");
    case ForceTermsFrom::kProbit: return VoteWords::tr("Probit");
  }
  return {};
}

QString methodRule(ForceTermsFrom from) {
  switch (from) {
    case ForceTermsFrom::kVote: return VoteWords::tr("The winner of each force (the paper).");
    case ForceTermsFrom::kFrequency: return VoteWords::tr("The trapezoids closest to the shares of all answers.");
    case ForceTermsFrom::kThresholds: return VoteWords::tr("The mean of the participants' own limits.");
    case ForceTermsFrom::kProbit: return VoteWords::tr("Ordered probit over all answers.");
  }
  return {};
}

QString seriesText(const std::string& series) {
  if (series == "ascending") return VoteWords::tr("rising forces");
  if (series == "descending") return VoteWords::tr("falling forces");
  if (series == "random") return VoteWords::tr("random order");
  return harmless(text(series));
}

void VoteTable::setVotes(const ForceVotes& votes) {
  using Row = elicitation::VoteStep;
  words_ = votes.words;
  std::vector<Column<Row>> columns = {{VoteWords::tr("Force"),
                                       [this](const Row& row) { return quantityText(row.force_n, words_.unit); },
                                       Qt::AlignRight}};
  for (std::size_t i = 0; i < words_.terms.size(); ++i) {
    columns.push_back({initialsOf(labelOf(words_.terms[i])),
                       [i](const Row& row) { return QString::number(row.votes[i]); },
                       Qt::AlignHCenter,
                       labelOf(words_.terms[i]),
                       {{kShareRole,
                         [i](const Row& row) {
                           const int cast = std::accumulate(row.votes.begin(), row.votes.end(), 0);
                           return cast > 0 ? static_cast<double>(row.votes[i]) / cast : 0.0;
                         }},
                        {kWinsRole, [i](const Row& row) { return row.term == i; }}}});
  }
  const std::map<int, CellOf<Row>> rule = {{Qt::ToolTipRole, &reasonRule}};
  columns.push_back(
      {VoteWords::tr("Winner"),
       [this](const Row& row) { return row.term ? labelOf(words_.terms[*row.term]) : QStringLiteral("–"); },
       Qt::AlignLeft,
       {},
       rule});
  columns.push_back({VoteWords::tr("Why"), &reasonText, Qt::AlignLeft, {}, rule});
  setTable(std::move(columns), votes.steps);
}

std::string VoteTable::wordAt(int column) const {
  if (column < kFirstWord || column >= winnerColumn()) return {};
  return words_.terms[static_cast<std::size_t>(column - kFirstWord)].id;
}

}  // namespace tactus::workbench
