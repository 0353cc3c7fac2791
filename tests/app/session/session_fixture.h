// A session of a study with one person, and a person who does whatever the session asks for.
#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/session/session.h"
#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

#include "tests/support/temp_folder.h"

namespace tactus::session {

/// A session short enough to try every moment of it.
inline SessionSettings shortSession() {
  SessionSettings settings;
  settings.speed.strokes = 2;
  settings.speed.order = experiments::SpeedSettings::Order::kShuffled;
  settings.force.descending = true;
  settings.item_order = questionnaires::ItemOrder::kShuffled;
  return settings;
}

/// Time that advances by 7 ms with each look.
inline SessionTools steadyTools(std::uint64_t seed) {
  return {[moment = study::Moment{1'700'000'000'000, 0}]() mutable {
            moment.utc_ms += 7;
            moment.monotonic_ns += 7'000'000;
            return moment;
          },
          study::RecordIds(seed)};
}

/// A study with one person, and a person who does whatever the session asks for.
class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    auto created = store::StudyFile::create(path_, {ids_.next(), "test", 1, "test"});
    ASSERT_TRUE(created) << created.error().message();
    file_.emplace(*std::move(created));
    person_ = {ids_.next(), "amber-otter", false};
    ASSERT_TRUE(store::append(*file_, person_));
  }

  SessionStart start(SessionSettings settings = shortSession()) {
    SessionStart start;
    start.person = person_.id;
    start.consent_version = "2026-1";
    start.seed = 11;
    start.program = "test";
    start.settings = std::move(settings);
    return start;
  }

  void begin(const SessionStart& with) {
    auto begun = Session::begin(*file_, with, steadyTools(++tools_seed_));
    ASSERT_TRUE(begun) << begun.error().message();
    session_.emplace(*std::move(begun));
  }

  /// As after a crash: the file is closed and opened, the session read back.
  void restart() {
    const auto id = session_->record().id;
    session_.reset();
    file_.reset();
    auto file = store::StudyFile::open(path_);
    ASSERT_TRUE(file) << file.error().message();
    file_.emplace(*std::move(file));
    auto again = Session::resume(*file_, id, steadyTools(++tools_seed_));
    ASSERT_TRUE(again) << again.error().message();
    session_.emplace(*std::move(again));
  }

  /// Does what the session asks for next, not always well.
  void doNext(base::Random& random) {
    base::Result<void> done;
    switch (session_->part()) {
      case SessionPart::kProfile: {
        study::ProfileRecord profile;
        profile.years_experience = 12;
        profile.category = "expert";
        done = session_->tell(profile);
        break;
      }
      case SessionPart::kSpeed: {
        experiments::Stroke stroke{2, 8, 0.002, 0.007, 0, 60, experiments::StrokeVerdict::kAccepted};
        if (random.below(4) == 0) stroke.verdict = experiments::StrokeVerdict::kTooShort;
        study::Recording recording{1000, {{"depth", "mm", {0, 0, 5, 15, 30, 45, 55, 60, 60, 60}}}};
        done = session_->addStroke(stroke, recording, 0);
        break;
      }
      case SessionPart::kForce: {
        experiments::ForceAnswer answer;
        answer.forward_mm = random.below(5) == 0 ? 0 : 40;
        answer.forward_speed_mm_s = 60;
        answer.response_s = 1.5;
        answer.delivered = random.below(6) != 0;
        const auto plan = session_->force()->next();
        if (!plan.question.answers.empty()) {
          const bool enough = plan.step.force_n > 0.55;
          answer.kind = enough ? study::ForceJudgement::Kind::kBeyondPractice : study::ForceJudgement::Kind::kTerm;
          if (!enough) answer.term = "small";
        }
        done = session_->judge(answer);
        break;
      }
      case SessionPart::kForm: {
        const int which = random.below(10);
        if (which == 0) {
          done = session_->reply({study::Answer::Status::kSkipped, {}}, 2);
        } else if (which == 1) {
          done = session_->reply({study::Answer::Status::kCantTell, {}}, 2);
        } else {
          done = session_->reply({study::Answer::Status::kAnswered, "medium"}, 2);
        }
        break;
      }
      case SessionPart::kRating: done = session_->rate(2, 6); break;
      case SessionPart::kFinished:
      case SessionPart::kAborted: FAIL() << "nothing is left to do";
    }
    ASSERT_TRUE(done) << done.error().message();
  }

  /// Everything that a screen would show.
  std::string shown() const {
    std::string text(name(session_->part()));
    text += ' ' + std::to_string(session_->blocksDone());
    if (session_->part() == SessionPart::kSpeed) {
      const auto plan = session_->speed()->next();
      text += ' ' + plan.level + ' ' + std::to_string(plan.number) + ' ' + std::to_string(plan.attempt) +
              (plan.repeat_reason.empty() ? "" : " again");
    }
    if (session_->part() == SessionPart::kForce) {
      const auto plan = session_->force()->next();
      text += ' ' + plan.step.series + ' ' + std::to_string(plan.step.step) + ' ' + std::to_string(plan.attempt) + ' ' +
              std::to_string(plan.step.force_n);
    }
    if (session_->part() == SessionPart::kForm) {
      text += ' ' + std::to_string(session_->form()->page()->question->number) + ' ' +
              std::to_string(session_->form()->page()->position);
    }
    return text;
  }

  support::TempFolder folder_;
  std::string path_ = folder_.file("study.tactus");
  study::RecordIds ids_{99};
  study::Person person_;
  std::optional<store::StudyFile> file_;
  std::optional<Session> session_;
  std::uint64_t tools_seed_ = 100;
};

}  // namespace tactus::session
