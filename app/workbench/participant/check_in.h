// CheckIn of a participant: her code, new or known, and the session that begins or is resumed with her consent.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "app/session/session_settings.h"
#include "app/session/setup_certificate.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/study/connection/session_proxy.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

/// What the researcher has set for the sessions of a study.
struct ParticipantPlan {
  session::SessionSettings settings;
  std::vector<QString> languages;  ///< ids, in the order offered; empty: all that the screens have
  QString consent_version = QStringLiteral("1");
  std::map<QString, QString> consent_texts;    ///< by language; may be empty
  std::map<QString, QString> statements;       ///< by language, instead of the general ones
  QString contact;                             ///< whom a participant can ask
  double force_cap_n = 2;                      ///< largest force of the device
  std::optional<study::RecordId> protocol;     ///< the record of the study's protocol; nothing: none was set
  QString device = QStringLiteral("virtual");  ///< id of the list of devices
  std::optional<double> device_friction_n;
  std::optional<session::SetupCertificate> setup;  ///< under which the session begins; nothing: it is not checked
  QString station;
  std::optional<std::uint64_t> seed;  ///< of the sessions; nothing: another one for each
  bool simulated = false;             ///< a program is the participant
};

/// The plan of the study's protocol; the defaults where the study has none. The caller says which device is there.
/// Thread: that of `file`.
base::Result<ParticipantPlan> participantPlan(const store::StudyFile& file);

/// Thread: gui.
class CheckIn : public QObject {
  Q_OBJECT

 public:
  /// All outlive this. The study must be open.
  CheckIn(StudyConnection& study, SessionProxy& proxy, const ParticipantPlan& plan);

  /// Draws an unused code. `usability`: a clinical teacher who answers the usability form, in a session of its
  /// own. Ends with `changed` or `refused`.
  void newHere(bool usability);
  /// Looks for the participant with this code. Ends with `changed` or `refused`.
  void enterCode(const QString& code);
  /// The same for the participant whom the researcher has chosen: nobody else can take part until `forget`.
  void prepare(const QString& code);
  bool isPrepared() const { return welcome_.prepared; }
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
