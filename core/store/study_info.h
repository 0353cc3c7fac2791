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
  int protocol_version = 0;        ///< of the study's protocol (study_records.h); 0: none was set
  bool protocol_locked = false;    ///< a participant's session follows it
  std::vector<TableCount> counts;  ///< of person, session, each kind of record, model_version, tombstone, import_log
};

base::Result<StudyInfo> studyInfo(const StudyFile& file);

/// An incident that lost records, or may have lost some. The opening of the file that found it has noted it.
struct PastIncident {
  std::int64_t utc_ms = 0;
  std::string sentence;  ///< as that of a Notice

  bool operator==(const PastIncident&) const = default;
};

/// All incidents of the study, the oldest first. Those of the current opening are among them if the study is open for
/// writing.
base::Result<std::vector<PastIncident>> pastIncidents(const StudyFile& file);

/// Checks the whole file. Returns one sentence for each fault; empty if there is none. The faults:
///   file        damaged pages, references to records that are not there
///   sessions    numbers missing in the order of a session (a lost record), or given twice (the session continued in
///   two
///               copies of the file)
///   bytes       recordings and model texts that differ from their checksums, records that differ from their CRC-32
///   strokes     without a recording
///   incidents   a journal that was missing, cut or damaged
///   codes       one code for two persons
///   corrections two of one record, or corrections in a circle
///   feeling     placements and recordings that contradict each other (feel_records.h)
///   duels       answers and ends without their plan (duel_records.h)
base::Result<std::vector<std::string>> checkStudy(const StudyFile& file);

}  // namespace tactus::store
