#include "core/store/person_codes.h"

#include "core/base/check.h"

namespace tactus::store {

// Embedded from core/store/data.
std::string_view codeWords();

namespace {

std::uint64_t seedFromEntropy() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32U) | device();
}

/// The words of the block that begins with the line `title`.
std::vector<std::string_view> wordsUnder(std::string_view title) {
  std::vector<std::string_view> words;
  std::string_view rest = codeWords();
  rest.remove_prefix(rest.find(title) + title.size() + 1);
  rest = rest.substr(0, rest.find('['));
  while (!rest.empty()) {
    const auto end = rest.find_first_of(" \n");
    if (end > 0) words.push_back(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return words;
}

}  // namespace

PersonCodes::PersonCodes() : PersonCodes(seedFromEntropy()) {}

PersonCodes::PersonCodes(std::uint64_t seed)
    : first_(wordsUnder("[first]")), second_(wordsUnder("[second]")), engine_(seed) {
  TACTUS_CHECK(!first_.empty() && !second_.empty());
}

std::string_view PersonCodes::draw(const std::vector<std::string_view>& words) {
  // 64 random bits against a few hundred words: the rest of the division favors no word by more than 1e-16.
  return words[static_cast<std::size_t>(engine_() % words.size())];
}

std::string PersonCodes::next() {
  std::string code(draw(first_));
  code += '-';
  code += draw(second_);
  return code;
}

}  // namespace tactus::store
