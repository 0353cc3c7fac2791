// One participant fills in one form: the next page, the answers so far, and the way back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/session_records.h"
#include "questionnaires/questionnaire.h"

namespace tactus::questionnaires {

/// The display order of a form's items.
enum class ItemOrder {
  kFixed,         ///< as in the form
  kShuffled,      ///< random, from a seed
  kWithinBlocks,  ///< random within each block of the form (Question::block), from a seed; the blocks as in the form
  kLeastKnown,    ///< next what the answers so far tell least about (QuestionnaireRun::chooseBy)
  kLeastKnownInBlocks,  ///< the same within each block; the blocks as in the form
};
inline constexpr ItemOrder kItemOrders[] = {ItemOrder::kFixed, ItemOrder::kShuffled, ItemOrder::kWithinBlocks,
                                            ItemOrder::kLeastKnown, ItemOrder::kLeastKnownInBlocks};

/// `fixed`, `shuffled`, `within_blocks`, `least_known`, `least_known_in_blocks`.
std::string_view name(ItemOrder order) noexcept;

/// The indices of `questions` in display order, as far as it does not follow from answers: then as in the form. Of
/// those that are drawn every order is equally likely (Fisher and Yates), and the same seed gives the same order on
/// every machine.
std::vector<std::size_t> itemOrder(std::span<const Question> questions, ItemOrder order, std::uint64_t seed);

/// Why a question is asked now: of what is unknown of the force, its answer removes the most.
struct Reason {
  double share = 0;      ///< of the variance of the force that its answer would remove, [0, 1]
  double unknown_n = 0;  ///< standard deviation of the force before it, N

  bool operator==(const Reason&) const = default;
};

/// The content of a screen.
struct Page {
  const Question* question = nullptr;
  std::size_t position = 0;                          ///< from 1, in the order shown
  std::size_t count = 0;                             ///< questions of the form
  const study::AnswerRecord* last_answer = nullptr;  ///< the last answer to this question; null if there is none
  std::optional<Reason> reason = {};                 ///< of an order that follows from the answers
};

/// The progress of a participant. The five numbers sum to the number of questions.
struct Progress {
  std::size_t answered = 0;
  std::size_t skipped = 0;
  std::size_t cant_tell = 0;
  std::size_t cleared = 0;
  std::size_t open = 0;  ///< no reply yet

  bool operator==(const Progress&) const = default;
};

/// The participant's reply to the displayed question.
struct Reply {
  study::Answer::Status status = study::Answer::Status::kSkipped;
  std::string value;  ///< one of the choices if the status is kAnswered, else empty
};

/// A form being filled in. The state depends only on the form, the order, the seed and the added records. So a run made
/// again from stored records continues where the last one stopped. Records are never overwritten: a changed answer is a
/// new record that supersedes the previous one.
///
/// A reply takes two steps, so that the next page opens only after the answer is stored: `draft` makes the record, and
/// the caller stores it and passes it to `add`.
class QuestionnaireRun {
 public:
  QuestionnaireRun(Questionnaire form, ItemOrder order, std::uint64_t seed);

  /// The question to ask next, one of `open`: indices into the questions of the form. `values`: of each question the
  /// value of its answer; empty without one.
  struct Chosen {
    std::size_t question = 0;
    Reason reason;
  };
  using ChooseNext = std::function<Chosen(const std::vector<std::string>& values, std::span<const std::size_t> open)>;
  /// From here on `choose` decides, if the order is one that follows from the answers. To be given after the stored
  /// records were added: their order is the one in which the questions were asked.
  void chooseBy(ChooseNext choose);

  /// The current page; nothing after the last one.
  std::optional<Page> page() const;

  /// The record of `reply` to the current page. The caller completes its entry (id, session, time) and its response
  /// time, and stores it. `entry.supersedes` is already set. Returns an error for: no current page, a value that is not
  /// a choice, a value with another status than kAnswered, clearing without an answer.
  base::Result<study::AnswerRecord> draft(const Reply& reply) const;

  /// Adds a stored record and opens the page after the last page with a reply. This is the next page or, after a
  /// correction, the page from which the participant went back. After a cleared answer the page stays.
  /// Returns an error for: a record of another form or version, an item that the form lacks, a value that is not a
  /// choice, a record that does not supersede the last one of its item.
  base::Result<void> add(const study::AnswerRecord& record);

  /// Opens the previous page; stays on the first.
  void back();
  /// Opens the next page, if the current one has a reply; otherwise the participant must answer or skip. Returns
  /// whether the page changed.
  bool forward();

  /// Opens the page of item `number`. Returns false for an item that the form lacks, or beyond the page that is asked
  /// next.
  bool goTo(int number);
  /// Opens the page after the last page with a reply: after `back` or `goTo`, where the participant went back from.
  void goOn() { at_ = furthest_; }

  Progress progress() const;
  /// Whether every question has an answer, a skip or a "can't tell".
  bool isComplete() const { return progress().open == 0 && progress().cleared == 0; }
  /// Whether the participant has passed the last page.
  bool isAtEnd() const noexcept { return at_ == order_.size(); }
  /// Opens the first page without a reply or with a cleared answer. Returns false if there is none.
  bool goToFirstOpen();

  /// All records of item `number`, oldest first.
  std::vector<study::AnswerRecord> history(int number) const;

  const Questionnaire& form() const noexcept { return form_; }

 private:
  const study::AnswerRecord* lastOf(std::size_t place) const;
  bool needsReply(std::size_t place) const;
  base::Result<std::size_t> placeOf(const study::AnswerRecord& record) const;
  base::Result<void> checkValue(study::Answer::Status status, const std::string& value) const;

  Questionnaire form_;
  void decide();

  ItemOrder item_order_;
  ChooseNext choose_;
  std::vector<std::size_t> order_;                         ///< indices into form_.questions in display order
  std::size_t decided_ = 0;                                ///< so many of `order_` stay
  std::vector<std::optional<Reason>> reasons_;             ///< of each place of `order_`
  std::vector<std::vector<study::AnswerRecord>> records_;  ///< per question of the form
  std::size_t at_ = 0;                                     ///< index into order_
  std::size_t furthest_ = 0;                               ///< index after the last page with a reply
};

}  // namespace tactus::questionnaires
