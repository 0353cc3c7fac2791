// One table of all that participants did: a row for each stroke, judgement and answer, with what it was done under.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/session_notes.h"
#include "app/session/study_view.h"
#include "core/base/error.h"
#include "core/store/record_tables.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

inline constexpr std::string_view kTrialsTable = "trials.csv";

/// A stroke, a judgement or an answer. What does not apply to its kind is empty.
struct Trial {
  enum class Kind { kStroke, kJudgement, kAnswer };

  Kind kind = Kind::kStroke;
  std::string participant;
  bool simulated = false;
  study::RecordId session_id;
  int session = 1;  ///< from 1, of the participant, by its start
  std::int64_t utc_ms = 0;
  double time_s = 0;       ///< since the session began, by the wall clock
  int order = 0;           ///< from 1, of the participant's session: the place among its trials
  bool counts = false;     ///< is among the data that a model is built from (study_view.h)
  std::string entered_by;  ///< `participant`, `researcher` or `program`
  Circumstances under;     ///< of the moment; of older sessions what the session itself says
  std::string protocol;    ///< id of the study's protocol; empty: none
  std::string settings;    ///< JSON text: those of the session
  std::string station;
  bool setup_checked = false;  ///< the set-up was checked and good when the session began or was resumed
  std::string block;           ///< level of the speed, series of forces, or form
  int number = 0;              ///< of the stroke within its level, of the step within its series, or of the item
  int attempt = 1;
  bool practice = false;
  bool catch_trial = false;
  std::string wording;               ///< of an answer: id of the words in which it was asked
  std::optional<int> position;       ///< of an answer: place in the order shown, from 1
  std::string answer;                ///< term, or point of a scale
  std::string status;                ///< verdict of a stroke; kind of a judgement; status of an answer
  std::optional<double> response_s;  ///< of judgements and answers
  std::optional<double> force_n;     ///< commanded
  std::optional<double> felt_n;      ///< with the device's friction
  std::optional<double> delivered_share;
  std::optional<int> feel_again;
  std::optional<double> forward_mm;
  std::optional<std::size_t> samples;     ///< of the stroke's forward movement
  std::optional<double> mean_speed_mm_s;  ///< over them
  std::optional<double> sd_speed_mm_s;    ///< over them, n - 1; nothing for fewer than two

  bool operator==(const Trial&) const = default;
};

/// `stroke`, `judgement`, `answer`.
std::string_view name(Trial::Kind kind) noexcept;

/// All trials of the participants of `view`, which is of the same file: participant after participant by code, and in
/// the order in which they were done. Corrected records are replaced by their corrections. Usability sessions have
/// trials too; none of them counts.
base::Result<std::vector<Trial>> trials(const store::StudyFile& file, const StudyView& view);

/// Those of the study at `path`; none of a folder of tables. The file is not changed. Errors name the file.
base::Result<std::vector<Trial>> trialsAt(const std::string& path);

/// The trials of those in `codes`, under their new codes, without dates, times of day, ids, stations, serial numbers of
/// devices and who entered a record (shareable.h).
std::vector<Trial> shareable(std::vector<Trial> trials, const std::map<std::string, std::string>& codes);

/// Columns of the table, for codebooks. `shareable`: without those that are then empty.
store::RecordTable trialsTable(bool shareable);

/// The cells of its rows, by its columns.
std::vector<std::vector<std::string>> trialRows(const std::vector<Trial>& trials, bool shareable);
/// The table as CSV.
std::string trialsText(const std::vector<Trial>& trials, bool shareable);

}  // namespace tactus::session
