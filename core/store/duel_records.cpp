#include "core/store/duel_records.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/store/felt_events.h"

namespace tactus::store {

using base::JsonMembers;
using base::JsonWriter;
using base::required;
using base::Result;
using study::EventRecord;

namespace {

constexpr std::array<std::string_view, 2> kQuestions = {"heavier", "more_real"};
constexpr std::array<std::string_view, 3> kRules = {"fixed", "sequential", "own_jnd"};
constexpr std::array<std::string_view, 4> kTrialKinds = {"pair", "large", "same", "own"};
constexpr std::array<std::string_view, 3> kChoices = {"first", "second", "cant_tell"};

template <class Enum, std::size_t kSize>
void readWord(JsonMembers& members, base::JsonKey key, const std::array<std::string_view, kSize>& words, Enum& target) {
  if (const auto index = members.word(key, words)) {
    target = static_cast<Enum>(*index);
  } else if (members.has(key.name)) {
    members.refuse(key.name, "a word that this program knows");
  }
}

void write(const char* key, const study::DuelModel& model, JsonWriter& json) {
  json.key(key).beginObject(JsonWriter::Layout::kInline).key("name").value(model.name);
  if (model.version) json.key("version").value(study::toText(*model.version));
  if (!model.expert.empty()) json.key("expert").value(model.expert);
  json.endObject();
}

void readModel(JsonMembers& members, std::optional<base::Error>& error, const char* key, study::DuelModel& model) {
  const auto object = members.object(required(key));
  if (!object) return;
  JsonMembers inside(*object, error);
  inside.text(required("name"), model.name);
  inside.text("expert", model.expert);
  readId(inside, "version", model.version);
}

}  // namespace

std::string_view wordOf(study::DuelQuestion question) noexcept {
  return kQuestions[static_cast<std::size_t>(question)];
}
std::string_view wordOf(study::DuelRule rule) noexcept { return kRules[static_cast<std::size_t>(rule)]; }
std::string_view wordOf(study::DuelTrialKind kind) noexcept { return kTrialKinds[static_cast<std::size_t>(kind)]; }
std::string_view wordOf(study::DuelChoice choice) noexcept { return kChoices[static_cast<std::size_t>(choice)]; }

namespace {

EventRecord eventOf(const study::DuelStart& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline);
  write("a", record.a, json);
  write("b", record.b, json);
  json.key("question").value(wordOf(record.question)).key("rule").value(wordOf(record.rule));
  json.key("expects_b").value(record.expects_b).key("from_mm").value(record.from_mm).key("to_mm").value(record.to_mm);
  json.key("speed_mm_s").value(record.speed_mm_s).key("seed").value(std::size_t{record.seed});
  json.key("trials").value(record.trials).key("sought_jnd").value(record.sought_jnd);
  json.key("power").value(record.power).key("predicted_jnd").value(record.predicted_jnd);
  json.key("gives_force").value(record.gives_force);
  writeSetting(record.setting, json);
  return eventWith(record.entry, kDuelStartKind, json.endObject());
}

EventRecord eventOf(const study::DuelAnswer& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("duel").value(study::toText(record.duel));
  json.key("trial").value(record.trial).key("attempt").value(record.attempt);
  json.key("kind").value(wordOf(record.kind)).key("second_first").value(record.second_first);
  json.key("difference_jnd").value(record.difference_jnd);
  if (record.choice) json.key("choice").value(wordOf(*record.choice));
  if (!record.repeated.empty()) json.key("repeated").value(record.repeated);
  json.key("first_mm_s").value(record.first_mm_s).key("second_mm_s").value(record.second_mm_s);
  json.key("response_s").value(record.response_s);
  return eventWith(record.entry, kDuelAnswerKind, json.endObject());
}

EventRecord eventOf(const study::DuelEnd& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("duel").value(study::toText(record.duel));
  json.key("outcome").value(record.outcome).key("trials").value(record.trials).key("right").value(record.right);
  return eventWith(record.entry, kDuelEndKind, json.endObject());
}

Result<study::DuelStart> duelStartOf(const EventRecord& event) {
  return recordOf<study::DuelStart>(event, [](auto& out, JsonMembers& members, auto& error) {
    readModel(members, error, "a", out.a);
    readModel(members, error, "b", out.b);
    readWord(members, required("question"), kQuestions, out.question);
    readWord(members, required("rule"), kRules, out.rule);
    members.flag(required("expects_b"), out.expects_b);
    members.number(required("from_mm"), out.from_mm);
    members.number(required("to_mm"), out.to_mm);
    members.number(required("speed_mm_s"), out.speed_mm_s, kPositive);
    members.integer(required("seed"), out.seed);
    members.integer(required("trials"), out.trials, kFromOne);
    members.number(required("sought_jnd"), out.sought_jnd, kPositive);
    members.number(required("power"), out.power, {0, 1});
    members.numberOrNull("predicted_jnd", out.predicted_jnd);
    members.flag(required("gives_force"), out.gives_force);
    readSetting(members, out.setting);
  });
}

Result<study::DuelAnswer> duelAnswerOf(const EventRecord& event) {
  return recordOf<study::DuelAnswer>(event, [](auto& out, JsonMembers& members, auto&) {
    readId(members, required("duel"), out.duel);
    members.integer(required("trial"), out.trial, kFromOne);
    members.integer(required("attempt"), out.attempt, kFromOne);
    readWord(members, required("kind"), kTrialKinds, out.kind);
    members.flag(required("second_first"), out.second_first);
    members.number(required("difference_jnd"), out.difference_jnd, kPositive);
    if (members.has("choice")) {
      out.choice = study::DuelChoice::kFirst;
      readWord(members, "choice", kChoices, *out.choice);
    }
    members.text("repeated", out.repeated);
    members.number(required("first_mm_s"), out.first_mm_s, kPositive);
    members.number(required("second_mm_s"), out.second_mm_s, kPositive);
    members.number(required("response_s"), out.response_s, kPositive);
  });
}

Result<study::DuelEnd> duelEndOf(const EventRecord& event) {
  return recordOf<study::DuelEnd>(event, [](auto& out, JsonMembers& members, auto&) {
    readId(members, required("duel"), out.duel);
    members.text(required("outcome"), out.outcome);
    members.integer(required("trials"), out.trials, kCount);
    members.number(required("right"), out.right, kPositive);
  });
}

}  // namespace

Result<void> append(StudyFile& file, const study::DuelStart& record) {
  return appendEvent(file, eventOf(record), duelStartOf);
}
Result<void> append(StudyFile& file, const study::DuelAnswer& record) {
  return appendEvent(file, eventOf(record), duelAnswerOf);
}
Result<void> append(StudyFile& file, const study::DuelEnd& record) {
  return appendEvent(file, eventOf(record), duelEndOf);
}

Result<std::vector<StoredDuel>> duels(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  TACTUS_TRY(const auto codes, codesOfSessions(file));
  std::optional<base::Error> first;
  const auto keep = [&](const base::Error& error) {
    if (!first) first = error;
  };
  std::vector<StoredDuel> out;
  for (auto& start : readEvents(all, kDuelStartKind, duelStartOf, keep)) {
    StoredDuel duel;
    duel.code = codes.at(start.entry.session);
    duel.start = std::move(start);
    out.push_back(std::move(duel));
  }
  const auto duelOf = [&](const study::RecordId& id) {
    return std::find_if(out.begin(), out.end(), [&](const auto& one) { return one.start.entry.id == id; });
  };
  for (auto& answer : readEvents(all, kDuelAnswerKind, duelAnswerOf, keep)) {
    if (const auto duel = duelOf(answer.duel); duel != out.end()) duel->answers.push_back(std::move(answer));
  }
  for (auto& end : readEvents(all, kDuelEndKind, duelEndOf, keep)) {
    if (const auto duel = duelOf(end.duel); duel != out.end()) duel->end = std::move(end);
  }
  if (first) return base::inFile(*first, file.path());
  std::stable_sort(out.begin(), out.end(), [](const StoredDuel& a, const StoredDuel& b) {
    return a.start.entry.when.utc_ms < b.start.entry.when.utc_ms;
  });
  return out;
}

Result<std::vector<std::string>> checkDuelRecords(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  std::vector<std::string> findings;
  const auto tell = [&](const base::Error& error) { findings.push_back(error.message()); };
  std::vector<study::RecordId> known;
  for (const auto& start : readEvents(all, kDuelStartKind, duelStartOf, tell)) known.push_back(start.entry.id);
  const auto look = [&](const study::RecordId& duel, const study::RecordId& record, const char* what) {
    if (std::find(known.begin(), known.end(), duel) != known.end()) return;
    findings.push_back(std::string(what) + ' ' + study::toText(record) + ": of duel " + study::toText(duel) +
                       ", whose plan is missing");
  };
  for (const auto& answer : readEvents(all, kDuelAnswerKind, duelAnswerOf, tell))
    look(answer.duel, answer.entry.id, "answer");
  for (const auto& end : readEvents(all, kDuelEndKind, duelEndOf, tell)) look(end.duel, end.entry.id, "end");
  return findings;
}

}  // namespace tactus::store
