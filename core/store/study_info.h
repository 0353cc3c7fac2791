// A summary of a study file.
#pragma once

#include <cstdint>
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
  std::string program;  ///< name and version of the creating program
  int version = 0;      ///< of the schema
  long long simulated_persons = 0;
  long long placements = 0;        ///< of a tube while feeling a model (feel_records.h); stored as events
  long long feel_recordings = 0;   ///< of feeling a model; stored as events, with their pieces as strokes
  int protocol_version = 0;        ///< of the study's protocol (protocols.h); 0: none was set
  bool protocol_locked = false;    ///< a participant's session follows it
  std::vector<TableCount> counts;  ///< of person, session, each kind of record, model_version, tombstone, import_log
};

base::Result<StudyInfo> studyInfo(const StudyFile& file);

/// Something that lost records or may have, as it was noted at the opening that found it.
struct PastIncident {
  std::int64_t utc_ms = 0;
  std::string sentence;  ///< as that of a Notice

  bool operator==(const PastIncident&) const = default;
};

/// What happened to the study so far, the oldest first; that of this opening too where the study is open for writing.
base::Result<std::vector<PastIncident>> pastIncidents(const StudyFile& file);

/// Looks for anything that is not as it should be, one sentence each; empty when all is well: the integrity of the file
/// and of its references, numbers missing in the order of a session (a lost record) or given twice (a session that went
/// on in two copies of the file), strokes without recording, recordings and model texts that do not fit their
/// checksums, records that do not fit their CRC-32, incidents (a journal that was missing, cut or damaged), codes of
/// two persons, records with two corrections or corrections in a circle, placements and recordings of feeling a model
/// that do not fit (feel_records.h). Reads the whole file.
base::Result<std::vector<std::string>> checkStudy(const StudyFile& file);

}  // namespace tactus::store
