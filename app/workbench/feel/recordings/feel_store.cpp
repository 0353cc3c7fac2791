#include "app/workbench/feel/recordings/feel_store.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/haptics/simulated/replay_device.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/feel_records.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::workbench {
namespace {

using base::Result;
using study::RecordId;

std::string settingsOf(const FeelSessions::Visit& visit) {
  base::JsonWriter json;
  json.beginObject(base::JsonWriter::Layout::kInline).key("purpose").value("feel");
  json.key("device").value(visit.device_id).key("simulated").value(visit.simulated).endObject();
  std::string text = json.text();
  text.pop_back();  // the newline of a whole file
  return text;
}

}  // namespace

Result<RecordId> FeelSessions::researcher(store::StudyFile& file, study::RecordIds& ids) {
  TACTUS_TRY(const auto people, readPeople(file));
  for (const StudyPerson& person : people) {
    if (person.researcher) return person.id;
  }
  store::PersonCodes codes;
  TACTUS_TRY(const auto code, store::unusedCode(file, codes));
  const study::Person person{ids.next(), code, false};
  if (auto ok = store::append(file, person); !ok) return tl::unexpected(ok.error());
  return person.id;
}

Result<RecordId> FeelSessions::sessionOf(const Visit& visit, store::StudyFile& file, study::RecordIds& ids) {
  const Key key(visit.run, visit.who);
  if (const auto found = sessions_.find(key); found != sessions_.end()) return found->second;
  // Person, session and profile together or not at all: it is tried again where the disk refuses.
  TACTUS_TRY(auto batch, store::Batch::begin(file));
  const auto who = visit.who ? Result<RecordId>(*visit.who) : researcher(file, ids);
  if (!who) return who;
  study::SessionRecord session;
  session.id = ids.next();
  session.person = *who;
  session.kind = study::SessionKind::kUsability;
  session.started = visit.started;
  session.program = kGenerator;
  session.device = visit.device;
  session.device_friction_n = visit.device_friction_n;
  session.settings = settingsOf(visit);
  if (auto ok = store::append(file, session); !ok) return tl::unexpected(ok.error());
  if (!visit.who) {
    study::ProfileRecord profile;
    profile.entry = {ids.next(), session.id, visit.started, study::EnteredBy::kResearcher, std::nullopt, {}};
    profile.category = kResearcherCategory;
    if (auto ok = store::append(file, profile); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = batch.commit(); !ok) return tl::unexpected(ok.error());
  sessions_[key] = session.id;
  return session.id;
}

int FeelSessions::numberOf(std::uint64_t serial, const RecordId& session) {
  const auto [it, is_new] = numbers_.try_emplace(serial, 0);
  if (is_new) it->second = ++counts_[session];
  return it->second;
}

FeelRecorder::FeelRecorder(double rate_hz, const std::vector<Condition>& conditions) {
  empty_.sample_rate_hz = rate_hz;
  empty_.channels = {{"time", "s", {}},        {"position", "mm", {}},     {"speed", "mm/s", {}},
                     {"depth", "mm", {}},      {"slip_speed", "mm/s", {}}, {"stretch", "mm", {}},
                     {"model_force", "N", {}}, {"source_force", "N", {}},  {"force", "N", {}},
                     {"button", "1", {}},      {"stroke", "1", {}},        {"placement", "1", {}},
                     {"limited", "1", {}}};
  for (const Condition& condition : conditions) {
    empty_.channels.push_back({condition.id, condition.unit, {}});
    conditions_.push_back(condition.value);
  }
  piece_ = empty_;
}

bool FeelRecorder::has(const std::vector<Condition>& conditions) const {
  const auto first = empty_.channels.end() - static_cast<std::ptrdiff_t>(conditions_.size());
  return std::equal(first, empty_.channels.end(), conditions.begin(), conditions.end(),
                    [](const study::Channel& channel, const Condition& condition) {
                      return channel.name == condition.id && channel.unit == condition.unit;
                    });
}

void FeelRecorder::add(const haptics::Sample& sample, double depth_mm, int placement) {
  if (!start_ns_) start_ns_ = sample.time_ns;
  last_tick_ = sample.tick;
  length_s_ = static_cast<double>(sample.time_ns - *start_ns_) * 1e-9;
  auto channel = piece_.channels.begin();
  const auto put = [&](double value) { (channel++)->values.push_back(value); };
  put(length_s_);
  put(sample.position_mm);
  put(sample.speed_mm_s);
  put(depth_mm);
  put(sample.slip_speed_mm_s);
  put(sample.stretch_mm);
  put(sample.model_force_n);
  put(sample.source_force_n);
  put(sample.force_n);
  put(sample.enabled ? 1 : 0);
  put(sample.stroke);
  put(placement);
  put(sample.limited);
  for (const double value : conditions_) put(value);
}

double FeelRecorder::pieceS() const {
  return piece_.size() == 0 ? 0 : length_s_ - piece_.channels.front().values.front();
}

std::optional<study::Recording> FeelRecorder::takePiece() {
  if (piece_.size() == 0) return std::nullopt;
  return std::exchange(piece_, empty_);
}

const std::vector<double>* channelOf(const study::Recording& recording, const std::string& name) {
  for (const study::Channel& channel : recording.channels) {
    if (channel.name == name) return &channel.values;
  }
  return nullptr;
}

std::string deviceText(const haptics::DeviceInfo& info) {
  return info.serial.empty() ? info.name : info.name + ' ' + info.serial;
}

namespace {

using base::Result;

constexpr double kTailS = 0.3;  // a replay shows that the force has gone

}  // namespace

FeelStore::FeelStore(FeelController& feel, SceneController& scene, StudyConnection& study, ModelVersion model_version,
                     QObject* parent)
    : QObject(parent),
      feel_(feel),
      scene_(scene),
      study_(study),
      model_version_(std::move(model_version)),
      sessions_(std::make_shared<FeelSessions>()) {
  connect(&feel_, &FeelController::stateChanged, this, &FeelStore::onState);
  connect(&feel_, &FeelController::sampled, this, &FeelStore::onSampled);
  connect(&feel_, &FeelController::advanced, this, &FeelStore::onAdvanced);
  connect(&feel_, &FeelController::placementEnded, this, &FeelStore::onPlacementEnded);
  connect(&scene_, &SceneController::modelChanged, this, &FeelStore::onModel);
  connect(&study_, &StudyConnection::opened, this, &FeelStore::onStudy);
  connect(&study_, &StudyConnection::closed, this, &FeelStore::onStudy);
  connect(&study_, &StudyConnection::leaving, this, [this] {
    setRecording(false);
    endPlacement();
  });
}

FeelStore::~FeelStore() { endRecording(); }

bool FeelStore::canRecord() const { return study_.takesOrders() && !study_.isOpening(); }

std::optional<study::RecordId> FeelStore::replayed() const { return replay_ ? replay_->id : std::nullopt; }

void FeelStore::setWho(std::optional<study::RecordId> who) {
  if (who == who_) return;
  // The current recording belongs to the previous person.
  if (recorder_) setRecording(false);
  endPlacement();
  who_ = who;
  emit changed();
}

void FeelStore::setRecording(bool recording) {
  if (recording == recording_ || (recording && !canRecord())) return;
  if (recording) {
    recording_ = true;
    shown_s_ = -1;
    if (feel_.isRunning() && !feel_.isReplay()) {
      feel_.newPlacement();
      beginRecording();
    }
  } else {
    endRecording();
  }
  emit changed();
}

void FeelStore::recordAgain() {
  setRecording(false);
  setRecording(true);
}

MessageAct FeelStore::recordingAgain() {
  return {tr("Record again"), [this] { recordAgain(); }};
}

void FeelStore::onState() {
  if (!feel_.isRunning()) {
    if (recorder_) endRecording();
    replay_.reset();
    emit changed();
    playNext();
    return;
  }
  if (feel_.runs() != seen_run_) {
    seen_run_ = feel_.runs();
    run_started_ = study::momentNow();
    if (recording_ && !feel_.isReplay()) beginRecording();
  }
  emit changed();
}

void FeelStore::beginRecording() {
  recorded_visit_ = visit();
  recorder_.emplace(feel_.device()->rate_hz, conditions());
  first_orders_ = placement_orders_ = feel_.placementOrders();
  placement_ = 1;
  pieces_ = 0;
  ++recordings_;
  store(study::FeelStart{entry(), setting(), 1}, tr("The recording"), recorded_visit_, recordings_, recordingAgain(),
        [this] { study_.refresh(); });
}

void FeelStore::endRecording() {
  recording_ = false;
  if (!recorder_) return;
  storePiece();
  recorder_.reset();
  store(study::FeelEnd{entry(), 1, pieces_}, tr("The end of the recording"), recorded_visit_, recordings_,
        recordingAgain(), [this, study = study_.fileName()] {
          emit said(tr("Recorded into %1.").arg(study));
          study_.refresh();
        });
}

void FeelStore::onSampled(std::span<const haptics::Sample> samples) {
  const auto in_hand = [this](const haptics::Sample& sample) {
    return sample.orders >= feel_.placementOrders() && sample.phase != render::Phase::kReleased;
  };
  if (!felt_ && std::any_of(samples.begin(), samples.end(), in_hand)) felt_ = setting();
  if (!recorder_) return;
  std::vector<double> values;
  for (const auto& condition : conditions()) values.push_back(condition.value);
  recorder_->setConditions(values);
  for (const haptics::Sample& sample : samples) {
    if (sample.orders < first_orders_) continue;
    if (sample.orders >= feel_.placementOrders() && feel_.placementOrders() != placement_orders_) {
      placement_orders_ = feel_.placementOrders();
      ++placement_;
    }
    // A piece is stored only when its next sample is there, so that it can say whether samples were lost in between.
    if (recorder_->isGapBefore(sample)) {
      storePiece(true);
      emit failed(
          tr("Samples of the recording were lost, because this program came to a standstill. The recording says "
             "where."),
          recordingAgain());
    } else if (recorder_->pieceS() >= kPieceS) {
      storePiece();
    }
    recorder_->add(sample, sample.depth_mm + feel_.depthOffsetMm(), placement_);
  }
}

// A recording has a channel for each condition; a model of other inputs has others.
void FeelStore::onModel() {
  if (!recorder_ || recorder_->has(conditions())) return;
  setRecording(false);
  emit said(tr("The recording into %1 has ended, because the model has other inputs now.").arg(study_.fileName()));
}

void FeelStore::storePiece(bool gap_follows) {
  auto piece = recorder_->takePiece();
  if (!piece) return;
  ++pieces_;
  store(study::FeelPiece{entry(), 1, pieces_, std::move(*piece), gap_follows}, tr("A piece of the recording"),
        recorded_visit_, recordings_, recordingAgain(), {});
}

void FeelStore::onAdvanced() {
  if (recorder_ && static_cast<int>(recorder_->lengthS()) != shown_s_) {
    shown_s_ = static_cast<int>(recorder_->lengthS());
    emit changed();
  }
  if (!replay_ || !feel_.isReplay()) return;
  const double now_s = feel_.history().nowS();
  if (now_s > replay_->time_s.back() + kTailS) {
    feel_.stop();
    return;
  }
  const auto after = std::upper_bound(replay_->time_s.begin(), replay_->time_s.end(), now_s);
  if (after != replay_->time_s.begin()) showSample(static_cast<std::size_t>(after - replay_->time_s.begin()) - 1);
}

// Conditions and placements are those of the recording; the model is the present one.
void FeelStore::showSample(std::size_t sample) {
  const std::size_t before = std::exchange(replay_->sample, sample);
  for (std::size_t input = 0; input < scene_.model()->model.inputs.size(); ++input) {
    const fuzzy::Variable& variable = scene_.model()->model.inputs[input];
    if (isMovedByHand(variable)) continue;
    const auto* values = channelOf(replay_->recording, variable.id);
    if (values != nullptr && (*values)[sample] != (*values)[before]) scene_.setValue(input, (*values)[sample]);
  }
  const auto* placements = channelOf(replay_->recording, "placement");
  if (placements != nullptr && (*placements)[sample] != (*placements)[before]) feel_.newPlacement();
}

void FeelStore::onPlacementEnded() {
  const auto summary = feel_.lastPlacement();
  const auto felt = std::exchange(felt_, std::nullopt);
  // A replay is not a placement.
  if (!summary || !study_.takesOrders() || feel_.isReplay()) return;
  study::PlacementRecord record;
  record.entry = entry();
  record.setting = felt ? *felt : setting();
  record.duration_s = summary->duration_s;
  record.strokes = static_cast<int>(summary->strokes);
  record.peak_force_n = summary->peak_force_n;
  record.mean_force_n = summary->mean_force_n;
  record.depth_mm = summary->depth_mm;
  storePlacement(std::move(record), visit());
}

void FeelStore::storePlacement(study::PlacementRecord record, FeelSessions::Visit visit) {
  // Later it may be stored for another person, if the study does not know this one any more.
  const MessageAct again{tr("Try again"), [this, record, visit, path = study_.path()]() mutable {
                           if (!study_.takesOrders() || study_.path() != path) return;
                           visit.who = who_;
                           record.entry.entered_by = enteredBy();
                           storePlacement(record, visit);
                         }};
  store(std::move(record), tr("The placement"), visit, 0, again, [this, study = study_.fileName()] {
    emit said(tr("The placement is stored in %1.").arg(study));
    study_.refresh();
  });
}

// The movement so far is stored unchanged; what follows belongs to another person or model.
void FeelStore::endPlacement() {
  if (feel_.isRunning() && !feel_.isReplay()) feel_.newPlacement();
}

void FeelStore::onStudy() {
  sessions_ = std::make_shared<FeelSessions>();
  who_.reset();
  emit changed();
}

void FeelStore::replay(const study::RecordId& id) {
  if (!study_.isOpen() || !scene_.model()) return;
  if (recording_) setRecording(false);
  // Reading is enough: a study that may not be changed is replayed too.
  study_.read(*this, [this, id](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto read = std::make_shared<Result<study::Recording>>(store::feelRecording(file, id));
    return [this, id, read] {
      if (*read) {
        play(id, **read);
      } else {
        emit failed(tr("The recording was not replayed. %1").arg(text(read->error().message())),
                    {tr("Try again"), [this, id] { replay(id); }});
      }
    };
  });
}

void FeelStore::play(const std::optional<RecordId>& id, const study::Recording& recording) {
  haptics::ReplaySettings settings;
  settings.room_for_forces = 0;  // the servo's samples tell them
  auto device = haptics::ReplayDevice::make(recording, settings);
  const auto* times = channelOf(recording, "time");
  const auto* forces = channelOf(recording, "force");
  if (!device || times == nullptr || forces == nullptr || scene_.model() == nullptr) {
    emit notReplayable(
        tr("The recording was not replayed. %1")
            .arg(device ? tr("It has no channels 'time' and 'force'.") : text(device.error().message())));
    return;
  }
  Replay next{id, recording, *times, 0};
  for (double& time_s : next.time_s) time_s += settings.lead_s - times->front();
  // The conditions of the beginning, before there is a force.
  for (std::size_t input = 0; input < scene_.model()->model.inputs.size(); ++input) {
    const fuzzy::Variable& variable = scene_.model()->model.inputs[input];
    if (isMovedByHand(variable)) continue;
    if (const auto* values = channelOf(recording, variable.id)) scene_.setValue(input, values->front());
  }
  feel_.stop();
  next_ = Next{std::move(*device), {next.time_s, *forces}, std::move(next)};
  playNext();
}

// A device behind a driver takes its time to stop, and is waited for.
void FeelStore::playNext() {
  if (!next_ || feel_.state() != FeelController::State::kStopped) return;
  Next next = std::move(*next_);
  next_.reset();
  replay_ = std::move(next.replay);
  feel_.startReplay(std::move(next.device), std::move(next.beside));
  if (!feel_.isRunning()) replay_.reset();
  emit changed();
}

FeelSessions::Visit FeelStore::visit() const {
  const haptics::DeviceInfo info = *feel_.device();
  return {feel_.runs(), who_, run_started_, deviceText(info), info.id, info.simulated, info.friction_in_n};
}

study::FeltSetting FeelStore::setting() const {
  const haptics::DeviceInfo info = *feel_.device();
  study::FeltSetting out;
  out.device = deviceText(info);
  out.simulated = info.simulated;
  out.model = scene_.model()->model.name;
  if (const std::string& expert = scene_.model()->only_expert; !expert.empty()) out.model += ": " + expert + " alone";
  out.model_version = model_version_();
  for (const auto& condition : conditions()) out.conditions[condition.id] = condition.value;
  return out;
}

std::vector<FeelRecorder::Condition> FeelStore::conditions() const {
  std::vector<FeelRecorder::Condition> out;
  const auto& inputs = scene_.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isMovedByHand(inputs[i])) {
      out.push_back({inputs[i].id, inputs[i].unit, scene_.value(i)});
    }
  }
  return out;
}

study::Entry FeelStore::entry() {
  study::Entry out;
  out.id = ids_.next();
  out.when = study::momentNow();
  out.entered_by = enteredBy();
  return out;
}

study::EnteredBy FeelStore::enteredBy() const {
  return who_ ? study::EnteredBy::kParticipant : study::EnteredBy::kResearcher;
}

template <class Record>
void FeelStore::store(Record record, const QString& what, const FeelSessions::Visit& visit, std::uint64_t serial,
                      const MessageAct& act, std::function<void()> done) {
  const auto shared = std::make_shared<Record>(std::move(record));
  study_.order(
      [shared, visit, serial, sessions = sessions_](store::StudyFile& file, study::RecordIds& ids) -> Result<void> {
        TACTUS_TRY(const auto session, sessions->sessionOf(visit, file, ids));
        shared->entry.session = session;
        if constexpr (std::is_same_v<Record, study::FeelStart>) {
          shared->number = sessions->numberOf(serial, session);
        } else if constexpr (!std::is_same_v<Record, study::PlacementRecord>) {
          shared->recording = sessions->numberOf(serial, session);
        }
        return store::append(file, *shared);
      },
      std::move(done),
      [this, what, act, serial, study = study_.fileName()](const QString& sentence) {
        if (serial != 0 && std::exchange(refused_, serial) == serial) return;
        emit failed(FeelStore::tr("%1 was not stored in %2: %3").arg(what, study, sentence), act);
      });
}

}  // namespace tactus::workbench
