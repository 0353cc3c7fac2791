// The versions of the study's protocol in a study file.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// The state of the study's protocol.
struct ProtocolState {
  std::optional<study::ProtocolRecord> current;  ///< the latest record of the highest version; nothing: none was set
  /// A participant's session follows the current version, so a change is an amendment: the next version, with a reason.
  /// Sessions of simulated persons do not lock.
  bool locked = false;

  /// The version that the next record must have.
  int nextVersion() const { return !current ? 1 : locked ? current->version + 1 : current->version; }
};

base::Result<ProtocolState> protocolState(const StudyFile& file);

/// Adds a record. Returns an error for another version than ProtocolState::nextVersion, for an amendment without a
/// reason, and for a text that is no JSON object.
base::Result<void> append(StudyFile& file, const study::ProtocolRecord& record);

/// All records, by version and time.
base::Result<std::vector<study::ProtocolRecord>> protocols(const StudyFile& file);

}  // namespace tactus::store
