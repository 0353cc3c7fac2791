#include "app/workbench/participant/arrival.h"

#include <algorithm>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/known_person.h"
#include "questionnaires/questionnaire.h"

namespace tactus::workbench {
namespace {

std::string languageOf(const std::string& form, const QString& language) {
  const auto known = questionnaires::languagesOf(form);
  const std::string wanted = language.toStdString();
  return std::find(known.begin(), known.end(), wanted) == known.end() ? "en" : wanted;
}

}  // namespace

Arrival::Arrival(StudyConnection& study, SessionProxy& proxy, const ParticipantPlan& plan)
    : study_(study), proxy_(proxy), plan_(plan) {}

void Arrival::newHere(bool usability) {
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
      welcome_ = {WelcomeState::Step::kNewCode, 0, false, {}, 0};
      emit changed();
    };
  });
}

void Arrival::enterCode(const QString& code) {
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
        welcome_ = {step, found->answers, false, {}, 0};
      }
      emit changed();
    };
  });
}

void Arrival::forget() {
  person_.reset();
  session_.reset();
  newcomer_ = usability_ = false;
  welcome_ = {};
}

QString Arrival::code() const { return person_ ? QString::fromStdString(person_->code) : QString(); }

void Arrival::resume() { proxy_.resume(*session_); }

void Arrival::begin(const QString& language, std::uint64_t seed, const std::string& device) {
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
  } else {
    start.settings = plan_.settings;
    start.device = device;
    start.device_friction_n = plan_.device_friction_n;
  }
  start.language = languageOf(start.settings.form, language);
  proxy_.begin(start, newcomer_ ? person_ : std::nullopt);
}

}  // namespace tactus::workbench
