// The questions about the participant, one at a time, and the profile that follows from the answers.
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "app/session/session_notes.h"
#include "app/workbench/participant/participant_state.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

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

}  // namespace tactus::workbench
