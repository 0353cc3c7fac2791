#include "app/planning/simulated_people.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/session/simulated_nurse.h"
#include "core/base/statistics.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/force/force_voting.h"
#include "experiments/published_tables.h"

namespace tactus::planning {
namespace {

using base::Result;

constexpr std::string_view kSeries = "ascending";
constexpr int kSamples = 9;  // of a stroke

/// The speeds along a stroke over its mean speed: minimum jerk, its spread made that of Table 1.
std::array<double, kSamples> strokeShape() {
  std::vector<double> shares;
  for (const auto& one : experiments::publishedSpeeds()) shares.push_back(one.sd_mm_s / one.mean_mm_s);
  const double wanted = base::median(shares);
  std::array<double, kSamples> out{};
  double square = 0;
  double mean = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double t = (i + 0.5) / kSamples;
    out[static_cast<std::size_t>(i)] = 30 * t * t * (1 - t) * (1 - t);
    mean += out[static_cast<std::size_t>(i)] / kSamples;
  }
  for (const double one : out) square += (one - mean) * (one - mean) / kSamples;
  for (double& one : out) one = 1 + wanted * (one - mean) / std::sqrt(square);
  return out;
}

std::array<double, kSamples> samplesOf(double stroke_mm_s) {
  static const auto kShape = strokeShape();
  auto out = kShape;
  for (double& one : out) one *= stroke_mm_s;
  return out;
}

Result<void> addRamps(std::size_t levels, NurseData& out) {
  std::vector<double> samples;
  for (const double stroke : out.strokes_mm_s) {
    for (const double speed : samplesOf(stroke)) samples.push_back(speed);
  }
  elicitation::FcmSettings fcm;
  fcm.clusters = levels;
  TACTUS_TRY(const auto clusters, elicitation::fuzzyCMeans(samples, fcm));
  TACTUS_TRY(out.ramps, elicitation::alphaCutRamps(clusters.centres, 2, elicitation::kDefaultAlpha));
  out.largest_centre_mm_s = clusters.centres.back();
  return {};
}

std::size_t wordAt(double level, std::size_t words) {
  return static_cast<std::size_t>(std::clamp(std::round(level), 0.0, static_cast<double>(words - 1)));
}

}  // namespace

Result<NurseData> dataOf(const Questions& questions, const TrueNurse& nurse, const RepeatNoise& noise, int strokes,
                         const std::string& code, base::Random& random) {
  NurseData out;
  session::ResponderTraits traits;
  traits.code = code;
  traits.threshold_n = nurse.threshold_n;
  traits.beyond_from_n = nurse.beyond_from_n;
  traits.noise = noise.judgement_jnd;
  traits.lapse = noise.lapse;
  session::SimulatedResponder responder(traits, questions.words());
  for (const double force_n : questions.forces_n) {
    const auto response = responder.judge(force_n, random);
    out.judged.push_back({code,
                          std::string(kSeries),
                          static_cast<int>(out.judged.size()) + 1,
                          force_n,
                          response.kind,
                          response.term,
                          {}});
  }
  const std::size_t words = nurse.threshold_n.size() + 1;
  for (const double level : nurse.level)
    out.words.push_back(wordAt(level + noise.answer_words * random.normal(), words));
  for (const double speed : nurse.speed_mm_s) {
    for (int stroke = 0; stroke < strokes; ++stroke)
      out.strokes_mm_s.push_back(speed * std::exp(noise.stroke_log * random.normal()));
  }
  if (out.strokes_mm_s.empty()) return out;
  if (auto ok = addRamps(nurse.speed_mm_s.size(), out); !ok) return tl::unexpected(ok.error());
  return out;
}

void addTo(study::Study& study, const study::Form& form, const std::string& code, const NurseData& data) {
  study::Participant person;
  person.code = code;
  person.simulated = true;
  study.participants.push_back(person);
  study.judgements.insert(study.judgements.end(), data.judged.begin(), data.judged.end());
  std::size_t word = 0;
  for (const auto& item : form.items) {
    if (study::isWayOut(item)) continue;
    study.answers.push_back(
        {code, form.id, item.number, form.answers[data.words[word++]].term, study::Answer::Status::kAnswered});
  }
  const fuzzy::Variable* const rate = procedure::of(study).rateInput();
  if (rate == nullptr || data.strokes_mm_s.empty()) return;
  const std::size_t each = data.strokes_mm_s.size() / rate->terms.size();
  for (std::size_t i = 0; i < data.strokes_mm_s.size(); ++i) {
    study::SpeedSample sample;
    sample.participant = code;
    sample.level = rate->terms[i / each].id;
    sample.stroke = static_cast<int>(i % each) + 1;
    constexpr double kTickS = 0.05;
    for (const double speed : samplesOf(data.strokes_mm_s[i])) {
      sample.speed_mm_s = speed;
      study.speeds.push_back(sample);
      sample.time_s += kTickS;
      sample.depth_mm += speed * kTickS;
    }
  }
}

Result<NurseData> trueDataOf(const Questions& questions, const TrueNurse& nurse) {
  base::Random unused(1);
  return dataOf(questions, nurse, {0, 0, 0, 0}, 1, "N1", unused);
}

Result<fuzzy::Variable> outputOf(const Questions& questions, std::span<const NurseData> people,
                                 elicitation::ForceTermsFrom way) {
  std::vector<study::ForceJudgement> all;
  for (const auto& one : people) all.insert(all.end(), one.judged.begin(), one.judged.end());
  TACTUS_TRY(const auto counts, elicitation::countVotes(all, kSeries, questions.words()));
  const auto votes = elicitation::vote(counts, static_cast<int>(people.size()));
  TACTUS_TRY(auto terms, elicitation::forceTermsFrom(way, questions.about->output, all, kSeries, votes));
  return std::move(terms.output);
}

fuzzy::ForceModel modelOf(const Questions& questions, std::span<const NurseData> people,
                          std::span<const std::size_t> asked, const fuzzy::Variable& output) {
  fuzzy::ForceModel out;
  out.inputs = questions.inputs;
  out.output = output;
  std::vector<std::vector<elicitation::Ramp>> ramps;
  for (const auto& one : people) ramps.push_back(one.ramps);
  const auto averaged = elicitation::averageRamps(ramps, {}, elicitation::Averaging::kMean);
  for (auto& input : out.inputs) {
    if (fuzzy::roleOf(input) != fuzzy::Role::kRate) continue;
    double end = input.max;
    for (const auto& one : people)
      end = std::max(end, elicitation::speedUniverseMax(input.max, one.largest_centre_mm_s, one.ramps));
    input.max = end;
    input.terms = elicitation::speedTerms(input, averaged);
  }
  const auto ids = questions.words();
  for (std::size_t who = 0; who < people.size(); ++who) {
    auto& expert = out.experts.emplace_back();
    expert.id = "N" + std::to_string(who + 1);
    expert.label = expert.id;
    for (const std::size_t item : asked)
      expert.rules.push_back({questions.items[item], ids[people[who].words[item]], 1, true});
  }
  return out;
}

}  // namespace tactus::planning
