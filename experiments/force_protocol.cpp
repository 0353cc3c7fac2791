#include "experiments/force_protocol.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::experiments {
namespace {

using Answer = study::ForceJudgement::Kind;

constexpr double kSameForceN = 1e-9;
constexpr const char* kStandStill = "Once more, please: push forward while you feel the force.";
constexpr const char* kNotDelivered = "Once more, please: the device did not give the whole force.";

bool isOf(const study::JudgementRecord& record, const SeriesStep& step) {
  return record.series == step.series && record.step == step.step;
}

std::vector<ForceAnswerOption> allAnswers(const std::vector<std::string>& terms) {
  std::vector<ForceAnswerOption> answers;
  answers.reserve(terms.size() + 2);
  for (const auto& term : terms) answers.push_back({Answer::kTerm, term, false});
  answers.push_back({Answer::kNotFelt, "not_felt", true});
  answers.push_back({Answer::kBeyondPractice, "beyond_practice", true});
  return answers;
}

std::string described(const std::string& series, int step, int attempt, double force_n) {
  return series + " step " + std::to_string(step) + ", attempt " + std::to_string(attempt) + ", " +
         base::formatNumber(force_n) + " N";
}

std::string_view sentence(RepeatReason reason) {
  if (reason == RepeatReason::kNone) return {};
  return reason == RepeatReason::kStoodStill ? kStandStill : kNotDelivered;
}

bool isAmount(double value) { return std::isfinite(value) && value >= 0; }

}  // namespace

std::string_view name(RepeatReason reason) noexcept {
  switch (reason) {
    case RepeatReason::kNone: return "none";
    case RepeatReason::kStoodStill: return "stood_still";
    case RepeatReason::kNotDelivered: return "not_delivered";
  }
  return {};
}

base::Result<ForceProtocol> ForceProtocol::create(const ForceSettings& settings, std::uint64_t seed,
                                                  std::span<const study::JudgementRecord> records) {
  if (auto valid = validate(settings); !valid) return tl::unexpected(valid.error());
  std::vector<SeriesStep> block;
  if (settings.random) {
    TACTUS_TRY(auto drawn, randomBlock(settings, seed));
    block = std::move(drawn);
  }
  ForceProtocol protocol(settings, seed, std::move(block));
  for (const auto& record : records) {
    if (auto added = protocol.add(record); !added) return tl::unexpected(added.error());
  }
  return protocol;
}

ForceProtocol::ForceProtocol(const ForceSettings& settings, std::uint64_t seed, std::vector<SeriesStep> block)
    : settings_(settings), seed_(seed), block_(std::move(block)) {}

ForcePlan ForceProtocol::next() const {
  ForcePlan plan;
  const auto step = nextStep();
  if (!step) {
    plan.finished = true;
    return plan;
  }
  plan.step = *step;
  plan.attempt = attemptsAt(*step) + 1;
  plan.pause_before_s = settings_.pause_s;
  plan.start_zone_mm = settings_.start_zone_mm;
  plan.ramp_s = settings_.ramp_s;
  if (step->force_n > settings_.continuous_n) plan.hold_limit_s = settings_.hold_limit_s;
  plan.forward_least_mm = settings_.forward_least_mm;
  plan.forward_least_mm_s = settings_.forward_least_mm_s;
  plan.device_scale = settings_.device_scale;
  plan.question.answers = allAnswers(settings_.terms);
  if (plan.attempt > 1) plan.question.repeat = repeatReason(*step);
  plan.question.repeat_reason = sentence(plan.question.repeat);
  const auto felt = static_cast<int>(judgements_.size());
  plan.question.rest_first = settings_.rest_every > 0 && felt > 0 && felt % settings_.rest_every == 0;
  return plan;
}

base::Result<study::JudgementRecord> ForceProtocol::record(const ForceAnswer& answer) const {
  const ForcePlan plan = next();
  TACTUS_CHECK(!plan.finished);
  const auto refuse = [](std::string place, std::string found, std::string wanted) {
    return base::fail(base::ErrorCode::kValue, std::move(place), std::move(found), std::move(wanted));
  };
  const auto& offered = plan.question.answers;
  const bool known = answer.kind == Answer::kNoAnswer ||
                     std::any_of(offered.begin(), offered.end(), [&](const ForceAnswerOption& option) {
                       return option.kind == answer.kind && (answer.kind != Answer::kTerm || option.id == answer.term);
                     });
  if (!known) return refuse("answer", base::quoted(answer.term), "one of the answers that were offered");
  if (!isAmount(answer.forward_mm)) return refuse("forward_mm", base::formatNumber(answer.forward_mm), "0 or more");
  if (!isAmount(answer.forward_speed_mm_s)) {
    return refuse("forward_speed_mm_s", base::formatNumber(answer.forward_speed_mm_s), "0 or more");
  }
  if (!isAmount(answer.response_s)) return refuse("response_s", base::formatNumber(answer.response_s), "0 or more");
  if (answer.delivered_share && !(*answer.delivered_share >= 0 && *answer.delivered_share <= 1)) {
    return refuse("delivered_share", base::formatNumber(*answer.delivered_share), "0 to 1");
  }
  if (answer.feel_again < 0) return refuse("feel_again", std::to_string(answer.feel_again), "0 or more");

  study::JudgementRecord record;
  record.series = plan.step.series;
  record.step = plan.step.step;
  record.attempt = plan.attempt;
  record.commanded_n = plan.step.force_n;
  record.forward_mm = answer.forward_mm;
  record.forward_speed_mm_s = answer.forward_speed_mm_s;
  record.delivered_share = settings_.delivered ? answer.delivered_share : std::optional(0.0);
  const bool delivered = settings_.delivered && answer.delivered && answer.delivered_share.value_or(1) >= kLeastShare;
  const bool felt = delivered && movedForward(record);
  if (settings_.device_friction_n && felt)
    record.felt_n = plan.step.force_n + *settings_.device_friction_n * settings_.device_scale;
  record.kind = answer.kind;
  if (answer.kind == Answer::kTerm) record.term = answer.term;
  record.scored = felt && plan.step.series != kFamiliarisation;
  record.catch_trial = plan.step.catch_trial;
  record.feel_again = answer.feel_again;
  record.response_s = answer.response_s;
  return record;
}

const study::JudgementRecord* ForceProtocol::lastScored() const {
  if (judgements_.empty() || !judgements_.back().scored) return nullptr;
  return &judgements_.back();
}

base::Result<study::JudgementRecord> ForceProtocol::correction(Answer kind, const std::string& term) const {
  const study::JudgementRecord* last = lastScored();
  if (last == nullptr) return base::fail(base::ErrorCode::kValue, "correction", "no judgement", "one that counts");
  const auto offered = allAnswers(settings_.terms);
  const bool known = std::any_of(offered.begin(), offered.end(), [&](const ForceAnswerOption& option) {
    return option.kind == kind && (kind != Answer::kTerm || option.id == term);
  });
  if (!known) {
    return base::fail(base::ErrorCode::kValue, "correction", base::quoted(term),
                      "one of the answers that were offered");
  }
  study::JudgementRecord record = *last;
  record.kind = kind;
  record.term = kind == Answer::kTerm ? term : std::string();
  record.entry = {};
  record.entry.supersedes = last->entry.id;
  return record;
}

base::Result<void> ForceProtocol::add(const study::JudgementRecord& record) {
  const auto refuse = [&](std::string found, std::string wanted) {
    return base::fail(base::ErrorCode::kData, "judgement " + study::toText(record.entry.id), std::move(found),
                      std::move(wanted));
  };
  const std::string found = described(record.series, record.step, record.attempt, record.commanded_n);
  const auto& terms = settings_.terms;
  if (record.kind == Answer::kTerm && std::find(terms.begin(), terms.end(), record.term) == terms.end()) {
    return refuse("the term " + base::quoted(record.term), "a term of the settings");
  }
  if (record.entry.supersedes) {
    const auto corrected = std::find_if(judgements_.begin(), judgements_.end(), [&](const auto& earlier) {
      return earlier.entry.id == *record.entry.supersedes;
    });
    if (corrected == judgements_.end()) return refuse("a correction of an unknown judgement", "one of this session");
    const std::string wanted =
        described(corrected->series, corrected->step, corrected->attempt, corrected->commanded_n);
    if (found != wanted) return refuse("a correction of " + found, wanted);
    *corrected = record;
    return {};
  }
  const auto step = stepFor(record);
  if (!step) return refuse(found, "nothing: the force experiment is finished");
  const int attempt = attemptsAt(*step) + 1;
  const bool fits =
      isOf(record, *step) && record.attempt == attempt && std::abs(record.commanded_n - step->force_n) < kSameForceN;
  if (!fits) return refuse(found, described(step->series, step->step, attempt, step->force_n));
  judgements_.push_back(record);
  return {};
}

std::vector<SeriesStep> ForceProtocol::steps() const {
  std::vector<SeriesStep> steps = familiarisationSeries(settings_);
  const auto append = [&steps](const std::vector<SeriesStep>& series) {
    steps.insert(steps.end(), series.begin(), series.end());
  };
  const auto ascending = ascendingSteps();
  append(ascending);
  if (settings_.descending && isDone(ascending.back())) {
    double start_n = descendingStart(settings_, ascending.back().force_n, seed_);
    // A later correction in the ascending series does not move a descending series that has begun.
    for (const auto& judgement : judgements_) {
      if (judgement.series == kDescending && judgement.step == 1) start_n = judgement.commanded_n;
    }
    append(withCatchTrials(descendingSeries(settings_, start_n), settings_, seed_));
  }
  append(block_);
  return steps;
}

/// The ascending series up to the first force that is beyond practice.
std::vector<SeriesStep> ForceProtocol::ascendingSteps() const {
  if (!settings_.ascending) return {};
  auto series = withCatchTrials(ascendingSeries(settings_), settings_, seed_);
  for (const auto& judgement : judgements_) {
    const bool ends = judgement.series == kAscending && !judgement.catch_trial &&
                      (judgement.scored || !settings_.delivered) && judgement.kind == Answer::kBeyondPractice;
    if (ends && static_cast<std::size_t>(judgement.step) < series.size()) {
      series.resize(static_cast<std::size_t>(judgement.step));
    }
  }
  return series;
}

std::optional<SeriesStep> ForceProtocol::nextStep() const {
  for (const auto& step : steps()) {
    if (!isDone(step)) return step;
  }
  return std::nullopt;
}

bool ForceProtocol::movedForward(const study::JudgementRecord& record) const {
  return record.forward_mm >= settings_.forward_least_mm && record.forward_speed_mm_s >= settings_.forward_least_mm_s;
}

/// A hand that moved forward was no reason not to score the last attempt: then it was the force.
RepeatReason ForceProtocol::repeatReason(const SeriesStep& step) const {
  const auto last = std::find_if(judgements_.rbegin(), judgements_.rend(),
                                 [&step](const auto& judgement) { return isOf(judgement, step); });
  const bool moved = last != judgements_.rend() && movedForward(*last);
  return moved ? RepeatReason::kNotDelivered : RepeatReason::kStoodStill;
}

/// The step of a new record. Sessions from before attempts were limited may hold more attempts at a step.
std::optional<SeriesStep> ForceProtocol::stepFor(const study::JudgementRecord& record) const {
  if (!judgements_.empty() && isOf(record, {judgements_.back().series, judgements_.back().step})) {
    for (const auto& step : steps()) {
      if (isOf(record, step) && !isScored(step) && step.series != kFamiliarisation) return step;
    }
  }
  return nextStep();
}

bool ForceProtocol::isScored(const SeriesStep& step) const {
  return std::any_of(judgements_.begin(), judgements_.end(),
                     [&](const auto& judgement) { return isOf(judgement, step) && judgement.scored; });
}

/// A step that is never delivered or never felt in motion is left out, so that a session cannot stay at it for ever.
bool ForceProtocol::isDone(const SeriesStep& step) const {
  const int most = step.series == kFamiliarisation || !settings_.delivered ? 1 : settings_.attempts_most;
  return isScored(step) || attemptsAt(step) >= most;
}

int ForceProtocol::attemptsAt(const SeriesStep& step) const {
  return static_cast<int>(std::count_if(judgements_.begin(), judgements_.end(),
                                        [&](const auto& judgement) { return isOf(judgement, step); }));
}

}  // namespace tactus::experiments
