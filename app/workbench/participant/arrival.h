// Arrival of a participant: her code, new or known, and the session that begins or is resumed with her consent.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

#include "app/workbench/participant/participant_plan.h"
#include "app/workbench/participant/participant_state.h"
#include "app/workbench/study/connection/session_proxy.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

/// Thread: gui.
class Arrival : public QObject {
  Q_OBJECT

 public:
  /// All outlive this. The study must be open.
  Arrival(StudyConnection& study, SessionProxy& proxy, const ParticipantPlan& plan);

  /// Draws an unused code. `usability`: a clinical teacher who answers the usability form, in a session of its
  /// own. Ends with `changed` or `refused`.
  void newHere(bool usability);
  /// Looks for the participant with this code. Ends with `changed` or `refused`.
  void enterCode(const QString& code);
  /// Back to the first question: no participant is known yet.
  void forget();

  bool isKnown() const { return person_.has_value(); }
  const std::optional<study::Person>& person() const { return person_; }
  /// She is in the study file, or will be with her session.
  bool isNewcomer() const { return newcomer_; }
  bool isForUsability() const { return usability_; }
  /// A session that she can resume.
  bool hasSession() const { return session_.has_value(); }
  QString code() const;
  const WelcomeState& welcome() const { return welcome_; }

  /// Goes on with her session.
  void resume();
  /// Begins a session. She agreed to the text in `language`.
  void begin(const QString& language, std::uint64_t seed, const std::string& device);

 signals:
  void changed();
  /// One sentence for the researcher.
  void refused(const QString& sentence);

 private:
  StudyConnection& study_;
  SessionProxy& proxy_;
  const ParticipantPlan& plan_;
  study::RecordIds ids_;
  std::optional<study::Person> person_;
  bool newcomer_ = false;
  bool usability_ = false;
  std::optional<study::RecordId> session_;
  WelcomeState welcome_;
};

}  // namespace tactus::workbench
