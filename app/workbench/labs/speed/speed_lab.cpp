#include "app/workbench/labs/speed/speed_lab.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stop_token>
#include <utility>

#include "app/workbench/labs/data/corrections.h"
#include "core/store/entries.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/fcm_starts.h"
#include "experiments/stroke.h"
#include "experiments/stroke_speeds.h"

namespace tactus::workbench {

StrokeInfluence::StrokeInfluence(LabModel& model, QObject* parent)
    : QObject(parent),
      model_(model),
      answer_(
          [this]() -> std::optional<Asked> {
            const auto built = model_.inputs();
            return asked_ && built ? std::optional(Asked{*built, *asked_, which_}) : std::nullopt;
          },
          [](const Asked& asked, const auto&) {
            const auto& [built, study, settings] = asked.built;
            const auto moved = elicitation::withoutStroke(*built, study->study, settings, asked.stroke.participant,
                                                          asked.stroke.level, asked.stroke.stroke);
            return std::make_shared<const QString>(influenceText(asked.which, moved, built->model));
          }) {
  answer_.needs(model_);
  connect(&model_, &Computation::valueChanged, this, [this] {
    answer_.forget();
    if (asked_) emit told();
  });
  connect(&answer_, &Computation::valueChanged, this, &StrokeInfluence::told);
}

void StrokeInfluence::ask(const elicitation::StrokeKey& stroke, const QString& which) {
  asked_ = stroke;
  which_ = which;
  answer_.hold(*this);
  answer_.forget();
  emit told();
}

void StrokeInfluence::stop() {
  asked_.reset();
  answer_.forget();
  answer_.hold(*this, false);
  emit told();
}

QString StrokeInfluence::sentence() const {
  if (!asked_) return {};
  if (answer_.value() != nullptr) return *answer_.value();
  if (model_.value() != nullptr) return tr("%1: comparing the force with and without it…").arg(which_);
  return model_.failure().isEmpty() ? tr("%1: building the model…").arg(which_) : model_.failure();
}

namespace {

constexpr int kMostIterations = 100;
constexpr double kStill = 1e-6;  // of the range: nothing to see below it

}  // namespace

ObjectiveTrace objectiveTrace(std::span<const double> samples, std::size_t clusters, double m,
                              const std::function<bool()>& keep_going) {
  ObjectiveTrace out;
  const auto data = elicitation::prepareFcmData(samples, {});
  if (!data) return out;
  const auto entries = elicitation::condense(*data);
  if (entries.size() <= clusters) return out;
  std::vector<double> centres = elicitation::quantileStart(entries, clusters);
  elicitation::FcmPass pass(clusters, m);
  elicitation::FcmSums sums;
  for (int i = 0; i <= kMostIterations && !out.converged; ++i) {
    if (!keep_going()) return {};
    pass.run(*data, centres, sums);
    out.objective.push_back(std::ldexp(sums.objective, data->objectiveExponent()));
    double step = 0;
    for (std::size_t k = 0; k < clusters; ++k) {
      const double move = sums.weight[k] > 0 ? sums.pull[k] / sums.weight[k] : 0;
      centres[k] += move;
      step = std::max(step, std::abs(move));
    }
    out.converged = step < kStill * data->range();
  }
  return out;
}

namespace {

// Of a run's time, about.
constexpr double kClustered = 0.3;
constexpr double kChecked = 0.5;
constexpr auto kTell = std::chrono::milliseconds(100);  // between two reports of progress
constexpr auto kCalm = std::chrono::milliseconds(150);  // more than between two steps of a slider that moves

/// Waits for a moment. Returns whether nothing newer has come meanwhile.
bool staysCalm(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any woken;
  std::unique_lock lock(mutex);
  woken.wait_for(lock, stop, kCalm, [] { return false; });
  return !stop.stop_requested();
}

}  // namespace

SpeedLab::SpeedLab(LabData& data, QObject* parent)
    : QObject(parent),
      data_(data),
      work_(
          [this]() -> std::optional<Inputs> {
            const auto from = data_.inputs();
            return from ? std::optional(Inputs{*from, clusters_, page_}) : std::nullopt;
          },
          [calculation = std::make_shared<SpeedClusters>()](const Inputs& inputs, const RunOf<Found>& run) {
            return compute(inputs, run, *calculation);
          }) {
  followLabData(work_, data_);
  connect(&work_, &Computation::valueChanged, this, &SpeedLab::onResult);
  connect(&data_, &LabData::settingsChanged, this, [this] {
    current_ = false;
    emit settingsChanged();
  });
}

template <class Change>
void SpeedLab::change(Change apply) {
  elicitation::BuildSettings settings = data_.settings();
  apply(settings);
  data_.setSettings(std::move(settings));
}

void SpeedLab::setAlpha(double alpha) {
  change([alpha](auto& settings) { settings.speed.alpha = alpha; });
}

void SpeedLab::setFuzziness(double m) {
  change([m](auto& settings) { settings.speed.fcm.m = m; });
}

void SpeedLab::setTrim(double share) {
  change([share](auto& settings) { settings.speed.trim = share; });
}

void SpeedLab::setCentres(elicitation::SpeedCentres centres) {
  change([centres](auto& settings) { settings.speed.centres = centres; });
}

void SpeedLab::setAveraging(elicitation::Averaging averaging) {
  change([averaging](auto& settings) { settings.averaging = averaging; });
}

void SpeedLab::setDefaults() {
  setClusters(elicitation::FcmSettings().clusters);
  change([](auto& settings) {
    settings.speed = {};
    settings.averaging = elicitation::Averaging::kMean;
  });
}

void SpeedLab::setClusters(std::size_t clusters) {
  if (clusters == clusters_) return;
  clusters_ = clusters;
  current_ = false;
  work_.refresh();
  emit settingsChanged();
}

std::size_t SpeedLab::pages() const {
  const std::size_t count = result_ ? result_->subjects.size() : 0;
  return std::max<std::size_t>(1, (count + kPerPage - 1) / kPerPage);
}

void SpeedLab::setPage(std::size_t page) {
  page = std::min(page, pages() - 1);
  if (page == page_) return;
  page_ = page;
  objectives_.clear();
  work_.refresh();
  emit pageChanged();
}

std::pair<std::size_t, std::size_t> SpeedLab::shown() const {
  const std::size_t count = result_ ? result_->subjects.size() : 0;
  return {std::min(count, page_ * kPerPage), std::min(count, (page_ + 1) * kPerPage)};
}

void SpeedLab::onResult() {
  const auto& found = work_.value();
  result_ = found == nullptr ? nullptr : found->result;
  current_ = work_.isCurrent();
  if (found == nullptr) {
    page_ = 0;
    objectives_.clear();
  } else if (found->objectives) {
    objectives_ = *found->objectives;
  }
  if (page_ >= pages()) {
    page_ = pages() - 1;
    emit pageChanged();
  }
  emit resultChanged();
}

// First what the plots show: it comes to its end even if the slider has moved on, so
// that a drag shows something. What takes longer, and would make the next step of a slider wait, begins when the
// settings stand still.
SpeedLab::FoundCell::Answer SpeedLab::compute(const Inputs& inputs, const RunOf<Found>& run,
                                              SpeedClusters& calculation) {
  double from = 0;
  double to = kClustered;
  auto told = std::chrono::steady_clock::now();
  const auto tell = [&](double share) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told > kTell) {
      told = now;
      run.progress(from + (to - from) * share);
    }
    return true;
  };
  const auto go_on = [&](double share) { return !run.stop.stop_requested() && tell(share); };
  std::optional<std::vector<ObjectiveTrace>> objectives;
  const auto hand = [&](std::shared_ptr<const SpeedResult> result) { run.hand({std::move(result), objectives}); };
  elicitation::BuildSettings settings = inputs.from.settings;
  settings.speed.fcm.keep_going = [given_up = run.given_up](const auto&) { return !given_up(); };
  const auto clustered = calculation.cluster(inputs.from.study, settings, inputs.clusters,
                                             [&](double share) { return !run.given_up() && tell(share); });
  if (!clustered) return nullptr;
  run.show({clustered});
  if (!staysCalm(run.stop)) return nullptr;
  run.say(tr("Comparing clusters and levels"));
  from = kClustered;
  to = kChecked;
  auto checked = calculation.check(go_on);
  if (!checked) return nullptr;
  hand(checked);
  std::vector<ObjectiveTrace> traces;
  const std::size_t first = inputs.page * kPerPage;
  for (std::size_t i = first; i < std::min(first + kPerPage, checked->subjects.size()); ++i) {
    const SpeedSubject& subject = *checked->subjects[i];
    traces.push_back(objectiveTrace(calculation.speedsOf(subject.speeds.participant), checked->clusters,
                                    subject.speeds.m, [&run] { return !run.stop.stop_requested(); }));
  }
  if (run.stop.stop_requested()) return nullptr;
  objectives = std::move(traces);
  hand(checked);
  run.say(tr("Drawing strokes again for the intervals"));
  from = kChecked;
  to = 1;
  calculation.bootstrap(go_on, hand);
  return nullptr;
}

namespace {

constexpr std::size_t kMostKept = 24;  // sets: some megabytes

bool isShown(const study::StrokeRecord& stroke) {
  const auto verdict = experiments::strokeVerdict(stroke.verdict);
  return !stroke.practice &&
         (verdict == experiments::StrokeVerdict::kAccepted || verdict == experiments::StrokeVerdict::kRejected);
}

StrokeTrace traceOf(study::StrokeRecord record, const base::Result<study::Recording>& recording) {
  StrokeTrace out;
  if (!recording) {
    out.record = std::move(record);
    out.failure = recording.error().message();
    return out;
  }
  record.recording = *recording;
  const auto time = std::find_if(recording->channels.begin(), recording->channels.end(),
                                 [](const study::Channel& channel) { return channel.name == "time"; });
  for (std::size_t i = 0; i < recording->size(); ++i) {
    out.time_s.push_back(time != recording->channels.end() ? time->values[i] - time->values.front()
                                                           : static_cast<double>(i) / recording->sample_rate_hz);
  }
  study::StrokeRecord whole = record;
  whole.first = 0;
  whole.last = whole.recording.size();
  if (const auto motion = experiments::strokeMotion(whole)) {
    for (const auto& sample : *motion) {
      out.speed_time_s.push_back(sample.time_s - motion->front().time_s);
      out.speed_mm_s.push_back(static_cast<float>(sample.speed_mm_s));
    }
  } else {
    out.failure = motion.error().message();
  }
  record.recording = {};
  out.record = std::move(record);
  return out;
}

}  // namespace

double StrokeTrace::timeOf(std::size_t index) const {
  if (time_s.empty()) return 0;
  return time_s[std::min(index, time_s.size() - 1)];
}

std::size_t StrokeTrace::sampleAt(double at_s) const {
  if (time_s.empty()) return 0;
  const auto next = std::lower_bound(time_s.begin(), time_s.end(), at_s);
  if (next == time_s.begin()) return 0;
  if (next == time_s.end()) return time_s.size() - 1;
  const auto index = static_cast<std::size_t>(next - time_s.begin());
  return *next - at_s < at_s - *(next - 1) ? index : index - 1;
}

StrokeTraces::StrokeTraces(LabData& data, QObject* parent) : QObject(parent), data_(data) {
  connect(&data_, &LabData::studyChanged, this, [this] {
    if (data_.study() == nullptr) kept_.clear();
  });
}

std::shared_ptr<const StrokeSet> StrokeTraces::strokes(const std::string& participant, const std::string& level) {
  if (data_.study() == nullptr) return nullptr;
  auto found = std::find_if(kept_.begin(), kept_.end(),
                            [&](const Kept& one) { return one.participant == participant && one.level == level; });
  if (found == kept_.end()) {
    kept_.push_front({participant, level, nullptr, nullptr, false});
    if (kept_.size() > kMostKept) kept_.pop_back();
    found = kept_.begin();
  }
  if (found->of != data_.study() && !found->reading) read(*found);
  return found->set;
}

void StrokeTraces::read(Kept& kept) {
  const auto study = data_.study();
  std::set<study::RecordId> sessions;
  for (const auto& session : study->sessions) {
    if (study->codeOf(session.id) == kept.participant) sessions.insert(session.id);
  }
  std::vector<study::StrokeRecord> records;
  for (const auto& stroke : study->strokes) {
    if (stroke.level == kept.level && isShown(stroke) && sessions.count(stroke.entry.session) > 0) {
      records.push_back(stroke);
    }
  }
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& one, const auto& other) { return one.number < other.number; });
  kept.reading = true;
  data_.connection().read(*this,
                          [this, study, records, participant = kept.participant,
                           level = kept.level](const store::StudyFile& file) -> StudyConnection::Deliver {
                            const auto set = std::make_shared<StrokeSet>(StrokeSet{participant, level, {}});
                            for (const auto& record : records) {
                              set->strokes.push_back(traceOf(record, store::recordingOf(file, record.entry.id)));
                            }
                            return [this, study, set] { setStrokes(study, set); };
                          });
}

void StrokeTraces::setStrokes(const std::shared_ptr<const LabStudy>& of, std::shared_ptr<const StrokeSet> set) {
  for (Kept& one : kept_) {
    if (one.participant != set->participant || one.level != set->level) continue;
    one.of = of;
    one.set = std::move(set);
    one.reading = false;
    break;
  }
  emit arrived();
}

}  // namespace tactus::workbench
