#include "questionnaires/questionnaire_run.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/random.h"

namespace tactus::questionnaires {

std::string_view name(ItemOrder order) noexcept {
  switch (order) {
    case ItemOrder::kFixed: return "fixed";
    case ItemOrder::kShuffled: return "shuffled";
    case ItemOrder::kWithinBlocks: return "within_blocks";
    case ItemOrder::kLeastKnown: return "least_known";
    case ItemOrder::kLeastKnownInBlocks: return "least_known_in_blocks";
  }
  return "";
}

namespace {

bool followsAnswers(ItemOrder order) {
  return order == ItemOrder::kLeastKnown || order == ItemOrder::kLeastKnownInBlocks;
}

}  // namespace

std::vector<std::size_t> itemOrder(std::span<const Question> questions, ItemOrder order, std::uint64_t seed) {
  std::vector<std::size_t> places(questions.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (order == ItemOrder::kFixed || followsAnswers(order)) return places;
  base::Random random(seed);
  std::size_t first = 0;
  while (first < places.size()) {
    std::size_t end = first + 1;
    const auto together = [&](std::size_t place) {
      return order == ItemOrder::kShuffled || questions[place].block == questions[first].block;
    };
    while (end < places.size() && together(end)) ++end;
    for (std::size_t left = end - first; left > 1; --left) {
      std::swap(places[first + left - 1],
                places[first + static_cast<std::size_t>(random.below(static_cast<int>(left)))]);
    }
    first = end;
  }
  return places;
}

using base::ErrorCode;
using base::fail;
using base::Result;
using Status = study::Answer::Status;

QuestionnaireRun::QuestionnaireRun(Questionnaire form, ItemOrder order, std::uint64_t seed)
    : form_(std::move(form)),
      item_order_(order),
      order_(itemOrder(form_.questions, order, seed)),
      decided_(followsAnswers(order) ? 0 : order_.size()),
      reasons_(order_.size()),
      records_(form_.questions.size()) {}

void QuestionnaireRun::chooseBy(ChooseNext choose) {
  choose_ = std::move(choose);
  decide();
}

// The question after the last reply, once it is to be shown.
void QuestionnaireRun::decide() {
  if (!choose_ || decided_ > furthest_ || decided_ == order_.size()) return;
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(decided_);
  std::vector<std::size_t> open(begin, order_.end());
  if (item_order_ == ItemOrder::kLeastKnownInBlocks) {
    const int block = form_.questions[open.front()].block;
    std::erase_if(open, [&](std::size_t question) { return form_.questions[question].block != block; });
  }
  std::vector<std::string> values(form_.questions.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const study::AnswerRecord* const last = lastOf(i);
    if (last != nullptr && last->status == Status::kAnswered) values[i] = last->value;
  }
  const Chosen chosen = choose_(values, open);
  const auto at = std::find(begin, order_.end(), chosen.question);
  TACTUS_CHECK(at != order_.end());
  std::rotate(begin, at, at + 1);
  reasons_[decided_++] = chosen.reason;
}

const study::AnswerRecord* QuestionnaireRun::lastOf(std::size_t place) const {
  return records_[place].empty() ? nullptr : &records_[place].back();
}

bool QuestionnaireRun::needsReply(std::size_t place) const {
  const study::AnswerRecord* const last = lastOf(place);
  return last == nullptr || last->status == Status::kCleared;
}

std::optional<Page> QuestionnaireRun::page() const {
  if (isAtEnd()) return std::nullopt;
  const std::size_t place = order_[at_];
  return Page{&form_.questions[place], at_ + 1, order_.size(), lastOf(place), reasons_[at_]};
}

Result<void> QuestionnaireRun::checkValue(Status status, const std::string& value) const {
  if (status == Status::kAnswered && form_.choice(value) == nullptr) {
    std::string wanted = "one of";
    for (const auto& choice : form_.choices) wanted += ' ' + choice.value;
    return fail(ErrorCode::kValue, "answer", base::quoted(value), std::move(wanted));
  }
  if (status != Status::kAnswered && !value.empty()) {
    return fail(ErrorCode::kValue, "answer", base::quoted(value) + " to a question without an answer", "no value");
  }
  return {};
}

Result<study::AnswerRecord> QuestionnaireRun::draft(const Reply& reply) const {
  const auto open = page();
  if (!open) return fail(ErrorCode::kValue, form_.form, "a reply after the last question", "a reply to an open page");
  if (auto ok = checkValue(reply.status, reply.value); !ok) return tl::unexpected(ok.error());
  if (reply.status == Status::kCleared && needsReply(order_[at_])) {
    return fail(ErrorCode::kValue, "item " + std::to_string(open->question->number), "nothing to clear", "an answer");
  }
  study::AnswerRecord record;
  if (open->last_answer != nullptr) record.entry.supersedes = open->last_answer->entry.id;
  record.form = form_.form;
  record.form_version = form_.version;
  record.item = open->question->number;
  record.position = static_cast<int>(open->position);
  record.status = reply.status;
  record.value = reply.value;
  record.wording = form_.wording;
  return record;
}

Result<std::size_t> QuestionnaireRun::placeOf(const study::AnswerRecord& record) const {
  if (record.form != form_.form || record.form_version != form_.version) {
    return fail(ErrorCode::kReference, "answer",
                base::quoted(record.form) + " version " + std::to_string(record.form_version),
                base::quoted(form_.form) + " version " + std::to_string(form_.version));
  }
  const auto it = std::find_if(form_.questions.begin(), form_.questions.end(),
                               [&](const Question& question) { return question.number == record.item; });
  if (it == form_.questions.end()) {
    return fail(ErrorCode::kReference, "answer", "item " + std::to_string(record.item),
                "an item of " + base::quoted(form_.form));
  }
  return static_cast<std::size_t>(it - form_.questions.begin());
}

Result<void> QuestionnaireRun::add(const study::AnswerRecord& record) {
  TACTUS_TRY(const auto place, placeOf(record));
  if (auto ok = checkValue(record.status, record.value); !ok) return ok;
  const study::AnswerRecord* const last = lastOf(place);
  const bool follows =
      last == nullptr ? !record.entry.supersedes.has_value() : record.entry.supersedes == last->entry.id;
  if (!follows) {
    return fail(ErrorCode::kReference, "answer to item " + std::to_string(record.item),
                "a record that does not follow the last one", "one that supersedes it");
  }
  records_[place].push_back(record);

  const auto found = std::find(order_.begin(), order_.end(), place);
  auto shown = static_cast<std::size_t>(found - order_.begin());
  if (shown >= decided_) {  // a stored record, of the question that was asked next
    std::rotate(order_.begin() + static_cast<std::ptrdiff_t>(decided_), found, found + 1);
    shown = decided_++;
  }
  furthest_ = std::max(furthest_, shown + 1);
  at_ = record.status == Status::kCleared ? shown : furthest_;
  decide();
  return {};
}

void QuestionnaireRun::back() {
  if (at_ > 0) --at_;
}

bool QuestionnaireRun::forward() {
  if (isAtEnd() || needsReply(order_[at_])) return false;
  ++at_;
  return true;
}

bool QuestionnaireRun::goTo(int number) {
  for (std::size_t place = 0; place < order_.size() && place <= furthest_; ++place) {
    if (form_.questions[order_[place]].number != number) continue;
    at_ = place;
    return true;
  }
  return false;
}

bool QuestionnaireRun::goToFirstOpen() {
  const auto it = std::find_if(order_.begin(), order_.end(), [this](std::size_t place) { return needsReply(place); });
  if (it == order_.end()) return false;
  at_ = static_cast<std::size_t>(it - order_.begin());
  return true;
}

Progress QuestionnaireRun::progress() const {
  Progress progress;
  for (std::size_t place = 0; place < records_.size(); ++place) {
    const study::AnswerRecord* const last = lastOf(place);
    if (last == nullptr) {
      ++progress.open;
      continue;
    }
    switch (last->status) {
      case Status::kAnswered: ++progress.answered; break;
      case Status::kSkipped: ++progress.skipped; break;
      case Status::kCantTell: ++progress.cant_tell; break;
      case Status::kCleared: ++progress.cleared; break;
    }
  }
  return progress;
}

std::vector<study::AnswerRecord> QuestionnaireRun::history(int number) const {
  for (std::size_t place = 0; place < records_.size(); ++place) {
    if (form_.questions[place].number == number) return records_[place];
  }
  return {};
}

}  // namespace tactus::questionnaires
