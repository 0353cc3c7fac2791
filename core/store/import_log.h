// The log of imports into a study file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

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

}  // namespace tactus::store
