// Exports a study as CSV tables with a codebook (docs/study-export.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/record_tables.h"
#include "core/store/study_file.h"

namespace tactus::session {

struct ExportOptions {
  /// True: only the tables of the study as it counts now, without identifying details (shareable.h) and without
  /// records.
  bool shareable = false;
  /// Seed for the order of the participants in a shareable export. The receivers of the export must not know it.
  std::uint64_t seed = 0;
  store::ByteOrderMark mark = store::ByteOrderMark::kNone;
};

struct StudyExport {
  std::size_t participants = 0;
  std::vector<std::string> notes;  ///< one sentence each, for the person who exports; they may name participants
};

/// Writes into `folder`: participants.csv, speeds.csv, judgements.csv, answers.csv and rules.csv in the format of
/// readStudyFolder (core/study/csv_tables.h), codebook.json and codebook.md, and below `records` everything in the
/// study file (core/store/record_tables.h). The same study gives the same bytes. The folder appears completely or not
/// at all. It must be new, empty, or an earlier export, which is replaced. If the study has no view for elicitation
/// (study_view.h), a full export omits the five tables, with a note. Leftovers of crashes beside the study and the
/// folder are deleted, with a note, if they are certainly ours (leftovers.h).
base::Result<StudyExport> exportStudy(const store::StudyFile& file, const std::string& folder,
                                      const ExportOptions& options = {});

}  // namespace tactus::session
