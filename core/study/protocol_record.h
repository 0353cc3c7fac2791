// One version of a study's protocol, as stored in a study file (core/store/protocols.h).
#pragma once

#include <cstdint>
#include <string>

#include "core/study/record_id.h"

namespace tactus::study {

/// What each participant is asked. Append-only: a change is a further record.
struct ProtocolRecord {
  RecordId id;
  int version = 1;  ///< from 1; several records may have one version: its drafts, of which the latest counts
  std::int64_t utc_ms = 0;
  std::string author;
  std::string reason;  ///< of the change; empty for the first version
  std::string text;    ///< JSON object (app/session/study_protocol.h)

  bool operator==(const ProtocolRecord&) const = default;
};

}  // namespace tactus::study
