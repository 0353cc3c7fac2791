#include "app/workbench/labs/data/lab_study.h"

#include <algorithm>
#include <utility>

#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::workbench {
namespace {

/// Moves what was read into `place`.
template <class T>
base::Result<void> take(base::Result<T> read, T& place) {
  if (!read) return tl::unexpected(read.error());
  place = std::move(*read);
  return {};
}

}  // namespace

std::string LabStudy::codeOf(const study::RecordId& session) const {
  const auto visit = std::find_if(sessions.begin(), sessions.end(), [&](const auto& one) { return one.id == session; });
  if (visit == sessions.end()) return {};
  const auto person =
      std::find_if(persons.begin(), persons.end(), [&](const auto& one) { return one.id == visit->person; });
  return person == persons.end() ? std::string() : person->code;
}

base::Result<LabStudy> readLabStudy(const store::StudyFile& file) {
  auto view = session::studyForElicitation(file);
  if (!view) return tl::unexpected(view.error());
  LabStudy out;
  if (auto ok = take(session::judgedForces(file, *view), out.judged); !ok) return tl::unexpected(ok.error());
  out.answer_ids = std::move(view->answer_ids);
  out.rule_ids = std::move(view->rule_ids);
  out.study = std::move(view->study);
  out.notes = std::move(view->notes);
  out.forms = session::knownForms();
  // What is wrong with a measurement is told by the lab that measures; the others do without.
  if (auto aside = session::asideOf(file)) out.measured_depths = std::move(aside->measured_depths);
  if (auto ok = take(store::persons(file), out.persons); !ok) return tl::unexpected(ok.error());
  if (auto ok = take(store::sessions(file), out.sessions); !ok) return tl::unexpected(ok.error());
  if (auto ok = take(store::strokes(file, {}, store::Recordings::kLeaveOut), out.strokes); !ok) {
    return tl::unexpected(ok.error());
  }
  if (auto ok = take(store::judgements(file), out.judgements); !ok) return tl::unexpected(ok.error());
  if (auto ok = take(store::answers(file), out.answers); !ok) return tl::unexpected(ok.error());
  if (auto ok = take(store::rules(file), out.rules); !ok) return tl::unexpected(ok.error());
  return out;
}

}  // namespace tactus::workbench
