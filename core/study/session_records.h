// The records of the sessions of a study, as stored in a study file (core/store). A stored record never changes; a
// correction is a new record that supersedes the old one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/study/record_id.h"
#include "core/study/records.h"

namespace tactus::study {

// How the depths of the regions were measured on an image, as stored in a study file (core/store/study_records.h).

/// One state of the measurement. Append-only: a change, also an undo, is a further record; the latest counts.
struct DepthRecord {
  RecordId id;
  std::int64_t utc_ms = 0;
  std::string author;
  std::string text;                  ///< JSON object (elicitation/depth/depth_measurement.h)
  std::optional<RecordId> image_of;  ///< the record that holds the image; nothing: this one, or there is no image
  std::string image;                 ///< the bytes of the image's file, in the record with which it came; else empty

  bool operator==(const DepthRecord&) const = default;
};

// One version of a study's protocol, as stored in a study file (core/store/study_records.h).

/// What each participant is asked. Append-only: a change is a further record.
struct ProtocolRecord {
  RecordId id;
  int version = 1;  ///< from 1; several records may have one version: its drafts, of which the latest counts
  std::int64_t utc_ms = 0;
  std::string author;
  std::string reason;  ///< of the change; empty for the first version
  std::string text;    ///< JSON object (app/session/study_protocol.h)

  bool operator==(const ProtocolRecord&) const = default;
};

/// The time of a record.
struct Moment {
  std::int64_t utc_ms = 0;        ///< wall clock, milliseconds since 1970-01-01 UTC
  std::int64_t monotonic_ns = 0;  ///< a clock that never jumps; only differences within one session count

  bool operator==(const Moment&) const = default;
};

/// By the clocks of this computer.
Moment momentNow();

/// The person or program that entered a record.
enum class EnteredBy {
  kParticipant,
  kResearcher,  ///< for the participant, e.g. after reading aloud
  kProgram,     ///< a simulated participant, or an import
};

/// The common part of all session records.
struct Entry {
  RecordId id;
  RecordId session;
  Moment when;
  EnteredBy entered_by = EnteredBy::kParticipant;
  std::optional<RecordId> supersedes;  ///< the corrected record, of the same kind
  std::string reason;                  ///< of the correction; may be empty

  bool operator==(const Entry&) const = default;
};

/// A person, or a program that simulates one.
struct Person {
  RecordId id;
  std::string code;        ///< random, not derived from the person; unique in the file
  bool simulated = false;  ///< a program generated all data of this person

  bool operator==(const Person&) const = default;
};

/// The participant's own statements. An empty text or an absent number means that the participant did not say.
struct ProfileRecord {
  Entry entry;
  std::optional<double> years_experience;
  std::optional<double> insertions_per_month;
  std::string category;           ///< e.g. beginner, intermediate, expert
  std::string handedness;         ///< left, right, both
  std::string gloves;             ///< the ones usually worn
  std::string tube_size;          ///< usual size of tube, e.g. `14 Fr`
  std::string haptic_experience;  ///< with haptic devices, e.g. none, some, regular
  std::optional<double> weight;   ///< weight in the mean of the experts, set by the researcher
  std::string comfort;            ///< of hand and arm before the session, e.g. good, some_pain

  bool operator==(const ProfileRecord&) const = default;
};

enum class SessionKind {
  kElicitation,  ///< speed, force and questionnaire, with an expert
  kUsability,    ///< a user felt a model: a clinical teacher (paper, Section 5.4), an expert, the researcher
  kImport,       ///< tables imported from files
};

/// One visit of one participant.
struct SessionRecord {
  RecordId id;
  RecordId person;
  SessionKind kind = SessionKind::kElicitation;
  Moment started;
  std::string consent_version;  ///< version of the text that the participant agreed to
  std::uint64_t seed = 0;       ///< for every order and random choice of the session
  std::string language;         ///< of the forms, e.g. `en`
  std::string station;          ///< name of the place of recording; may be empty
  std::string program;          ///< program and version
  std::string device;           ///< haptic device and serial number; may be empty
  /// The device's own friction against forward motion, which adds to the felt force.
  std::optional<double> device_friction_n;
  std::string settings;              ///< JSON text: the settings of the protocols
  std::optional<RecordId> protocol;  ///< the study's protocol (session_records.h) that the session follows

  bool operator==(const SessionRecord&) const = default;
};

/// One line of a session's append-only log.
struct EventRecord {
  Entry entry;
  std::string kind;    ///< e.g. stage_entered, paused, resumed, aborted, finished
  std::string detail;  ///< JSON text; may be empty

  bool operator==(const EventRecord&) const = default;
};

/// One measured quantity of a recording.
struct Channel {
  std::string name;  ///< `depth`, `force`, `speed`, `time`
  std::string unit;  ///< `mm`, `N`, `mm/s`, `s`
  std::vector<double> values;

  bool operator==(const Channel&) const = default;
};

/// A recording of a stroke: channels of equal length at one rate.
struct Recording {
  double sample_rate_hz = 1000;
  std::vector<Channel> channels;

  /// Number of samples per channel.
  std::size_t size() const noexcept { return channels.empty() ? 0 : channels.front().values.size(); }
  bool operator==(const Recording&) const = default;
};

/// One insertion movement of the speed experiment, or a piece of a recording (session_records.h).
struct StrokeRecord {
  Entry entry;
  std::string level;  ///< term id of the requested speed
  int number = 0;     ///< from 1 within level and session; a repeated stroke keeps its number
  int attempt = 1;    ///< from 1
  bool practice = false;
  std::string verdict;    ///< `accepted`, or the reason for rejection (experiments/stroke_segmentation.h)
  std::size_t first = 0;  ///< index of the first sample of the forward movement in `recording`
  std::size_t last = 0;   ///< index after its last sample
  Recording recording;

  bool operator==(const StrokeRecord&) const = default;
};

/// One force stimulus and its judgement.
struct JudgementRecord {
  Entry entry;
  std::string series;            ///< `ascending`, `descending`, `random`
  int step = 0;                  ///< from 1, place in the series
  int attempt = 1;               ///< from 1; another where a step came again because it was not scored
  double commanded_n = 0;        ///< force of the stimulus
  std::optional<double> felt_n;  ///< estimate of the felt force: stimulus plus the device's friction
  ForceJudgement::Kind kind = ForceJudgement::Kind::kNoAnswer;
  std::string term;               ///< term id where `kind` is kTerm
  bool scored = true;             ///< false without forward motion, without the whole force, and for practice
  bool catch_trial = false;       ///< a blank of 0 N or a hidden repeat
  int feel_again = 0;             ///< number of times that the participant asked to feel it again
  double forward_mm = 0;          ///< distance moved forward during the judgement
  double forward_speed_mm_s = 0;  ///< mean speed over that distance
  double response_s = 0;          ///< from the full force to the answer
  /// The least share of the force that was in the hand from the full force on, [0, 1]; nothing: not known.
  std::optional<double> delivered_share;

  bool operator==(const JudgementRecord&) const = default;
};

/// The answer to one item of a form.
struct AnswerRecord {
  Entry entry;
  std::string form;  ///< form id
  int form_version = 1;
  int item = 0;      ///< the form's item number
  int position = 0;  ///< from 1: place in the displayed order
  Answer::Status status = Answer::Status::kSkipped;
  std::string value;      ///< a term id, or a number on a rating scale; empty unless answered
  double response_s = 0;  ///< from the display of the item to the answer
  std::string wording;    ///< id of the words in which the item was asked; empty: not known

  bool operator==(const AnswerRecord&) const = default;
};

/// The participant's rating of a block.
struct RatingRecord {
  Entry entry;
  std::string block;  ///< `speed`, `force`, `questionnaire`, …
  int effort = 0;     ///< 1 (none) to 7 (very much)
  int comfort = 0;    ///< 1 (very uncomfortable) to 7 (very comfortable)

  bool operator==(const RatingRecord&) const = default;
};

/// A rule given directly instead of through answers.
struct RuleRecord {
  Entry entry;
  GivenRule rule;  ///< `participant` and `line` are not used

  bool operator==(const RuleRecord&) const = default;
};

/// One state of a force model. Append-only: undo, snapshots and sign-off add versions.
struct ModelVersion {
  RecordId id;
  std::optional<RecordId> parent;
  std::int64_t utc_ms = 0;
  std::string author;
  std::string label;
  std::string text;    ///< the model file
  std::string sha256;  ///< of `text`, 64 hexadecimal digits

  bool operator==(const ModelVersion&) const = default;
};

// The records of feeling a model: placements of the tube as numbers, and recordings of hand and force. They are stored
// in a session of the kind usability, as events and pieces of recordings (docs/study-file.md, "Feeling a model").

/// The model and the device of a placement or recording.
struct FeltSetting {
  std::string device;                        ///< name and serial number
  bool simulated = false;                    ///< no hardware: the program computed hand, device and force
  std::string model;                         ///< its name
  std::optional<RecordId> model_version;     ///< the version in the same study; empty: a model from outside the study
  std::map<std::string, double> conditions;  ///< of tube and patient, by id of the model's input, in its unit

  bool operator==(const FeltSetting&) const = default;
};

/// One placement of the tube, from the first grip to the last release.
struct PlacementRecord {
  Entry entry;
  FeltSetting setting;
  double duration_s = 0;
  int strokes = 0;
  double peak_force_n = 0;  ///< largest resistance on the hand
  double mean_force_n = 0;  ///< mean resistance while the hand held the tube
  double depth_mm = 0;      ///< deepest position of the tip

  bool operator==(const PlacementRecord&) const = default;
};

/// A moment that was marked while the hand held the tube: where it was, and what it felt.
struct FeelMark {
  Entry entry;
  FeltSetting setting;
  double depth_mm = 0;
  double speed_mm_s = 0;     ///< of the tube, inward
  double force_n = 0;        ///< on the hand
  double model_force_n = 0;  ///< fuzzy force in use

  bool operator==(const FeelMark&) const = default;
};

/// The start of a recording. The id of its entry identifies the recording.
struct FeelStart {
  Entry entry;
  FeltSetting setting;
  int number = 1;  ///< from 1 within the session

  bool operator==(const FeelStart&) const = default;
};

/// A few seconds of a recording, stored while the recording continues.
struct FeelPiece {
  Entry entry;
  int recording = 1;         ///< FeelStart::number
  int number = 1;            ///< from 1 within the recording, without gaps
  Recording samples;         ///< channels as in docs/study-file.md
  bool gap_follows = false;  ///< samples between this piece and the next were lost

  bool operator==(const FeelPiece&) const = default;
};

/// The end of a recording. A recording without an end was interrupted by a crash and holds the pieces stored before.
struct FeelEnd {
  Entry entry;
  int recording = 1;  ///< FeelStart::number
  int pieces = 0;     ///< number of pieces

  bool operator==(const FeelEnd&) const = default;
};

// The records of a blind comparison by hand (a duel), as events of the same sessions: its plan, each answer, its end.

/// One of the two models of a duel.
struct DuelModel {
  std::string name;                 ///< as the researcher chose it
  std::optional<RecordId> version;  ///< in the same study; empty: a model from outside the study
  std::string expert;               ///< id of the one expert that is felt alone; empty: the mean

  bool operator==(const DuelModel&) const = default;
};

enum class DuelQuestion {
  kHeavier,   ///< which was heavier?
  kMoreReal,  ///< which was more like a real insertion?
};

/// When a duel ends.
enum class DuelRule {
  kFixed,       ///< after a number of trials that was fixed before
  kSequential,  ///< when the evidence is enough, or after the number of trials
  kOwnJnd,      ///< no comparison of two models: finds the smallest difference that this person feels on this device
};

/// The plan of a duel, stored before its first stroke. The id of its entry identifies the duel.
struct DuelStart {
  Entry entry;
  FeltSetting setting;  ///< `model` and `model_version`: those of `a`
  DuelModel a;
  DuelModel b;  ///< for kOwnJnd the same as `a`
  DuelQuestion question = DuelQuestion::kHeavier;
  DuelRule rule = DuelRule::kFixed;
  bool expects_b = true;  ///< the answers that name `b` are counted; otherwise those that name `a`
  double from_mm = 0;     ///< the stroke
  double to_mm = 0;
  double speed_mm_s = 0;
  std::uint64_t seed = 0;  ///< gives the order of everything; kept from every screen
  int trials = 0;          ///< that compare the two; for kSequential at most
  double sought_jnd = 1;   ///< the difference that the number of trials is made for
  double power = 0.8;
  std::optional<double> predicted_jnd;  ///< rms difference of the two along the stroke; empty: not known
  bool gives_force = true;              ///< of the device; false: nothing was felt, and the duel counts for nothing

  bool operator==(const DuelStart&) const = default;
};

enum class DuelTrialKind {
  kPair,   ///< the two models
  kLarge,  ///< catch trial: `a`, and `a` three just-noticeable differences heavier
  kSame,   ///< catch trial: one model twice
  kOwn,    ///< of kOwnJnd: `a`, and `a` heavier by `difference_jnd`
};

enum class DuelChoice { kFirst, kSecond, kCantTell };

/// One trial: two strokes and an answer, or the stroke that made it come again.
struct DuelAnswer {
  Entry entry;
  RecordId duel;  ///< the id of its DuelStart
  int trial = 1;  ///< from 1, in the order of the plan
  int attempt = 1;
  DuelTrialKind kind = DuelTrialKind::kPair;
  bool second_first = false;         ///< `b`, or the heavier one, was felt first
  double difference_jnd = 0;         ///< of kLarge and kOwn
  std::optional<DuelChoice> choice;  ///< empty: the trial came again
  std::string repeated;              ///< why it came again (experiments/duel_run.h); empty if it was answered
  double first_mm_s = 0;             ///< mean speed of the strokes; 0: not made
  double second_mm_s = 0;
  double response_s = 0;  ///< from the second stroke to the answer

  bool operator==(const DuelAnswer&) const = default;
};

/// The end of a duel. A duel without one was interrupted and can go on.
struct DuelEnd {
  Entry entry;
  RecordId duel;
  std::string outcome;  ///< `differ`, `not_shown`, `measured` (experiments/duel_run.h)
  int trials = 0;       ///< answered, without catch trials
  double right = 0;     ///< "can't tell" is one half

  bool operator==(const DuelEnd&) const = default;
};

}  // namespace tactus::study
