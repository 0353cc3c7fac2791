#include "app/link/client_session.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "app/link/link_lines.h"
#include "app/link/link_sockets.h"
#include "core/base/text.h"

namespace tactus::link {

void LineBuffer::add(std::string_view bytes) {
  // What was read is dropped here, not with each line: many short lines cost one move.
  bytes_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  bytes_ += bytes;
}

std::size_t LineBuffer::findEnd() {
  const std::size_t end = bytes_.find('\n', scanned_);
  scanned_ = end == std::string::npos ? bytes_.size() : end;
  return end;
}

bool LineBuffer::hasLine() {
  const std::size_t end = findEnd();
  return end != std::string::npos && end - begin_ <= kLongestLine;
}

bool LineBuffer::isTooLong() { return std::min(findEnd(), bytes_.size()) - begin_ > kLongestLine; }

std::optional<std::string_view> LineBuffer::next() {
  if (!hasLine()) return std::nullopt;
  const auto line = std::string_view(bytes_).substr(begin_, scanned_ - begin_);
  begin_ = scanned_ = scanned_ + 1;
  return line;
}

void ClientSession::receive(std::string_view bytes) {
  if (phase_ == Phase::kEnding) return;
  input_.add(bytes);
  findWork();
}

void ClientSession::findWork() { has_work_ = input_.hasLine() || input_.isTooLong(); }

void ClientSession::work(int most_lines, const SessionNeeds& needs) {
  for (int i = 0; i < most_lines && hasWork(); ++i) {
    ++lines_;
    if (const auto line = input_.next()) {
      readLine(*line, needs);
    } else {
      refuse("line " + std::to_string(lines_) + " of the client: found more than " +
             std::to_string(LineBuffer::kLongestLine) + " bytes, wanted at most these");
    }
    findWork();
  }
}

void ClientSession::readLine(std::string_view line, const SessionNeeds& needs) {
  const auto refuseLine = [this](base::Error error) {
    error.file = "line " + std::to_string(lines_) + " of the client";
    refuse(error.message());
  };
  if (phase_ == Phase::kHello) {
    const auto hello = readHello(line);
    if (!hello) return refuseLine(hello.error());
    greet(*hello, needs);
  } else {
    auto later = readLaterLine(line);
    if (!later) return refuseLine(later.error());
    if (const auto* const ask = std::get_if<Ask>(&*later)) {
      answer(*ask, needs.model);
    } else {
      setFelt(std::get<Felt>(*std::move(later)), needs.model);
    }
  }
}

void ClientSession::greet(const Hello& hello, const SessionNeeds& needs) {
  if (!isSameToken(hello.token, needs.token)) {
    refuse("hello: found another token, wanted the one in the server's token file");
  } else if (!needs.has_place) {
    refuse("found as many clients as the server takes, wanted fewer: try again when one has left");
  } else {
    phase_ = Phase::kGreeted;
    hello_ = hello;
    hello_.token.clear();
    greeting_ = helloLine(needs.program);
    offer(needs.model);
  }
}

void ClientSession::answer(const Ask& ask, const ServedModel& model) {
  const std::size_t wanted = model.compiled.inputCount();
  if (ask.inputs.size() != wanted) {
    return refuse("line " + std::to_string(lines_) + " of the client: /ask/inputs: found " +
                  std::to_string(ask.inputs.size()) + " numbers, wanted " + std::to_string(wanted) +
                  ", one for each input of the model");
  }
  replies_ += answerLine(ask.id, model.compiled.evaluate(ask.inputs), model.serial);
}

void ClientSession::setFelt(Felt felt, const ServedModel& model) {
  for (const auto& [id, value] : felt.conditions) {
    if (std::find(model.inputs.begin(), model.inputs.end(), id) != model.inputs.end()) continue;
    return refuse("line " + std::to_string(lines_) + " of the client: /felt/conditions: found " + base::quoted(id) +
                  ", wanted inputs of the model: " + base::joined(model.inputs, ", "));
  }
  felt_ = std::move(felt);
}

std::optional<Felt> ClientSession::takeFelt() { return std::exchange(felt_, std::nullopt); }

void ClientSession::offerFelt(std::shared_ptr<const std::string> line) {
  if (phase_ == Phase::kGreeted && hello_.wants_felt) others_felt_ = std::move(line);
}

void ClientSession::refuse(std::string_view sentence) {
  if (phase_ == Phase::kEnding) return;
  phase_ = Phase::kEnding;
  replies_ += errorLine(sentence);
  model_.reset();
  state_.reset();
  felt_.reset();
  others_felt_.reset();
  input_ = {};
  has_work_ = false;
}

void ClientSession::offer(const ServedModel& model) {
  if (phase_ == Phase::kGreeted && hello_.wants_model) model_ = model.line;
}

bool ClientSession::isDue(double time_s) {
  if (phase_ != Phase::kGreeted || !hello_.wants_state) return false;
  const double period_s = 1 / hello_.state_hz;
  const bool new_run = time_s < std::exchange(state_before_s_, time_s);
  // The moments lie on a grid of ticks, whose times are not exact.
  constexpr double kToleranceS = 2e-4;
  if (state_due_s_ && !new_run && time_s < *state_due_s_ - kToleranceS) return false;
  const bool late = !state_due_s_ || new_run || time_s > *state_due_s_ + period_s;
  state_due_s_ = (late ? time_s : *state_due_s_) + period_s;
  return true;
}

void ClientSession::offerState(std::shared_ptr<const std::string> line) { state_ = std::move(line); }

std::string_view ClientSession::output() {
  if (!current_) {
    current_sent_ = 0;
    if (!greeting_.empty()) {
      current_ = std::make_shared<const std::string>(std::exchange(greeting_, {}));
    } else if (model_) {
      current_ = std::exchange(model_, nullptr);
    } else if (!replies_.empty()) {
      if (state_) replies_ += *std::exchange(state_, nullptr);
      if (others_felt_) replies_ += *std::exchange(others_felt_, nullptr);
      current_ = std::make_shared<const std::string>(std::exchange(replies_, {}));
    } else if (state_) {
      current_ = std::exchange(state_, nullptr);
    } else if (others_felt_) {
      current_ = std::exchange(others_felt_, nullptr);
    } else {
      return {};
    }
  }
  return std::string_view(*current_).substr(current_sent_);
}

void ClientSession::sent(std::size_t bytes) {
  current_sent_ += bytes;
  if (current_ && current_sent_ == current_->size()) current_.reset();
}

}  // namespace tactus::link
