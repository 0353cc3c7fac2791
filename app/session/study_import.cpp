#include "app/session/study_import.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "core/base/sha256.h"
#include "core/base/text.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
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

/// The rows of each participant, in the participants' order; rows of nobody among them are left out.
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
  explicit Importer(store::StudyFile& file) : file_(file) {}

  Result<void> add(const study::Participant& participant, Rows rows) {
    rows.text = base::sha256(rows.text);
    const auto there = isThere(rows.text);
    if (!there) return tl::unexpected(there.error());
    if (*there) {
      import.notes.push_back(participant.code + "'s rows are in the study already.");
      return {};
    }
    const auto person = personOf(participant, rows.text);
    if (!person) return tl::unexpected(person.error());
    study::SessionRecord session;
    session.id = sessionOf(*person, rows.text);
    session.person = *person;
    session.kind = study::SessionKind::kImport;
    session.program = "import";
    const auto known = store::sessions(file_, *person);
    if (!known) return tl::unexpected(known.error());
    session.started.utc_ms = 1 + std::count_if(known->begin(), known->end(), [](const study::SessionRecord& other) {
                               return other.kind == study::SessionKind::kImport;
                             });
    if (auto ok = store::append(file_, session); !ok) return ok;
    ++import.sessions;
    session_ = session.id;
    next_ = 0;
    return appendAll(rows.profiles)
        .and_then([&] { return appendAll(rows.strokes); })
        .and_then([&] { return appendAll(rows.judgements); })
        .and_then([&] { return appendAll(rows.answers); })
        .and_then([&] { return appendAll(rows.rules); });
  }

  StudyImport import;

 private:
  /// Of the same rows for another person, as two sites may have them, it is another session.
  static RecordId sessionOf(const RecordId& person, const std::string& rows) {
    return idOf("session " + toText(person) + ' ' + rows);
  }

  /// Whether somebody has these rows already, perhaps under another code by now.
  Result<bool> isThere(const std::string& rows) {
    const auto persons = store::persons(file_);
    if (!persons) return tl::unexpected(persons.error());
    for (const auto& person : *persons) {
      const auto known = store::sessions(file_, person.id);
      if (!known) return tl::unexpected(known.error());
      const RecordId wanted = sessionOf(person.id, rows);
      if (std::any_of(known->begin(), known->end(), [&](const auto& one) { return one.id == wanted; })) return true;
    }
    return false;
  }

  /// The person in this file with the participant's code, or a new one, whose id no other study gives.
  Result<RecordId> personOf(const study::Participant& participant, const std::string& rows) {
    const auto known = store::findPerson(file_, participant.code);
    if (!known) return tl::unexpected(known.error());
    if (*known) {
      if ((*known)->simulated == participant.simulated) return (*known)->id;
      return fail(ErrorCode::kData, participant.code,
                  participant.simulated ? "simulated rows for a real participant" : "real rows for a simulated one",
                  "another code");
    }
    const auto study = store::studyInfo(file_);
    if (!study) return tl::unexpected(study.error());
    const std::string text = "person " + toText(study->id) + ' ' + rows;
    const study::Person person{idOf(text), participant.code, participant.simulated};
    if (auto ok = store::append(file_, person); !ok) return tl::unexpected(ok.error());
    ++import.persons;
    return person.id;
  }

  template <class Record>
  Result<void> appendAll(std::vector<Record>& records) {
    for (auto& record : records) {
      record.entry.id = idOf(toText(session_) + ' ' + std::to_string(next_++));
      record.entry.session = session_;
      record.entry.entered_by = study::EnteredBy::kProgram;
      if (auto ok = store::append(file_, record); !ok) return ok;
      ++import.records;
    }
    return {};
  }

  store::StudyFile& file_;
  RecordId session_;
  std::size_t next_ = 0;
};

}  // namespace

Result<StudyImport> importTables(const study::Study& study, store::StudyFile& file) {
  auto batch = store::Batch::begin(file);
  if (!batch) return tl::unexpected(batch.error());
  Importer importer(file);
  auto rows = rowsOfAll(study);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (auto ok = importer.add(study.participants[i], std::move(rows[i])); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = batch->commit(); !ok) return tl::unexpected(ok.error());
  return std::move(importer.import);
}

}  // namespace tactus::session
