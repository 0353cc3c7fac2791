// The protocol with one client of the live link, without a socket: bytes in, bytes out. Its memory is bounded, whatever
// the client sends and however slowly it reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/link/link_lines.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::link {

/// Lines out of a stream of bytes, with a limit on their length.
class LineBuffer {
 public:
  /// Bytes of a line of a client, without its line end.
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

  void add(std::string_view bytes);
  /// The next whole line without its line end, or nothing. Valid until the next call of any function.
  std::optional<std::string_view> next();
  /// Whether `next` would give a line.
  bool hasLine();
  /// Whether the line that is next is longer than the limit. It can then never be read.
  bool isTooLong();
  /// Bytes that are kept.
  std::size_t size() const { return bytes_.size() - begin_; }

 private:
  std::size_t findEnd();

  std::string bytes_;
  std::size_t begin_ = 0;    ///< of the next line
  std::size_t scanned_ = 0;  ///< no line end in [begin_, scanned_)
};

/// The model that is served. Immutable.
struct ServedModel {
  std::uint64_t serial = 0;  ///< from 1, higher with each model
  fuzzy::CompiledModel compiled;
  std::shared_ptr<const std::string> line;  ///< modelLine
  std::vector<std::string> inputs = {};     ///< ids
};

/// What a session needs of its server while it reads lines.
struct SessionNeeds {
  const ServedModel& model;
  std::string_view token;
  std::string_view program;
  bool has_place = true;  ///< for one client more
};

/// Thread: one at a time.
class ClientSession {
 public:
  enum class Phase {
    kHello,    ///< waits for the first line
    kGreeted,  ///< reads questions, gets what it wants
    kEnding,   ///< an error was said: nothing more is read; what is left to send is the end
  };
  /// No line is read while this many bytes of answers wait, so a flood of questions is not read either.
  static constexpr std::size_t kMostAnswers = std::size_t{64} << 10U;

  Phase phase() const { return phase_; }
  const Hello& hello() const { return hello_; }

  /// Whether there is room for more bytes of the client.
  bool wantsInput() const { return phase_ != Phase::kEnding && !has_work_; }
  void receive(std::string_view bytes);
  /// Whether lines are left to read and there is room for what they bring.
  bool hasWork() const { return phase_ != Phase::kEnding && has_work_ && replies_.size() < kMostAnswers; }
  /// Reads at most `most_lines` lines.
  void work(int most_lines, const SessionNeeds& needs);
  /// Says why, in one sentence, and ends. Answers to earlier questions are sent first.
  void refuse(std::string_view sentence);

  /// Replaces a model that was not sent yet.
  void offer(const ServedModel& model);
  /// Whether a state of this time is due. If so, the caller offers it.
  bool isDue(double time_s);
  /// Replaces a state that was not sent yet.
  void offerState(std::shared_ptr<const std::string> line);

  /// Where the client's simulator is, if it has said so since the last call: the newest.
  std::optional<Felt> takeFelt();
  /// Replaces a line about another client that was not sent yet.
  void offerFelt(std::shared_ptr<const std::string> line);

  /// The bytes to send next; empty if there are none. Valid until the next call of any function.
  std::string_view output();
  /// The client took the first `bytes` of `output()`.
  void sent(std::size_t bytes);

 private:
  void readLine(std::string_view line, const SessionNeeds& needs);
  void greet(const Hello& hello, const SessionNeeds& needs);
  void answer(const Ask& ask, const ServedModel& model);
  void setFelt(Felt felt, const ServedModel& model);
  void findWork();

  Phase phase_ = Phase::kHello;
  Hello hello_;
  LineBuffer input_;
  bool has_work_ = false;  ///< a whole line is there, or one that is too long
  std::uint64_t lines_ = 0;
  std::optional<Felt> felt_;
  std::optional<double> state_due_s_;
  double state_before_s_ = 0;

  // What is to be sent: the rest of one text, then the next of these in this order. A text that was begun is finished.
  std::shared_ptr<const std::string> current_;
  std::size_t current_sent_ = 0;
  std::string greeting_;
  std::shared_ptr<const std::string> model_;  ///< the newest that the client does not have
  std::string replies_;                       ///< answers and the error, in the order of the lines
  std::shared_ptr<const std::string> state_;  ///< the newest; follows the replies, so that questions never hold it up
  std::shared_ptr<const std::string> others_felt_;  ///< likewise
};

}  // namespace tactus::link
