// Exports a study as CSV tables with a codebook (docs/study-export.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/record_tables.h"
#include "core/store/study_file.h"

namespace tactus::session {

// The codebook of exported tables: the contents of each column, for programs (JSON) and people (Markdown).

inline constexpr std::string_view kCodebookFormat = "tactus-study-export";

/// From the lowest to the highest force that each participant called by each word (elicitation/force/word_intervals.h).
inline constexpr std::string_view kWordIntervalsTable = "word_intervals.csv";

/// Where the participants would stop (experiments/stop_force.h); only of a procedure that asks for it.
inline constexpr std::string_view kStopForcesTable = "stop_forces.csv";

/// A codebook under construction: the tables in order, with their file names below the folder.
struct Codebook {
  struct Table {
    std::string file;
    const store::RecordTable* table = nullptr;
  };
  bool shareable = false;
  std::vector<std::string> notes;  ///< one sentence each
  std::vector<Table> tables;
};

/// The five tables at the top of an export. `input_ids`: the inputs in rules.csv; they must outlive the result.
/// `shareable`: with the column of experience bands.
std::vector<store::RecordTable> viewTables(const std::vector<std::string>& input_ids, bool shareable);

std::string asJson(const Codebook& codebook);
std::string asMarkdown(const Codebook& codebook);

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
/// readStudyFolder (core/study/csv_tables.h), trials.csv, word_intervals.csv, of a procedure that asks for it
/// stop_forces.csv, codebook.json and codebook.md, and below `records` everything in the study file
/// (core/store/record_tables.h). The same study gives the same bytes. The folder appears completely or not at all. It
/// must be new, empty, or an earlier export, which is replaced. If the study has no view for elicitation
/// (study_view.h), a full export omits the five tables, with a note. Leftovers of crashes beside the study and the
/// folder are deleted, with a note, if they are certainly ours (export_folder.h).
base::Result<StudyExport> exportStudy(const store::StudyFile& file, const std::string& folder,
                                      const ExportOptions& options = {});

}  // namespace tactus::session
