#include "app/workbench/participant/known_person.h"

#include <algorithm>
#include <utility>

#include "app/session/session_settings.h"
#include "core/store/entries.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::workbench {
namespace {

using base::Result;

Result<bool> endedEarly(const store::StudyFile& file, const study::RecordId& session) {
  const auto events = store::events(file, {{}, session, true});
  if (!events) return tl::unexpected(events.error());
  return std::any_of(events->begin(), events->end(), [](const auto& event) { return event.kind == "aborted"; });
}

/// A session of these screens: an elicitation, or the usability form. Feeling a model is a session too.
bool isOnScreens(const study::SessionRecord& session) {
  if (session.kind != study::SessionKind::kUsability) return session.kind == study::SessionKind::kElicitation;
  const auto settings = session::parseSessionSettings(session.settings);
  const auto wanted = session::usabilitySession();
  return !session.settings.empty() && settings && settings->blocks == wanted.blocks && settings->form == wanted.form;
}

Result<int> answersIn(const store::StudyFile& file, const study::RecordId& session) {
  const store::Selection now{{}, session, false};
  const auto judgements = store::judgements(file, now);
  if (!judgements) return tl::unexpected(judgements.error());
  const auto answers = store::answers(file, now);
  if (!answers) return tl::unexpected(answers.error());
  const auto scored = std::count_if(judgements->begin(), judgements->end(), [](const auto& one) { return one.scored; });
  return static_cast<int>(scored) + static_cast<int>(answers->size());
}

}  // namespace

Result<KnownPerson> knownPerson(const store::StudyFile& file, const std::string& typed) {
  auto found = store::findTyped(file, typed);
  if (!found) return tl::unexpected(found.error());
  KnownPerson out;
  out.person = std::move(found->person);
  if (!found->meant.empty()) out.meant = found->meant.front();
  if (!out.person) return out;
  const auto sessions = store::sessions(file, out.person->id);
  if (!sessions) return tl::unexpected(sessions.error());
  for (auto session = sessions->rbegin(); session != sessions->rend() && !out.session; ++session) {
    if (!isOnScreens(*session)) continue;
    const auto ended = endedEarly(file, session->id);
    if (!ended) return tl::unexpected(ended.error());
    if (!*ended) out.session = session->id;
  }
  if (!out.session) return out;
  const auto answers = answersIn(file, *out.session);
  if (!answers) return tl::unexpected(answers.error());
  out.answers = *answers;
  return out;
}

Result<std::string> newCode(const store::StudyFile& file) {
  store::PersonCodes codes;
  return store::unusedCode(file, codes);
}

}  // namespace tactus::workbench
