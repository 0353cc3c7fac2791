// Reads a study from a study file or from a folder of tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/study_procedure.h"
#include "app/session/study_view.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/csv_tables.h"
#include "core/study/records.h"
#include "elicitation/depth/depth_measurement.h"
#include "elicitation/model/evidence.h"
#include "experiments/duel_run.h"
#include "experiments/order_effects.h"
#include "questionnaires/scale_summary.h"

namespace tactus::session {

/// What a study file holds beside the data of its experts: the depths measured on an image, and what participants
/// think of the simulator.
struct StudyAside {
  std::optional<elicitation::DepthMeasurement> measured_depths;  ///< the latest; nothing: none was made
  std::vector<questionnaires::ScaleSummary> usability;           ///< one row per statement; empty without any answer
  bool usability_simulated = false;                              ///< a simulated person gave one of these answers
};

base::Result<StudyAside> asideOf(const store::StudyFile& file);

/// What the participants of `view` said of stopping at the forces that count, in the order of its judgements. `view` is
/// of the same file.
base::Result<std::vector<experiments::StopAnswer>> stopAnswers(const store::StudyFile& file, const StudyView& view);

/// What each participant of `view` did, in its order, with the catch trials: of the sessions that count
/// (experiments/order_effects.h). `view` is of the same file.
base::Result<std::vector<experiments::DoneInOrder>> doneInOrder(const store::StudyFile& file, const StudyView& view);

/// The blind comparisons of models in the file, from the oldest to the newest.
base::Result<std::vector<experiments::JudgedDuel>> judgedDuels(const store::StudyFile& file);

/// The references that are or were under seal, from the oldest to the newest.
base::Result<std::vector<elicitation::SealedCurve>> sealedCurves(const store::StudyFile& file);

struct StudyEvidence {
  std::vector<experiments::JudgedDuel> duels;
  std::vector<elicitation::SealedCurve> sealed;
};
/// Both of the study at `path`; nothing of a folder of tables. The file is not changed. Errors name the file.
base::Result<StudyEvidence> readEvidence(const std::string& path);

// The forms to which answers and given rules of a study can refer.

/// The forms of the procedure; of the default one also the readings of published rule tables as forms without items. A
/// form without items only gives the set of terms of the way that its rules use.
std::vector<study::Form> knownForms(const procedure::Procedure& procedure);

/// Reads the tables of a folder (csv_tables.h); accepts everyday spellings (table_words.h). `procedure`: of the study
/// that they are of; null: the pack in the folder `procedure` beside them, or the default one.
base::Result<study::StudyTables> readTables(const std::string& folder, ProcedurePtr procedure = nullptr);

/// Of a folder with the tables of a study: its pack.
inline constexpr std::string_view kPackFolder = "procedure";

/// The procedure that a single table is of: the pack `named` (readPack), else the one in the folder `procedure` beside
/// `table`, else the default one. Never null.
base::Result<ProcedurePtr> procedureOfTable(const std::string& table, const std::string& named);

/// Writes the pack of `study` into the folder `procedure` below `folder`; nothing of the default procedure.
base::Result<void> writePack(const study::Study& study, const std::string& folder);

/// Writes the tables of `study` into `folder` (csv_tables.h), with its pack beside them in the folder `procedure`
/// unless it is the default one.
base::Result<void> writeTables(const study::Study& study, const std::string& folder);

/// Reads the study at `path`: a folder like readTables, or the data for elicitation from a study file (study_view.h)
/// with any extension. The file is not changed. Errors name the file.
base::Result<study::StudyTables> readStudy(const std::string& path);

/// A study with all that a report says of it.
struct WholeStudy {
  study::StudyTables tables;
  base::Result<StudyAside> aside;
  base::Result<std::vector<experiments::DoneInOrder>> in_order;
};

/// The same as readStudy, with what else a study file holds; a folder of tables has nothing of it.
base::Result<WholeStudy> readWholeStudy(const std::string& path);

}  // namespace tactus::session
