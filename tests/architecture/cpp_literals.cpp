#include "tests/architecture/cpp_literals.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace tactus::tests {
namespace {

bool isNamePart(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':'; }

class Scanner {
 public:
  explicit Scanner(std::string_view source) : source_(source) {}

  std::vector<Literal> literals() {
    while (at_ < source_.size()) step();
    return std::move(found_);
  }

 private:
  char now() const { return source_[at_]; }
  bool sees(std::string_view text) const { return source_.substr(at_).starts_with(text); }

  void skipTo(std::string_view end) {
    const auto place = source_.find(end, at_);
    at_ = place == std::string_view::npos ? source_.size() : place + end.size();
  }

  // To behind the closing quote.
  void skipQuoted(char quote) {
    for (++at_; at_ < source_.size() && now() != quote; ++at_) {
      if (now() == '\\') ++at_;
    }
    ++at_;
  }

  void step() {
    const bool line_begins = at_ == 0 || source_[at_ - 1] == '\n';
    if (sees("//") || (line_begins && now() == '#')) return skipTo("\n");
    if (sees("/*")) return skipTo("*/");
    if (sees("R\"(")) {
      const std::size_t begin = at_ + 3;
      skipTo(")\"");
      return add(begin, at_ - 2);
    }
    switch (now()) {
      case '\'':
        // Between digits it only groups them.
        if (at_ > 0 && std::isdigit(static_cast<unsigned char>(source_[at_ - 1])) != 0) break;
        return skipQuoted('\'');
      case '"': {
        const std::size_t begin = at_ + 1;
        skipQuoted('"');
        return add(begin, at_ - 1);
      }
      case '(':
      case '{':
      case '[': calls_.push_back(nameBefore(at_)); break;
      case ')':
      case '}':
      case ']':
        if (!calls_.empty()) calls_.pop_back();
        break;
      default: break;
    }
    ++at_;
  }

  std::string nameBefore(std::size_t place) const {
    while (place > 0 && source_[place - 1] == ' ') --place;
    std::size_t begin = place;
    while (begin > 0 && isNamePart(source_[begin - 1])) --begin;
    return std::string(source_.substr(begin, place - begin));
  }

  void add(std::size_t begin, std::size_t end) {
    const auto line = std::count(source_.begin(), source_.begin() + static_cast<std::ptrdiff_t>(begin), '\n') + 1;
    found_.push_back({std::string(source_.substr(begin, end - begin)), static_cast<std::size_t>(line), calls_});
  }

  std::string_view source_;
  std::size_t at_ = 0;
  std::vector<std::string> calls_;
  std::vector<Literal> found_;
};

}  // namespace

std::vector<Literal> literalsOf(std::string_view source) { return Scanner(source).literals(); }

}  // namespace tactus::tests
