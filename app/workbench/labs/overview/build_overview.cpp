#include "app/workbench/labs/overview/build_overview.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <set>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using PartKind = BuildPart::Kind;

struct OverviewText {
  Q_DECLARE_TR_FUNCTIONS(OverviewText)
};

/// The part that a choice of the method belongs to.
std::optional<PartKind> partOf(std::string_view factor) {
  if (factor == "depths") return PartKind::kDepth;
  if (factor == "force_terms") return PartKind::kForce;
  if (factor == "weights") return PartKind::kExperts;
  constexpr std::array<std::string_view, 6> kSpeed = {"alpha", "m", "trim", "centres", "averaging", "terms"};
  const bool speed = std::find(kSpeed.begin(), kSpeed.end(), factor) != kSpeed.end();
  return speed ? std::optional(PartKind::kSpeed) : std::nullopt;
}

/// `effect`: gives the words for these newtons, if they are the most.
template <class Effect>
void raise(BuildPart& part, double newtons, Effect effect) {
  if (newtons <= part.stake_n.value_or(0)) return;
  part.stake_n = newtons;
  part.effect = effect();
}

QString speedSentence(const BuiltStudy& built) {
  std::set<std::tuple<std::string_view, std::string_view, int>> strokes;
  std::set<std::string_view> people;
  const study::SpeedSample* before = nullptr;  // the samples of a stroke stand together
  for (const auto& sample : built.study->study.speeds) {
    const bool same = before != nullptr && before->stroke == sample.stroke && before->level == sample.level &&
                      before->participant == sample.participant;
    before = &sample;
    if (same) continue;
    strokes.insert({sample.participant, sample.level, sample.stroke});
    people.insert(sample.participant);
  }
  if (strokes.empty()) return OverviewText::tr("No strokes: the words for the speed are the template's.");
  return OverviewText::tr("%1 strokes of %2 became the words for the speed.")
      .arg(strokes.size())
      .arg(OverviewText::tr("%n nurse(s)", nullptr, static_cast<int>(people.size())));
}

QString forceSentence(const BuiltStudy& built) {
  int votes = 0;
  int decided = 0;
  int unusual = 0;
  for (const elicitation::VoteStep& step : built.model->votes) {
    for (const int count : step.votes) votes += count;
    if (!step.term) continue;
    ++decided;
    const int most = *std::max_element(step.votes.begin(), step.votes.end());
    if (step.votes[*step.term] < most) ++unusual;
  }
  if (votes == 0) return OverviewText::tr("No judgements: the words for the force are the template's.");
  const QString made = OverviewText::tr("%n judgement(s) became the words for the force.", nullptr, votes);
  if (unusual == 0) return made;
  return made + QLatin1Char(' ') +
         OverviewText::tr("%1 of %2 winners are not the most frequent word.").arg(unusual).arg(decided);
}

QString rulesSentence(const BuiltStudy& built) {
  std::size_t rules = 0;
  for (const auto& expert : built.model->model.experts) rules += expert.rules.size();
  return OverviewText::tr("%1 answers and given rules became %2 rules of %3.")
      .arg(built.study->study.answers.size() + built.study->study.rules.size())
      .arg(rules)
      .arg(OverviewText::tr("%n expert(s)", nullptr, static_cast<int>(built.model->model.experts.size())));
}

QString expertsSentence(const BuiltStudy& built) {
  QStringList weights;
  for (const auto& expert : built.model->model.experts)
    weights << QStringLiteral("%1 %2").arg(text(expert.id), numberText(expert.weight));
  constexpr qsizetype kShown = 6;
  if (weights.size() > kShown) weights = weights.mid(0, kShown) << QStringLiteral("…");
  return OverviewText::tr("The force is their mean, with the weights %1.").arg(weights.join(QStringLiteral(" : ")));
}

void addWarnings(const elicitation::BuiltModel& model, std::vector<BuildPart>& parts) {
  for (std::size_t i = 0; i < model.notes.size() && i < model.note_subjects.size(); ++i) {
    const std::string& subject = model.note_subjects[i];
    const auto& inputs = model.model.inputs;
    const auto is = [&](const std::optional<std::size_t>& input) { return input && inputs[*input].id == subject; };
    const auto kind = is(fuzzy::wayOf(inputs))           ? PartKind::kDepth
                      : is(fuzzy::rateOf(inputs))        ? PartKind::kSpeed
                      : subject == model.model.output.id ? PartKind::kForce
                                                         : PartKind::kRules;
    for (BuildPart& part : parts) {
      if (part.kind == kind) part.warnings << text(model.notes[i]);
    }
  }
}

}  // namespace

std::vector<BuildPart> buildParts(const BuiltStudy& built, const elicitation::MethodStudy* choices) {
  const elicitation::BuiltModel& model = *built.model;
  const bool measured = built.settings.depths == elicitation::DepthsFrom::kMeasured;
  std::vector<BuildPart> parts = {
      {PartKind::kDepth,
       measured ? OverviewText::tr("The regions are as they were measured on an image.")
                : OverviewText::tr("The regions are the template's; an image can replace them."),
       {},
       {},
       {}},
      {PartKind::kSpeed, speedSentence(built), {}, {}, {}},
      {PartKind::kForce, forceSentence(built), {}, {}, {}},
      {PartKind::kRules, rulesSentence(built), {}, {}, {}},
      {PartKind::kExperts, expertsSentence(built), {}, {}, {}}};
  const auto part = [&parts](PartKind kind) -> BuildPart& { return parts[static_cast<std::size_t>(kind)]; };
  for (const auto& pair : model.influences.pairs) {
    if (pair.largest)
      raise(part(PartKind::kRules), pair.largest->newtons, [&pair] {
        return OverviewText::tr("%1 and %2 are so far apart").arg(text(pair.first), text(pair.second));
      });
  }
  for (const auto& one : model.influences.experts) {
    if (one.largest)
      raise(part(PartKind::kExperts), one.largest->newtons,
            [&one] { return OverviewText::tr("leaving %1 out").arg(text(one.expert)); });
  }
  if (choices != nullptr) {
    for (const auto& variant : choices->variants) {
      const auto kind = partOf(variant.factor);
      if (!kind || !variant.unavailable.empty()) continue;
      raise(part(*kind), variant.largest_n, [&variant] {
        return OverviewText::tr("%1: %2").arg(text(elicitation::factorTitle(variant.factor)), spelled(variant.value));
      });
    }
  }
  addWarnings(model, parts);
  for (BuildPart& one : parts) {
    if (one.stake_n) continue;
    one.effect = choices == nullptr ? OverviewText::tr("Its newtons are being compared…")
                                    : OverviewText::tr("No other choice that can be tried moves the force.");
  }
  if (choices != nullptr) {
    std::stable_sort(parts.begin(), parts.end(), [](const BuildPart& one, const BuildPart& other) {
      return one.stake_n.value_or(0) > other.stake_n.value_or(0);
    });
  }
  return parts;
}

BuildOverview::BuildOverview(LabModel& model, QObject* parent)
    : QObject(parent),
      model_(model),
      choices_(
          [&model] { return model.inputs(); },
          [](const BuiltStudy& built,
             const RunOf<elicitation::MethodStudy>& run) -> Computed<BuiltStudy, elicitation::MethodStudy>::Answer {
            const auto settings = stoppable(built.settings, run.stop);
            // Terms in other shapes take longer than all the others together, and no card has them.
            const auto wanted = [](std::string_view factor) { return partOf(factor).has_value(); };
            auto study = elicitation::methodStudy(built.study->study, built.study->forms, settings, *built.model,
                                                  {run.stop, run.progress, wanted, nullptr});
            if (!study) return tl::unexpected(text(study.error().message()));
            return std::make_shared<const elicitation::MethodStudy>(std::move(*study));
          }) {
  choices_.needs(model_);
  connect(&model_, &Computation::valueChanged, &choices_, &Computation::refresh);
  connect(&model_, &Computation::valueChanged, this, &BuildOverview::changed);
  connect(&choices_, &Computation::valueChanged, this, &BuildOverview::changed);
}

std::optional<StudiedMethod> BuildOverview::studied() const {
  if (choices_.value() == nullptr) return std::nullopt;
  return StudiedMethod{*choices_.of(), choices_.value()};
}

void BuildOverview::setSeen(bool seen) { choices_.hold(*this, seen); }

std::vector<BuildPart> BuildOverview::parts() const {
  const auto built = model_.inputs();
  if (!built) return {};
  const bool of_these = choices_.value() != nullptr && choices_.of() != nullptr && choices_.of()->model == built->model;
  return buildParts(*built, of_these ? choices_.value().get() : nullptr);
}

}  // namespace tactus::workbench
