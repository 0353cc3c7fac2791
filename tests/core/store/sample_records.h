// Records for the tests of the study file: short to make, every field set.
#pragma once

#include <cstdint>
#include <string>

#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Makes records with ids of its own, in one session.
class SampleRecords {
 public:
  explicit SampleRecords(std::uint64_t seed = 1) : ids_(seed) {}

  study::RecordId id() { return ids_.next(); }
  NewStudy study();
  study::Person person(const std::string& code);
  study::SessionRecord session(const study::RecordId& person);
  study::Entry entry(const study::RecordId& session);

  study::ProfileRecord profile(const study::RecordId& session);
  study::EventRecord event(const study::RecordId& session);
  study::StrokeRecord stroke(const study::RecordId& session, std::size_t samples = 20);
  study::JudgementRecord judgement(const study::RecordId& session);
  study::AnswerRecord answer(const study::RecordId& session, int item = 7);
  study::RatingRecord rating(const study::RecordId& session);
  study::RuleRecord rule(const study::RecordId& session);
  study::ModelVersion model(const std::string& text);

 private:
  study::RecordIds ids_;
  std::int64_t time_ms_ = 1'770'000'000'000;
};

/// An open study with one person and one session.
struct OpenStudy {
  StudyFile file;
  study::Person person;
  study::SessionRecord session;
};

/// Makes it at `path`; a failure stops the test program.
OpenStudy makeStudy(const std::string& path, SampleRecords& records);

}  // namespace tactus::store
