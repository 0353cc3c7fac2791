#include "app/session/sealing.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/session/study_procedure.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/study/session_records.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::Result;
using study::RecordId;

/// The person who keeps the seal; a new one with the first record. No real person, so that none can withdraw it.
Result<RecordId> sealKeeperOf(store::StudyFile& file, study::RecordIds& ids) {
  TACTUS_TRY(const auto trials, store::sealedTrials(file));
  TACTUS_TRY(const auto sessions, store::sessions(file));
  for (const auto& session : sessions) {
    if (!trials.empty() && session.id == trials.front().reference.entry.session) return session.person;
  }
  store::PersonCodes codes;
  TACTUS_TRY(auto code, store::unusedCode(file, codes));
  const study::Person person{ids.next(), std::move(code), false};
  if (auto ok = store::append(file, person); !ok) return tl::unexpected(ok.error());
  return person.id;
}

/// A new session of the person who keeps the seal, for one record. A part of the caller's batch.
Result<study::Entry> newEntry(store::StudyFile& file, std::string_view program) {
  study::RecordIds ids;
  study::SessionRecord session;
  TACTUS_TRY(session.person, sealKeeperOf(file, ids));
  session.id = ids.next();
  session.kind = study::SessionKind::kUsability;
  session.started = study::momentNow();
  session.program = std::string(program);
  if (auto ok = store::append(file, session); !ok) return tl::unexpected(ok.error());
  study::ProfileRecord profile;
  profile.entry = {ids.next(), session.id, session.started, study::EnteredBy::kProgram, std::nullopt, {}};
  profile.category = store::kSealCategory;
  if (auto ok = store::append(file, profile); !ok) return tl::unexpected(ok.error());
  return study::Entry{ids.next(), session.id, study::momentNow(), study::EnteredBy::kResearcher, std::nullopt, {}};
}

}  // namespace

Result<SealState> sealState(const store::StudyFile& file) {
  SealState out;
  TACTUS_TRY(out.trials, store::sealedTrials(file));
  TACTUS_TRY(out.began, store::elicitationBegan(file));
  TACTUS_TRY(const auto versions, store::modelVersions(file));
  out.signed_off = std::any_of(versions.begin(), versions.end(), store::isSignOff);
  return out;
}

std::map<std::string, double> usualConditions(const procedure::Procedure& about) {
  std::map<std::string, double> out;
  const auto usual = elicitation::referenceInputs(about, {}, 0);
  for (std::size_t k = 0; k < about.inputs.size(); ++k) {
    if (k != about.way()) out[about.inputs[k].id] = usual[k];
  }
  return out;
}

Result<Sealed> seal(store::StudyFile& file, const SealOrder& order, std::string_view program) {
  TACTUS_TRY(const auto procedure, procedureIn(file));
  TACTUS_TRY(const auto points,
             elicitation::readReferenceCurve(order.content, order.name, procedure::orDefault(procedure)));
  TACTUS_TRY(const auto state, sealState(file));
  if (!state.trials.empty()) {
    return base::inFile({ErrorCode::kValue,
                         {},
                         {},
                         "a reference that is sealed already",
                         "a study without one; a second curve belongs into a study of its own"},
                        file.path());
  }
  Sealed out;
  out.points = points.size();
  out.record.note = order.note;
  out.record.conditions = order.conditions;
  out.record.late = state.began;
  TACTUS_TRY(auto batch, store::Batch::begin(file));
  TACTUS_TRY(out.record.entry, newEntry(file, program));
  if (auto ok = store::sealContent(out.record, order.content, order.passphrase); !ok) return tl::unexpected(ok.error());
  if (auto ok = store::append(file, out.record); !ok) return tl::unexpected(ok.error());
  if (auto ok = batch.commit(); !ok) return tl::unexpected(ok.error());
  return out;
}

Result<Unsealed> unseal(store::StudyFile& file, const std::string& passphrase, std::string_view program) {
  TACTUS_TRY(const auto state, sealState(file));
  if (state.trials.empty()) {
    return base::inFile({ErrorCode::kReference, {}, {}, "no sealed reference", "one sealed with `tactus study seal`"},
                        file.path());
  }
  Unsealed out;
  std::optional<base::Error> refused;
  const store::SealedTrial* opened = nullptr;
  for (const auto& trial : state.trials) {
    auto content = store::openContent(trial.reference, passphrase);
    if (!content) {
      refused = content.error();
      continue;
    }
    opened = &trial;
    out.opening.content = std::move(*content);
    break;
  }
  if (opened == nullptr) return base::inFile(*refused, file.path());
  out.reference = opened->reference;
  out.opening.reference = opened->reference.entry.id;
  out.opening.early = !state.signed_off;
  out.times = opened->openings.size() + 1;
  out.changes_after = opened->changed_after.size();
  TACTUS_TRY(auto batch, store::Batch::begin(file));
  TACTUS_TRY(out.opening.entry, newEntry(file, program));
  if (auto ok = store::append(file, out.opening); !ok) return tl::unexpected(ok.error());
  if (auto ok = batch.commit(); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto procedure, procedureIn(file));
  TACTUS_TRY(out.points,
             elicitation::readReferenceCurve(out.opening.content, file.path(), procedure::orDefault(procedure)));
  return out;
}

}  // namespace tactus::session
