#include "app/workbench/participant/check_in.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/session/session_settings.h"
#include "app/session/study_procedure.h"
#include "app/session/study_protocol.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_file.h"
#include "core/store/study_records.h"
#include "core/study/session_records.h"
#include "experiments/stroke.h"
#include "questionnaires/questionnaire.h"

namespace tactus::workbench {

base::Result<ParticipantPlan> participantPlan(const store::StudyFile& file) {
  TACTUS_TRY(const auto state, store::protocolState(file));
  ParticipantPlan out;
  TACTUS_TRY(auto setup, session::latestSetup(file));
  out.setup = std::move(setup);
  if (!state.current) {
    TACTUS_TRY(const auto procedure, session::procedureIn(file));
    if (procedure == nullptr) return out;
    TACTUS_TRY(auto first, session::firstProtocol(procedure));
    out.settings = std::move(first.settings);
    out.force_cap_n = first.device.force_cap_n;
    return out;
  }
  TACTUS_TRY(auto protocol, session::protocolOf(file, *state.current));
  out.protocol = state.current->id;
  out.settings = std::move(protocol.settings);
  for (const std::string& language : protocol.languages) out.languages.push_back(QString::fromStdString(language));
  out.consent_version = QString::fromStdString(protocol.consent_version);
  for (const auto& [language, text] : protocol.consent) {
    out.consent_texts[QString::fromStdString(language)] = QString::fromStdString(text);
  }
  for (const auto& [language, text] : protocol.statements) {
    out.statements[QString::fromStdString(language)] = QString::fromStdString(text);
  }
  out.contact = QString::fromStdString(protocol.contact).trimmed();
  out.force_cap_n = protocol.device.force_cap_n;
  out.device_friction_n = protocol.device.friction_n;
  return out;
}

namespace {

// The participants' codes at the welcome: a new one, and who has the code that was typed.

/// The person with a typed code, and what is kept of them.
struct KnownPerson {
  std::optional<study::Person> person;     ///< nothing: no code of this study
  std::string meant;                       ///< a code that may have been meant; may be empty
  std::optional<study::RecordId> session;  ///< the latest on these screens that was not ended early
  int answers = 0;                         ///< scored judgements and replies to questions in it, corrected ones once
  int strokes = 0;                         ///< accepted insertions in it
  int all_strokes = 0;                     ///< that its protocol asks for; 0: not known
  int forces = 0;                          ///< scored judgements in it
  bool in_form = false;                    ///< questions were answered
};

using base::Result;

Result<bool> endedEarly(const store::StudyFile& file, const study::RecordId& session) {
  TACTUS_TRY(const auto events, store::events(file, {{}, session, true}));
  return std::any_of(events.begin(), events.end(), [](const auto& event) { return event.kind == "aborted"; });
}

/// A session of these screens: an elicitation, or the usability form. Feeling a model is a session too.
bool isOnScreens(const study::SessionRecord& session) {
  if (session.kind != study::SessionKind::kUsability) return session.kind == study::SessionKind::kElicitation;
  const auto settings = session::parseSessionSettings(session.settings);
  const auto wanted = session::usabilitySession();
  return !session.settings.empty() && settings && settings->blocks == wanted.blocks && settings->form == wanted.form;
}

/// What `session` holds.
Result<void> count(const store::StudyFile& file, const study::SessionRecord& session, KnownPerson& out) {
  const store::Selection now{{}, session.id, false};
  TACTUS_TRY(const auto strokes, store::strokes(file, now, store::Recordings::kLeaveOut));
  TACTUS_TRY(const auto judgements, store::judgements(file, now));
  TACTUS_TRY(const auto answers, store::answers(file, now));
  out.strokes = static_cast<int>(std::count_if(strokes.begin(), strokes.end(), [](const auto& one) {
    return !one.practice && one.verdict == name(experiments::StrokeVerdict::kAccepted);
  }));
  if (const auto settings = session::parseSessionSettings(session.settings); settings && !session.settings.empty()) {
    out.all_strokes = static_cast<int>(settings->speed.levels.size()) * settings->speed.strokes;
  }
  out.forces =
      static_cast<int>(std::count_if(judgements.begin(), judgements.end(), [](const auto& one) { return one.scored; }));
  out.in_form = !answers.empty();
  out.answers = out.forces + static_cast<int>(answers.size());
  return {};
}

/// Thread: that of `file`.
Result<KnownPerson> knownPerson(const store::StudyFile& file, const std::string& typed) {
  TACTUS_TRY(auto found, store::findTyped(file, typed));
  KnownPerson out;
  out.person = std::move(found.person);
  if (!found.meant.empty()) out.meant = found.meant.front();
  if (!out.person) return out;
  TACTUS_TRY(const auto sessions, store::sessions(file, out.person->id));
  for (auto session = sessions.rbegin(); session != sessions.rend() && !out.session; ++session) {
    if (!isOnScreens(*session)) continue;
    TACTUS_TRY(const auto ended, endedEarly(file, session->id));
    if (ended) continue;
    out.session = session->id;
    if (auto ok = count(file, *session, out); !ok) return tl::unexpected(ok.error());
  }
  return out;
}

/// A code that no participant has or had. Thread: that of `file`.
Result<std::string> newCode(const store::StudyFile& file) {
  store::PersonCodes codes;
  return store::unusedCode(file, codes);
}

/// The language in which the form is asked: `language`, or the first one in which there is a wording.
std::string languageOf(const procedure::Procedure& procedure, const std::string& form, const QString& language) {
  const auto known = questionnaires::languagesOf(procedure, form);
  for (const std::string& wanted : {language.toStdString(), procedure.languages.front()}) {
    if (std::find(known.begin(), known.end(), wanted) != known.end()) return wanted;
  }
  return known.empty() ? "en" : known.front();
}

}  // namespace

CheckIn::CheckIn(StudyConnection& study, SessionProxy& proxy, const ParticipantPlan& plan)
    : study_(study), proxy_(proxy), plan_(plan) {}

void CheckIn::newHere(bool usability) {
  study_.read(*this, [this, usability](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto code = newCode(file);
    return [this, code, usability] {
      if (!code) {
        emit refused(text(code.error().message()));
        return;
      }
      person_ = study::Person{ids_.next(), *code, plan_.simulated};
      newcomer_ = true;
      usability_ = usability;
      session_.reset();
      welcome_ = {};
      welcome_.step = WelcomeState::Step::kNewCode;
      emit changed();
    };
  });
}

void CheckIn::prepare(const QString& code) {
  welcome_.prepared = true;
  enterCode(code);
}

void CheckIn::enterCode(const QString& code) {
  study_.read(*this, [this, typed = code.toStdString()](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto found = knownPerson(file, typed);
    return [this, found] {
      if (!found) {
        emit refused(text(found.error().message()));
      } else if (!found->person) {
        welcome_.code_unknown = true;
        welcome_.meant = QString::fromStdString(found->meant);
      } else {
        person_ = found->person;
        newcomer_ = usability_ = false;
        session_ = found->session;
        // Without a session yet, she is shown the code to write it down.
        const auto step = session_ ? WelcomeState::Step::kWelcomeBack : WelcomeState::Step::kNewCode;
        const bool prepared = welcome_.prepared;
        welcome_ = {};
        welcome_.step = step;
        welcome_.kept_answers = found->answers;
        welcome_.prepared = prepared;
        if (!found->in_form) {
          welcome_.kept_strokes = found->strokes;
          welcome_.all_strokes = found->all_strokes;
          welcome_.kept_forces = found->forces;
        }
      }
      emit changed();
    };
  });
}

void CheckIn::forget() {
  person_.reset();
  session_.reset();
  newcomer_ = usability_ = false;
  welcome_ = {};
}

QString CheckIn::code() const { return person_ ? QString::fromStdString(person_->code) : QString(); }

void CheckIn::resume() { proxy_.resume(*session_); }

void CheckIn::begin(const QString& language, std::uint64_t seed, const std::string& device) {
  session::SessionStart start;
  start.person = person_->id;
  start.consent_version = plan_.consent_version.toStdString();
  start.seed = seed;
  start.station = plan_.station.toStdString();
  start.program = kGenerator;
  start.protocol = plan_.protocol;
  if (usability_) {
    start.kind = study::SessionKind::kUsability;
    start.settings = session::usabilitySession();
    start.settings.procedure = plan_.settings.procedure;
  } else {
    start.settings = plan_.settings;
    start.device = device;
    start.device_friction_n = plan_.device_friction_n;
  }
  start.language = languageOf(start.settings.about(), start.settings.form, language);
  proxy_.begin(start, newcomer_ ? person_ : std::nullopt);
}

}  // namespace tactus::workbench
