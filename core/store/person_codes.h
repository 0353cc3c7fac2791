// Random codes of two words, such as `velvet-otter`, that say nothing about the person.
#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::store {

/// Combines the words of core/store/data/code_words.txt: any first word with any second word.
class PersonCodes {
 public:
  /// Seeded by the operating system; for real participants.
  PersonCodes();
  /// The same seed gives the same codes. For simulated studies and tests.
  explicit PersonCodes(std::uint64_t seed);

  std::string next();

  const std::vector<std::string_view>& firstWords() const { return first_; }
  const std::vector<std::string_view>& secondWords() const { return second_; }

 private:
  std::string_view draw(const std::vector<std::string_view>& words);

  std::vector<std::string_view> first_;
  std::vector<std::string_view> second_;
  std::mt19937_64 engine_;
};

}  // namespace tactus::store
