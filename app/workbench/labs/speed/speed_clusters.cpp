#include "app/workbench/labs/speed/speed_clusters.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
#include <thread>
#include <tuple>
#include <utility>

#include "app/figures/colors.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {

bool sideBySide(std::size_t count, const std::function<void(std::size_t)>& work,
                const std::function<bool(double share)>& keep_going) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stopped = !keep_going(0);
  std::jthread other;
  if (std::thread::hardware_concurrency() > 1 && count > 1 && !stopped) {
    other = std::jthread([&] {
      for (std::size_t i = next++; i < count && !stopped; i = next++) work(i);
    });
  }
  for (std::size_t i = next++; i < count && !stopped; i = next++) {
    work(i);
    if (!keep_going(static_cast<double>(i + 1) / static_cast<double>(count))) stopped = true;
  }
  if (other.joinable()) other.join();
  return !stopped && keep_going(1);
}

namespace {

using elicitation::SpeedCentres;

constexpr std::size_t kBins = 36;
constexpr std::size_t kBatch = 100;  // replicates of a participant between two looks whether to stop: 1 or 2 ms

/// The rate with the default terms of the procedure; without terms if the procedure has none.
fuzzy::Variable rateOf(const procedure::Procedure& procedure) {
  const fuzzy::Variable* const rate = procedure.rateInput();
  return rate == nullptr ? fuzzy::Variable() : *rate;
}

std::vector<std::string> levelsOf(const fuzzy::Variable& speed) {
  std::vector<std::string> levels;
  for (const auto& term : speed.terms) levels.push_back(term.id);
  return levels;
}

/// What the centers of a participant depend on.
struct ClusterKey {
  double trim;
  double m;
  std::size_t clusters;
  SpeedCentres centres;

  bool operator==(const ClusterKey&) const = default;
};

ClusterKey keyOf(const elicitation::BuildSettings& settings, std::size_t clusters) {
  return {settings.speed.trim, settings.speed.fcm.m, clusters, settings.speed.centres};
}

void fillHistogram(SpeedSubject& out, std::span<const double> kept_mm_s, double highest_mm_s) {
  out.end_mm_s = std::max(10.0, std::ceil(highest_mm_s / 10) * 10);
  out.histogram.assign(kBins, 0.0);
  for (const double speed_mm_s : kept_mm_s) {
    if (speed_mm_s < 0) continue;
    const auto bin = static_cast<std::size_t>(speed_mm_s / out.end_mm_s * static_cast<double>(kBins));
    out.histogram[std::min(kBins - 1, bin)] += 1;
  }
  const double fullest = std::max(1.0, *std::max_element(out.histogram.begin(), out.histogram.end()));
  for (double& count : out.histogram) count /= fullest;
}

}  // namespace

/// The samples of one participant, and what was computed from them last.
struct SpeedClusters::Subject {
  const study::Participant* participant = nullptr;
  std::span<const study::SpeedSample> samples;
  std::vector<double> all_mm_s;
  std::vector<std::uint32_t> stroke_of;  ///< a study of 200 participants has millions of samples
  std::vector<double> peaks_mm_s;        ///< of each stroke
  double highest_mm_s = 0;

  std::optional<double> trim;     ///< of the next one
  std::vector<double> kept_mm_s;  ///< only if some are left out
  std::optional<ClusterKey> key;  ///< of `result`, but for its ramps
  std::shared_ptr<const SpeedSubject> result;

  void prepare();
  void keep(double share);
  std::span<const double> kept() const { return *trim > 0 ? kept_mm_s : all_mm_s; }
  std::span<const study::SpeedSample> keptSamples(std::vector<study::SpeedSample>& room) const {
    return elicitation::keptSamples(samples, *trim, room);
  }
  /// The mean of each level, as LevelSpeeds has it.
  base::Result<std::vector<double>> levelMeans(const std::vector<std::string>& levels) const;
};

void SpeedClusters::Subject::prepare() {
  std::map<std::tuple<std::string_view, int>, std::uint32_t> strokes;
  all_mm_s.reserve(samples.size());
  stroke_of.reserve(samples.size());
  for (const auto& sample : samples) {
    // Most samples belong to the stroke of the one before.
    const bool same = !all_mm_s.empty() && samples[all_mm_s.size() - 1].stroke == sample.stroke &&
                      samples[all_mm_s.size() - 1].level == sample.level;
    const auto next = static_cast<std::uint32_t>(peaks_mm_s.size());
    const std::uint32_t stroke =
        same ? stroke_of.back() : strokes.try_emplace({sample.level, sample.stroke}, next).first->second;
    if (stroke == peaks_mm_s.size()) peaks_mm_s.push_back(sample.speed_mm_s);
    peaks_mm_s[stroke] = std::max(peaks_mm_s[stroke], sample.speed_mm_s);
    all_mm_s.push_back(sample.speed_mm_s);
    stroke_of.push_back(stroke);
    highest_mm_s = std::max(highest_mm_s, sample.speed_mm_s);
  }
}

// As elicitation::trimStrokes.
void SpeedClusters::Subject::keep(double share) {
  if (trim == share) return;
  trim = share;
  kept_mm_s.clear();
  if (share <= 0) return;
  for (std::size_t i = 0; i < all_mm_s.size(); ++i) {
    if (all_mm_s[i] >= share * peaks_mm_s[stroke_of[i]]) kept_mm_s.push_back(all_mm_s[i]);
  }
}

base::Result<std::vector<double>> SpeedClusters::Subject::levelMeans(const std::vector<std::string>& levels) const {
  std::vector<study::SpeedSample> room;
  std::vector<double> means;
  for (const auto& level : elicitation::levelSpeeds(keptSamples(room), levels)) {
    if (level.samples == 0) {
      return base::fail(base::ErrorCode::kData, "level " + level.level, "no samples",
                        "samples of each level for level means");
    }
    means.push_back(level.mean_mm_s);
  }
  if (std::adjacent_find(means.begin(), means.end(), std::greater_equal<>()) != means.end()) {
    return base::fail(base::ErrorCode::kData, "level means", "means that do not rise with the level",
                      "means that rise, or clusters as centers");
  }
  return means;
}

SpeedClusters::SpeedClusters() : speed_(rateOf(*procedure::defaultProcedure())) {}
SpeedClusters::~SpeedClusters() = default;

// Returns whether it came to the end.
bool SpeedClusters::take(const std::shared_ptr<const LabStudy>& study, const KeepGoing& keep_going) {
  if (study == study_) return true;
  subjects_.clear();
  study_ = nullptr;
  speed_ = rateOf(procedure::of(study->study));
  samples_.emplace(study->study.speeds);
  for (const auto& participant : study->study.participants) {
    const auto samples = samples_->of(participant.code);
    if (samples.empty()) continue;
    if (!keep_going(0)) return false;
    Subject& subject = subjects_.emplace_back();
    subject.participant = &participant;
    subject.samples = samples;
    subject.prepare();
  }
  study_ = study;
  return true;
}

void SpeedClusters::clusterOne(Subject& subject, const elicitation::BuildSettings& settings,
                               std::size_t clusters) const {
  const ClusterKey key = keyOf(settings, clusters);
  subject.keep(settings.speed.trim);
  const bool same = subject.key == key && subject.result->failure.empty();
  auto next = same ? std::make_shared<SpeedSubject>(*subject.result) : std::make_shared<SpeedSubject>();
  elicitation::ParticipantSpeeds& out = next->speeds;
  if (!same) {
    out.participant = subject.participant->code;
    out.simulated = subject.participant->simulated;
    out.samples = subject.all_mm_s.size();
    out.kept = subject.kept().size();
    out.m = settings.speed.fcm.m;
    fillHistogram(*next, subject.kept(), subject.highest_mm_s);
    if (settings.speed.centres == SpeedCentres::kLevelMeans) {
      auto means = subject.levelMeans(levelsOf(speed_));
      if (means) {
        out.centres = std::move(*means);
      } else {
        next->failure = means.error().message();
      }
    } else {
      elicitation::FcmSettings fcm = settings.speed.fcm;
      fcm.clusters = clusters;
      auto found = elicitation::fuzzyCMeans(subject.kept(), fcm);
      if (found) {
        out.centres = found->centres;
        out.clusters = std::move(*found);
      } else {
        next->failure = found.error().message();
      }
    }
  }
  out.ramps.clear();
  if (next->failure.empty()) {
    if (auto ramps = elicitation::alphaCutRamps(out.centres, out.m, settings.speed.alpha)) {
      out.ramps = std::move(*ramps);
    } else {
      next->failure = ramps.error().message();
    }
  }
  subject.key = key;
  subject.result = std::move(next);
}

// Returns whether it came to the end.
bool SpeedClusters::clusterAll(const elicitation::BuildSettings& settings, std::size_t clusters,
                               const KeepGoing& keep_going) {
  const auto is_kept = [&](const Subject& subject) { return subject.key == keyOf(settings, clusters); };
  const auto work = [&](std::size_t i) { clusterOne(subjects_[i], settings, clusters); };
  if (!std::all_of(subjects_.begin(), subjects_.end(), is_kept)) return sideBySide(subjects_.size(), work, keep_going);
  for (std::size_t i = 0; i < subjects_.size(); ++i) work(i);
  return keep_going(1);
}

std::shared_ptr<const SpeedResult> SpeedClusters::cluster(const std::shared_ptr<const LabStudy>& study,
                                                          const elicitation::BuildSettings& settings,
                                                          std::size_t clusters, const KeepGoing& keep_going) {
  if (!take(study, keep_going)) return nullptr;
  settings_ = settings;
  if (settings.speed.centres == SpeedCentres::kLevelMeans) clusters = speed_.terms.size();
  result_ = {};
  result_.clusters = clusters;
  result_.speed = speed_;
  if (!clusterAll(settings, clusters, keep_going)) return nullptr;
  for (const Subject& subject : subjects_) result_.subjects.push_back(subject.result);
  average(settings);
  return std::make_shared<const SpeedResult>(result_);
}

void SpeedClusters::average(const elicitation::BuildSettings& settings) {
  if (result_.subjects.empty() || result_.clusters != speed_.terms.size()) return;
  std::vector<std::vector<elicitation::Ramp>> ramps;
  std::vector<elicitation::ParticipantSpeeds> speeds;
  std::vector<study::Participant> people;
  for (std::size_t i = 0; i < subjects_.size(); ++i) {
    const SpeedSubject& one = *result_.subjects[i];
    if (!one.failure.empty()) {
      result_.failure = one.speeds.participant + ": " + one.failure;
      return;
    }
    ramps.push_back(one.speeds.ramps);
    speeds.push_back({.participant = one.speeds.participant,
                      .centres = one.speeds.centres,
                      .clusters = {},
                      .validity = {},
                      .ramps = one.speeds.ramps,
                      .diagnostics = {}});
    people.push_back(*subjects_[i].participant);
  }
  std::vector<double> weights;
  if (settings.averaging == elicitation::Averaging::kWeightedMean) {
    auto given = elicitation::expertWeights(people, settings.weights);
    if (!given) {
      result_.failure = given.error().message();
      return;
    }
    weights = std::move(*given);
  }
  result_.averaged = elicitation::averageRamps(ramps, weights, settings.averaging);
  result_.speed = elicitation::averagedSpeed(speed_, speeds, result_.averaged);
}

std::shared_ptr<const SpeedResult> SpeedClusters::check(const KeepGoing& keep_going) {
  const auto levels = levelsOf(speed_);
  result_.same_terms.clear();
  for (std::size_t i = 0; i < subjects_.size(); ++i) {
    if (!keep_going(static_cast<double>(i) / static_cast<double>(subjects_.size()))) return nullptr;
    Subject& subject = subjects_[i];
    if (!subject.result->failure.empty()) continue;
    if (!subject.result->checked) {
      auto next = std::make_shared<SpeedSubject>(*subject.result);
      elicitation::ParticipantSpeeds& out = next->speeds;
      out.validity = elicitation::fcmValidity(subject.kept(), out.centres, out.m);
      if (!keep_going(static_cast<double>(i) / static_cast<double>(subjects_.size()))) return nullptr;
      std::vector<study::SpeedSample> room;
      const auto kept = subject.keptSamples(room);
      // Clusters are compared with the levels only if there are as many.
      if (result_.clusters == levels.size()) {
        out.diagnostics = elicitation::levelDiagnostics(kept, levels, out.centres, out.participant);
      } else {
        out.diagnostics.levels = elicitation::levelSpeeds(kept, levels);
      }
      next->checked = true;
      subject.result = std::move(next);
    }
    result_.subjects[i] = subject.result;
    if (result_.averaged.empty() || settings_.terms != elicitation::SpeedTermsOf::kAveraged) continue;
    fuzzy::Variable own = result_.speed;
    own.terms = elicitation::speedTerms(result_.speed, subject.result->speeds.ramps);
    if (auto note = elicitation::sameTermNote(subject.result->speeds.diagnostics.levels, result_.speed, own,
                                              subject.result->speeds.participant)) {
      result_.same_terms.push_back(std::move(*note));
    }
  }
  return std::make_shared<const SpeedResult>(result_);
}

void SpeedClusters::bootstrap(const KeepGoing& keep_going,
                              const std::function<void(std::shared_ptr<const SpeedResult>)>& more) {
  if (result_.averaged.empty()) return;
  elicitation::BuiltModel built;
  built.model.inputs = {result_.speed};
  built.averaged_ramps = result_.averaged;
  std::vector<study::Participant> people;
  for (const Subject& subject : subjects_) {
    built.speeds.push_back(subject.result->speeds);
    people.push_back(*subject.participant);
  }
  if (settings_.averaging == elicitation::Averaging::kWeightedMean) {
    if (auto weights = elicitation::expertWeights(people, settings_.weights)) built.speed_weights = *weights;
  }
  auto replicates = elicitation::SpeedBootstrap::of(study_->study, built, settings_, 1, [&] { return keep_going(0); });
  if (!replicates) return;
  std::size_t told = 0;
  while (replicates->replicates() < elicitation::kBootstrapReplicates) {
    const auto all = static_cast<double>(elicitation::kBootstrapReplicates);
    const double from = static_cast<double>(replicates->replicates()) / all;
    const auto go_on = [&](double share) { return keep_going(from + share * kBatch / all); };
    if (!sideBySide(
            subjects_.size(), [&](std::size_t i) { replicates->addTo(i, kBatch); }, go_on))
      return;
    const std::size_t done = replicates->replicates();
    if (done < 2 * told && done < elicitation::kBootstrapReplicates) continue;
    told = done;
    result_.intervals = replicates->intervals();
    more(std::make_shared<const SpeedResult>(result_));
  }
}

std::span<const double> SpeedClusters::speedsOf(const std::string& participant) const {
  for (const Subject& subject : subjects_) {
    if (subject.participant->code == participant) return subject.kept();
  }
  return {};
}

std::vector<std::size_t> subjectNumbers(const SpeedResult& result) {
  std::vector<fuzzy::Expert> experts;
  for (const auto& subject : result.subjects) {
    experts.emplace_back();
    experts.back().id = subject->speeds.participant;
  }
  return figures::expertNumbers(experts);
}

}  // namespace tactus::workbench
