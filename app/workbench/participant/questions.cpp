#include "app/workbench/participant/questions.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/session/profile_questions.h"
#include "app/session/study_source.h"
#include "app/workbench/participant/kit/pages.h"

namespace tactus::workbench {

std::optional<int> scalePoints(const QString& id) {
  bool number = false;
  const int points = id.toInt(&number);
  return number && points >= 1 && points <= kScalePoints ? std::optional(points) : std::nullopt;
}

std::optional<int> BlockRating::points() const { return scalePoints(chosen_); }

void BlockRating::choose(const QString& id) {
  if (scalePoints(id) || id == QLatin1String(kNotSay)) chosen_ = id;
}

bool BlockRating::next() {
  if (!isAnswered()) return false;
  if (isFirst()) {
    effort_ = points();
    if (effort()) chosen_.clear();
    return !effort();
  }
  comfort_ = points();
  return true;
}

void BlockRating::back() {
  if (isFirst()) return;
  chosen_ = effort() ? QString::number(*effort()) : QString();
  effort_.reset();
}

PageState BlockRating::page() const {
  return ratingPage(isFirst() ? QStringLiteral("rate.effort") : QStringLiteral("rate.comfort"), chosen_);
}

namespace {

using Question = AboutYouState::Question;

const session::ProfileQuestion& asked(Question question) {
  return session::profileQuestions()[static_cast<std::size_t>(question)];
}

// Empty if she did not say.
std::string stored(Question question, const QString& chosen) {
  return std::string(session::storedAnswer(asked(question), chosen.toStdString()));
}

}  // namespace

AboutYouState AboutYou::state() const { return {static_cast<Question>(at_), chosen_[at_], isFirst()}; }

void AboutYou::choose(const QString& id) {
  const bool offered = !stored(static_cast<Question>(at_), id).empty();
  if (id == QLatin1String(kNotSay) || offered) chosen_[at_] = id;
}

void AboutYou::next() {
  if (isAnswered() && !isLast()) ++at_;
}

void AboutYou::back() {
  if (!isFirst()) --at_;
}

study::ProfileRecord AboutYou::profile() const {
  const auto answer = [this](Question question) {
    return stored(question, chosen_[static_cast<std::size_t>(question)]);
  };
  study::ProfileRecord out;
  out.handedness = answer(Question::kHand);
  out.gloves = answer(Question::kGloves);
  out.haptic_experience = answer(Question::kHaptic);
  out.comfort = answer(Question::kComfort);
  return out;
}

std::optional<session::ExperienceBand> AboutYou::experience() const {
  return session::experienceBandCalled(chosen_[static_cast<std::size_t>(Question::kYears)].toStdString());
}

bool AboutYou::isLeftHanded() const {
  return chosen_[static_cast<std::size_t>(Question::kHand)] == QLatin1String("left");
}

namespace {

using Status = study::Answer::Status;

constexpr auto kCantTell = "cant_tell";

/// What an item is about: the region of the tip, and the other conditions.
struct Situation {
  std::vector<study::ItemCondition> conditions;
  QString region;
};

Situation situationOf(const procedure::Procedure& procedure, const study::Form& form, int number) {
  Situation out;
  const auto item = std::find_if(form.items.begin(), form.items.end(),
                                 [number](const study::FormItem& one) { return one.number == number; });
  if (item == form.items.end()) return out;
  for (const study::ItemCondition& condition : item->conditions) {
    if (condition.input == procedure.wayInput().id) {
      out.region = QString::fromStdString(condition.term);
    } else {
      out.conditions.push_back(condition);
    }
  }
  return out;
}

}  // namespace

std::optional<study::Form> formWithConditions(const procedure::Procedure& procedure, const std::string& form) {
  for (study::Form& known : session::knownForms(procedure)) {
    if (known.id == form && !known.items.empty()) return std::move(known);
  }
  return std::nullopt;
}

QuestionState questionState(const procedure::Procedure& procedure, const study::Form& form, const ItemPage& page,
                            const QString& chosen) {
  Situation situation = situationOf(procedure, form, page.item);
  QuestionState out;
  out.item = page.item;
  out.position = static_cast<int>(page.position);
  out.unknown_n = page.unknown_n;
  out.count = static_cast<int>(page.count);
  out.conditions = std::move(situation.conditions);
  out.region = situation.region;
  out.chosen = chosen;
  return out;
}

ReviewState reviewState(const procedure::Procedure& procedure, const study::Form& form,
                        const std::vector<ItemReply>& replies) {
  ReviewState out;
  for (const ItemReply& reply : replies) {
    Situation situation = situationOf(procedure, form, reply.item);
    out.answers.push_back({reply.item, std::move(situation.conditions), situation.region, wordOf(reply.reply)});
    if (reply.isOpen()) ++out.gaps;
  }
  return out;
}

QString wordOf(const std::optional<questionnaires::Reply>& reply) {
  if (!reply) return {};
  if (reply->status == Status::kCantTell) return QLatin1String(kCantTell);
  return reply->status == Status::kAnswered ? QString::fromStdString(reply->value) : QString();
}

QString wordOf(const study::JudgementRecord& judgement) {
  using Kind = study::ForceJudgement::Kind;
  if (judgement.kind == Kind::kNotFelt) return QStringLiteral("not_felt");
  if (judgement.kind == Kind::kBeyondPractice) return QStringLiteral("beyond_practice");
  return QString::fromStdString(judgement.term);
}

std::optional<questionnaires::Reply> replyOf(const study::Form& form, const QString& word) {
  if (word == QLatin1String(kCantTell)) return questionnaires::Reply{Status::kCantTell, {}};
  for (const study::AnswerWord& answer : form.answers) {
    if (word == QString::fromStdString(answer.term)) return questionnaires::Reply{Status::kAnswered, answer.term};
  }
  return std::nullopt;
}

}  // namespace tactus::workbench
