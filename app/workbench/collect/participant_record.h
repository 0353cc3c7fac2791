// The record of one participant: each line that the file holds about them, in the order in which it was stored.
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

struct RecordLine {
  int session = 1;            ///< from 1, by its start
  std::int64_t utc_ms = 0;    ///< when it was stored
  std::int64_t sequence = 0;  ///< its place in the file
  QString part;               ///< Person, Speed, Forces, Questions, Rating, Log
  QString asked;              ///< what it is about
  QString said;               ///< what was answered or done
  bool is_log = false;        ///< a line that the screens wrote, no answer
  QString remark;             ///< not counted, corrected, the reason of a correction; may be empty
};

/// All lines of `person`, with those that were corrected. Reads no recordings. Thread: that of `file`.
base::Result<std::vector<RecordLine>> readParticipantRecord(const store::StudyFile& file,
                                                            const study::RecordId& person);

}  // namespace tactus::workbench
