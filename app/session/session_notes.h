// What happens in a session beside its protocols: lines of its log that screens write and the researcher reads.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/study/record_id.h"
#include "core/study/session_records.h"
#include "questionnaires/questionnaire_run.h"

namespace tactus::session {

/// A line of the log without its entry.
struct Note {
  std::string kind;
  std::string detail;  ///< JSON text; may be empty

  bool operator==(const Note&) const = default;
};

// Kinds without a detail.
inline constexpr const char* kForceOff = "force_off";                  ///< the participant switched the force off
inline constexpr const char* kResearcherCalled = "researcher_called";  ///< the participant asked for help
inline constexpr const char* kCallSeen = "call_seen";                  ///< the researcher answered it at the monitor
inline constexpr const char* kPausedByHer = "paused_by_participant";   ///< a reason of a pause: where no force was
inline constexpr const char* kDiscomfort = "discomfort";               ///< hand or arm do not feel well today
inline constexpr const char* kRested = "rested";                       ///< the participant ended a rest
inline constexpr const char* kAnswersSealed = "answers_sealed";        ///< the participant locked the answers

Note consentGiven(const std::string& version, const std::string& language, const std::string& text);
Note languageChosen(const std::string& language);
/// `percent`: of the usual size.
Note textSizeChosen(int percent);
/// Under what a participant answers. It is noted when a session begins, when it is resumed and when any of it changes,
/// so the latest such line before an answer, a judgement or a stroke holds for it.
struct Circumstances {
  std::string language;  ///< of the screens
  int text_percent = 100;
  std::string device;          ///< as in study::SessionRecord
  std::string calibrated_utc;  ///< when the device was calibrated with Tactus; empty: never, or its driver does it
  std::optional<double> friction_in_n;  ///< dry friction of the device against insertion, if measured

  bool operator==(const Circumstances&) const = default;
};
Note circumstancesNoted(const Circumstances& circumstances);

/// `reason`: what the device said; may be empty.
Note deviceLost(const std::string& reason);
/// The researcher's own words.
Note researcherNote(const std::string& text);

/// A band of years of experience. The profile keeps the middle of the band as its number.
struct ExperienceBand {
  std::string_view id;  ///< `years_1` to `years_4`
  double middle_years = 0;
};
/// Under 5, 5 to 9, 10 to 14, 15 or more years: middles 2.5, 7.5, 12.5, 20.
std::optional<ExperienceBand> experienceBandCalled(std::string_view id);
Note experienceBandChosen(const ExperienceBand& band);

/// By what means a participant answered.
enum class InputMeans { kMouse, kKeyboard, kTouch, kDeviceButton, kPedal };

/// How a judgement or an answer was entered. With the button of the device, presses go through the words from a start
/// word that is drawn; both are kept, because a fixed start makes one word the cheapest.
struct AnswerInput {
  InputMeans means = InputMeans::kMouse;
  std::string start_word;  ///< the first word that was lit; empty without the device's button
  int presses = 0;         ///< of the device's button

  bool operator==(const AnswerInput&) const = default;
};
/// Refused: presses below 0, presses or a start word without the device's button.
base::Result<void> validate(const AnswerInput& input);
/// `record`: the judgement or the answer.
Note answerInput(const study::RecordId& record, const AnswerInput& input);

/// Why the question of an answer was asked then, in an order that follows from the answers.
Note questionChosen(const study::RecordId& record, const questionnaires::Reason& reason);

/// Whether the participant would stop at the force of a judgement (procedure::Procedure::stop_question).
/// `judgement`: the record of the judgement.
Note wouldStop(const study::RecordId& judgement, bool would_stop);

/// An answer that came sooner than a person can read and choose, or so late that something came in between.
enum class ResponseMark { kSoon, kLate };
inline constexpr double kSoonS = 0.3;  ///< less: the press was meant for something else
inline constexpr double kLateS = 30;   ///< more: she was interrupted

/// `soon`, `late`.
std::string_view name(ResponseMark mark) noexcept;
/// The mark of a response time, s; nothing between the limits. A marked answer still counts.
std::optional<ResponseMark> responseMark(double response_s) noexcept;
/// `record`: the judgement or the answer.
Note responseMarked(const study::RecordId& record, ResponseMark mark);

/// What the participant said of the own model in one region: in practice the force is …
enum class OwnModelVerdict { kLighter, kAboutRight, kHeavier, kCantTell };

/// `lighter`, `about_right`, `heavier`, `cant_tell`.
std::string_view name(OwnModelVerdict verdict) noexcept;

/// The label of a version that is the model of one participant's own answers: it is kept for the records that name it,
/// and is no version of the researcher's model.
inline constexpr const char* kOwnModelLabel = "own model";

/// What was in the hand.
struct OwnModelPlace {
  std::optional<study::RecordId> model_version;  ///< of the same study
  std::string region;                            ///< term id of the depth
  std::optional<double> depth_mm;
  std::optional<double> force_n;
  std::optional<double> pushed_mm = {};           ///< of a verdict: the way that was pushed under the force before it
  std::map<std::string, double> conditions = {};  ///< at which the model was felt, by id of its input

  bool operator==(const OwnModelPlace&) const = default;
};
Note ownModelVerdict(const OwnModelPlace& place, OwnModelVerdict verdict);
/// The participant marked this moment.
Note ownModelMark(const OwnModelPlace& place);

/// What the participant said of the effort of a block, 1 to 7, before the rest of its rating was asked.
Note effortRated(const std::string& block, int effort);

// Back from the log. Nothing for a line of another kind; an error for a detail that does not fit the kind.
struct AnswerInputLine {
  study::RecordId record;
  AnswerInput input;
};
struct OwnModelLine {
  OwnModelPlace place;
  std::optional<OwnModelVerdict> verdict;  ///< nothing: a mark
};
struct ResponseMarkLine {
  study::RecordId record;
  ResponseMark mark = ResponseMark::kSoon;
};
base::Result<std::optional<Circumstances>> circumstancesIn(const study::EventRecord& event);
base::Result<std::optional<ResponseMarkLine>> responseMarkIn(const study::EventRecord& event);
base::Result<std::optional<AnswerInputLine>> answerInputIn(const study::EventRecord& event);
struct WouldStopLine {
  study::RecordId judgement;
  bool would_stop = false;
};
base::Result<std::optional<WouldStopLine>> wouldStopIn(const study::EventRecord& event);
base::Result<std::optional<OwnModelLine>> ownModelIn(const study::EventRecord& event);

/// Whether a note of this kind would be taken for a step of the session itself (began, paused, aborted, …).
bool steersSession(std::string_view kind) noexcept;

}  // namespace tactus::session
