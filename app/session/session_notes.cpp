#include "app/session/session_notes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "app/session/session_state.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonWriter;
using base::required;
using base::Result;

constexpr const char* kAnswerInput = "answer_input";
constexpr const char* kResponseTime = "response_time";
constexpr const char* kWouldStop = "would_stop";
constexpr const char* kOwnModelVerdict = "own_model_verdict";
constexpr const char* kOwnModelMark = "own_model_mark";

constexpr std::array kBands = {ExperienceBand{"years_1", 2.5}, ExperienceBand{"years_2", 7.5},
                               ExperienceBand{"years_3", 12.5}, ExperienceBand{"years_4", 20}};
constexpr std::array<std::string_view, 5> kMeans = {"mouse", "keyboard", "touch", "device_button", "pedal"};
constexpr std::array<std::string_view, 2> kMarks = {"soon", "late"};
constexpr std::array<std::string_view, 4> kVerdicts = {"lighter", "about_right", "heavier", "cant_tell"};

constexpr base::NumberRange kCount{0, std::numeric_limits<int>::max()};

JsonWriter object() {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline);
  return json;
}

Note note(std::string kind, JsonWriter& json) {
  std::string text = json.endObject().text();
  text.pop_back();  // the newline of a whole file
  return {std::move(kind), std::move(text)};
}

void write(const OwnModelPlace& place, JsonWriter& json) {
  if (place.model_version) json.key("model_version").value(study::toText(*place.model_version));
  json.key("region").value(place.region);
  if (place.depth_mm) json.key("depth_mm").value(*place.depth_mm);
  if (place.force_n) json.key("force_n").value(*place.force_n);
  if (place.pushed_mm) json.key("pushed_mm").value(*place.pushed_mm);
  if (place.conditions.empty()) return;
  json.key("conditions").beginObject(JsonWriter::Layout::kInline);
  for (const auto& [input, value] : place.conditions) json.key(input).value(value);
  json.endObject();
}

void readId(JsonMembers& members, base::JsonKey key, std::optional<study::RecordId>& id) {
  std::string text;
  members.text(key, text);
  if (text.empty()) return;
  id = study::parseRecordId(text);
  if (!id) members.refuse(key.name, "32 hexadecimal digits");
}

void readRecord(JsonMembers& members, study::RecordId& record) {
  std::optional<study::RecordId> id;
  readId(members, required("record"), id);
  record = id.value_or(study::RecordId{});
}

template <class Read>
Result<void> readDetail(const study::EventRecord& event, Read read) {
  const auto document = base::JsonDocument::parse(event.detail);
  std::optional<base::Error> error;
  if (document) {
    JsonMembers members(document->root(), error);
    read(members);
  } else {
    error = document.error();
  }
  if (!error) return {};
  error->place = event.kind + " " + toText(event.entry.id) + (error->place.empty() ? "" : ": " + error->place);
  return tl::unexpected(std::move(*error));
}

}  // namespace

Note consentGiven(const std::string& version, const std::string& language, const std::string& text) {
  auto json = object();
  json.key("version").value(version).key("language").value(language).key("text").value(text);
  return note("consent_given", json);
}

Note languageChosen(const std::string& language) { return {"language_chosen", detail("language", language)}; }

Note textSizeChosen(int percent) {
  auto json = object();
  json.key("percent").value(percent);
  return note("text_size_chosen", json);
}

Note circumstancesNoted(const Circumstances& circumstances) {
  auto json = object();
  json.key("language").value(circumstances.language).key("text_percent").value(circumstances.text_percent);
  json.key("device").value(circumstances.device);
  if (!circumstances.calibrated_utc.empty()) json.key("calibrated_utc").value(circumstances.calibrated_utc);
  if (circumstances.friction_in_n) json.key("friction_in_n").value(*circumstances.friction_in_n);
  return note("circumstances", json);
}

Note deviceLost(const std::string& reason) { return {"device_lost", detail("reason", reason)}; }
Note researcherNote(const std::string& text) { return {"researcher_note", detail("text", text)}; }

std::optional<ExperienceBand> experienceBandCalled(std::string_view id) {
  const auto found = std::find_if(kBands.begin(), kBands.end(), [id](const auto& band) { return band.id == id; });
  return found == kBands.end() ? std::nullopt : std::optional(*found);
}

Note experienceBandChosen(const ExperienceBand& band) {
  auto json = object();
  json.key("band").value(band.id).key("middle_years").value(band.middle_years);
  return note("experience_band", json);
}

Result<void> validate(const AnswerInput& input) {
  if (input.presses < 0) {
    return base::fail(ErrorCode::kValue, "presses", std::to_string(input.presses), "0 or more");
  }
  const bool cycles = input.presses > 0 || !input.start_word.empty();
  if (cycles && input.means != InputMeans::kDeviceButton) {
    return base::fail(ErrorCode::kValue, "input", "presses of the device's button by other means",
                      "them only with the device's button");
  }
  return {};
}

Note answerInput(const study::RecordId& record, const AnswerInput& input) {
  auto json = object();
  json.key("record").value(toText(record)).key("means").value(kMeans[static_cast<std::size_t>(input.means)]);
  if (input.means == InputMeans::kDeviceButton) {
    json.key("start_word").value(input.start_word).key("presses").value(input.presses);
  }
  return note(kAnswerInput, json);
}

Note questionChosen(const study::RecordId& record, const questionnaires::Reason& reason) {
  auto json = object();
  json.key("record").value(toText(record)).key("share").value(reason.share).key("unknown_n").value(reason.unknown_n);
  return note("question_chosen", json);
}

Note wouldStop(const study::RecordId& judgement, bool would_stop) {
  auto json = object();
  json.key("record").value(toText(judgement)).key("stop").value(would_stop);
  return note(kWouldStop, json);
}

std::string_view name(ResponseMark mark) noexcept { return kMarks[static_cast<std::size_t>(mark)]; }

std::optional<ResponseMark> responseMark(double response_s) noexcept {
  if (response_s < kSoonS) return ResponseMark::kSoon;
  return response_s > kLateS ? std::optional(ResponseMark::kLate) : std::nullopt;
}

Note responseMarked(const study::RecordId& record, ResponseMark mark) {
  auto json = object();
  json.key("record").value(toText(record)).key("mark").value(name(mark));
  return note(kResponseTime, json);
}

Result<std::optional<Circumstances>> circumstancesIn(const study::EventRecord& event) {
  if (event.kind != "circumstances") return std::nullopt;
  Circumstances read;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    members.text(required("language"), read.language);
    members.integer("text_percent", read.text_percent);
    members.text("device", read.device);
    members.text("calibrated_utc", read.calibrated_utc);
    members.number("friction_in_n", read.friction_in_n);
  });
  if (!ok) return tl::unexpected(ok.error());
  return read;
}

Result<std::optional<ResponseMarkLine>> responseMarkIn(const study::EventRecord& event) {
  if (event.kind != kResponseTime) return std::nullopt;
  ResponseMarkLine line;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    readRecord(members, line.record);
    if (const auto mark = members.word(required("mark"), kMarks)) line.mark = static_cast<ResponseMark>(*mark);
  });
  if (!ok) return tl::unexpected(ok.error());
  return line;
}

std::string_view name(OwnModelVerdict verdict) noexcept { return kVerdicts[static_cast<std::size_t>(verdict)]; }

Note ownModelVerdict(const OwnModelPlace& place, OwnModelVerdict verdict) {
  auto json = object();
  json.key("verdict").value(name(verdict));
  write(place, json);
  return note(kOwnModelVerdict, json);
}

Note ownModelMark(const OwnModelPlace& place) {
  auto json = object();
  write(place, json);
  return note(kOwnModelMark, json);
}

Note effortRated(const std::string& block, int effort) {
  auto json = object();
  json.key("block").value(block).key("effort").value(effort);
  return note("effort_rated", json);
}

Result<std::optional<AnswerInputLine>> answerInputIn(const study::EventRecord& event) {
  if (event.kind != kAnswerInput) return std::nullopt;
  AnswerInputLine line;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    readRecord(members, line.record);
    if (const auto means = members.word(required("means"), kMeans)) line.input.means = static_cast<InputMeans>(*means);
    members.textOrEmpty("start_word", line.input.start_word);
    members.integer("presses", line.input.presses, kCount);
  });
  if (!ok) return tl::unexpected(ok.error());
  return line;
}

Result<std::optional<WouldStopLine>> wouldStopIn(const study::EventRecord& event) {
  if (event.kind != kWouldStop) return std::nullopt;
  WouldStopLine line;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    readRecord(members, line.judgement);
    members.flag(required("stop"), line.would_stop);
  });
  if (!ok) return tl::unexpected(ok.error());
  return line;
}

Result<std::optional<OwnModelLine>> ownModelIn(const study::EventRecord& event) {
  if (event.kind != kOwnModelVerdict && event.kind != kOwnModelMark) return std::nullopt;
  OwnModelLine line;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    readId(members, "model_version", line.place.model_version);
    members.text(required("region"), line.place.region);
    members.number("depth_mm", line.place.depth_mm);
    members.number("force_n", line.place.force_n);
    members.number("pushed_mm", line.place.pushed_mm);
    members.numbers("conditions", line.place.conditions, base::kAnyNumber);
    if (event.kind != kOwnModelVerdict) return;
    if (const auto word = members.word(required("verdict"), kVerdicts)) {
      line.verdict = static_cast<OwnModelVerdict>(*word);
    }
  });
  if (!ok) return tl::unexpected(ok.error());
  return line;
}

bool steersSession(std::string_view kind) noexcept {
  constexpr std::array<std::string_view, 8> kSteering = {kBegan,    kResumed,      kStageEntered, kPaused,
                                                         kUnpaused, kBlockSkipped, kBlockClosed,  kAborted};
  return std::find(kSteering.begin(), kSteering.end(), kind) != kSteering.end();
}

}  // namespace tactus::session
