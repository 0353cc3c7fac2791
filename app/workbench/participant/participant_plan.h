// What the researcher has set for the sessions of a study.
#pragma once

#include <QString>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "app/session/session_settings.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

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
  QString station;
  std::optional<std::uint64_t> seed;  ///< of the sessions; nothing: another one for each
  bool simulated = false;             ///< a program is the participant
};

/// The plan of the study's protocol; the defaults where the study has none. The caller says which device is there.
/// Thread: that of `file`.
base::Result<ParticipantPlan> participantPlan(const store::StudyFile& file);

}  // namespace tactus::workbench
