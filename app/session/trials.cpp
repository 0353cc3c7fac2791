#include "app/session/trials.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <iterator>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "app/session/session_state.h"
#include "app/session/setup_certificate.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/words.h"
#include "experiments/force_protocol.h"
#include "experiments/stroke.h"

namespace tactus::session {
namespace {

using base::Result;
using study::RecordId;

/// What a session says of all its trials.
struct OneSession {
  study::SessionRecord record;
  std::string code;
  bool simulated = false;
  int number = 1;
  bool setup_checked = false;
  std::map<std::int64_t, Circumstances> noted;  ///< by the place of the line in the session
};

class TrialReader {
 public:
  TrialReader(const store::StudyFile& file, const StudyView& view) : file_(file) {
    for (const auto* ids : {&view.stroke_ids, &view.judgement_ids, &view.answer_ids})
      counted_.insert(ids->begin(), ids->end());
    for (const auto& participant : view.study.participants) codes_.insert(participant.code);
  }

  Result<std::vector<Trial>> read() {
    using Step = Result<void> (TrialReader::*)();
    for (const Step step : {&TrialReader::readVisits, &TrialReader::readCircumstances, &TrialReader::addStrokes,
                            &TrialReader::addJudgements, &TrialReader::addAnswers}) {
      if (auto ok = (this->*step)(); !ok) return tl::unexpected(base::inFile(ok.error(), file_.path()));
    }
    std::stable_sort(found_.begin(), found_.end(), [](const Placed& a, const Placed& b) {
      return std::tie(a.trial.participant, a.trial.session, a.sequence) <
             std::tie(b.trial.participant, b.trial.session, b.sequence);
    });
    std::vector<Trial> out;
    for (Placed& one : found_) {
      const bool same = !out.empty() && out.back().session_id == one.trial.session_id;
      one.trial.order = same ? out.back().order + 1 : 1;
      out.push_back(std::move(one.trial));
    }
    return out;
  }

 private:
  struct Placed {
    Trial trial;
    std::int64_t sequence = 0;
  };

  Result<void> readVisits() {
    TACTUS_TRY(auto sequences, store::sequences(file_));
    sequences_ = std::move(sequences);
    TACTUS_TRY(const auto persons, store::persons(file_));
    for (const auto& person : persons) {
      if (!codes_.contains(person.code)) continue;
      TACTUS_TRY(const auto sessions, sessionsInOrder(file_, person.id));
      int number = 0;
      for (const auto& session : sessions) {
        visits_[session.id] = {session, person.code, person.simulated, ++number, false, {}};
      }
    }
    return {};
  }

  Result<void> readCircumstances() {
    TACTUS_TRY(const auto events, store::events(file_));
    for (const auto& event : events) {
      const auto visit = visits_.find(event.entry.session);
      if (visit == visits_.end()) continue;
      TACTUS_TRY(const auto noted, circumstancesIn(event));
      if (noted) visit->second.noted[sequences_[event.entry.id]] = *noted;
      TACTUS_TRY(const auto setup, setupIn(event));
      visit->second.setup_checked = visit->second.setup_checked || (setup && setup->isGood());
    }
    return {};
  }

  /// Nothing for a record of a session that is not read.
  Trial* add(const study::Entry& entry, Trial::Kind kind) {
    const auto found = visits_.find(entry.session);
    if (found == visits_.end()) return nullptr;
    const OneSession& visit = found->second;
    Trial trial;
    trial.kind = kind;
    trial.participant = visit.code;
    trial.simulated = visit.simulated;
    trial.session_id = entry.session;
    trial.session = visit.number;
    trial.utc_ms = entry.when.utc_ms;
    trial.time_s = static_cast<double>(entry.when.utc_ms - visit.record.started.utc_ms) / 1e3;
    trial.counts = counted_.contains(entry.id);
    trial.entered_by = store::wordFor(entry.entered_by);
    trial.protocol = visit.record.protocol ? study::toText(*visit.record.protocol) : std::string();
    trial.settings = visit.record.settings;
    trial.station = visit.record.station;
    trial.setup_checked = visit.setup_checked;
    const std::int64_t sequence = sequences_[entry.id];
    const auto after = visit.noted.upper_bound(sequence);
    if (after != visit.noted.begin()) {
      trial.under = std::prev(after)->second;
    } else {
      trial.under.language = visit.record.language;
      trial.under.text_percent = 0;
      trial.under.device = visit.record.device;
    }
    found_.push_back({std::move(trial), sequence});
    return &found_.back().trial;
  }

  Result<void> addStrokes() {
    TACTUS_TRY(const auto strokes, store::strokes(file_, {}, store::Recordings::kLeaveOut));
    for (auto stroke : strokes) {
      Trial* trial = add(stroke.entry, Trial::Kind::kStroke);
      if (trial == nullptr) continue;
      trial->block = stroke.level;
      trial->number = stroke.number;
      trial->attempt = stroke.attempt;
      trial->practice = stroke.practice;
      trial->status = stroke.verdict;
      if (stroke.verdict != name(experiments::StrokeVerdict::kAccepted)) continue;
      TACTUS_TRY(auto recording, store::recordingOf(file_, stroke.entry.id));
      stroke.recording = std::move(recording);
      // Imported recordings may hold what is no insertion: such a stroke has no speed.
      const auto samples = speedSamples(stroke, trial->participant);
      if (samples) describe(*samples, *trial);
    }
    return {};
  }

  static void describe(const std::vector<study::SpeedSample>& samples, Trial& trial) {
    trial.samples = samples.size();
    if (samples.empty()) return;
    double sum = 0;
    for (const auto& sample : samples) sum += sample.speed_mm_s;
    const double mean = sum / static_cast<double>(samples.size());
    trial.mean_speed_mm_s = mean;
    if (samples.size() < 2) return;
    double squares = 0;
    for (const auto& sample : samples) squares += (sample.speed_mm_s - mean) * (sample.speed_mm_s - mean);
    trial.sd_speed_mm_s = std::sqrt(squares / static_cast<double>(samples.size() - 1));
  }

  Result<void> addJudgements() {
    TACTUS_TRY(const auto judgements, store::judgements(file_));
    for (const auto& judgement : judgements) {
      Trial* trial = add(judgement.entry, Trial::Kind::kJudgement);
      if (trial == nullptr) continue;
      trial->block = judgement.series;
      trial->number = judgement.step;
      trial->attempt = judgement.attempt;
      trial->practice = judgement.series == experiments::kFamiliarisation;
      trial->catch_trial = judgement.catch_trial;
      trial->answer = judgement.term;
      trial->status = store::wordFor(judgement.kind);
      trial->response_s = judgement.response_s;
      trial->force_n = judgement.commanded_n;
      trial->felt_n = judgement.felt_n;
      trial->delivered_share = judgement.delivered_share;
      trial->feel_again = judgement.feel_again;
      trial->forward_mm = judgement.forward_mm;
    }
    return {};
  }

  Result<void> addAnswers() {
    TACTUS_TRY(const auto answers, store::answers(file_));
    for (const auto& answer : answers) {
      Trial* trial = add(answer.entry, Trial::Kind::kAnswer);
      if (trial == nullptr) continue;
      trial->block = answer.form;
      trial->number = answer.item;
      trial->wording = answer.wording;
      trial->position = answer.position;
      trial->answer = answer.value;
      trial->status = store::wordFor(answer.status);
      trial->response_s = answer.response_s;
    }
    return {};
  }

  const store::StudyFile& file_;
  std::set<RecordId> counted_;
  std::set<std::string> codes_;
  std::map<RecordId, std::int64_t> sequences_;
  std::map<RecordId, OneSession> visits_;
  std::vector<Placed> found_;
};

}  // namespace

std::string_view name(Trial::Kind kind) noexcept {
  switch (kind) {
    case Trial::Kind::kStroke: return "stroke";
    case Trial::Kind::kJudgement: return "judgement";
    case Trial::Kind::kAnswer: break;
  }
  return "answer";
}

Result<std::vector<Trial>> trials(const store::StudyFile& file, const StudyView& view) {
  return TrialReader(file, view).read();
}

Result<std::vector<Trial>> trialsAt(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return std::vector<Trial>{};
  TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  TACTUS_TRY(const auto view, studyForElicitation(file));
  return trials(file, view);
}

namespace {

/// A device of the list without what is one's own: `hid:VVVV:PPPP`, `openhaptics`, `haply`, `simulated-haply` or
/// `virtual`; empty for any other text.
std::string kindOf(const std::string& device) {
  constexpr std::size_t kHidKind = 13;  // hid:VVVV:PPPP
  if (device.starts_with("hid:")) return device.substr(0, kHidKind);
  const std::string kind = device.substr(0, device.find(':'));
  constexpr std::string_view kKinds[] = {"openhaptics", "haply", "simulated-haply", "virtual"};
  return std::find(std::begin(kKinds), std::end(kKinds), kind) != std::end(kKinds) ? kind : std::string();
}

}  // namespace

std::vector<Trial> shareable(std::vector<Trial> trials, const std::map<std::string, std::string>& codes) {
  std::erase_if(trials, [&](const Trial& trial) { return !codes.contains(trial.participant); });
  for (Trial& trial : trials) {
    trial.participant = codes.at(trial.participant);
    trial.session_id = {};
    trial.utc_ms = 0;
    trial.entered_by.clear();
    trial.protocol.clear();
    trial.station.clear();
    trial.under.device = kindOf(trial.under.device);
    trial.under.calibrated_utc.clear();
  }
  // P10 comes after P9.
  std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    return std::pair(a.participant.size(), a.participant) < std::pair(b.participant.size(), b.participant);
  });
  return trials;
}

namespace {

using Kind = store::ColumnKind;

std::string cell(const std::string& text) { return text; }
std::string cell(std::string_view text) { return std::string(text); }
std::string cell(bool value) { return value ? "1" : "0"; }
std::string cell(double value) { return base::formatNumber(value); }
template <std::integral Number>
std::string cell(Number value) {
  return std::to_string(value);
}
template <class Number>
std::string cell(const std::optional<Number>& value) {
  return value ? cell(*value) : std::string();
}

/// A column, what it holds of a trial, and whether it is in what is shared.
struct Column {
  store::RecordColumn says;
  bool shared = true;
  std::string (*cell)(const Trial&);
};

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      {{"participant", Kind::kText, "", "Code of the participant"},
       true,
       [](const Trial& t) { return cell(t.participant); }},
      {{"simulated", Kind::kFlag, "", "1 where a program made the data"},
       true,
       [](const Trial& t) { return cell(t.simulated); }},
      {{"session", Kind::kInteger, "", "Number of the participant's session, from 1"},
       true,
       [](const Trial& t) { return cell(t.session); }},
      {{"session_id", Kind::kId, "", "The session", "session"},
       false,
       [](const Trial& t) { return cell(study::toText(t.session_id)); }},
      {{"station", Kind::kText, "", "Name of the place of recording", "", true},
       false,
       [](const Trial& t) { return cell(t.station); }},
      {{"setup_checked", Kind::kFlag, "", "1 where the set-up was checked and good before the session"},
       true,
       [](const Trial& t) { return cell(t.setup_checked); }},
      {{"utc_ms", Kind::kInteger, "ms", "When it was stored, since 1970-01-01 UTC"},
       false,
       [](const Trial& t) { return cell(t.utc_ms); }},
      {{"time_s", Kind::kNumber, "s", "Since the session began; a session may go on on another day"},
       true,
       [](const Trial& t) { return cell(t.time_s); }},
      {{"order", Kind::kInteger, "", "Place among the trials of the session, from 1"},
       true,
       [](const Trial& t) { return cell(t.order); }},
      {{"kind", Kind::kText, "", "stroke, judgement or answer"},
       true,
       [](const Trial& t) { return cell(name(t.kind)); }},
      {{"block", Kind::kText, "", "The speed that was asked for, the series of forces, or the form"},
       true,
       [](const Trial& t) { return cell(t.block); }},
      {{"number", Kind::kInteger, "", "Of the stroke within its speed, the step within its series, or the item"},
       true,
       [](const Trial& t) { return cell(t.number); }},
      {{"attempt", Kind::kInteger, "", "From 1; another where a stroke or a step came again"},
       true,
       [](const Trial& t) { return cell(t.attempt); }},
      {{"practice", Kind::kFlag, "", "1 for practice"}, true, [](const Trial& t) { return cell(t.practice); }},
      {{"catch_trial", Kind::kFlag, "", "1 for a blank of 0 N or a hidden repeat"},
       true,
       [](const Trial& t) { return cell(t.catch_trial); }},
      {{"counts", Kind::kFlag, "", "1 where a model is built from it: accepted, scored, of the session that counts"},
       true,
       [](const Trial& t) { return cell(t.counts); }},
      {{"status", Kind::kText, "",
        "Verdict of a stroke; term, not_felt, beyond_practice or no_answer of a judgement; "
        "answered, skipped, cant_tell or cleared of an answer"},
       true,
       [](const Trial& t) { return cell(t.status); }},
      {{"answer", Kind::kText, "", "The word, or the point of a scale", "", true},
       true,
       [](const Trial& t) { return cell(t.answer); }},
      {{"response_s", Kind::kNumber, "s", "From the full force, or from the item on the screen, to the answer", "",
        true},
       true,
       [](const Trial& t) { return cell(t.response_s); }},
      {{"force_n", Kind::kNumber, "N", "Commanded force", "", true},
       true,
       [](const Trial& t) { return cell(t.force_n); }},
      {{"felt_n", Kind::kNumber, "N", "The same with the device's friction", "", true},
       true,
       [](const Trial& t) { return cell(t.felt_n); }},
      {{"delivered_share", Kind::kNumber, "", "Least share of the force in the hand, 0 to 1", "", true},
       true,
       [](const Trial& t) { return cell(t.delivered_share); }},
      {{"feel_again", Kind::kInteger, "", "How often it was felt again", "", true},
       true,
       [](const Trial& t) { return cell(t.feel_again); }},
      {{"forward_mm", Kind::kNumber, "mm", "Distance moved forward under the force", "", true},
       true,
       [](const Trial& t) { return cell(t.forward_mm); }},
      {{"samples", Kind::kInteger, "", "Of an accepted stroke's forward movement", "", true},
       true,
       [](const Trial& t) { return cell(t.samples); }},
      {{"mean_speed_mm_s", Kind::kNumber, "mm/s", "Mean over these samples", "", true},
       true,
       [](const Trial& t) { return cell(t.mean_speed_mm_s); }},
      {{"sd_speed_mm_s", Kind::kNumber, "mm/s", "Standard deviation over these samples (n - 1)", "", true},
       true,
       [](const Trial& t) { return cell(t.sd_speed_mm_s); }},
      {{"position", Kind::kInteger, "", "Of an answer: place in the order shown, from 1", "", true},
       true,
       [](const Trial& t) { return cell(t.position); }},
      {{"language", Kind::kText, "", "Of the screens at that moment"},
       true,
       [](const Trial& t) { return cell(t.under.language); }},
      {{"wording", Kind::kText, "", "Words in which the item was asked", "", true},
       true,
       [](const Trial& t) { return cell(t.wording); }},
      {{"text_percent", Kind::kInteger, "%", "Size of the text on the screens; empty: not noted", "", true},
       true,
       [](const Trial& t) {
         return cell(t.under.text_percent > 0 ? std::optional(t.under.text_percent) : std::nullopt);
       }},
      {{"device", Kind::kText, "", "Haptic device", "", true},
       true,
       [](const Trial& t) { return cell(t.under.device); }},
      {{"calibrated_utc", Kind::kText, "", "When the device was calibrated with Tactus; empty: never, or by its driver",
        "", true},
       false,
       [](const Trial& t) { return cell(t.under.calibrated_utc); }},
      {{"friction_in_n", Kind::kNumber, "N", "Dry friction of the device against insertion, if measured", "", true},
       true,
       [](const Trial& t) { return cell(t.under.friction_in_n); }},
      {{"entered_by", Kind::kText, "", "participant, researcher or program"},
       false,
       [](const Trial& t) { return cell(t.entered_by); }},
      {{"protocol_id", Kind::kId, "", "The study's protocol that the session follows", "protocol", true},
       false,
       [](const Trial& t) { return cell(t.protocol); }},
      {{"settings", Kind::kJson, "", "The settings of the session", "", true},
       true,
       [](const Trial& t) { return cell(t.settings); }},
  };
  return all;
}

}  // namespace

store::RecordTable trialsTable(bool shareable) {
  store::RecordTable table{kTrialsTable, kTrialsTable, "A stroke, a judgement or an answer", "", {}};
  for (const Column& column : columns()) {
    if (column.shared || !shareable) table.columns.push_back(column.says);
  }
  return table;
}

std::vector<std::vector<std::string>> trialRows(const std::vector<Trial>& trials, bool shareable) {
  std::vector<std::vector<std::string>> rows;
  for (const Trial& trial : trials) {
    auto& row = rows.emplace_back();
    for (const Column& column : columns()) {
      if (column.shared || !shareable) row.push_back(column.cell(trial));
    }
  }
  return rows;
}

std::string trialsText(const std::vector<Trial>& trials, bool shareable) {
  std::vector<std::string> names;
  for (const auto& column : trialsTable(shareable).columns) names.emplace_back(column.name);
  base::CsvWriter csv{std::span<const std::string>(names)};
  for (const auto& row : trialRows(trials, shareable)) {
    for (const std::string& text : row) csv.cell(std::string_view(text));
    csv.endRow();
  }
  return csv.text();
}

}  // namespace tactus::session
