#include "app/workbench/participant/participant_course.h"

#include <gtest/gtest.h>

namespace tactus::workbench {
namespace {

using session::Block;
using session::SessionPart;
using Screen = ParticipantScreen;

SessionSnapshot at(SessionPart part, std::optional<Block> block = {}) {
  SessionSnapshot out;
  out.part = part;
  out.block = block;
  out.settings = std::make_shared<const session::SessionSettings>();
  out.speed.emplace();
  out.force.emplace();
  out.page = ItemPage{1, 1, 45, {}};
  return out;
}

CoursePassed ready() {
  CoursePassed out;
  out.code = out.device = out.glossary = true;
  return out;
}

TEST(ParticipantCourse, BeforeTheSessionItIsTheCodeThenTheConsent) {
  CoursePassed passed;
  EXPECT_EQ(screenOf(nullptr, passed), Screen::kWelcome);
  passed.code = true;
  EXPECT_EQ(screenOf(nullptr, passed), Screen::kConsent);
  passed.stopped = true;
  EXPECT_EQ(screenOf(nullptr, passed), Screen::kStopped);
}

TEST(ParticipantCourse, WhatNeedsTheDeviceWaitsForItsCheck) {
  CoursePassed passed = ready();
  auto speed = at(SessionPart::kSpeed, Block::kSpeed);
  EXPECT_EQ(screenOf(&speed, passed), Screen::kSpeed);
  speed.speed->practice = true;
  EXPECT_EQ(screenOf(&speed, passed), Screen::kPractice);
  passed.device = false;
  EXPECT_EQ(screenOf(&speed, passed), Screen::kDeviceCheck);
  const auto form = at(SessionPart::kForm, Block::kForm);
  EXPECT_EQ(screenOf(&form, passed), Screen::kQuestion) << "questions need no device";
}

TEST(ParticipantCourse, ARestComesOnceBeforeItsForce) {
  CoursePassed passed = ready();
  auto force = at(SessionPart::kForce, Block::kForce);
  force.force->step = {"ascending", 7, 0.7, false};
  EXPECT_EQ(screenOf(&force, passed), Screen::kForce);
  force.force->question.rest_first = true;
  EXPECT_EQ(screenOf(&force, passed), Screen::kRest);
  passed.rests.insert(restBefore(force, passed));
  EXPECT_EQ(screenOf(&force, passed), Screen::kForce);
  force.force->attempt = 2;
  EXPECT_EQ(screenOf(&force, passed), Screen::kRest) << "another attempt may need another rest";
}

TEST(ParticipantCourse, AfterThePracticeACardSaysThatItCounts) {
  CoursePassed passed = ready();
  auto force = at(SessionPart::kForce, Block::kForce);
  force.force->step = {"familiarisation", 1, 0.5, false};
  EXPECT_EQ(screenOf(&force, passed), Screen::kPractice);
  force.force->step = {"ascending", 1, 0.1, false};
  EXPECT_EQ(screenOf(&force, passed), Screen::kRest);
  EXPECT_EQ(restBefore(force, passed), kBeginsToCount);
  passed.rests.insert(kBeginsToCount);
  EXPECT_EQ(screenOf(&force, passed), Screen::kForce);
  auto unpractised = std::make_shared<session::SessionSettings>();
  unpractised->force.familiarisation_n.clear();
  force.settings = unpractised;
  EXPECT_EQ(screenOf(&force, ready()), Screen::kForce);
}

TEST(ParticipantCourse, APartIsRatedAndThenComesARest) {
  CoursePassed passed = ready();
  const auto rating = at(SessionPart::kRating, Block::kSpeed);
  EXPECT_EQ(screenOf(&rating, passed), Screen::kRating);
  auto force = at(SessionPart::kForce, Block::kForce);
  force.blocks_done = 1;
  EXPECT_EQ(screenOf(&force, passed), Screen::kRest);
  passed.rests.insert(restBefore(force, passed));
  EXPECT_EQ(screenOf(&force, passed), Screen::kForce);
  CoursePassed back_again = ready();
  back_again.blocks = 1;
  EXPECT_EQ(screenOf(&force, back_again), Screen::kForce) << "she has just sat down";
}

TEST(ParticipantCourse, ATeacherIsAskedTheStatementsAlone) {
  const CoursePassed passed = ready();
  study::SessionRecord record;
  record.kind = study::SessionKind::kUsability;
  for (const SessionPart part : {SessionPart::kProfile, SessionPart::kForm, SessionPart::kRating}) {
    auto form = at(part, Block::kForm);
    form.record = std::make_shared<const study::SessionRecord>(record);
    EXPECT_EQ(screenOf(&form, passed), Screen::kScale);
  }
  auto done = at(SessionPart::kFinished);
  done.record = std::make_shared<const study::SessionRecord>(record);
  EXPECT_EQ(screenOf(&done, passed), Screen::kThanks);
}

TEST(ParticipantCourse, ARestComesEveryFifteenQuestions) {
  CoursePassed passed = ready();
  passed.replies = 15;
  auto form = at(SessionPart::kForm, Block::kForm);
  form.page->position = 15;
  EXPECT_EQ(screenOf(&form, passed), Screen::kQuestion);
  form.page->position = 16;
  EXPECT_EQ(screenOf(&form, passed), Screen::kRest);
  form.page->reply = questionnaires::Reply{study::Answer::Status::kCantTell, {}};
  EXPECT_EQ(screenOf(&form, passed), Screen::kQuestion) << "she only looks back";
  form.page->reply.reset();
  passed.replies = 0;
  EXPECT_EQ(screenOf(&form, passed), Screen::kQuestion) << "she has just sat down";
}

TEST(ParticipantCourse, TheEndIsReviewOwnModelThanks) {
  CoursePassed passed = ready();
  const auto rating = at(SessionPart::kRating, Block::kForm);
  EXPECT_EQ(screenOf(&rating, passed), Screen::kReview);
  passed.sealing = true;
  EXPECT_EQ(screenOf(&rating, passed), Screen::kRating);
  auto done = at(SessionPart::kFinished);
  EXPECT_EQ(screenOf(&done, passed), Screen::kOwnModel) << "a session without questions";
  done.form = std::make_shared<const questionnaires::Questionnaire>();
  EXPECT_EQ(screenOf(&done, passed), Screen::kReview) << "her answers are locked";
  passed.sealed = true;
  EXPECT_EQ(screenOf(&done, passed), Screen::kOwnModel);
  passed.own_model = true;
  EXPECT_EQ(screenOf(&done, passed), Screen::kThanks);
  const auto aborted = at(SessionPart::kAborted);
  EXPECT_EQ(screenOf(&aborted, passed), Screen::kStopped);
}

}  // namespace
}  // namespace tactus::workbench
