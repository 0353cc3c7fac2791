// What a study file holds, at a glance.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

struct TableCount {
  std::string table;
  long long rows = 0;

  bool operator==(const TableCount&) const = default;
};

struct StudyInfo {
  study::RecordId id;
  std::string name;
  std::int64_t created_utc_ms = 0;
  std::string program;  ///< that made the file
  int version = 0;      ///< of the schema
  long long simulated_persons = 0;
  std::vector<TableCount> counts;  ///< of person, session, each kind of record, model_version, tombstone, import_log
};

base::Result<StudyInfo> studyInfo(const StudyFile& file);

/// Looks for anything that is not as it should be, one sentence each; empty when all is well: the integrity of the file
/// and of its references, numbers missing in the order of a session (a lost record) or given twice (a session that went
/// on in two copies of the file), strokes without recording, recordings and model texts that do not fit their
/// checksums, codes of two persons, records with two corrections. Reads the whole file.
base::Result<std::vector<std::string>> checkStudy(const StudyFile& file);

}  // namespace tactus::store
