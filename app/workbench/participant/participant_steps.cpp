// The steps of the nurse's course without the device: arrival, questions, answers, rests, the end.
#include "app/workbench/participant/participant_steps.h"

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/consent_text.h"
#include "app/workbench/participant/kit/pages.h"
#include "app/workbench/participant/questions.h"

namespace tactus::workbench {

/// Inside ParticipantController, so that they reach what the steps share.
struct ParticipantController::PlainSteps {
  class Welcome;
  class Consent;
  class AboutHer;
  class Rest;
  class Glossary;
  class Question;
  class Review;
  class Rating;
  class Scale;
  class End;
};

class ParticipantController::PlainSteps::Welcome final : public Step {
 public:
  using Step::Step;

  std::string question() const override { return std::to_string(static_cast<int>(course_.state_.welcome.step)); }
  void show(ParticipantState& state) override {
    state.can_go_on = course_.check_in_.isKnown();
    state.can_go_back = state.can_go_on && !course_.check_in_.isPrepared();
  }
  void next() override {
    if (course_.check_in_.hasSession()) {
      course_.resumes_ = true;
      course_.check_in_.resume();
    } else {
      course_.passed_.code = true;
    }
  }
  void back() override { course_.check_in_.forget(); }
};

class ParticipantController::PlainSteps::Consent final : public Step {
 public:
  using Step::Step;

  void show(ParticipantState& state) override {
    const bool usability = course_.check_in_.isForUsability();
    state.consent = {course_.plan_.consent_version, consentParagraphs(course_.plan_, language(), usability), usability};
    state.can_go_back = true;
  }
  /// Agrees.
  void next() override {
    const QString& id = course_.state_.language;
    course_.consent_language_ = id;
    course_.consent_text_ = consentText(course_.plan_, course_.state_.consent.paragraphs, language());
    course_.check_in_.begin(id, course_.plan_.seed ? *course_.plan_.seed : course_.chance_(),
                            course_.plan_.device.toStdString());
  }
  void back() override { course_.passed_.code = false; }

 private:
  nurse::Language language() const { return nurse::Language{course_.state_.language}; }
};

class ParticipantController::PlainSteps::AboutHer final : public Step {
 public:
  using Step::Step;

  std::string question() const override { return std::to_string(static_cast<int>(about_.state().question)); }
  void show(ParticipantState& state) override {
    state.about = about_.state();
    state.page = aboutYouPage(state.about);
    state.can_go_on = about_.isAnswered();
    state.can_go_back = !about_.isFirst();
  }
  void choose(const QString& id) override { about_.choose(id); }
  void next() override {
    if (about_.isLast()) {
      if (about_.state().chosen == QLatin1String("no")) course_.proxy_.note({session::kDiscomfort, {}});
      course_.proxy_.tell(course_.at()->step, about_.profile(), about_.experience());
    } else {
      about_.next();
    }
  }
  void back() override { about_.back(); }

 private:
  AboutYou about_;
};

class ParticipantController::PlainSteps::Rest final : public Step {
 public:
  using Step::Step;

  void show(ParticipantState& state) override {
    state.can_go_back = course_.at()->judged.has_value();
    state.page = restPage(rest() == kBeginsToCount);
  }
  void next() override {
    const std::string had = rest();
    course_.passed_.rests.insert(had);
    course_.passed_.replies = 0;
    if (had != kBeginsToCount) course_.proxy_.note({session::kRested, {}});
  }
  void back() override { course_.correcting_ = !course_.correcting_; }

 private:
  std::string rest() const { return restBefore(*course_.at(), course_.passed_); }
};

class ParticipantController::PlainSteps::Glossary final : public Step {
 public:
  using Step::Step;

  void next() override { course_.passed_.glossary = true; }
};

class ParticipantController::PlainSteps::Question final : public Step {
 public:
  using Step::Step;

  void ask() override { course_.chosen_ = wordOf(page().reply); }
  void show(ParticipantState& state) override {
    if (course_.form_) state.question = questionState(course_.about(), *course_.form_, page(), course_.chosen_);
    state.question.from_review = course_.from_review_;
    state.can_go_on = !course_.chosen_.isEmpty();
    state.can_go_back = page().position > 1;
  }
  void choose(const QString& id) override {
    if (course_.form_ && replyOf(*course_.form_, id)) course_.chosen_ = id;
  }
  void next() override {
    const SessionStep step = course_.at()->step;
    const bool answered = page().reply.has_value();
    if (answered && wordOf(page().reply) == course_.chosen_) {
      course_.from_review_ ? course_.proxy_.goOn(step) : course_.proxy_.forward(step);
      return;
    }
    const auto reply = *replyOf(*course_.form_, course_.chosen_);
    if (course_.proxy_.reply(step, reply, course_.responseS(), course_.answerInput()) && !answered) ++course_.replies_;
  }
  void back() override {
    course_.from_review_ = false;
    course_.proxy_.back(course_.at()->step);
  }

 private:
  const ItemPage& page() const { return *course_.at()->page; }
};

class ParticipantController::PlainSteps::Review final : public Step {
 public:
  using Step::Step;

  void ask() override { course_.from_review_ = false; }
  void show(ParticipantState& state) override {
    if (course_.form_) state.review = reviewState(course_.about(), *course_.form_, course_.at()->replies);
    state.review.sealed = isSealed();
  }
  void next() override {
    if (isSealed()) {
      course_.passed_.sealed = true;
    } else {
      course_.passed_.sealing = true;
    }
  }

 private:
  bool isSealed() const { return course_.at()->part == session::SessionPart::kFinished; }
};

class ParticipantController::PlainSteps::Rating final : public Step {
 public:
  using Step::Step;

  std::string question() const override { return rating().isFirst() ? "effort" : "comfort"; }
  void show(ParticipantState& state) override {
    state.page = rating().page();
    state.can_go_on = rating().isAnswered();
    state.can_go_back = !rating().isFirst() || course_.passed_.sealing || course_.at()->judged;
  }
  void choose(const QString& id) override { rating().choose(id); }
  void next() override {
    const SessionSnapshot& at = *course_.at();
    const bool first = rating().isFirst();
    const bool all = rating().next();
    if (first && rating().effort()) {
      course_.proxy_.note(session::effortRated(std::string(name(*at.block)), *rating().effort()));
    }
    if (!all) return;
    const bool stored = rating().effort() && rating().comfort()
                            ? course_.proxy_.rate(at.step, *rating().effort(), *rating().comfort())
                            : course_.proxy_.closeBlock(at.step);
    if (stored && course_.passed_.sealing) course_.proxy_.note({session::kAnswersSealed, {}});
  }
  void back() override {
    if (!rating().isFirst()) {
      rating().back();
    } else if (course_.passed_.sealing) {
      course_.passed_.sealing = false;
    } else {
      course_.correcting_ = true;
    }
  }

 private:
  BlockRating& rating() const { return course_.rating_; }
};

class ParticipantController::PlainSteps::Scale final : public Step {
 public:
  using Step::Step;

  void ask() override {
    if (page() && page()->reply) course_.chosen_ = QString::fromStdString(page()->reply->value);
  }
  void show(ParticipantState& state) override {
    state.can_go_on = !course_.chosen_.isEmpty();
    if (!page()) return;  // the last answer ends it
    state.page = statementPage(page()->item, static_cast<int>(page()->position), static_cast<int>(page()->count),
                               course_.chosen_);
    state.can_go_on = state.can_go_on && course_.at()->part == session::SessionPart::kForm;
    state.can_go_back = page()->position > 1;
  }
  void choose(const QString& id) override {
    if (scalePoints(id)) course_.chosen_ = id;
  }
  void next() override {
    const auto& before = page()->reply;
    if (before && QString::fromStdString(before->value) == course_.chosen_) {
      course_.proxy_.forward(course_.at()->step);
    } else {
      course_.proxy_.reply(course_.at()->step, {study::Answer::Status::kAnswered, course_.chosen_.toStdString()},
                           course_.responseS(), course_.answerInput());
    }
  }
  void back() override { course_.proxy_.back(course_.at()->step); }

 private:
  const std::optional<ItemPage>& page() const { return course_.at()->page; }
};

/// Thanks, or stopped: the device rests, and the next participant may sit down.
class ParticipantController::PlainSteps::End final : public Step {
 public:
  using Step::Step;

  void ask() override { course_.stopDevice(); }
  void show(ParticipantState& state) override {
    state.thanks.curve = course_.own_->curve();
    state.page = stoppedPage(state.stop, state.code);
  }
  void next() override { course_.ended_ = true; }
};

ParticipantController::Steps ParticipantController::allSteps(ParticipantController& course) {
  Steps steps;
  steps[ParticipantScreen::kWelcome] = std::make_unique<PlainSteps::Welcome>(course);
  steps[ParticipantScreen::kConsent] = std::make_unique<PlainSteps::Consent>(course);
  steps[ParticipantScreen::kAboutYou] = std::make_unique<PlainSteps::AboutHer>(course);
  steps[ParticipantScreen::kRest] = std::make_unique<PlainSteps::Rest>(course);
  steps[ParticipantScreen::kGlossary] = std::make_unique<PlainSteps::Glossary>(course);
  steps[ParticipantScreen::kQuestion] = std::make_unique<PlainSteps::Question>(course);
  steps[ParticipantScreen::kReview] = std::make_unique<PlainSteps::Review>(course);
  steps[ParticipantScreen::kRating] = std::make_unique<PlainSteps::Rating>(course);
  steps[ParticipantScreen::kScale] = std::make_unique<PlainSteps::Scale>(course);
  steps[ParticipantScreen::kThanks] = std::make_unique<PlainSteps::End>(course);
  steps[ParticipantScreen::kStopped] = std::make_unique<PlainSteps::End>(course);
  addDeviceSteps(course, steps);
  return steps;
}

}  // namespace tactus::workbench
