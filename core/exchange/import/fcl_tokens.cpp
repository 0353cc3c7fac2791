#include "core/exchange/import/fcl_tokens.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/base/text.h"

namespace tactus::exchange {
namespace {

bool isDigitAt(std::string_view text, std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; }

bool isNamePart(std::string_view text, std::size_t at) {
  if (at >= text.size()) return false;
  const auto c = static_cast<unsigned char>(text[at]);
  return c >= 0x80 || c == '_' || std::isalnum(c) != 0;
}

class FclLexer {
 public:
  explicit FclLexer(const SourceText& source) : source_(source), text_(source.text()) {}

  base::Result<std::vector<Token>> read() {
    for (skip(); at_ < text_.size() && !error_; skip()) {
      const std::size_t end = isNumberHere() ? endOfNumber() : isNamePart(text_, at_) ? endOfName(at_) : endOfSign();
      const std::string_view token = text_.substr(at_, end - at_);
      tokens_.push_back({kindOf(token), token, at_});
      at_ = end;
      line_start_ = false;
    }
    if (error_) return tl::unexpected(*error_);
    tokens_.push_back({Token::Kind::kEnd, {}, text_.size()});
    return std::move(tokens_);
  }

 private:
  static Token::Kind kindOf(std::string_view token) {
    if (numberIn(token)) return Token::Kind::kNumber;
    return isNamePart(token, 0) ? Token::Kind::kWord : Token::Kind::kSymbol;
  }

  /// Moves behind blanks and comments.
  void skip() {
    while (at_ < text_.size() && !error_) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("(*")) {
        skipTo("*)");
      } else if (rest.starts_with("/*")) {
        skipTo("*/");
      } else if (rest.starts_with("//") || rest.front() == '#' || (rest.front() == '%' && line_start_)) {
        at_ = std::min(text_.size(), text_.find('\n', at_));
      } else if (std::isspace(static_cast<unsigned char>(rest.front())) != 0) {
        if (rest.front() == '\n') line_start_ = true;
        ++at_;
      } else {
        return;
      }
    }
  }

  void skipTo(std::string_view end) {
    const std::size_t found = text_.find(end, at_ + 2);
    if (found == std::string_view::npos) {
      error_ = source_.error(base::ErrorCode::kSyntax, at_, "a comment without an end", base::quoted(end));
    } else {
      at_ = found + 2;
    }
  }

  bool isSigned() const { return text_[at_] == '+' || text_[at_] == '-'; }

  bool isNumberHere() const {
    const std::size_t first = at_ + (isSigned() ? 1 : 0);
    if (isDigitAt(text_, first) || (first < text_.size() && text_[first] == '.' && isDigitAt(text_, first + 1)))
      return true;
    return isSigned() && numberIn(text_.substr(first, endOfName(first) - first)).has_value();
  }

  /// `0..24` is a number, a sign and a number; a name may begin with digits.
  std::size_t endOfNumber() const {
    std::size_t end = at_ + (isSigned() ? 1 : 0);
    while (isDigitAt(text_, end)) ++end;
    if (text_.substr(end).starts_with(".") && !text_.substr(end).starts_with("..")) ++end;
    while (isDigitAt(text_, end)) ++end;
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (isDigitAt(text_, exponent)) end = exponent;
      while (isDigitAt(text_, end)) ++end;
    }
    return endOfName(end);
  }

  /// Names of fuzzylite may hold dots.
  std::size_t endOfName(std::size_t end) const {
    while (isNamePart(text_, end) || (end > at_ && end < text_.size() && text_[end] == '.' &&
                                      isNamePart(text_, end - 1) && isNamePart(text_, end + 1)))
      ++end;
    return end;
  }

  std::size_t endOfSign() const {
    const std::string_view rest = text_.substr(at_);
    return at_ + (rest.starts_with(":=") || rest.starts_with("..") ? 2 : 1);
  }

  const SourceText& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool line_start_ = true;  ///< nothing but blanks and comments since the last line end
  std::vector<Token> tokens_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<std::vector<Token>> fclTokens(const SourceText& source) { return FclLexer(source).read(); }

}  // namespace tactus::exchange
