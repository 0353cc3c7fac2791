// What the screens ask in words: effort and comfort of a part, the questions about the participant, the questions of
// the form, and all answers to them for the review.
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session_notes.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/procedure/procedure.h"
#include "core/study/records.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

// Effort and comfort of a part that she has done, one question after the other.

/// Plain state. Thread: gui.
class BlockRating {
 public:
  void begin() { *this = {}; }
  /// Ignores what is no answer.
  void choose(const QString& id);
  bool isAnswered() const { return !chosen_.isEmpty(); }
  bool isFirst() const { return !effort_ || !*effort_; }
  /// Takes what is chosen. Whether both questions are answered now; who does not say the one is not asked the other.
  bool next();
  void back();

  /// 1 to 7; nothing: she did not say.
  std::optional<int> effort() const { return effort_.value_or(std::nullopt); }
  std::optional<int> comfort() const { return comfort_; }
  PageState page() const;

 private:
  std::optional<int> points() const;

  QString chosen_;
  std::optional<std::optional<int>> effort_;  ///< of the first question, once it is answered
  std::optional<int> comfort_;
};

/// The points of a scale: `1` to `7`; nothing for anything else.
std::optional<int> scalePoints(const QString& id);

// The questions about the participant, one at a time, and the profile that follows from the answers.

/// Nothing is chosen at the beginning. `not_say` (I would rather not say) is an answer: the profile lacks the field.
class AboutYou {
 public:
  AboutYouState state() const;
  /// Whether the question has an answer, so that `next` acts.
  bool isAnswered() const { return !chosen_[at_].isEmpty(); }
  bool isLast() const { return at_ + 1 == chosen_.size(); }
  bool isFirst() const { return at_ == 0; }

  /// Ignores an id that the question does not offer (AboutYouState::chosen).
  void choose(const QString& id);
  void next();
  void back();

  /// Without the years of experience, of which she names a band.
  study::ProfileRecord profile() const;
  /// Nothing if she did not say.
  std::optional<session::ExperienceBand> experience() const;
  /// The hand that guides the tube is the left one.
  bool isLeftHanded() const;

 private:
  static constexpr std::size_t kQuestions = 5;

  std::array<QString, kQuestions> chosen_;
  std::size_t at_ = 0;  ///< AboutYouState::Question
};

/// The form with this id, if its items have conditions; the one of usability has none.
std::optional<study::Form> formWithConditions(const procedure::Procedure& procedure, const std::string& form);

/// The question of `page`. `chosen`: what is chosen on the screen now.
QuestionState questionState(const procedure::Procedure& procedure, const study::Form& form, const ItemPage& page,
                            const QString& chosen);

ReviewState reviewState(const procedure::Procedure& procedure, const study::Form& form,
                        const std::vector<ItemReply>& replies);

/// A term id, or `cant_tell`; empty where there is no reply, or it was skipped or taken back.
QString wordOf(const std::optional<questionnaires::Reply>& reply);
/// Of a judged force: a term id, `not_felt`, `beyond_practice`.
QString wordOf(const study::JudgementRecord& judgement);
/// The reply that `word` stands for; nothing for a word that the form does not offer.
std::optional<questionnaires::Reply> replyOf(const study::Form& form, const QString& word);

}  // namespace tactus::workbench
