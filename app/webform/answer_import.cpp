#include <algorithm>
#include <optional>
#include <utility>

#include "app/session/profile_questions.h"
#include "app/session/session_notes.h"
#include "app/session/session_settings.h"
#include "app/session/session_state.h"
#include "app/webform/answers.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_records.h"

namespace tactus::webform {
namespace {

using base::ErrorCode;
using base::Result;
using study::RecordId;

constexpr std::size_t kLongestFile = 4U << 20U;
/// The last line of the log of a session that an answer file gave.
constexpr const char* kAnswerFile = "answer_file";

/// The first half of the SHA-256 of `text`.
RecordId idOf(const std::string& text) {
  return study::parseRecordId(base::sha256(text).substr(0, 32)).value_or(RecordId{});
}

struct ReadFile {
  std::string path;
  std::string sha256;
  AnswerFile answers;
  const FormContent* form = nullptr;
};

/// One session made of a file.
class SessionOfFile {
 public:
  SessionOfFile(store::StudyFile& file, const ReadFile& read, RecordId id)
      : file_(file), read_(read), session_(std::move(id)) {}

  Result<void> begin(const RecordId& person, study::SessionKind kind) {
    TACTUS_TRY(const auto known, session::sessionsInOrder(file_, person));
    study::SessionRecord record;
    record.id = session_;
    record.person = person;
    record.kind = kind;
    record.started.utc_ms = read_.answers.consent_utc_ms;
    record.consent_version = read_.answers.consent_version;
    record.language = read_.answers.language;
    record.program = "web form";
    if (kind == study::SessionKind::kUsability) record.settings = toJson(session::usabilitySession());
    if (auto ok = store::append(file_, record); !ok) return ok;
    if (!known.empty()) {
      if (auto ok = log({session::kBegan, session::afterDetail(known.back().id)}, record.started.utc_ms); !ok)
        return ok;
    }
    return log(
        session::consentGiven(record.consent_version, read_.answers.consent_language, read_.answers.consent_text),
        record.started.utc_ms);
  }

  Result<void> addProfile() {
    study::ProfileRecord profile;
    std::optional<session::ExperienceBand> band;
    for (const auto& [field, value] : read_.answers.profile) {
      if (field == "years") band = session::experienceBandCalled(value);
      if (field == "handedness") profile.handedness = value;
      if (field == "gloves") profile.gloves = value;
      if (field == "haptic_experience") profile.haptic_experience = value;
    }
    if (band) profile.years_experience = band->middle_years;
    const std::int64_t at = read_.answers.consent_utc_ms;
    if (auto ok = append(profile, at); !ok) return ok;
    return band ? log(session::experienceBandChosen(*band), at) : Result<void>();
  }

  Result<void> addAnswers(const std::vector<FileAnswer>& answers, const questionnaires::Questionnaire& asked) {
    int position = 0;
    for (const FileAnswer& one : answers) {
      study::AnswerRecord record;
      record.form = asked.form;
      record.form_version = asked.version;
      record.item = one.item;
      record.position = ++position;
      record.status = one.status;
      record.value = one.term;
      record.response_s = one.response_s;
      record.wording = asked.wording;
      if (auto ok = append(record, one.utc_ms); !ok) return ok;
    }
    return {};
  }

  /// Where the session came from, and how often each answer was changed before it was saved.
  Result<void> addOrigin(const std::vector<FileAnswer>& answers) {
    base::JsonWriter json;
    json.beginObject(base::JsonWriter::Layout::kInline);
    json.key("sha256").value(read_.sha256).key("form_sha256").value(read_.answers.form_sha256);
    json.key("run").value(toText(read_.answers.run)).key("check_code").value(read_.answers.check_code);
    json.key("code_given").value(read_.answers.code_typed ? "typed" : "page").key("changes").beginObject();
    std::int64_t last_ms = read_.answers.consent_utc_ms;
    for (const FileAnswer& one : answers) {
      last_ms = std::max(last_ms, one.utc_ms);
      if (one.changes > 0) json.key(std::to_string(one.item)).value(one.changes);
    }
    std::string detail = json.endObject().endObject().text();
    detail.pop_back();  // the newline of a whole file
    return log({kAnswerFile, std::move(detail)}, last_ms);
  }

  std::size_t records() const { return records_; }

 private:
  study::Entry entry(std::int64_t utc_ms) {
    study::Entry out;
    out.id = idOf(toText(session_) + ' ' + std::to_string(next_++));
    out.session = session_;
    out.when.utc_ms = utc_ms;
    out.entered_by = study::EnteredBy::kParticipant;
    return out;
  }

  template <class Record>
  Result<void> append(Record record, std::int64_t utc_ms) {
    record.entry = entry(utc_ms);
    ++records_;
    return store::append(file_, record);
  }

  Result<void> log(const session::Note& note, std::int64_t utc_ms) {
    study::EventRecord event{entry(utc_ms), note.kind, note.detail};
    // The page and this program wrote the line, not the person.
    event.entry.entered_by = study::EnteredBy::kProgram;
    return store::append(file_, event);
  }

  store::StudyFile& file_;
  const ReadFile& read_;
  RecordId session_;
  std::size_t next_ = 0;
  std::size_t records_ = 0;
};

class Importer {
 public:
  explicit Importer(store::StudyFile& file) : file_(file) {}

  Result<void> look() {
    TACTUS_TRY(sessions_, store::sessions(file_));
    return {};
  }

  Result<void> add(const ReadFile& read) {
    ImportedAnswers out{read.path, read.answers.code, false, 0};
    const auto is_answered = [](const FileAnswer& one) { return one.status == study::Answer::Status::kAnswered; };
    out.answered =
        static_cast<std::size_t>(std::count_if(read.answers.answers.begin(), read.answers.answers.end(), is_answered));
    // What is in the file, not its bytes: a copied text and a saved file are the same answers.
    const std::string content = toText(read.answers.study) + ' ' + toText(read.answers.run) + ' ' +
                                read.answers.form_sha256 + ' ' + read.answers.check_code;
    const RecordId main = idOf("answers " + content);
    const auto is_main = [&](const study::SessionRecord& session) { return session.id == main; };
    if (std::any_of(sessions_.begin(), sessions_.end(), is_main)) {
      import.files.push_back(std::move(out));
      return {};
    }
    if (auto ok = addNew(read, main, content); !ok) return base::inFile(ok.error(), read.path);
    out.added = true;
    import.files.push_back(std::move(out));
    return {};
  }

  /// What the study remembers of the import; nothing where nothing was new.
  Result<void> remember(std::int64_t utc_ms) {
    if (import.sessions == 0) return {};
    base::JsonWriter json;
    json.beginObject(base::JsonWriter::Layout::kInline).key("persons").value(import.persons);
    json.key("sessions").value(import.sessions).key("records").value(import.records);
    std::string detail = json.endObject().text();
    detail.pop_back();
    // Files are called after the code of a participant, which a withdrawal must not leave here.
    const std::string source = std::to_string(added_) + (added_ == 1 ? " answer file" : " answer files");
    return store::append(
        file_, store::ImportLogEntry{idOf("import " + all_), utc_ms, "tables", source, detail, base::sha256(hashes_)});
  }

  AnswerImport import;

 private:
  Result<void> addNew(const ReadFile& read, const RecordId& main, const std::string& content) {
    TACTUS_TRY(const auto person, personOf(read));
    const AnswerFile& answers = read.answers;
    const FormLanguage& words = *read.form->language(answers.language);
    const bool is_scale = answers.form == words.scale.form;
    SessionOfFile first(file_, read, main);
    auto done = first.begin(person, is_scale ? study::SessionKind::kUsability : study::SessionKind::kImport)
                    .and_then([&] { return first.addProfile(); })
                    .and_then([&] { return first.addAnswers(answers.answers, words.asked); })
                    .and_then([&] { return first.addOrigin(answers.answers); });
    if (!done) return done;
    count(first, main);
    if (!answers.usability.empty()) {
      const RecordId second_id = idOf("usability " + content);
      SessionOfFile second(file_, read, second_id);
      done = second.begin(person, study::SessionKind::kUsability)
                 .and_then([&] { return second.addAnswers(answers.usability, words.scale); })
                 .and_then([&] { return second.addOrigin(answers.usability); });
      if (!done) return done;
      count(second, second_id);
    }
    ++added_;
    hashes_ += read.sha256 + '\n';
    if (answers.consent_version.empty())
      import.notes.push_back(answers.code + " agreed to no consent text: the form was made before the study had one.");
    return {};
  }

  void count(const SessionOfFile& session, const RecordId& id) {
    ++import.sessions;
    import.records += session.records();
    all_ += toText(id);
    study::SessionRecord record;
    record.id = id;
    sessions_.push_back(std::move(record));
  }

  /// Whether one of the person's sessions came from this run of the page.
  Result<bool> isOfRun(const RecordId& person, const RecordId& run) {
    TACTUS_TRY(const auto events, store::events(file_, {person, {}, true}));
    return std::any_of(events.begin(), events.end(), [&](const study::EventRecord& event) {
      return event.kind == kAnswerFile && event.detail.find(toText(run)) != std::string::npos;
    });
  }

  /// The participant with the code of the file, or a new one, whose id no other study gives.
  Result<RecordId> personOf(const ReadFile& read) {
    const AnswerFile& answers = read.answers;
    TACTUS_TRY(const auto typed, store::findTyped(file_, answers.code));
    if (typed.person) {
      if (typed.person->simulated)
        return base::fail(ErrorCode::kData, answers.code, "the code of a simulated participant",
                          "a code of this study's own");
      if (answers.code_typed) return typed.person->id;
      TACTUS_TRY(const auto same, isOfRun(typed.person->id, answers.run));
      if (same) return typed.person->id;
      return base::fail(
          ErrorCode::kData, answers.code, "a code that the page drew and another participant of the study has",
          "another code for that one: tactus study recode STUDY " + store::shellWord(typed.person->code) + " NEW");
    }
    const std::string id = "person " + toText(answers.study) + ' ' +
                           (answers.code_typed ? study::codeKey(answers.code) : toText(answers.run));
    const study::Person person{idOf(id), answers.code, false};
    // The same person under a code that the researcher changed since.
    TACTUS_TRY(const auto all, store::persons(file_));
    for (const auto& one : all) {
      if (one.id == person.id) return one.id;
    }
    if (auto ok = store::append(file_, person); !ok) return tl::unexpected(ok.error());
    ++import.persons;
    return person.id;
  }

  store::StudyFile& file_;
  std::vector<study::SessionRecord> sessions_;
  std::size_t added_ = 0;  ///< files
  std::string all_;        ///< ids of the new sessions
  std::string hashes_;
};

}  // namespace

Result<AnswerImport> importAnswers(store::StudyFile& file, const std::vector<std::string>& paths, std::int64_t utc_ms) {
  TACTUS_TRY(const auto forms, formsOf(file));
  // Everything that can be wrong with the files is found before the first record is written.
  std::vector<ReadFile> all;
  for (const std::string& path : paths) {
    TACTUS_TRY(const auto text, base::readFile(path, kLongestFile));
    ReadFile read{path, base::sha256(text), {}, nullptr};
    TACTUS_TRY(read.answers, parseAnswerFile(text, path));
    TACTUS_TRY(read.form, formAnswered(read.answers, forms, path));
    all.push_back(std::move(read));
  }
  TACTUS_TRY(auto batch, store::Batch::begin(file));
  Importer importer(file);
  if (auto ok = importer.look(); !ok) return tl::unexpected(ok.error());
  for (const ReadFile& read : all) {
    if (auto ok = importer.add(read); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = importer.remember(utc_ms); !ok) return tl::unexpected(ok.error());
  if (auto ok = batch.commit(); !ok) return tl::unexpected(ok.error());
  return std::move(importer.import);
}

}  // namespace tactus::webform
