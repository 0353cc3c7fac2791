#include "app/replay/recorded_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "app/editing/edit.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/model_io/model_file.h"
#include "core/render/insertion.h"
#include "core/store/entries.h"
#include "core/store/feel_records.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::replay {
namespace {

using base::Result;
using haptics::ServoScene;

/// A longer time between two ticks, in periods, may be samples that were lost.
constexpr double kLongTick = 1.5;

const std::vector<double>* channelOf(const study::Recording& recording, const std::string& name) {
  const auto found = std::find_if(recording.channels.begin(), recording.channels.end(),
                                  [&](const study::Channel& channel) { return channel.name == name; });
  return found == recording.channels.end() ? nullptr : &found->values;
}

// The channels of a recording as docs/study-file.md names them. All others are conditions.
constexpr std::array<std::string_view, 6> kNeeded = {"time",         "position", "depth",
                                                     "source_force", "button",   "placement"};
constexpr std::array<std::string_view, 7> kNotNeeded = {"speed", "slip_speed", "stretch", "model_force",
                                                        "force", "stroke",     "limited"};

template <std::size_t size>
bool isOneOf(const std::array<std::string_view, size>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The channels that a replay needs.
struct Channels {
  const std::vector<double>* time;
  const std::vector<double>* position;
  const std::vector<double>* depth;
  const std::vector<double>* source_force;
  const std::vector<double>* button;
  const std::vector<double>* placement;

  explicit Channels(const study::Recording& of)
      : time(channelOf(of, "time")),
        position(channelOf(of, "position")),
        depth(channelOf(of, "depth")),
        source_force(channelOf(of, "source_force")),
        button(channelOf(of, "button")),
        placement(channelOf(of, "placement")) {}
  bool areComplete() const {
    return time != nullptr && position != nullptr && depth != nullptr && source_force != nullptr && button != nullptr &&
           placement != nullptr && !time->empty();
  }
};

/// The time of each tick since the one before, as the servo computed it: from whole nanoseconds.
std::vector<double> ticksOf(const study::Recording& recording, const std::vector<double>& time_s) {
  std::vector<double> out{1 / recording.sample_rate_hz};
  const auto nanoseconds = [&](std::size_t i) { return std::llround(time_s[i] * 1e9); };
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    out.push_back(std::max(render::kShortestTickS, static_cast<double>(nanoseconds(i) - nanoseconds(i - 1)) * 1e-9));
  }
  return out;
}

/// A recording through its own model, tick by tick as the servo does it.
class OwnRun {
 public:
  explicit OwnRun(const StoredRecording& stored)
      : stored_(stored), channels_(stored.samples), dt_s_(ticksOf(stored.samples, *channels_.time)) {
    auto read = model_io::parseModel(stored.model_text, "");
    if (!read || read->model.name != stored.model_name) return;
    auto ready = editing::ready(std::move(read->model));
    if (ready) model_ = *ready;
  }

  std::vector<RecordedStroke> strokes() {
    std::vector<RecordedStroke> out;
    const std::size_t size = channels_.time->size();
    for (std::size_t i = 0; i < size;) {
      if (!isHeld(i)) {
        if (model_ != nullptr) tick(i);
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < size && isHeld(end) && (end == i || !isPlaced(end))) ++end;
      out.push_back(stroke(i, end));
      out.back().number = static_cast<int>(out.size());
      i = end;
    }
    return out;
  }

 private:
  bool isHeld(std::size_t i) const { return (*channels_.button)[i] != 0; }
  bool isPlaced(std::size_t i) const { return i == 0 || (*channels_.placement)[i] != (*channels_.placement)[i - 1]; }

  /// The depth of the tube without the offset of the model.
  double depthMm(std::size_t i) const {
    return (*channels_.depth)[i] - (scene_ != nullptr ? scene_->renderer().depth_offset_mm : 0);
  }

  std::map<std::string, double> conditions(std::size_t i) const {
    std::map<std::string, double> out;
    for (const study::Channel& channel : stored_.samples.channels) {
      if (!isOneOf(kNeeded, channel.name)) out[channel.name] = channel.values[i];
    }
    return out;
  }

  /// Does nothing where the conditions stay: a scene of the same conditions would fade like another one.
  void takeConditions(std::size_t i) {
    auto now = conditions(i);
    if (scene_ != nullptr && now == conditions_) return;
    haptics::SceneSettings settings;
    settings.largest_cost_s = std::numeric_limits<double>::infinity();
    auto scene = ServoScene::make(model_->model, model_->compiled, now, settings);
    if (!scene) {
      model_ = nullptr;
      return;
    }
    scene_ = *std::move(scene);
    conditions_ = std::move(now);
  }

  void place(std::size_t i) {
    takeConditions(i);
    if (model_ != nullptr && isPlaced(i)) insertion_.place(depthMm(i));
  }

  void tick(std::size_t i) {
    place(i);
    if (model_ == nullptr) return;
    render::InsertionTick tick;
    tick.active = true;
    tick.enabled = isHeld(i);
    tick.position_mm = (*channels_.position)[i];
    tick.scene = scene_.get();
    tick.fade_s = scene_->fadeS();
    tick.dt_s = dt_s_[i];
    insertion_.tick(tick);
  }

  RecordedStroke stroke(std::size_t begin, std::size_t end) {
    RecordedStroke out;
    out.recording = stored_.id;
    out.recording_number = stored_.number;
    out.person = stored_.person;
    out.simulated = stored_.simulated;
    out.calculated = stored_.calculated;
    out.conditions = conditions(begin);
    const auto cut = [&](const std::vector<double>& all) {
      return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                 all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    out.dt_s = cut(dt_s_);
    out.position_mm = cut(*channels_.position);
    out.recorded_n = cut(*channels_.source_force);
    if (model_ != nullptr) place(begin);
    // A press does not move the tube. After a stroke that came out differently the tube is set where it was recorded.
    // Depths are compared as they are recorded: without the offset again they could differ in their last bit.
    const auto recordedMm = [&] { return insertion_.state().depth_mm + scene_->renderer().depth_offset_mm; };
    if (model_ != nullptr && recordedMm() != (*channels_.depth)[begin]) insertion_.place(depthMm(begin));
    out.at_press = insertion_.state();
    double since_press_s = 0;
    bool is_long = false;
    for (std::size_t i = begin; i < end && model_ != nullptr; ++i) {
      tick(i);
      since_press_s += i == begin ? 0 : dt_s_[i];
      is_long = is_long || (i > begin && dt_s_[i] * stored_.samples.sample_rate_hz > kLongTick);
      if (model_ == nullptr || out.use != StrokeUse::kExact) continue;
      if (insertion_.state().force_n == (*channels_.source_force)[i]) continue;
      out.use = is_long && stored_.has_gaps ? StrokeUse::kSamplesLost : StrokeUse::kOtherForce;
      out.differs_at_s = since_press_s;
    }
    if (model_ == nullptr) out.use = StrokeUse::kUnknownModel;
    return out;
  }

  const StoredRecording& stored_;
  Channels channels_;
  std::vector<double> dt_s_;
  editing::SharedModel model_;  ///< null: not kept, or refused by the renderer
  std::shared_ptr<const ServoScene> scene_;
  std::map<std::string, double> conditions_;
  render::Insertion insertion_;
};

/// The hand lay still where the movement began; the tube is there.
RecordedStroke strokeOf(const StoredMovement& movement) {
  const study::StrokeRecord& stored = movement.stroke;
  const std::vector<double>& time_s = *channelOf(stored.recording, "time");
  const std::vector<double>& depth_mm = *channelOf(stored.recording, "depth");
  RecordedStroke out;
  out.recording = stored.entry.id;
  out.number = stored.number;
  out.person = movement.person;
  out.level = stored.level;
  out.simulated = movement.simulated;
  out.use = StrokeUse::kForceOff;
  const std::size_t before = stored.first > 0 ? stored.first - 1 : stored.first;
  out.at_press.depth_mm = depth_mm[before];
  out.at_press.position_mm = depth_mm[before];
  for (std::size_t i = stored.first; i < stored.last; ++i) {
    out.dt_s.push_back(i == 0 ? 1 / stored.recording.sample_rate_hz : time_s[i] - time_s[i - 1]);
    out.position_mm.push_back(depth_mm[i]);
  }
  return out;
}

bool isUsable(const study::StrokeRecord& stroke) {
  const auto* const time_s = channelOf(stroke.recording, "time");
  const auto* const depth_mm = channelOf(stroke.recording, "depth");
  return time_s != nullptr && depth_mm != nullptr && stroke.last <= time_s->size() && stroke.first + 2 <= stroke.last;
}

Result<void> addRecordings(const store::StudyFile& file, const std::set<study::RecordId>& simulated,
                           StoredStrokes& out) {
  TACTUS_TRY(const auto summaries, store::feelRecordings(file));
  for (const store::FeelSummary& summary : summaries) {
    StoredRecording one;
    one.id = summary.start.entry.id;
    one.number = static_cast<int>(&summary - summaries.data()) + 1;
    one.person = summary.code;
    one.simulated = summary.start.setting.simulated || simulated.contains(summary.start.entry.session);
    one.calculated = summary.start.setting.device == kNoHand;
    one.has_gaps = summary.gaps > 0;
    one.model_name = summary.start.setting.model;
    if (summary.pieces == 0) continue;  // ended at once
    auto samples = store::feelRecording(file, one.id);
    if (!samples) {
      out.unreadable.push_back(samples.error().message());
      continue;
    }
    one.samples = *std::move(samples);
    std::erase_if(one.samples.channels,
                  [](const study::Channel& channel) { return isOneOf(kNotNeeded, channel.name); });
    if (!Channels(one.samples).areComplete()) {
      out.unreadable.push_back(base::Error{base::ErrorCode::kSchema, file.path(),
                                           "recording " + std::to_string(one.number), "not all channels",
                                           "time, position, depth, source_force, button and placement"}
                                   .message());
      continue;
    }
    if (const auto& version = summary.start.setting.model_version) {
      if (auto kept = store::modelVersion(file, *version)) one.model_text = std::move(kept->text);
    }
    out.recordings.push_back(std::move(one));
  }
  return {};
}

}  // namespace

Result<StoredStrokes> storedStrokes(const store::StudyFile& file) {
  TACTUS_TRY(const auto persons, store::persons(file));
  TACTUS_TRY(const auto sessions, store::sessions(file));
  std::map<study::RecordId, const study::Person*> by_session;
  std::set<study::RecordId> simulated;
  for (const study::SessionRecord& session : sessions) {
    const auto person = std::find_if(persons.begin(), persons.end(),
                                     [&](const study::Person& one) { return one.id == session.person; });
    if (person == persons.end()) continue;
    by_session[session.id] = &*person;
    if (person->simulated) simulated.insert(session.id);
  }
  StoredStrokes out;
  if (auto ok = addRecordings(file, simulated, out); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(auto strokes, store::strokes(file));
  for (study::StrokeRecord& stroke : strokes) {
    if (stroke.level == store::kFeelLevel || stroke.verdict != "accepted" || stroke.practice || !isUsable(stroke)) {
      continue;
    }
    const auto person = by_session.find(stroke.entry.session);
    const bool known = person != by_session.end();
    out.movements.push_back({std::move(stroke), known ? person->second->code : "", known && person->second->simulated});
  }
  return out;
}

std::vector<RecordedStroke> recordedStrokes(const StoredStrokes& stored) {
  std::vector<RecordedStroke> out;
  for (const StoredRecording& recording : stored.recordings) {
    for (RecordedStroke& stroke : OwnRun(recording).strokes()) {
      if (stroke.position_mm.size() >= 2) out.push_back(std::move(stroke));
    }
  }
  for (const StoredMovement& movement : stored.movements) out.push_back(strokeOf(movement));
  return out;
}

}  // namespace tactus::replay
