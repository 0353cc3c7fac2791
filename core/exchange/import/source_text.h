// The text of a file of another fuzzy program, with places in it for messages, and what its reader warns about.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace tactus::exchange {

/// A file larger than this is refused. The largest model that one expert may have fills less than half of it.
inline constexpr std::size_t kMostImportBytes = std::size_t{2} << 20U;

/// A word of the text and its first byte. Words stay valid as long as their SourceText.
struct Word {
  std::string_view text;
  std::size_t at = 0;
};

class SourceText {
 public:
  /// Decodes `bytes` as base::decodeText does, and turns all line ends into `\n`. An encoding other than UTF-8 becomes
  /// a warning. Refused: bytes of no text encoding, a zero byte, more than kMostImportBytes. `file`: its name in
  /// messages.
  static base::Result<std::shared_ptr<SourceText>> decoded(std::string bytes, std::string file);

  // Words point into it.
  SourceText(const SourceText&) = delete;
  SourceText& operator=(const SourceText&) = delete;

  std::string_view text() const { return text_; }
  const std::string& file() const { return file_; }

  /// An error at the byte `at`, with line and column.
  base::Error error(base::ErrorCode code, std::size_t at, std::string found, std::string wanted) const;
  /// The same as a failed result.
  tl::unexpected<base::Error> fail(base::ErrorCode code, std::size_t at, std::string found, std::string wanted) const;
  /// An error about the whole file.
  tl::unexpected<base::Error> failWhole(base::ErrorCode code, std::string found, std::string wanted) const;

  /// Adds `FILE: line 3, column 5: sentence`. After kMostWarnings, only their number is kept.
  void warn(std::size_t at, const std::string& sentence);
  void warnWhole(const std::string& sentence);
  std::vector<std::string> warnings() const;

 private:
  static constexpr std::size_t kMostWarnings = 100;

  SourceText(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {}

  std::string text_;
  std::string file_;
  std::vector<std::string> warnings_;
  std::size_t more_warnings_ = 0;
};

/// A number as people and programs write it: also `+1`, `.5`, `5.`, `inf`, `nan`. Nothing for other text.
std::optional<double> numberIn(std::string_view text) noexcept;

}  // namespace tactus::exchange
