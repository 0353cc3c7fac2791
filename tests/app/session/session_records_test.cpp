// What a session keeps of one answer, and what it does with a correction.
#include <algorithm>
#include <set>

#include "tests/app/session/session_fixture.h"

namespace tactus::session {
namespace {

using experiments::ForceAnswer;
using Kind = study::ForceJudgement::Kind;
using Status = study::Answer::Status;

TEST_F(SessionTest, AProfileIsCorrectedByAFurtherRecord) {
  begin(start());
  study::ProfileRecord profile;
  profile.years_experience = 3;
  ASSERT_TRUE(session_->tell(profile));
  profile.years_experience = 13;
  session_->setEnteredBy(study::EnteredBy::kResearcher);
  ASSERT_TRUE(session_->tell(profile));
  ASSERT_NE(session_->profile(), nullptr);
  EXPECT_EQ(session_->profile()->years_experience, 13);
  EXPECT_EQ(session_->part(), SessionPart::kSpeed);
  EXPECT_EQ(store::profiles(*file_)->size(), 1U);
  const auto history = store::profiles(*file_, {{}, {}, true});
  ASSERT_EQ(history->size(), 2U);
  EXPECT_EQ(history->at(0).entry.entered_by, study::EnteredBy::kParticipant);
  EXPECT_EQ(history->at(1).entry.entered_by, study::EnteredBy::kResearcher);
}

TEST_F(SessionTest, ABandOfYearsIsKeptBesideItsMiddle) {
  begin(start());
  study::ProfileRecord profile;
  profile.comfort = "good";
  ASSERT_TRUE(session_->tell(profile, *experienceBandCalled("years_3")));
  EXPECT_EQ(session_->profile()->years_experience, 12.5);
  EXPECT_EQ(store::profiles(*file_)->front().comfort, "good");
  const auto events = store::events(*file_);
  EXPECT_TRUE(std::any_of(events->begin(), events->end(), [](const study::EventRecord& event) {
    return event.kind == "experience_band" && event.detail.find("years_3") != std::string::npos;
  }));
}

TEST_F(SessionTest, HowAnAnswerWasEnteredIsStoredWithIt) {
  begin(start());
  ASSERT_TRUE(session_->tell({}));
  ASSERT_TRUE(session_->skipBlock("short"));
  ForceAnswer answer;
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.delivered_share = 1;
  while (session_->force()->next().step.series == "familiarisation") ASSERT_TRUE(session_->judge(answer));
  answer.kind = Kind::kTerm;
  answer.term = "small";
  answer.response_s = 1.2;
  const AnswerInput input{InputMeans::kDeviceButton, "large", 4};
  ASSERT_TRUE(session_->judge(answer, input));
  EXPECT_FALSE(session_->judge(answer, AnswerInput{InputMeans::kTouch, "large", 4}));
  const auto judged = store::judgements(*file_)->back();
  EXPECT_EQ(judged.delivered_share, 1);
  const auto events = store::events(*file_);
  const auto line = answerInputIn(events->back());
  ASSERT_TRUE(line && *line) << events->back().kind;
  EXPECT_EQ((*line)->record, judged.entry.id);
  EXPECT_EQ((*line)->input, input);
  const std::string before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), before);
}

TEST_F(SessionTest, WhereSheWouldStopIsStoredBesideTheWord) {
  auto with = start();
  with.settings.blocks = {Block::kForce};
  with.settings.force.familiarisation_n = {};
  with.settings.force.ladder = {0.2, 0.4, 0.2};
  with.settings.force.descending = false;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  ForceAnswer answer;
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.response_s = 2;
  answer.kind = Kind::kTerm;
  answer.term = "small";
  answer.would_stop = true;
  ASSERT_TRUE(session_->judge(answer));
  const auto said = [&] {
    const auto line = wouldStopIn(store::events(*file_)->back());
    EXPECT_TRUE(line && *line);
    EXPECT_EQ((*line)->judgement, store::judgements(*file_)->back().entry.id);
    return (*line)->would_stop;
  };
  EXPECT_TRUE(said());
  ASSERT_TRUE(session_->correctJudgement(Kind::kTerm, "small", {}, false));
  EXPECT_FALSE(said());
  // Where nobody was asked, nothing is said.
  answer.would_stop.reset();
  ASSERT_TRUE(session_->judge(answer));
  int notes = 0;
  const auto events = store::events(*file_);
  for (const auto& event : *events) {
    const auto line = wouldStopIn(event);
    if (line && *line) ++notes;
  }
  EXPECT_EQ(notes, 2);
}

TEST_F(SessionTest, TheLeastKnownQuestionIsNextAndItsReasonIsStored) {
  auto with = start();
  with.settings.blocks = {Block::kForm};
  with.settings.item_order = questionnaires::ItemOrder::kLeastKnown;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  std::set<int> asked;
  double before_n = 1;
  for (int count = 0; count < 6; ++count) {
    const auto page = session_->form()->page();
    ASSERT_TRUE(page && page->reason);
    EXPECT_TRUE(asked.insert(page->question->number).second);
    EXPECT_GT(page->reason->share, 0);
    EXPECT_LT(page->reason->unknown_n, before_n + 0.01) << "answers as expected do not make the force less known";
    before_n = page->reason->unknown_n;
    ASSERT_TRUE(session_->reply({study::Answer::Status::kAnswered, "medium"}, 2));
    const auto events = store::events(*file_);
    const auto chosen = std::find_if(events->rbegin(), events->rend(),
                                     [](const auto& event) { return event.kind == "question_chosen"; });
    ASSERT_NE(chosen, events->rend());
    EXPECT_NE(chosen->detail.find(toText(store::answers(*file_)->back().entry.id)), std::string::npos);
    EXPECT_NE(chosen->detail.find("unknown_n"), std::string::npos);
  }
  EXPECT_NE(asked, (std::set<int>{1, 2, 3, 4, 5, 6}));
  const std::string shown_before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), shown_before);
  EXPECT_EQ(store::answers(*file_)->back().position, 6);
}

TEST_F(SessionTest, FrictionOfTheDeviceCountsAtTheScale) {
  auto scaled = std::make_shared<procedure::Procedure>(*procedure::defaultProcedure());
  scaled->device_scale = 3;
  auto with = start();
  with.settings.procedure = scaled;
  with.settings.blocks = {Block::kForce};
  with.settings.force.familiarisation_n = {};
  with.settings.force.ladder = {3, 6, 3};
  with.device_friction_n = 0.1;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  EXPECT_EQ(session_->force()->next().device_scale, 3);
  ForceAnswer answer;
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.kind = Kind::kTerm;
  answer.term = "large";
  ASSERT_TRUE(session_->judge(answer));
  EXPECT_DOUBLE_EQ(*store::judgements(*file_)->back().felt_n, 3.3);
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(session_->force()->next().device_scale, 3);
  EXPECT_EQ(session_->force()->next().step.force_n, 6);
}

TEST_F(SessionTest, ACorrectedJudgementIsARecordOfItsOwnAndCountsInstead) {
  auto with = start();
  with.settings.blocks = {Block::kForce};
  with.settings.force.familiarisation_n = {};
  with.settings.force.ladder = {0.2, 0.4, 0.2};
  with.settings.force.descending = false;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  EXPECT_FALSE(session_->correctJudgement(Kind::kTerm, "small")) << "nothing was judged";
  ForceAnswer answer;
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.response_s = 2;
  answer.kind = Kind::kBeyondPractice;
  ASSERT_TRUE(session_->judge(answer));
  EXPECT_EQ(session_->part(), SessionPart::kRating) << "beyond practice ends the ascending series";
  EXPECT_FALSE(session_->correctJudgement(Kind::kTerm, "no_such_term"));
  // A slip: she meant a word, so the series continues.
  ASSERT_TRUE(session_->correctJudgement(Kind::kTerm, "small", AnswerInput{InputMeans::kMouse, "", 0}));
  EXPECT_EQ(session_->part(), SessionPart::kForce);
  ASSERT_TRUE(session_->correctJudgement(Kind::kTerm, "medium"));
  const auto now = *store::judgements(*file_);
  ASSERT_EQ(now.size(), 1U);
  EXPECT_EQ(now[0].term, "medium");
  EXPECT_EQ(now[0].forward_mm, 40);
  EXPECT_EQ(now[0].response_s, 2);
  EXPECT_TRUE(now[0].scored);
  const auto all = *store::judgements(*file_, {{}, {}, true});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].kind, Kind::kBeyondPractice);
  EXPECT_EQ(all[1].entry.supersedes, all[0].entry.id);
  EXPECT_EQ(all[2].entry.supersedes, all[1].entry.id);
  const std::string before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), before);
  EXPECT_EQ(session_->force()->next().step.force_n, 0.4);
}

TEST_F(SessionTest, AnAnswerThatCameVerySoonOrVeryLateIsMarkedAndCounts) {
  auto with = start();
  with.settings.blocks = {Block::kForm};
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  for (const double response_s : {0.29, 0.3, 30.0, 30.1}) {
    ASSERT_TRUE(session_->reply({Status::kAnswered, "medium"}, response_s));
  }
  const auto answers = *store::answers(*file_);
  ASSERT_EQ(answers.size(), 4U);
  std::vector<std::pair<study::RecordId, ResponseMark>> marked;
  const auto events = *store::events(*file_);
  for (const auto& event : events) {
    if (const auto line = *responseMarkIn(event)) marked.emplace_back(line->record, line->mark);
  }
  const std::vector<std::pair<study::RecordId, ResponseMark>> wanted = {{answers[0].entry.id, ResponseMark::kSoon},
                                                                        {answers[3].entry.id, ResponseMark::kLate}};
  EXPECT_EQ(marked, wanted);
}

TEST_F(SessionTest, NotesGoToTheLogAndSteerNothing) {
  begin(start());
  ASSERT_TRUE(session_->note(languageChosen("zh-Hant")));
  ASSERT_TRUE(session_->note({kForceOff, {}}));
  EXPECT_FALSE(session_->note({"aborted", {}}));
  EXPECT_FALSE(session_->note({"", {}}));
  EXPECT_FALSE(session_->note({"odd", "no JSON"}));
  EXPECT_EQ(session_->part(), SessionPart::kProfile);
  EXPECT_EQ(store::events(*file_)->size(), 3U);
  ASSERT_TRUE(session_->abort("stop"));
  EXPECT_TRUE(session_->note(researcherNote("felt dizzy"))) << "also after the end";
}

TEST_F(SessionTest, AStrokeTakenBackIsAskedForAgain) {
  auto settings = shortSession();
  settings.speed.practice = 0;
  begin(start(settings));
  base::Random random(4);
  ASSERT_NO_FATAL_FAILURE(doNext(random));
  while (session_->speed()->next().accepted < 2) ASSERT_NO_FATAL_FAILURE(doNext(random));
  const auto strokes = store::strokes(*file_);
  ASSERT_TRUE(strokes);
  const auto& last = strokes->back();
  ASSERT_TRUE(session_->rejectStroke(last.entry.id, "coughed"));
  EXPECT_EQ(session_->speed()->next().accepted, 1);
  EXPECT_EQ(session_->speed()->next().number, last.number);
  const std::string before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), before);
}

}  // namespace
}  // namespace tactus::session
