// What a study file holds once: versions of its protocol, the measured depths, the log of imports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

// The log of imports into a study file.

/// One import of tables, or one merge.
struct ImportLogEntry {
  study::RecordId id;
  std::int64_t utc_ms = 0;
  std::string kind;    ///< `tables` or `merge`
  std::string source;  ///< name of the file or folder
  std::string detail;  ///< JSON: number of added records by kind
  std::string sha256;  ///< of the imported data; empty for an import by an older Tactus

  bool operator==(const ImportLogEntry&) const = default;
};

base::Result<void> append(StudyFile& file, const ImportLogEntry& entry);

/// All imports by time.
base::Result<std::vector<ImportLogEntry>> importLog(const StudyFile& file);

// The measurement of depths on an image in a study file.

/// The largest image that a study takes: more than a scan of the whole body at 0.33 mm per pixel without compression.
inline constexpr std::size_t kMostImageBytes = 32U << 20U;

/// Adds a record. Returns an error for a text that is no JSON object, an image that is too large, an image beside
/// `image_of`, and an `image_of` that holds none.
base::Result<void> append(StudyFile& file, const study::DepthRecord& record);

/// The latest record, with the image that it uses in `image`, also if another record holds it; nothing if none was
/// measured.
base::Result<std::optional<study::DepthRecord>> depthMeasurement(const StudyFile& file);

// The versions of the study's protocol in a study file.

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
