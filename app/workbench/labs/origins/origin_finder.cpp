#include "app/workbench/labs/origins/origin_finder.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/corrections.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {

namespace {

using elicitation::BuildSettings;
using elicitation::BuiltModel;
using elicitation::Sources;
using RecordKind = OriginRecord::Kind;

constexpr double kSameShare = 1e-6;  // of a universe: what an edit by hand never hits

struct OriginText {
  Q_DECLARE_TR_FUNCTIONS(OriginText)
};

QString wordOf(const fuzzy::Variable& variable, const std::string& id) {
  const fuzzy::Term* const term = fuzzy::findTerm(variable.terms, id);
  return term == nullptr ? harmless(text(id)) : labelOf(*term);
}

const fuzzy::Variable* variableOf(const fuzzy::ForceModel& model, const std::string& id) {
  if (model.output.id == id) return &model.output;
  const auto found =
      std::find_if(model.inputs.begin(), model.inputs.end(), [&](const auto& input) { return input.id == id; });
  return found == model.inputs.end() ? nullptr : &*found;
}

QString judgementText(const fuzzy::Variable& output, const study::ForceJudgement& one) {
  switch (one.kind) {
    case study::ForceJudgement::Kind::kTerm: return wordOf(output, one.term);
    case study::ForceJudgement::Kind::kNotFelt: return OriginText::tr("not felt");
    case study::ForceJudgement::Kind::kBeyondPractice: return OriginText::tr("beyond practice");
    case study::ForceJudgement::Kind::kNoAnswer: return OriginText::tr("no answer");
  }
  return {};
}

QString conditionText(const fuzzy::ForceModel& model, const std::string& input, const std::string& term) {
  const fuzzy::Variable* const variable = variableOf(model, input);
  if (variable == nullptr) return harmless(text(term));
  return OriginText::tr("%1 %2").arg(wordOf(*variable, term), shortLabelOf(*variable).toLower());
}

QString conditionsText(const fuzzy::ForceModel& model, const fuzzy::Rule& rule) {
  QStringList parts;
  for (const fuzzy::Condition& one : rule.conditions) parts << conditionText(model, one.input, one.term);
  return parts.join(QStringLiteral(", "));
}

/// Turns sources into rows.
class Rows {
 public:
  Rows(const BuiltModel& built, const LabStudy& study) : built_(built), study_(study) {}

  void add(const Sources& sources, Origin& out) const {
    const auto means = sources.strokes.empty() ? Means() : strokeMeans();
    for (const elicitation::StrokeKey& key : sources.strokes) {
      OriginRecord row{RecordKind::kStroke, key, 0, {}, who(key.participant), {}, {}};
      const auto rate = fuzzy::rateOf(built_.model.inputs);
      const fuzzy::Variable* const speed = rate ? &built_.model.inputs[*rate] : nullptr;
      row.what = OriginText::tr("%1, stroke %2")
                     .arg(speed == nullptr ? text(key.level) : wordOf(*speed, key.level))
                     .arg(key.stroke);
      if (const auto found = means.find({key.participant, key.level, key.stroke}); found != means.end()) {
        row.says = OriginText::tr("mean %1").arg(
            quantityText(found->second.first / static_cast<double>(found->second.second), "mm/s", 1));
      }
      out.records.push_back(std::move(row));
    }
    for (const std::size_t index : sources.judgements) addJudgement(index, out);
    for (const std::size_t index : sources.answers) {
      const study::Answer& answer = study_.study.answers[index];
      const auto rule = elicitation::ruleOfAnswer(study_.study, built_, index);
      QString what = OriginText::tr("item %1").arg(answer.item);
      if (rule) what += QStringLiteral(": ") + conditionsText(built_.model, ruleAt(*rule));
      out.records.push_back(
          {RecordKind::kAnswer,
           {},
           index,
           rule,
           who(answer.participant),
           what,
           answer.term.empty() ? OriginText::tr("no answer") : wordOf(built_.model.output, answer.term)});
    }
    for (const std::size_t index : sources.rules) {
      const study::GivenRule& given = study_.study.rules[index];
      const auto rule = elicitation::ruleOfGiven(study_.study, built_, index);
      QString what = OriginText::tr("rule given directly");
      if (rule) what += QStringLiteral(": ") + conditionsText(built_.model, ruleAt(*rule));
      out.records.push_back({RecordKind::kGivenRule,
                             {},
                             index,
                             rule,
                             who(given.participant),
                             what,
                             wordOf(built_.model.output, given.then)});
    }
    for (const std::string& sentence : sources.without_records) out.notes << text(sentence);
  }

  /// Names the simulated participants among those of the rows.
  void addSimulated(Origin& out) const {
    QStringList simulated;
    for (const study::Participant& one : study_.study.participants) {
      const bool behind = std::any_of(out.records.begin(), out.records.end(),
                                      [&](const OriginRecord& row) { return row.participant == who(one.code); });
      if (one.simulated && behind) simulated << who(one.code);
    }
    if (!simulated.isEmpty()) {
      out.notes << OriginText::tr("SIMULATED: data of %1").arg(simulated.join(QStringLiteral(", ")));
    }
  }

 private:
  using Means = std::map<std::tuple<std::string, std::string, int>, std::pair<double, std::size_t>>;

  static QString who(const std::string& participant) { return harmless(text(participant)); }

  const fuzzy::Rule& ruleAt(const elicitation::RulePlace& place) const {
    return built_.model.experts[place.expert].rules[place.rule];
  }

  void addJudgement(std::size_t index, Origin& out) const {
    const study::ForceJudgement& one = study_.study.judgements[index];
    out.records.push_back(
        {RecordKind::kJudgement,
         {},
         index,
         {},
         who(one.participant),
         OriginText::tr("%1, step %2").arg(quantityText(one.force_n, built_.model.output.unit)).arg(one.step),
         judgementText(built_.model.output, one)});
  }

  /// Sum and number of the samples of each stroke.
  Means strokeMeans() const {
    Means out;
    std::pair<double, std::size_t>* last = nullptr;
    const study::SpeedSample* of = nullptr;
    for (const study::SpeedSample& sample : study_.study.speeds) {
      const bool same = of != nullptr && of->stroke == sample.stroke && of->level == sample.level &&
                        of->participant == sample.participant;
      if (!same) last = &out[{sample.participant, sample.level, sample.stroke}];
      of = &sample;
      last->first += sample.speed_mm_s;
      ++last->second;
    }
    return out;
  }

  const BuiltModel& built_;
  const LabStudy& study_;
};

void addSources(const base::Result<Sources>& sources, const Rows& rows, Origin& out) {
  sources ? rows.add(*sources, out) : void(out.notes << text(sources.error().message()));
}

void answer(const VertexQuestion& asked, const BuiltModel& built, const LabStudy& study, const BuildSettings& settings,
            const Rows& rows, Origin& out) {
  const fuzzy::Variable* const variable = variableOf(built.model, asked.variable);
  const fuzzy::Term* const term = variable == nullptr ? nullptr : fuzzy::findTerm(variable->terms, asked.term);
  out.title = variable == nullptr ? harmless(text(asked.variable)) : labelOf(*variable);
  if (term == nullptr || asked.point >= term->points.size()) {
    out.title += QStringLiteral(", ") + harmless(text(asked.term));
    out.notes << OriginText::tr("The model of the study has no such vertex: it was made by hand.");
    return;
  }
  const double value = term->points[asked.point];
  out.title += QStringLiteral(", %1: %2 %3")
                   .arg(labelOf(*term), text(editing::pointName(term->shape, asked.point)),
                        placeText(*variable, asked.shown.value_or(value)));
  if (asked.shown && std::abs(*asked.shown - value) > kSameShare * (variable->max - variable->min)) {
    out.notes << OriginText::tr(
                     "The study gives %1 with the settings of the labs. The vertex was moved by hand, or the "
                     "model was built with other settings.")
                     .arg(placeText(*variable, value));
  }
  const fuzzy::Variable* const rate = built.about().rateInput();
  if (rate != nullptr && asked.variable == rate->id) {
    const auto shares = elicitation::speedVertexShares(study.study, built, settings, asked.term, asked.point);
    QStringList parts;
    for (std::size_t i = 0; shares && i < shares->size(); ++i) {
      const elicitation::VertexShare& one = (*shares)[i];
      QString part = QStringLiteral("%1 %2").arg(harmless(text(one.participant)), numberText(one.value_mm_s, 1));
      if (one.share > 0) part += QStringLiteral(" (%1 %)").arg(numberText(100 * one.share, 0));
      parts << part;
    }
    if (parts.size() > 12) parts = parts.mid(0, 12) << QStringLiteral("…");
    if (!parts.isEmpty()) out.notes << OriginText::tr("Averaged from %1 mm/s.").arg(parts.join(QStringLiteral(", ")));
  }
  addSources(elicitation::sourcesOfVertex(study.study, built, settings, asked.variable, asked.term, asked.point), rows,
             out);
}

void answer(const VoteQuestion& asked, const BuiltModel& built, const LabStudy& study, const BuildSettings& settings,
            const Rows& rows, Origin& out) {
  const QString force = quantityText(asked.force_n, built.model.output.unit);
  out.title = asked.word.empty()
                  ? OriginText::tr("Votes at %1").arg(force)
                  : OriginText::tr("Votes for %1 at %2").arg(wordOf(built.model.output, asked.word), force);
  Sources sources = elicitation::sourcesOfVote(study.study, settings, asked.force_n);
  if (!asked.word.empty()) {
    std::erase_if(sources.judgements,
                  [&](std::size_t index) { return study.study.judgements[index].term != asked.word; });
  }
  if (sources.judgements.empty()) out.notes << OriginText::tr("No participant said so.");
  rows.add(sources, out);
}

void answer(const RuleQuestion& asked, const BuiltModel& built, const LabStudy& study, const BuildSettings&,
            const Rows& rows, Origin& out) {
  out.title = OriginText::tr("%1, %2: %3")
                  .arg(harmless(text(asked.expert)), conditionsText(built.model, asked.rule),
                       wordOf(built.model.output, asked.rule.then));
  for (std::size_t e = 0; e < built.model.experts.size(); ++e) {
    const fuzzy::Expert& expert = built.model.experts[e];
    if (expert.id != asked.expert) continue;
    for (std::size_t r = 0; r < expert.rules.size(); ++r) {
      if (expert.rules[r].conditions != asked.rule.conditions) continue;
      if (expert.rules[r].then != asked.rule.then) {
        out.notes << OriginText::tr("The study says %1: the rule was changed by hand.")
                         .arg(wordOf(built.model.output, expert.rules[r].then));
      }
      return addSources(elicitation::sourcesOfRule(study.study, built, e, r), rows, out);
    }
  }
  out.notes << OriginText::tr("No answer of the study gives a rule with these conditions: it was added by hand.");
}

void answer(const ForceQuestion& asked, const BuiltModel& built, const LabStudy& study, const BuildSettings& settings,
            const Rows& rows, Origin& out) {
  const auto compiled = fuzzy::compile(built.model);
  std::optional<double> force_n;
  if (compiled && asked.inputs.size() == built.model.inputs.size()) {
    const auto found = compiled->evaluate(asked.inputs);
    if (found.fired) force_n = found.force_n;
  }
  const std::optional<double> title_n = asked.shown_n ? asked.shown_n : force_n;
  out.title = OriginText::tr("Force at %1").arg(text(elicitation::pointText(built.model, asked.inputs)));
  if (title_n) out.title += QStringLiteral(": ") + forceText(*title_n, built.model.output.unit);
  if (asked.shown_n && (!force_n || std::abs(*asked.shown_n - *force_n) > kSameShare)) {
    out.notes << (force_n
                      ? OriginText::tr("The study gives %1 with the settings of the labs; the model on the screen was "
                                       "edited, or built with other settings.")
                            .arg(forceText(*force_n, built.model.output.unit))
                      : OriginText::tr("No rule of the study's own model fires here."));
  }
  addSources(elicitation::sourcesOfForce(study.study, built, settings, asked.inputs), rows, out);
}

}  // namespace

Origin originOf(const OriginQuestion& question, const BuiltModel& built, const LabStudy& study,
                const BuildSettings& settings) {
  Origin out;
  const Rows rows(built, study);
  std::visit([&](const auto& asked) { answer(asked, built, study, settings, rows, out); }, question);
  rows.addSimulated(out);
  return out;
}

base::Result<elicitation::RecordInfluence> influenceOf(const OriginRecord& record, const BuiltModel& built,
                                                       const LabStudy& study, const BuildSettings& settings) {
  switch (record.kind) {
    case RecordKind::kStroke:
      return elicitation::withoutStroke(built, study.study, settings, record.stroke.participant, record.stroke.level,
                                        record.stroke.stroke);
    case RecordKind::kJudgement: return elicitation::withoutJudgement(built, study.study, settings, record.index);
    case RecordKind::kAnswer:
    case RecordKind::kGivenRule:
      if (record.rule) return elicitation::withoutRule(built, record.rule->expert, record.rule->rule);
      return elicitation::RecordInfluence();  // it gave no rule
  }
  return elicitation::RecordInfluence();
}

OriginFinder::OriginFinder(LabData& data, LabModel& model, QObject* parent)
    : QObject(parent),
      data_(data),
      model_(model),
      origin_(
          [this]() -> std::optional<Asked> {
            const auto built = model_.inputs();
            const bool asked = question_ && not_of_study_.isEmpty();
            return asked && built ? std::optional(Asked{*question_, *built}) : std::nullopt;
          },
          [](const Asked& asked, const auto&) {
            const auto& [built, study, settings] = asked.built;
            return std::make_shared<const Origin>(originOf(asked.question, *built, *study, settings));
          }),
      moved_(
          [this]() -> std::optional<Compared> {
            const auto row = nextRow();
            return row ? std::optional(Compared{*row, origin_.value(), origin_.of()}) : std::nullopt;
          },
          [](const Compared& one, const auto&) {
            const auto& [built, study, settings] = one.of->built;
            return std::make_shared<const Moved>(
                Moved{one.row, influenceOf(one.origin->records[one.row], *built, *study, settings)});
          }) {
  origin_.needs(model_);
  connect(&model_, &Computation::valueChanged, this, [this] {
    origin_.refresh();
    if (isAsked() && model_.value() == nullptr) emit changed();
  });
  connect(&data_, &LabData::studyChanged, this, [this] {
    if (isAsked() && data_.study() == nullptr) emit changed();
  });
  connect(&origin_, &Computation::valueChanged, this, [this] {
    influences_.assign(origin() == nullptr ? 0 : origin()->records.size(), std::nullopt);
    wanted_.reset();
    emit changed();
    moved_.forget();
  });
  connect(&moved_, &Computation::valueChanged, this, [this] {
    if (moved_.value() == nullptr) return;
    const std::size_t row = moved_.value()->row;
    influences_[row] = moved_.value()->influence;
    emit influenceChanged(row);
    moved_.refresh();
  });
}

void OriginFinder::ask(OriginQuestion question, const QString& not_of_study) {
  setAsked(std::move(question), not_of_study);
}

void OriginFinder::close() { setAsked(std::nullopt, not_of_study_); }

void OriginFinder::setAsked(std::optional<OriginQuestion> question, const QString& not_of_study) {
  question_ = std::move(question);
  not_of_study_ = not_of_study;
  const bool wanted = question_ && not_of_study_.isEmpty();
  origin_.hold(*this, wanted);
  moved_.hold(*this, wanted);
  origin_.forget();
  emit changed();
}

QString OriginFinder::failure() const {
  if (!not_of_study_.isEmpty()) return not_of_study_;
  if (!data_.failure().isEmpty()) return data_.failure();
  return model_.failure();
}

void OriginFinder::askInfluence(std::size_t row) {
  if (row >= influences_.size() || influences_[row]) return;
  wanted_ = row;
  if (!moved_.isBusy()) moved_.refresh();
}

// One at a time, so that the one that is asked for never waits for more than one.
std::optional<std::size_t> OriginFinder::nextRow() {
  const auto is_open = [this](std::size_t row) { return row < influences_.size() && !influences_[row]; };
  std::optional<std::size_t> row = std::exchange(wanted_, std::nullopt);
  if (row && !is_open(*row)) row.reset();
  for (std::size_t i = 0; !row && i < std::min(kMostUnasked, influences_.size()); ++i) {
    if (is_open(i)) row = i;
  }
  return row;
}

QString OriginFinder::influenceSentence(std::size_t row) const {
  if (origin() == nullptr || row >= influences_.size() || !influences_[row]) return {};
  const OriginRecord& record = origin()->records[row];
  return influenceText(QStringLiteral("%1, %2").arg(record.participant, record.what), *influences_[row],
                       origin_.of()->built.model->model);
}

}  // namespace tactus::workbench
