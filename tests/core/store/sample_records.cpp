#include "tests/core/store/sample_records.h"

#include <iostream>

#include "core/base/check.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::store {

NewStudy SampleRecords::study() { return {id(), "Tube study", 1'760'000'000'000, "tactus 0.1.0"}; }

study::Person SampleRecords::person(const std::string& code) { return {id(), code, true}; }

study::SessionRecord SampleRecords::session(const study::RecordId& person) {
  study::SessionRecord session;
  session.id = id();
  session.person = person;
  session.started = {time_ms_ += 1000, 5};
  session.consent_version = "consent 2";
  session.seed = 0xFFFF'FFFF'FFFF'FFFFU;  // the largest, which SQLite's integers do not hold
  session.language = "en";
  session.station = "north";
  session.program = "tactus 0.1.0";
  session.device = "simulated";
  session.device_friction_n = 0.26;
  session.settings = R"({"levels":["slow","fast"]})";
  return session;
}

study::Entry SampleRecords::entry(const study::RecordId& session) {
  study::Entry entry;
  entry.id = id();
  entry.session = session;
  entry.when = {time_ms_ += 7, time_ms_ * 1000};
  entry.entered_by = study::EnteredBy::kResearcher;
  entry.reason = "größer";
  return entry;
}

study::ProfileRecord SampleRecords::profile(const study::RecordId& session) {
  study::ProfileRecord record;
  record.entry = entry(session);
  record.years_experience = 12.5;
  record.category = "expert";
  record.handedness = "left";
  record.gloves = "nitrile";
  record.tube_size = "14 Fr";
  record.haptic_experience = "none";
  record.weight = 0.25;
  record.comfort = "some_pain";
  return record;
}

study::EventRecord SampleRecords::event(const study::RecordId& session) {
  return {entry(session), "stage_entered", R"({"stage":"speed"})"};
}

study::StrokeRecord SampleRecords::stroke(const study::RecordId& session, std::size_t samples) {
  study::StrokeRecord record;
  record.entry = entry(session);
  record.level = "medium";
  record.number = 2;
  record.attempt = 1;
  record.verdict = "accepted";
  record.first = 1;
  record.last = samples;
  study::Channel depth{"depth", "mm", {}};
  study::Channel force{"force", "N", {}};
  for (std::size_t i = 0; i < samples; ++i) {
    depth.values.push_back(0.055 * static_cast<double>(i));
    force.values.push_back(-1.0 / static_cast<double>(i + 3));
  }
  record.recording = {1000, {depth, force}};
  return record;
}

study::JudgementRecord SampleRecords::judgement(const study::RecordId& session) {
  study::JudgementRecord record;
  record.entry = entry(session);
  record.series = "ascending";
  record.step = 3;
  record.attempt = 2;
  record.commanded_n = 0.1 * 3;  // no decimal number: exact only if stored as it is
  record.felt_n = 0.56;
  record.kind = study::ForceJudgement::Kind::kTerm;
  record.term = "small";
  record.scored = false;
  record.catch_trial = true;
  record.feel_again = 1;
  record.forward_mm = 8.25;
  record.forward_speed_mm_s = 17.5;
  record.response_s = 2.75;
  record.delivered_share = 0.529;
  return record;
}

study::AnswerRecord SampleRecords::answer(const study::RecordId& session, int item) {
  study::AnswerRecord record;
  record.entry = entry(session);
  record.form = "ngt_force";
  record.form_version = 2;
  record.item = item;
  record.position = 4;
  record.status = study::Answer::Status::kAnswered;
  record.value = "very_large";
  record.response_s = 3.5;
  return record;
}

study::RatingRecord SampleRecords::rating(const study::RecordId& session) { return {entry(session), "speed", 3, 6}; }

study::RuleRecord SampleRecords::rule(const study::RecordId& session) {
  study::RuleRecord record;
  record.entry = entry(session);
  record.rule.form = "ngt_force";
  record.rule.conditions = {{"speed", "fast"}, {"depth", "\"odd\""}};
  record.rule.then = "large";
  record.rule.weight = 0.5;
  return record;
}

study::ModelVersion SampleRecords::model(const std::string& text) {
  study::ModelVersion version;
  version.id = id();
  version.utc_ms = time_ms_ += 1000;
  version.author = "north";
  version.label = "after the third interview";
  version.text = text;
  return version;
}

namespace {

/// Stops with the error where a study for a test cannot be made.
template <class Outcome>
void require(const Outcome& outcome) {
  if (!outcome) std::cerr << outcome.error().message() << '\n';
  TACTUS_CHECK(outcome.has_value());
}

}  // namespace

OpenStudy makeStudy(const std::string& path, SampleRecords& records) {
  auto file = StudyFile::create(path, records.study());
  require(file);
  const auto person = records.person("velvet-otter");
  const auto session = records.session(person.id);
  require(append(*file, person));
  require(append(*file, session));
  return {*std::move(file), person, session};
}

}  // namespace tactus::store
