#include "app/session/study_view.h"

#include <filesystem>
#include <gtest/gtest.h>

#include "app/session/session.h"
#include "app/session/session_state.h"
#include "app/session/study_import.h"
#include "core/store/entries.h"
#include "core/store/merge.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "questionnaires/form_file.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/default_procedure.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

constexpr std::int64_t kMonday = 1'770'000'000'000;
constexpr std::int64_t kDay = 86'400'000;

/// A plan of two strokes at a level and a ladder of two forces.
SessionSettings shortPlan() {
  SessionSettings settings;
  settings.speed.strokes = 2;
  settings.force.familiarisation_n.clear();
  settings.force.ladder = {0.1, 0.2, 0.1};
  return settings;
}

class CountedSessions : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  /// A session that began at `utc_ms`, without a log.
  study::RecordId session(std::int64_t utc_ms) {
    auto session = records_.session(study_.person.id);
    session.started.utc_ms = utc_ms;
    session.settings = toJson(shortPlan());
    EXPECT_TRUE(append(study_.file, session));
    return session.id;
  }

  /// The same through the program, which writes the log.
  study::RecordId begun(store::StudyFile& file, std::int64_t utc_ms) {
    SessionStart start;
    start.person = study_.person.id;
    start.consent_version = "1";
    start.settings = shortPlan();
    const SessionTools tools{[utc_ms] { return study::Moment{utc_ms, 0}; }, study::RecordIds(++seed_)};
    const auto begun = Session::begin(file, start, tools);
    EXPECT_TRUE(begun) << begun.error().message();
    return begun->record().id;
  }

  /// `count` accepted strokes of 21 samples or more: how many tells in the view which session they are of.
  void addStrokes(store::StudyFile& file, const study::RecordId& session, int count, std::size_t samples) {
    for (int i = 1; i <= count; ++i) {
      auto stroke = records_.stroke(session, samples);
      stroke.level = "slow";
      stroke.number = i;
      stroke.practice = false;
      stroke.verdict = "accepted";
      stroke.first = 0;
      stroke.last = samples;
      const auto added = append(file, stroke);
      ASSERT_TRUE(added) << added.error().message();
    }
  }

  void addJudgements(const study::RecordId& session, int count, const std::string& term) {
    for (int i = 1; i <= count; ++i) {
      auto judgement = records_.judgement(session);
      judgement.series = "ascending";
      judgement.step = i;
      judgement.attempt = 1;
      judgement.commanded_n = 0.1 * i;
      judgement.felt_n.reset();
      judgement.kind = study::ForceJudgement::Kind::kTerm;
      judgement.term = term;
      judgement.scored = true;
      judgement.catch_trial = false;
      ASSERT_TRUE(append(study_.file, judgement));
    }
  }

  void addAnswers(const study::RecordId& session, int count, const std::string& value) {
    for (int i = 1; i <= count; ++i) {
      auto answer = records_.answer(session, i);
      answer.form = support::ngtForceForm().id;
      answer.status = study::Answer::Status::kAnswered;
      answer.value = value;
      ASSERT_TRUE(append(study_.file, answer));
    }
  }

  static StudyView viewOf(const store::StudyFile& file) {
    auto view = studyForElicitation(file);
    EXPECT_TRUE(view) << view.error().message();
    return view ? std::move(*view) : StudyView{};
  }
  std::size_t samples() const { return viewOf(study_.file).study.speeds.size(); }

  support::TempFolder folder_;
  store::SampleRecords records_;
  store::OpenStudy study_ = store::makeStudy(path("a.tactus"), records_);
  std::uint64_t seed_ = 0;
};

TEST_F(CountedSessions, AnAbortedOneDoesNotTakeThePlaceOfACompleteOne) {
  const auto complete = session(kMonday);
  addStrokes(study_.file, complete, 2, 30);
  addJudgements(complete, 2, "small");
  addAnswers(complete, 45, "large");
  const auto aborted = session(kMonday + kDay);
  addStrokes(study_.file, aborted, 1, 50);
  addJudgements(aborted, 1, "large");
  addAnswers(aborted, 3, "small");

  const auto view = viewOf(study_.file);
  EXPECT_EQ(view.study.speeds.size(), 60U);
  ASSERT_EQ(view.study.judgements.size(), 2U);
  EXPECT_EQ(view.study.judgements[0].term, "small");
  ASSERT_EQ(view.study.answers.size(), 45U);
  EXPECT_EQ(view.study.answers[0].term, "large");
  // 1770000000 s is 2026-02-02T02:40:00Z (date -u -d @1770000000).
  const std::string counted = "2026-02-02T02:40:00Z (complete, records 2, session " + toText(complete).substr(0, 8);
  const std::string other = "2026-02-03T02:40:00Z (not complete, records 1, session " + toText(aborted).substr(0, 8);
  ASSERT_EQ(view.notes.size(), 3U);
  EXPECT_EQ(view.notes[0], "velvet-otter did the speed 'slow' in more than one session: the one of " + counted +
                               ") counts, not the one of " + other + ").");
  EXPECT_NE(view.notes[1].find("the series 'ascending'"), std::string::npos);
  EXPECT_NE(view.notes[2].find("the form 'ngt-force-v1'"), std::string::npos);
}

/// The study of one real person whose session used `device`, with two strokes and two scored judgements, and the view.
StudyView viewWithDevice(const std::string& path, const std::string& device, VirtualStrokes strokes) {
  store::SampleRecords records;
  auto study = store::makeStudy(path, records);
  study::Person person{study::RecordIds(77).next(), "real-otter", false};
  EXPECT_TRUE(store::append(study.file, person));
  auto session = records.session(person.id);
  session.device = device;
  SessionSettings settings = shortPlan();
  settings.virtual_strokes = strokes;
  session.settings = toJson(settings);
  EXPECT_TRUE(append(study.file, session));
  for (int i = 1; i <= 2; ++i) {
    auto stroke = records.stroke(session.id, 30);
    stroke.level = "slow";
    stroke.number = i;
    stroke.practice = false;
    stroke.verdict = "accepted";
    stroke.first = 0;
    stroke.last = 30;
    EXPECT_TRUE(append(study.file, stroke));
    auto judgement = records.judgement(session.id);
    judgement.series = "ascending";
    judgement.step = i;
    judgement.attempt = 1;
    judgement.commanded_n = 0.1 * i;
    judgement.felt_n.reset();
    judgement.kind = study::ForceJudgement::Kind::kTerm;
    judgement.term = "small";
    judgement.scored = true;
    judgement.catch_trial = false;
    EXPECT_TRUE(append(study.file, judgement));
  }
  auto view = studyForElicitation(study.file);
  EXPECT_TRUE(view) << view.error().message();
  return view ? std::move(*view) : StudyView{};
}

// Studies of before sessions knew this hold such judgements as scored.
TEST(DevicesWithoutForce, NothingJudgedThereCounts) {
  const support::TempFolder folder;
  int number = 0;
  const auto view = [&](const std::string& device, VirtualStrokes strokes = VirtualStrokes::kPractice) {
    return viewWithDevice(folder.file(std::to_string(++number) + ".tactus"), device, strokes);
  };
  for (const char* const device : {"virtual", "replay:a.csv", "Dummy device", "disconnected", "simulated"}) {
    SCOPED_TRACE(device);
    const auto found = view(device);
    EXPECT_TRUE(found.study.judgements.empty());
    EXPECT_TRUE(found.study.speeds.empty());
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_EQ(found.notes[0],
              "VIRTUAL: real-otter moved a device that gives no force. 2 judgements were not delivered to the hand and "
              "not counted; 2 strokes taken as practice.");
  }
  const auto accepted = view("virtual", VirtualStrokes::kAccepted);
  EXPECT_TRUE(accepted.study.judgements.empty());
  EXPECT_EQ(accepted.study.speeds.size(), 60U);
  EXPECT_NE(accepted.notes[0].find("virtual = accepted"), std::string::npos);
  for (const char* const device : {"hid:1209:ffb0:1234", "openhaptics:Default Device", ""}) {
    SCOPED_TRACE(device);
    const auto found = view(device);
    EXPECT_EQ(found.study.judgements.size(), 2U);
    EXPECT_EQ(found.study.speeds.size(), 60U);
    EXPECT_TRUE(found.notes.empty());
  }
}

TEST_F(CountedSessions, EachNumberNamesTheRecordBehindIt) {
  const auto first = session(kMonday);
  addJudgements(first, 2, "small");
  addAnswers(first, 3, "large");
  auto rule = records_.rule(first);
  ASSERT_TRUE(append(study_.file, rule));
  auto correction = store::judgements(study_.file)->front();
  correction.entry.supersedes = correction.entry.id;
  correction.entry.id = records_.id();
  correction.term = "medium";
  ASSERT_TRUE(append(study_.file, correction));

  const auto view = viewOf(study_.file);
  ASSERT_EQ(view.judgement_ids.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool corrected = view.judgement_ids[i] == correction.entry.id;
    EXPECT_EQ(view.study.judgements[i].term, corrected ? "medium" : "small");
    EXPECT_EQ(view.study.judgements[i].step, corrected ? 1 : 2);
  }
  ASSERT_EQ(view.answer_ids.size(), view.study.answers.size());
  EXPECT_EQ(view.answer_ids[2], store::answers(study_.file)->at(2).entry.id);
  EXPECT_EQ(view.rule_ids, std::vector{rule.entry.id});
}

TEST_F(CountedSessions, TheLatestOfSeveralCompleteOnes) {
  const auto first = session(kMonday);
  const auto second = session(kMonday + kDay);
  addStrokes(study_.file, second, 2, 50);
  addStrokes(study_.file, first, 3, 30);
  EXPECT_EQ(samples(), 100U);
}

TEST_F(CountedSessions, WithoutACompleteOneTheOneWithMost) {
  auto settings = shortPlan();
  settings.speed.strokes = 4;
  std::vector<study::RecordId> ids;
  for (int day = 0; day < 3; ++day) {
    auto one = records_.session(study_.person.id);
    one.started.utc_ms = kMonday + day * kDay;
    one.settings = toJson(settings);
    ASSERT_TRUE(append(study_.file, one));
    ids.push_back(one.id);
  }
  addStrokes(study_.file, ids[0], 2, 30);
  addStrokes(study_.file, ids[1], 1, 50);
  EXPECT_EQ(samples(), 60U);
  addStrokes(study_.file, ids[2], 2, 70);
  EXPECT_EQ(samples(), 140U) << "of as many, the latest";
}

TEST_F(CountedSessions, AClockThatWasSetBackChangesNothing) {
  const auto first = begun(study_.file, kMonday);
  addStrokes(study_.file, first, 2, 30);
  const auto second = begun(study_.file, kMonday - 1000 * kDay);
  addStrokes(study_.file, second, 2, 50);
  EXPECT_EQ(samples(), 100U);
  const auto third = begun(study_.file, kMonday - 500 * kDay);
  addStrokes(study_.file, third, 2, 70);
  EXPECT_EQ(samples(), 140U);
  const auto ordered = sessionsInOrder(study_.file, study_.person.id);
  ASSERT_TRUE(ordered);
  std::vector<study::RecordId> ids;
  for (const auto& one : *ordered) ids.push_back(one.id);
  EXPECT_EQ(std::vector(ids.end() - 3, ids.end()), (std::vector{first, second, third}));
}

TEST_F(CountedSessions, TheOrderOfMergesChangesNothing) {
  const auto first = begun(study_.file, kMonday);
  addStrokes(study_.file, first, 2, 30);
  ASSERT_TRUE(study_.file.close());
  std::filesystem::copy_file(path("a.tactus"), path("b.tactus"));
  auto a = store::StudyFile::open(path("a.tactus"));
  auto b = store::StudyFile::open(path("b.tactus"));
  ASSERT_TRUE(a && b);
  // On the first station the clock is set back; on the other it is right.
  addStrokes(*a, begun(*a, kMonday - 9 * kDay), 2, 50);
  addStrokes(*b, begun(*b, kMonday - 5 * kDay), 2, 70);
  for (auto* file : {&*a, &*b}) ASSERT_TRUE(file->close());
  for (const auto& [into, from] : {std::pair("a.tactus", "b.tactus"), std::pair("b.tactus", "a.tactus")}) {
    std::filesystem::copy_file(path(into), path("c.tactus"), std::filesystem::copy_options::overwrite_existing);
    auto merged = store::StudyFile::open(path("c.tactus"));
    ASSERT_TRUE(merged);
    ASSERT_TRUE(store::mergeStudy(*merged, path(from), records_.id(), 1));
    EXPECT_EQ(viewOf(*merged).study.speeds.size(), 140U) << "both came after the first; of the two, the later by time";
    ASSERT_TRUE(merged->close());
  }
}

}  // namespace
}  // namespace tactus::session
