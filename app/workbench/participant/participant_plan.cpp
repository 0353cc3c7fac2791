#include "app/workbench/participant/participant_plan.h"

#include <utility>

#include "app/session/study_protocol.h"
#include "core/store/study_records.h"

namespace tactus::workbench {

base::Result<ParticipantPlan> participantPlan(const store::StudyFile& file) {
  const auto state = store::protocolState(file);
  if (!state) return tl::unexpected(state.error());
  ParticipantPlan out;
  if (!state->current) return out;
  auto protocol = session::parseStudyProtocol(state->current->text);
  if (!protocol) return tl::unexpected(protocol.error());
  out.protocol = state->current->id;
  out.settings = std::move(protocol->settings);
  for (const std::string& language : protocol->languages) out.languages.push_back(QString::fromStdString(language));
  out.consent_version = QString::fromStdString(protocol->consent_version);
  for (const auto& [language, text] : protocol->consent) {
    out.consent_texts[QString::fromStdString(language)] = QString::fromStdString(text);
  }
  for (const auto& [language, text] : protocol->statements) {
    out.statements[QString::fromStdString(language)] = QString::fromStdString(text);
  }
  out.contact = QString::fromStdString(protocol->contact).trimmed();
  out.force_cap_n = protocol->device.force_cap_n;
  out.device_friction_n = protocol->device.friction_n;
  return out;
}

}  // namespace tactus::workbench
