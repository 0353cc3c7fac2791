#include "app/session/study_source.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "app/session/study_view.h"
#include "app/session/table_words.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/model_io/model_file.h"
#include "core/store/duel_records.h"
#include "core/store/entries.h"
#include "core/store/sealed_references.h"
#include "core/store/sessions.h"
#include "core/store/study_file.h"
#include "core/store/study_records.h"
#include "experiments/stroke_speeds.h"
#include "questionnaires/form_file.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

base::Result<StudyAside> asideOf(const store::StudyFile& file) {
  StudyAside out;
  TACTUS_TRY(const auto measured, store::depthMeasurement(file));
  if (measured) {
    TACTUS_TRY(auto depths, elicitation::readMeasurement((measured)->text));
    out.measured_depths = std::move(depths);
  }
  TACTUS_TRY(const auto answers, store::answers(file));
  auto rows = questionnaires::summarize(questionnaires::usabilityForm(), answers);
  if (std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.n > 0; })) out.usability = std::move(rows);
  TACTUS_TRY(const auto sessions, store::sessionList(file));
  const std::string form = questionnaires::usabilityForm().id;
  out.usability_simulated = std::any_of(answers.begin(), answers.end(), [&](const study::AnswerRecord& answer) {
    return answer.form == form && std::any_of(sessions.begin(), sessions.end(), [&](const auto& one) {
             return one.simulated && one.session.id == answer.entry.session;
           });
  });
  return out;
}

base::Result<std::vector<experiments::StopAnswer>> stopAnswers(const store::StudyFile& file, const StudyView& view) {
  std::vector<experiments::StopAnswer> out;
  if (!procedure::of(view.study).stop_question) return out;
  TACTUS_TRY(const auto events, store::events(file));
  std::map<study::RecordId, bool> said;
  for (const auto& event : events) {
    TACTUS_TRY(const auto line, wouldStopIn(event));
    if (line) said[line->judgement] = line->would_stop;
  }
  for (std::size_t i = 0; i < view.judgement_ids.size(); ++i) {
    const auto found = said.find(view.judgement_ids[i]);
    if (found == said.end()) continue;
    const auto& judgement = view.study.judgements[i];
    out.push_back({judgement.participant, judgement.series, judgement.step, judgement.force_n, found->second});
  }
  return out;
}

base::Result<std::vector<experiments::DoneInOrder>> doneInOrder(const store::StudyFile& file, const StudyView& view) {
  std::vector<experiments::DoneInOrder> out;
  std::map<std::string, std::size_t> places;
  for (const auto& participant : view.study.participants) {
    places.try_emplace(participant.code, out.size());
    out.push_back({participant.code, participant.simulated, {}, {}, {}});
  }
  for (const auto& summary : experiments::summarizeSpeeds(view.study.speeds)) {
    const auto place = places.find(summary.participant);
    if (place != places.end()) out[place->second].speeds.emplace_back(summary.level, summary.mean_mm_s);
  }

  // Catch trials are not in the view: they belong to the sessions whose judgements are.
  TACTUS_TRY(const auto judgements, store::judgements(file));
  std::map<study::RecordId, std::size_t> counted;
  for (std::size_t i = 0; i < view.judgement_ids.size(); ++i) {
    const auto place = places.find(view.study.judgements[i].participant);
    if (place != places.end()) counted.emplace(view.judgement_ids[i], place->second);
  }
  std::map<study::RecordId, std::size_t> of_session;
  for (const auto& judgement : judgements) {
    const auto found = counted.find(judgement.entry.id);
    if (found != counted.end()) of_session.emplace(judgement.entry.session, found->second);
  }
  for (const auto& judgement : judgements) {
    const auto found = of_session.find(judgement.entry.session);
    if (found != of_session.end()) out[found->second].judgements.push_back(judgement);
  }

  TACTUS_TRY(auto stops, stopAnswers(file, view));
  for (auto& stop : stops) {
    const auto place = places.find(stop.participant);
    if (place != places.end()) out[place->second].stops.push_back(std::move(stop));
  }

  TACTUS_TRY(const auto answers, store::answers(file));
  std::map<study::RecordId, const study::AnswerRecord*> by_id;
  for (const auto& answer : answers) by_id.emplace(answer.entry.id, &answer);
  const auto& terms = procedure::of(view.study).output.terms;
  for (std::size_t i = 0; i < view.answer_ids.size(); ++i) {
    const auto place = places.find(view.study.answers[i].participant);
    const auto record = by_id.find(view.answer_ids[i]);
    if (place == places.end() || record == by_id.end() || record->second->position < 1) continue;
    const auto term =
        std::find_if(terms.begin(), terms.end(), [&](const auto& one) { return one.id == record->second->value; });
    if (term == terms.end()) continue;
    out[place->second].answers.push_back(
        {record->second->item, record->second->position, static_cast<std::size_t>(term - terms.begin())});
  }
  return out;
}

base::Result<std::vector<experiments::JudgedDuel>> judgedDuels(const store::StudyFile& file) {
  TACTUS_TRY(auto duels, store::duels(file));
  std::vector<experiments::JudgedDuel> out;
  for (auto& duel : duels) {
    const auto verdict = experiments::verdictOf(duel.start, duel.answers);
    out.push_back({std::move(duel.code), std::move(duel.start), verdict});
  }
  return out;
}

namespace {

std::string utcOf(std::int64_t utc_ms) {
  return base::formatUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(utc_ms)));
}

}  // namespace

base::Result<std::vector<elicitation::SealedCurve>> sealedCurves(const store::StudyFile& file) {
  TACTUS_TRY(auto trials, store::sealedTrials(file));
  TACTUS_TRY(const auto procedure, procedureIn(file));
  std::vector<elicitation::SealedCurve> out;
  for (auto& trial : trials) {
    auto& reference = trial.reference;
    elicitation::SealedCurve one{.sealed_utc = utcOf(reference.entry.when.utc_ms),
                                 .sha256 = std::move(reference.sha256),
                                 .note = std::move(reference.note),
                                 .conditions = std::move(reference.conditions),
                                 .late = reference.late,
                                 .records_after = trial.records_after};
    for (const auto& opening : trial.openings)
      one.openings.push_back({utcOf(opening.entry.when.utc_ms), opening.early});
    for (const auto& version : trial.changed_after) {
      one.changes.push_back({utcOf(version.utc_ms), version.author, version.label});
    }
    if (!trial.openings.empty()) {
      TACTUS_TRY(one.points, elicitation::readReferenceCurve(trial.openings.front().content, file.path(),
                                                             procedure::orDefault(procedure)));
    }
    if (trial.signed_off) {
      TACTUS_TRY(auto read, model_io::parseModel(trial.signed_off->text, file.path()));
      one.signed_model = std::move(read.model);
    }
    out.push_back(std::move(one));
  }
  return out;
}

base::Result<StudyEvidence> readEvidence(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return StudyEvidence{};
  TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  TACTUS_TRY(auto duels, judgedDuels(file));
  TACTUS_TRY(auto sealed, sealedCurves(file));
  return StudyEvidence{std::move(duels), std::move(sealed)};
}

std::vector<study::Form> knownForms(const procedure::Procedure& procedure) {
  std::vector<study::Form> forms = procedure.forms;
  if (procedure.id != procedure::defaultProcedure()->id) return forms;
  for (const auto& reading : questionnaires::s4Readings()) {
    study::Form form;
    form.id = reading.id;
    form.title = reading.title;
    form.depth_terms = reading.depth_terms;
    forms.push_back(std::move(form));
  }
  return forms;
}

base::Result<ProcedurePtr> procedureOfTable(const std::string& table, const std::string& named) {
  if (!named.empty()) return readPack(named);
  const auto beside = std::filesystem::path(table).parent_path() / kPackFolder;
  std::error_code ignored;
  if (std::filesystem::is_directory(beside, ignored)) return readPack(beside.string());
  return procedure::defaultProcedure();
}

base::Result<study::StudyTables> readTables(const std::string& folder, ProcedurePtr procedure) {
  const auto pack = std::filesystem::path(folder) / kPackFolder;
  std::error_code ignored;
  if (procedure == nullptr && std::filesystem::is_directory(pack, ignored)) {
    TACTUS_TRY(procedure, readPack(pack.string()));
  }
  auto tables = study::readStudyFolder(folder, procedure::orDefault(procedure).inputIds());
  if (!tables) return tables;
  tables->study.procedure = std::move(procedure);
  auto notes = readWords(tables->study);
  tables->notes.insert(tables->notes.end(), notes.begin(), notes.end());
  return tables;
}

base::Result<void> writeTables(const study::Study& study, const std::string& folder) {
  if (auto ok = study::writeStudyFolder(study, procedure::of(study).inputIds(), folder); !ok) return ok;
  return writePack(study, folder);
}

base::Result<void> writePack(const study::Study& study, const std::string& folder) {
  const procedure::Procedure& about = procedure::of(study);
  if (&about == procedure::defaultProcedure().get()) return {};
  for (const auto& [name, bytes] : about.files) {
    const auto path = std::filesystem::path(folder) / kPackFolder / name;
    if (auto ok = base::makeFolder(path.parent_path().string()); !ok) return ok;
    if (auto ok = base::writeFileAtomically(path.string(), bytes); !ok) return ok;
  }
  return {};
}

namespace {

/// Opens the study file at `path`; nothing: it is a folder.
base::Result<std::optional<store::StudyFile>> openFile(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return std::nullopt;
  if (!std::filesystem::is_regular_file(status)) {
    const bool is_there = std::filesystem::exists(status);
    return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                      path,
                                      {},
                                      is_there ? "a device or a pipe" : "nothing of this name",
                                      "a study file, or a folder with participants.csv"});
  }
  TACTUS_TRY(auto file, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  return std::optional<store::StudyFile>(std::move(file));
}

study::StudyTables tablesOf(const store::StudyFile& file, StudyView view) {
  study::StudyTables tables{std::move(view.study), std::move(view.notes)};
  for (const auto& notice : file.notices()) tables.notices.push_back(notice.sentence);
  return tables;
}

}  // namespace

base::Result<study::StudyTables> readStudy(const std::string& path) {
  TACTUS_TRY(const auto file, openFile(path));
  if (!file) return readTables(path);
  TACTUS_TRY(auto view, studyForElicitation(*file));
  return tablesOf(*file, std::move(view));
}

base::Result<WholeStudy> readWholeStudy(const std::string& path) {
  TACTUS_TRY(const auto file, openFile(path));
  if (!file) {
    TACTUS_TRY(auto tables, readTables(path));
    return WholeStudy{std::move(tables), StudyAside{}, std::vector<experiments::DoneInOrder>{}};
  }
  TACTUS_TRY(auto view, studyForElicitation(*file));
  auto in_order = doneInOrder(*file, view);
  return WholeStudy{tablesOf(*file, std::move(view)), asideOf(*file), std::move(in_order)};
}

}  // namespace tactus::session
