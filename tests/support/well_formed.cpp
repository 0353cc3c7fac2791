#include "tests/support/well_formed.h"

#include <cctype>
#include <set>
#include <vector>

namespace tactus::support {
namespace {

/// Walks over the text and remembers where it is.
class Checker {
 public:
  explicit Checker(std::string_view text) : text_(text) {}

  std::string run() {
    while (at_ < text_.size() && fault_.empty()) {
      if (starts("<!--")) {
        skipPast("-->");
      } else if (starts("<![CDATA[")) {
        skipPast("]]>");
      } else if (starts("<!")) {
        skipPast(">");
      } else if (starts("</")) {
        endTag();
      } else if (starts("<")) {
        startTag();
      } else {
        character("<");
      }
    }
    if (fault_.empty() && !open_.empty()) fail("<" + open_.back() + "> is never closed");
    return fault_;
  }

 private:
  bool starts(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  void fail(const std::string& what) {
    if (fault_.empty()) fault_ = what + " at " + std::to_string(at_) + ": " + std::string(text_.substr(at_, 60));
  }

  void skipPast(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) return fail("no " + std::string(end));
    at_ = found + end.size();
  }

  void skipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-'))
      ++at_;
    if (begin == at_) fail("no name");
    return std::string(text_.substr(begin, at_ - begin));
  }

  /// One character of text or of an attribute's value, none of `forbidden`.
  void character(std::string_view forbidden) {
    if (forbidden.find(text_[at_]) != std::string_view::npos) return fail("a bare character");
    if (text_[at_] == '&') {
      const std::size_t end = text_.find(';', at_);
      const std::string_view entity = text_.substr(at_ + 1, end == std::string_view::npos ? 0 : end - at_ - 1);
      static const std::set<std::string_view> kKnown = {"amp", "lt", "gt", "quot", "apos"};
      if (kKnown.count(entity) == 0 && (entity.size() < 2 || entity[0] != '#')) return fail("an unknown entity");
      at_ = end;
    }
    ++at_;
  }

  void endTag() {
    at_ += 2;
    const std::string tag = name();
    if (!starts(">")) return fail("no end of the tag");
    ++at_;
    if (open_.empty() || open_.back() != tag) return fail("</" + tag + "> does not close what is open");
    open_.pop_back();
  }

  void startTag() {
    ++at_;
    const std::string tag = name();
    std::set<std::string> attributes;
    while (fault_.empty()) {
      skipSpace();
      if (starts("/>")) {
        at_ += 2;
        return;
      }
      if (starts(">")) {
        ++at_;
        open_.push_back(tag);
        return;
      }
      if (!attributes.insert(name()).second) return fail("an attribute twice");
      if (!starts("=\"")) return fail("an attribute without a quoted value");
      at_ += 2;
      while (at_ < text_.size() && text_[at_] != '"' && fault_.empty()) character("<");
      if (at_ >= text_.size()) return fail("an open quote");
      ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::string fault_;
};

}  // namespace

std::string markupFault(std::string_view markup) { return Checker(markup).run(); }

std::size_t countOf(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace tactus::support
