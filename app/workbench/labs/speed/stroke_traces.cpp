#include "app/workbench/labs/speed/stroke_traces.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/store/entries.h"
#include "experiments/stroke.h"
#include "experiments/stroke_speeds.h"

namespace tactus::workbench {
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
                            return [this, study, set] { take(study, set); };
                          });
}

void StrokeTraces::take(const std::shared_ptr<const LabStudy>& of, std::shared_ptr<const StrokeSet> set) {
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
