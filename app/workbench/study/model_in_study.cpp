#include "app/workbench/study/model_in_study.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/editing/history_versions.h"
#include "app/session/data_checks.h"
#include "app/session/study_source.h"
#include "app/session/session_notes.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/study/review_notes.h"
#include "core/base/clock.h"
#include "core/store/model_versions.h"
#include "core/store/study_info.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/published_settings.h"

namespace tactus::workbench {
namespace {

using base::Result;

struct ModelInStudyText {
  Q_DECLARE_TR_FUNCTIONS(ModelInStudyText)
};

// `3 experts, 1 of them simulated`.
QString expertsText(const fuzzy::ForceModel& model, const std::vector<study::Participant>& participants) {
  const auto simulated = std::count_if(model.experts.begin(), model.experts.end(), [&](const fuzzy::Expert& expert) {
    return std::any_of(participants.begin(), participants.end(), [&](const study::Participant& participant) {
      return participant.code == expert.id && participant.simulated;
    });
  });
  const auto experts = static_cast<qlonglong>(model.experts.size());
  const QString all = ModelInStudyText::tr("%n expert(s)", nullptr, static_cast<int>(experts));
  if (simulated == 0) return all;
  return simulated == experts ? ModelInStudyText::tr("%1, SIMULATED").arg(all)
                              : ModelInStudyText::tr("%1, %2 of them SIMULATED").arg(all).arg(simulated);
}

Result<void> addVersions(const store::StudyFile& file, ModelInStudy& out) {
  auto versions = store::modelVersions(file);
  if (!versions) return tl::unexpected(versions.error());
  // What participants felt of their own answers is no state of the researcher's model.
  std::erase_if(*versions, [](const study::ModelVersion& version) { return version.label == session::kOwnModelLabel; });
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

bool hasAnswers(const store::StudyInfo& info) {
  return std::any_of(info.counts.begin(), info.counts.end(), [](const store::TableCount& count) {
    return (count.table == "answer" || count.table == "rule") && count.rows > 0;
  });
}

}  // namespace

Result<BuiltFromStudy> buildFromStudy(const store::StudyFile& file, const editing::Stamp& stamp,
                                      elicitation::BuildSettings settings) {
  const auto view = session::studyForElicitation(file);
  if (!view) return tl::unexpected(view.error());
  const auto data = session::dataFindings(view->study);
  if (auto ok = study::refuseData(data); !ok) return base::inFile(ok.error(), file.path());
  settings.created_utc =
      base::formatUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(stamp.utc_ms)));
  settings.generator = kGenerator;
  auto built = elicitation::buildModel(view->study, session::knownForms(), settings);
  if (!built) return base::inFile(built.error(), file.path());
  elicitation::noteUnlikePublished(*built, view->study, session::knownForms(), settings);
  const QString experts = expertsText(built->model, view->study.participants);
  auto history = editing::EditHistory::open(built->model,
                                            ModelInStudyText::tr("Built from the study: %1").arg(experts).toStdString(),
                                            stamp, study::RecordIds());
  if (!history) return tl::unexpected(history.error());
  BuiltFromStudy out{
      std::move(*history),
      ModelInStudyText::tr("Built from the answers in %1: %2.").arg(shownFileName(text(file.path())), experts),
      {}};
  out.notes = {dataNotes(data), notesOf(view->notes, *built)};
  const std::size_t count = out.notes.data.size() + out.notes.build.size();
  if (count > 0) {
    out.sentence += QLatin1Char(' ') + ModelInStudyText::tr("There are %n note(s) about it beside the heading.",
                                                            nullptr, static_cast<int>(count));
  }
  return out;
}

Result<ModelInStudy> readModel(const store::StudyFile& file) {
  ModelInStudy out;
  const auto info = store::studyInfo(file);
  if (!info) return tl::unexpected(info.error());
  if (auto ok = addVersions(file, out); !ok) return tl::unexpected(ok.error());
  out.has_answers = hasAnswers(*info);
  return out;
}

}  // namespace tactus::workbench
