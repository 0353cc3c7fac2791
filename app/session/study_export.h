// Exports a study as CSV tables with a codebook (docs/study-export.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/record_export.h"
#include "core/store/study_file.h"

namespace tactus::session {

struct ExportOptions {
  /// Only the tables of the study as it holds now, without identifying details (shareable.h) and without records.
  bool shareable = false;
  /// Draws the order of the participants of a shareable export; it must not be known to those who get it.
  std::uint64_t seed = 0;
  store::ByteOrderMark mark = store::ByteOrderMark::kNone;
};

struct StudyExport {
  std::size_t participants = 0;
  std::vector<std::string> notes;  ///< one sentence each, for the person who exports; they may name participants
};

/// Writes into `folder`: participants.csv, speeds.csv, judgements.csv, answers.csv and rules.csv as readStudyFolder
/// reads them (core/study/csv_tables.h), codebook.json and codebook.md, and below `records` everything that the study
/// file holds (core/store/record_export.h). The same study gives the same bytes. The folder appears whole or not at
/// all; it must be new, empty, or an earlier export, which is replaced. A full export leaves out the five tables, with
/// a note, where the study has no view for elicitation (study_view.h). What crashes left beside the study and the
/// folder is deleted, with a note, where it is certainly ours (leftovers.h).
base::Result<StudyExport> exportStudy(const store::StudyFile& file, const std::string& folder,
                                      const ExportOptions& options = {});

}  // namespace tactus::session
