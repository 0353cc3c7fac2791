#include "core/base/close_match.h"

#include <algorithm>
#include <vector>

#include "core/base/text.h"

namespace tactus::base {
namespace {

// A longer word is a mistake of another kind; comparing it would cost the square of its length.
constexpr std::size_t kLongestWord = 100;
constexpr std::size_t kMostEdits = 3;

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
  const std::string left = lowered(a);
  const std::string right = lowered(b);
  std::vector<std::size_t> before(right.size() + 1);
  std::vector<std::size_t> last(right.size() + 1);
  std::vector<std::size_t> now(right.size() + 1);
  for (std::size_t k = 0; k <= right.size(); ++k) last[k] = k;
  for (std::size_t i = 1; i <= left.size(); ++i) {
    now[0] = i;
    for (std::size_t k = 1; k <= right.size(); ++k) {
      const std::size_t replaced = last[k - 1] + (left[i - 1] == right[k - 1] ? 0 : 1);
      now[k] = std::min({last[k] + 1, now[k - 1] + 1, replaced});
      const bool swapped = i > 1 && k > 1 && left[i - 1] == right[k - 2] && left[i - 2] == right[k - 1];
      if (swapped) now[k] = std::min(now[k], before[k - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last.back();
}

std::string closestWord(std::string_view word, std::span<const std::string> known) {
  if (word.empty() || word.size() > kLongestWord) return {};
  std::string best;
  std::size_t least = kMostEdits + 1;
  for (const auto& candidate : known) {
    if (candidate.size() > kLongestWord) continue;
    const std::size_t edits = editDistance(word, candidate);
    if (edits >= least || 3 * edits > std::max({candidate.size(), word.size(), std::size_t{3}})) continue;
    least = edits;
    best = candidate;
  }
  return best;
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  const std::string close = closestWord(word, known);
  return close.empty() ? std::string() : " (" + close + "?)";
}

}  // namespace tactus::base
