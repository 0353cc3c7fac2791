#include "app/workbench/study/connection/study_contents.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sealed_references.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

namespace tactus::workbench {
namespace {

std::optional<questionnaires::Reply> replyOf(const study::AnswerRecord* answer) {
  if (answer == nullptr) return std::nullopt;
  return questionnaires::Reply{answer->status, answer->value};
}

void addForm(const questionnaires::QuestionnaireRun& run, const SessionSnapshot* before, SessionSnapshot& out) {
  out.form = before != nullptr ? before->form : std::make_shared<const questionnaires::Questionnaire>(run.form());
  if (const auto page = run.page()) {
    out.page = ItemPage{page->question->number, page->position, page->count, replyOf(page->last_answer)};
    if (page->reason) out.page->unknown_n = page->reason->unknown_n;
  }
  for (const questionnaires::Question& question : out.form->questions) {
    const auto history = run.history(question.number);
    out.replies.push_back({question.number, replyOf(history.empty() ? nullptr : &history.back())});
  }
  out.progress = run.progress();
}

}  // namespace

SessionSnapshot snapshotOf(const session::Session& session, SessionStep step, const SessionSnapshot* before) {
  if (before != nullptr && before->record->id != session.record().id) before = nullptr;
  SessionSnapshot out;
  out.step = step;
  out.record = before != nullptr ? before->record : std::make_shared<const study::SessionRecord>(session.record());
  out.settings =
      before != nullptr ? before->settings : std::make_shared<const session::SessionSettings>(session.settings());
  out.part = session.part();
  out.block = session.block();
  out.blocks_done = session.blocksDone();
  out.paused = session.isPaused();
  if (session.profile() != nullptr) out.profile = *session.profile();
  if (session.speed() != nullptr) out.speed = session.speed()->next();
  if (session.force() != nullptr) out.force = session.force()->next();
  const bool judges = out.part == session::SessionPart::kForce ||
                      (out.part == session::SessionPart::kRating && out.block == session::Block::kForce);
  if (judges && session.force()->lastScored() != nullptr) out.judged = *session.force()->lastScored();
  if (session.form() != nullptr) addForm(*session.form(), before, out);
  return out;
}

namespace {

using base::Result;

struct StudyContentsText {
  Q_DECLARE_TR_FUNCTIONS(StudyContentsText)
};

}  // namespace

std::int64_t utcNowMs() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

Result<std::vector<StudyPerson>> readPeople(const store::StudyFile& file) {
  TACTUS_TRY(const auto persons, store::persons(file));
  TACTUS_TRY(const auto sessions, store::sessions(file));
  TACTUS_TRY(const auto profiles, store::profiles(file));
  std::set<study::RecordId> researchers;
  std::set<study::RecordId> seals;
  for (const study::ProfileRecord& profile : profiles) {
    if (profile.category != kResearcherCategory && profile.category != store::kSealCategory) continue;
    for (const study::SessionRecord& session : sessions) {
      if (session.id != profile.entry.session) continue;
      (profile.category == kResearcherCategory ? researchers : seals).insert(session.person);
    }
  }
  std::vector<StudyPerson> out;
  for (const study::Person& person : persons) {
    if (seals.contains(person.id)) continue;
    out.push_back({person.id, text(person.code), person.simulated, researchers.contains(person.id)});
  }
  return out;
}

Result<StudyNotices> readNotices(const store::StudyFile& file) {
  StudyNotices out;
  const QString name = shownFileName(text(file.path()));
  for (const store::Notice& notice : file.notices()) {
    if (notice.kind != store::Notice::Kind::kJournal) continue;
    out.now.push_back(
        {StudyContentsText::tr("%1: %2. If records are missing, look for them in a backup or an export of the study.")
             .arg(name, harmless(text(notice.sentence))),
         false});
  }
  // As it is now, not as it was at the opening.
  TACTUS_TRY(const auto unfinished, store::unfinishedErasures(file));
  if (!unfinished.empty()) {
    const QString who =
        StudyContentsText::tr("%n participant(s) who withdrew", nullptr, static_cast<int>(unfinished.size()));
    out.now.push_back(
        {StudyContentsText::tr("%1: the erasure of %2 was interrupted. Traces of the data can still be in the file.")
             .arg(name, who),
         true});
  }
  TACTUS_TRY(const auto past, store::pastIncidents(file));
  for (const store::PastIncident& incident : past) {
    const auto said_now = [&incident](const store::Notice& notice) { return notice.sentence == incident.sentence; };
    if (std::any_of(file.notices().begin(), file.notices().end(), said_now)) continue;
    const auto when = QDateTime::fromMSecsSinceEpoch(incident.utc_ms);
    out.before << StudyContentsText::tr("%1: %2.").arg(when.toString(QStringLiteral("yyyy-MM-dd HH:mm")),
                                                       harmless(text(incident.sentence)));
  }
  return out;
}

Result<StudyContents> readContents(const store::StudyFile& file) {
  StudyContents out;
  out.path = text(file.path());
  TACTUS_TRY(out.procedure, session::procedureIn(file));
  TACTUS_TRY(auto people, readPeople(file));
  out.people = std::move(people);
  // Recordings of a newer program do not prevent reading the rest of the study.
  auto recordings = store::feelRecordings(file);
  if (recordings) out.recordings = std::move(*recordings);
  TACTUS_TRY(auto notices, readNotices(file));
  out.notices = std::move(notices);
  return out;
}

}  // namespace tactus::workbench
