#include "app/workbench/study/study_contents.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "app/editing/history_versions.h"
#include "app/session/data_checks.h"
#include "app/session/known_forms.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/study/review_notes.h"
#include "core/base/clock.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/withdrawal.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {
namespace {

using base::Result;

struct StudyContentsText {
  Q_DECLARE_TR_FUNCTIONS(StudyContentsText)
};

QString fileName(const QString& path) { return shownFileName(path); }

// `3 experts, 1 of them simulated`.
QString expertsText(const fuzzy::ForceModel& model, const std::vector<study::Participant>& participants) {
  const auto simulated = std::count_if(model.experts.begin(), model.experts.end(), [&](const fuzzy::Expert& expert) {
    return std::any_of(participants.begin(), participants.end(), [&](const study::Participant& participant) {
      return participant.code == expert.id && participant.simulated;
    });
  });
  const auto experts = static_cast<qlonglong>(model.experts.size());
  const QString all = StudyContentsText::tr("%n expert(s)", nullptr, static_cast<int>(experts));
  if (simulated == 0) return all;
  return simulated == experts ? StudyContentsText::tr("%1, SIMULATED").arg(all)
                              : StudyContentsText::tr("%1, %2 of them SIMULATED").arg(all).arg(simulated);
}

Result<void> addVersions(const store::StudyFile& file, StudyContents& out) {
  auto versions = store::modelVersions(file);
  if (!versions) return tl::unexpected(versions.error());
  out.versions = *versions;
  if (versions->empty()) return {};
  auto last = store::modelVersion(file, versions->back().id);
  if (!last) return tl::unexpected(last.error());
  versions->back() = std::move(*last);
  auto history = editing::historyFrom(*versions, study::RecordIds());
  if (!history) return base::inFile(history.error(), file.path());
  out.history = std::move(*history);
  return {};
}

// A study with answers but without a model gets the averaged one; one without answers says what to do.
void addBuilt(const store::StudyFile& file, const editing::Stamp& stamp, StudyContents& out) {
  const QString name = fileName(out.path);
  const bool has_data = std::any_of(out.info.counts.begin(), out.info.counts.end(), [](const store::TableCount& count) {
    return (count.table == "answer" || count.table == "rule") && count.rows > 0;
  });
  if (!has_data) {
    out.note =
        StudyContentsText::tr(
            "%1 holds neither a model nor answers of experts. Open a model and put it into the study with Study, "
            "or read tables into it with tactus study import.")
            .arg(name);
    return;
  }
  auto built = buildFromStudy(file, stamp);
  if (!built) {
    out.note = StudyContentsText::tr("%1 holds no model, and none can be built from its answers: %2")
                   .arg(name, text(built.error().message()));
    return;
  }
  out.note = std::move(built->sentence);
  out.notes = std::move(built->notes);
  out.history = std::move(built->history);
  out.built = true;
}

}  // namespace

std::int64_t utcNowMs() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

Result<std::vector<StudyPerson>> readPeople(const store::StudyFile& file) {
  const auto persons = store::persons(file);
  if (!persons) return tl::unexpected(persons.error());
  const auto sessions = store::sessions(file);
  if (!sessions) return tl::unexpected(sessions.error());
  const auto profiles = store::profiles(file);
  if (!profiles) return tl::unexpected(profiles.error());
  std::set<study::RecordId> researchers;
  for (const study::ProfileRecord& profile : *profiles) {
    if (profile.category != kResearcherCategory) continue;
    for (const study::SessionRecord& session : *sessions) {
      if (session.id == profile.entry.session) researchers.insert(session.person);
    }
  }
  std::vector<StudyPerson> out;
  for (const study::Person& person : *persons) {
    out.push_back({person.id, text(person.code), person.simulated, researchers.contains(person.id)});
  }
  return out;
}

Result<BuiltFromStudy> buildFromStudy(const store::StudyFile& file, const editing::Stamp& stamp) {
  const auto view = session::studyForElicitation(file);
  if (!view) return tl::unexpected(view.error());
  const auto data = session::dataFindings(view->study);
  if (auto ok = study::refuseData(data); !ok) return base::inFile(ok.error(), file.path());
  elicitation::BuildSettings settings;
  settings.created_utc =
      base::formatUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(stamp.utc_ms)));
  settings.generator = kGenerator;
  const auto built = elicitation::buildModel(view->study, session::knownForms(), settings);
  if (!built) return base::inFile(built.error(), file.path());
  const QString experts = expertsText(built->model, view->study.participants);
  auto history = editing::EditHistory::open(
      built->model, StudyContentsText::tr("Built from the study: %1").arg(experts).toStdString(), stamp,
      study::RecordIds());
  if (!history) return tl::unexpected(history.error());
  BuiltFromStudy out{
      std::move(*history),
      StudyContentsText::tr("Built from the answers in %1: %2.").arg(fileName(text(file.path())), experts),
      {}};
  out.notes = {dataNotes(data), notesOf(view->notes, *built)};
  const std::size_t count = out.notes.data.size() + out.notes.build.size();
  if (count > 0) {
    out.sentence += QLatin1Char(' ') + StudyContentsText::tr("There are %n note(s) about it beside the heading.",
                                                             nullptr, static_cast<int>(count));
  }
  return out;
}

Result<StudyNotices> readNotices(const store::StudyFile& file) {
  StudyNotices out;
  const QString name = fileName(text(file.path()));
  for (const store::Notice& notice : file.notices()) {
    if (notice.kind != store::Notice::Kind::kJournal) continue;
    out.now.push_back(
        {StudyContentsText::tr("%1: %2. If records are missing, look for them in a backup or an export of the study.")
             .arg(name, harmless(text(notice.sentence))),
         false});
  }
  // As it is now, not as it was at the opening.
  const auto unfinished = store::unfinishedErasures(file);
  if (!unfinished) return tl::unexpected(unfinished.error());
  if (!unfinished->empty()) {
    const QString who =
        StudyContentsText::tr("%n participant(s) who withdrew", nullptr, static_cast<int>(unfinished->size()));
    out.now.push_back(
        {StudyContentsText::tr("%1: the erasure of %2 was interrupted. Traces of the data can still be in the file.")
             .arg(name, who),
         true});
  }
  const auto past = store::pastIncidents(file);
  if (!past) return tl::unexpected(past.error());
  for (const store::PastIncident& incident : *past) {
    const auto said_now = [&incident](const store::Notice& notice) { return notice.sentence == incident.sentence; };
    if (std::any_of(file.notices().begin(), file.notices().end(), said_now)) continue;
    const auto when = QDateTime::fromMSecsSinceEpoch(incident.utc_ms);
    out.before << StudyContentsText::tr("%1: %2.").arg(when.toString(QStringLiteral("yyyy-MM-dd HH:mm")),
                                                       harmless(text(incident.sentence)));
  }
  return out;
}

Result<StudyContents> readContents(const store::StudyFile& file, const editing::Stamp& stamp) {
  StudyContents out;
  out.path = text(file.path());
  auto info = store::studyInfo(file);
  if (!info) return tl::unexpected(info.error());
  out.info = std::move(*info);
  auto people = readPeople(file);
  if (!people) return tl::unexpected(people.error());
  out.people = std::move(*people);
  // Records that only a newer program can read are no reason to keep the model from anybody.
  auto recordings = store::feelRecordings(file);
  if (recordings) out.recordings = std::move(*recordings);
  auto notices = readNotices(file);
  if (!notices) return tl::unexpected(notices.error());
  out.notices = std::move(*notices);
  if (auto ok = addVersions(file, out); !ok) return tl::unexpected(ok.error());
  if (!out.history) addBuilt(file, stamp, out);
  return out;
}

}  // namespace tactus::workbench
