#include "app/session/study_import.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/session/session_state.h"
#include "app/session/study_procedure.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/store/batch.h"
#include "core/store/copies.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"
#include "core/study/csv_tables.h"
#include "experiments/stroke.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using study::RecordId;

/// The first half of the SHA-256 of `text`.
RecordId idOf(std::string_view text) {
  const auto id = study::parseRecordId(base::sha256(text).substr(0, 32));
  return id.value_or(RecordId{});
}

/// Everything of one participant, record by record, without ids.
struct Rows {
  std::vector<study::ProfileRecord> profiles;
  std::vector<study::StrokeRecord> strokes;
  std::vector<study::JudgementRecord> judgements;
  std::vector<study::AnswerRecord> answers;
  std::vector<study::RuleRecord> rules;
  std::string text;  ///< all values, so that equal rows give an equal id

  std::string digest() const { return base::sha256(text); }
};

/// Collects values into a text that differs where any value does; a long one is folded into its hash.
class Digest {
 public:
  static constexpr std::size_t kLongest = 1 << 20;

  explicit Digest(std::string& text) : text_(text) {}
  Digest& operator<<(std::string_view value) {
    text_ += std::to_string(value.size()) + ':';
    text_ += value;
    if (text_.size() > kLongest) text_ = base::sha256(text_);
    return *this;
  }
  Digest& operator<<(double value) { return *this << base::formatNumber(value); }
  Digest& operator<<(int value) { return *this << std::to_string(value); }
  Digest& operator<<(const std::optional<double>& value) {
    return *this << (value ? base::formatNumber(*value) : std::string());
  }

 private:
  std::string& text_;
};

void addProfile(const study::Participant& participant, Rows& rows) {
  study::ProfileRecord profile;
  profile.years_experience = participant.years_experience;
  profile.category = participant.category;
  profile.handedness = participant.handedness;
  profile.weight = participant.weight;
  Digest(rows.text) << "profile" << profile.years_experience << profile.category << profile.handedness
                    << profile.weight;
  rows.profiles.push_back(std::move(profile));
}

void addSample(const study::SpeedSample& sample, Rows& rows) {
  const auto same = [&](const study::StrokeRecord& stroke) {
    return stroke.level == sample.level && stroke.number == sample.stroke;
  };
  // The samples of a stroke mostly stand together, so the search ends at once.
  auto stroke = std::find_if(rows.strokes.rbegin(), rows.strokes.rend(), same);
  if (stroke == rows.strokes.rend()) {
    study::StrokeRecord fresh;
    fresh.level = sample.level;
    fresh.number = sample.stroke;
    fresh.verdict = name(experiments::StrokeVerdict::kAccepted);
    fresh.recording.channels = {{"time", "s", {}}, {"depth", "mm", {}}, {"speed", "mm/s", {}}};
    rows.strokes.push_back(std::move(fresh));
    stroke = rows.strokes.rbegin();
  }
  auto& channels = stroke->recording.channels;
  channels[0].values.push_back(sample.time_s);
  channels[1].values.push_back(sample.depth_mm);
  channels[2].values.push_back(sample.speed_mm_s);
  stroke->last = stroke->recording.size();
  Digest(rows.text) << "speed" << sample.level << sample.stroke << sample.time_s << sample.depth_mm
                    << sample.speed_mm_s;
}

/// The rate that fits the time stamps; 1 Hz for a single sample.
void setRate(study::StrokeRecord& stroke) {
  const auto& times = stroke.recording.channels[0].values;
  const double length_s = times.back() - times.front();
  stroke.recording.sample_rate_hz = length_s > 0 ? static_cast<double>(times.size() - 1) / length_s : 1;
}

void addJudgement(const study::ForceJudgement& judgement, Rows& rows) {
  study::JudgementRecord record;
  record.series = judgement.series;
  record.step = judgement.step;
  record.commanded_n = judgement.force_n;
  record.kind = judgement.kind;
  record.term = judgement.term;
  Digest(rows.text) << "judgement" << record.series << record.step << record.commanded_n
                    << static_cast<int>(record.kind) << record.term;
  rows.judgements.push_back(std::move(record));
}

void addAnswer(const study::Answer& answer, Rows& rows) {
  study::AnswerRecord record;
  record.form = answer.form;
  record.item = answer.item;
  record.status = answer.status;
  record.value = answer.term;
  record.wording = answer.wording;
  Digest(rows.text) << "answer" << record.form << record.item << static_cast<int>(record.status) << record.value;
  rows.answers.push_back(std::move(record));
}

void addRule(const study::GivenRule& rule, Rows& rows) {
  study::RuleRecord record;
  record.rule = rule;
  record.rule.participant.clear();
  record.rule.line = {};
  Digest digest(rows.text);
  digest << "rule" << rule.form << rule.then << rule.weight;
  for (const auto& condition : rule.conditions) digest << condition.input << condition.term;
  rows.rules.push_back(std::move(record));
}

/// The rows of each participant, in the participants' order; rows without one of them are left out.
std::vector<Rows> rowsOfAll(const study::Study& study) {
  std::vector<Rows> all(study.participants.size());
  std::map<std::string_view, Rows*> by_code;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& participant = study.participants[i];
    by_code[participant.code] = &all[i];
    Digest(all[i].text) << "participant" << participant.code;
    addProfile(participant, all[i]);
  }
  const auto each = [&](const auto& records, auto add) {
    for (const auto& record : records) {
      if (const auto rows = by_code.find(record.participant); rows != by_code.end()) add(record, *rows->second);
    }
  };
  each(study.speeds, addSample);
  each(study.judgements, addJudgement);
  each(study.answers, addAnswer);
  each(study.rules, addRule);
  for (auto& rows : all) {
    for (auto& stroke : rows.strokes) setRate(stroke);
  }
  return all;
}

class Importer {
 public:
  Importer(store::StudyFile& file, const ImportSource& source) : file_(file), source_(source) {}

  /// Looks what was imported before; once, before the first `add`.
  Result<void> look() {
    TACTUS_TRY(const auto persons, store::persons(file_));
    for (const auto& person : persons) {
      TACTUS_TRY(const auto known, sessionsInOrder(file_, person.id));
      const auto latest = std::find_if(known.rbegin(), known.rend(), [](const study::SessionRecord& session) {
        return session.kind == study::SessionKind::kImport;
      });
      if (latest != known.rend()) latest_imports_.push_back(*latest);
    }
    return {};
  }

  Result<void> add(const study::Participant& participant, Rows rows) {
    if (isThere(rows)) {
      import.notes.push_back(participant.code + "'s rows are in the study already.");
      return {};
    }
    TACTUS_TRY(const auto person, personOf(participant, rows.digest()));
    TACTUS_TRY(const auto known, sessionsInOrder(file_, person));
    study::SessionRecord session;
    session.person = person;
    session.kind = study::SessionKind::kImport;
    session.program = "import";
    session.started.utc_ms = source_.utc_ms;
    const std::string digest = rows.digest();
    session.id = idAt(person, digest, session.started.utc_ms);
    // Where the clock stood still, the same rows may have come at this time before.
    while (std::any_of(known.begin(), known.end(), [&](const auto& other) { return other.id == session.id; })) {
      session.id = idAt(person, digest, ++session.started.utc_ms);
    }
    if (auto ok = store::append(file_, session); !ok) return ok;
    ++import.sessions;
    session_ = session.id;
    all_sessions_ += toText(session.id);
    next_ = 0;
    if (!known.empty()) {
      study::EventRecord began{entry(" began"), kBegan, afterDetail(known.back().id)};
      if (auto ok = store::append(file_, began); !ok) return ok;
    }
    return appendAll(rows.profiles)
        .and_then([&] { return appendAll(rows.strokes); })
        .and_then([&] { return appendAll(rows.judgements); })
        .and_then([&] { return appendAll(rows.answers); })
        .and_then([&] { return appendAll(rows.rules); });
  }

  /// What the study remembers of the import; nothing where nothing was new.
  Result<void> remember() {
    if (import.sessions == 0) return {};
    nlohmann::json counts{{"persons", import.persons}, {"sessions", import.sessions}, {"records", import.records}};
    return store::append(file_, store::ImportLogEntry{idOf("import " + all_sessions_), source_.utc_ms, "tables",
                                                      source_.name, counts.dump(), source_.sha256});
  }

  StudyImport import;

 private:
  static RecordId idAt(const RecordId& person, const std::string& digest, std::int64_t utc_ms) {
    return idOf("session " + toText(person) + ' ' + digest + " at " + std::to_string(utc_ms));
  }

  /// Whether the rows are those of a participant's latest import. The code may have changed since.
  bool isThere(const Rows& rows) const {
    const std::string digest = rows.digest();
    return std::any_of(latest_imports_.begin(), latest_imports_.end(), [&](const study::SessionRecord& session) {
      return session.id == idAt(session.person, digest, session.started.utc_ms);
    });
  }

  study::Entry entry(const std::string& what) const {
    study::Entry entry;
    entry.id = idOf(toText(session_) + what);
    entry.session = session_;
    entry.when.utc_ms = source_.utc_ms;
    entry.entered_by = study::EnteredBy::kProgram;
    return entry;
  }

  /// The person in this file with the participant's code, or a new one, whose id no other study gives.
  Result<RecordId> personOf(const study::Participant& participant, const std::string& digest) {
    TACTUS_TRY(const auto known, store::findPerson(file_, participant.code));
    if (known) {
      if ((known)->simulated == participant.simulated) return (known)->id;
      return fail(ErrorCode::kData, participant.code,
                  participant.simulated ? "simulated rows for a real participant" : "real rows for a simulated one",
                  "another code");
    }
    const auto study = store::studyInfo(file_);
    if (!study) return tl::unexpected(study.error());
    const std::string text = "person " + toText(study->id) + ' ' + digest;
    const study::Person person{idOf(text), participant.code, participant.simulated};
    if (auto ok = store::append(file_, person); !ok) return tl::unexpected(ok.error());
    ++import.persons;
    return person.id;
  }

  template <class Record>
  Result<void> appendAll(std::vector<Record>& records) {
    for (auto& record : records) {
      record.entry = entry(' ' + std::to_string(next_++));
      if (auto ok = store::append(file_, record); !ok) return ok;
      ++import.records;
    }
    return {};
  }

  store::StudyFile& file_;
  const ImportSource& source_;
  std::vector<study::SessionRecord> latest_imports_;  ///< of each person who has any
  std::string all_sessions_;                          ///< ids of the new ones
  RecordId session_;
  std::size_t next_ = 0;
};

}  // namespace

Result<StudyImport> importTables(const study::Study& study, store::StudyFile& file, const ImportSource& source) {
  TACTUS_TRY(auto batch, store::Batch::begin(file));
  Importer importer(file, source);
  if (auto ok = importer.look(); !ok) return tl::unexpected(ok.error());
  auto rows = rowsOfAll(study);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (auto ok = importer.add(study.participants[i], std::move(rows[i])); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = importer.remember(); !ok) return tl::unexpected(ok.error());
  if (auto ok = batch.commit(); !ok) return tl::unexpected(ok.error());
  return std::move(importer.import);
}

Result<ImportSource> tablesSource(const std::string& folder, const std::string& name, std::int64_t utc_ms) {
  std::vector<std::string> names;
  for (const auto table : {study::kParticipantsTable, study::kSpeedsTable, study::kJudgementsTable,
                           study::kAnswersTable, study::kRulesTable}) {
    names.emplace_back(table);
    names.push_back(study::publishedTable(table));  // only one of the two is there
  }
  TACTUS_TRY(auto hash, base::listingSha256(folder, names));
  return ImportSource{name, std::move(hash), utc_ms};
}

Result<StudyImport> importAsNewStudy(const study::Study& study, const std::string& path, const ImportSource& source,
                                     const std::string& program) {
  const auto said_of_path = [&path](base::Error error) {
    error.file = path;
    return tl::unexpected(std::move(error));
  };
  TACTUS_TRY(auto work, store::WorkFolder::beside(path));
  auto file =
      store::StudyFile::create(work.file("study"), {study::RecordIds().next(), study.name, source.utc_ms, program});
  if (!file) return said_of_path(file.error());
  if (study.procedure != nullptr && study.procedure != procedure::defaultProcedure()) {
    SessionTools tools = systemTools();
    if (auto kept = keepProcedure(*file, study.procedure, tools); !kept) return said_of_path(kept.error());
  }
  auto imported = importTables(study, *file, source);
  if (!imported) return said_of_path(imported.error());
  if (auto placed = store::backUp(*file, path); !placed) return tl::unexpected(placed.error());
  return imported;
}

}  // namespace tactus::session
