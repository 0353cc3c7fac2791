// One person filling in one form: what to show next, what has been said, and how to go back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/session_records.h"
#include "questionnaires/item_order.h"
#include "questionnaires/questionnaire.h"

namespace tactus::questionnaires {

/// What a screen shows.
struct Page {
  const Question* question = nullptr;
  std::size_t position = 0;                          ///< from 1, in the order shown
  std::size_t count = 0;                             ///< questions of the form
  const study::AnswerRecord* last_answer = nullptr;  ///< what was said of this question last, if anything
};

/// How far a person has come. The numbers of the five kinds sum to the number of questions.
struct Progress {
  std::size_t answered = 0;
  std::size_t skipped = 0;
  std::size_t cant_tell = 0;
  std::size_t cleared = 0;
  std::size_t open = 0;  ///< nothing was said yet

  bool operator==(const Progress&) const = default;
};

/// What a person says of the question on the page.
struct Reply {
  study::Answer::Status status = study::Answer::Status::kSkipped;
  std::string value;  ///< one of the choices where the status is kAnswered, else empty
};

/// A form being filled in. Its state follows from the form, the order, the seed and the records added so far, so a run
/// that is built anew from stored records goes on where the last one stopped. Nothing is overwritten: an answer that is
/// changed is a further record that supersedes the earlier one.
///
/// A reply becomes final in two steps, so that the next page opens on a stored answer only: `draft` makes the record,
/// and `add` takes it once it is stored.
class QuestionnaireRun {
 public:
  QuestionnaireRun(Questionnaire form, ItemOrder order, std::uint64_t seed);

  /// The page that is open, or nothing where the person has gone past the last one.
  std::optional<Page> page() const;

  /// The record of `reply` to the open page, to be completed with its entry (id, session, time) and its response time,
  /// and stored. `entry.supersedes` is filled in. Refused: no open page, a value that is not among the choices, a value
  /// with another status than kAnswered, clearing where nothing was said.
  base::Result<study::AnswerRecord> draft(const Reply& reply) const;

  /// Takes a stored record and opens the page after the furthest one that was replied to: the next one, or after a
  /// correction the one from which the person went back. An answer that was cleared stays on its page.
  /// Refused: a record of another form or version, an item that the form does not have, a value that is not among the
  /// choices, a record that does not supersede the last one of its item.
  base::Result<void> add(const study::AnswerRecord& record);

  /// Opens the page before, or stays at the first.
  void back();
  /// Opens the next page without an answer where one was given before; an open question must be answered or skipped.
  /// Returns whether the page changed.
  bool forward();

  Progress progress() const;
  /// Every question has an answer, a skip or a "can't tell".
  bool isComplete() const { return progress().open == 0 && progress().cleared == 0; }
  /// The person has gone past the last page.
  bool isAtEnd() const noexcept { return at_ == order_.size(); }
  /// Opens the first page that is open or cleared; returns false where there is none.
  bool goToFirstOpen();

  /// Everything that was said of item `number`, oldest first.
  std::vector<study::AnswerRecord> history(int number) const;

  const Questionnaire& form() const noexcept { return form_; }

 private:
  const study::AnswerRecord* lastOf(std::size_t place) const;
  bool needsReply(std::size_t place) const;
  base::Result<std::size_t> placeOf(const study::AnswerRecord& record) const;
  base::Result<void> checkValue(study::Answer::Status status, const std::string& value) const;

  Questionnaire form_;
  std::vector<std::size_t> order_;                         ///< places of form_.questions in the order shown
  std::vector<std::vector<study::AnswerRecord>> records_;  ///< for each question of the form
  std::size_t at_ = 0;                                     ///< place in order_
  std::size_t furthest_ = 0;                               ///< place after the last one that was replied to
};

}  // namespace tactus::questionnaires
