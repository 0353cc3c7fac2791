#include "elicitation/force/word_intervals.h"

#include <algorithm>
#include <set>

namespace tactus::elicitation {

std::vector<WordInterval> wordIntervals(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                        std::span<const fuzzy::Term> terms) {
  std::vector<WordInterval> out;
  std::vector<std::string> order;
  for (const auto& one : judgements) {
    if (one.series != series || one.kind != study::ForceJudgement::Kind::kTerm) continue;
    const auto term = std::find_if(terms.begin(), terms.end(), [&](const auto& each) { return each.id == one.term; });
    if (term == terms.end()) continue;
    const auto word = static_cast<std::size_t>(term - terms.begin());
    if (std::find(order.begin(), order.end(), one.participant) == order.end()) order.push_back(one.participant);
    const auto known = std::find_if(out.begin(), out.end(), [&](const WordInterval& each) {
      return each.participant == one.participant && each.word == word;
    });
    if (known == out.end()) {
      out.push_back({one.participant, word, one.force_n, one.force_n});
    } else {
      known->left_n = std::min(known->left_n, one.force_n);
      known->right_n = std::max(known->right_n, one.force_n);
    }
  }
  const auto place = [&order](const WordInterval& one) {
    return std::find(order.begin(), order.end(), one.participant) - order.begin();
  };
  std::sort(out.begin(), out.end(), [&](const WordInterval& a, const WordInterval& b) {
    return std::pair(place(a), a.word) < std::pair(place(b), b.word);
  });
  return out;
}

std::vector<IntervalShare> intervalAgreement(std::span<const WordInterval> intervals, std::size_t word) {
  std::set<double> ends;
  double count = 0;
  for (const auto& one : intervals) {
    if (one.word != word) continue;
    ends.insert({one.left_n, one.right_n});
    ++count;
  }
  const auto share = [&](double left_n, double right_n) {
    return static_cast<double>(std::count_if(intervals.begin(), intervals.end(),
                                             [&](const WordInterval& one) {
                                               return one.word == word && one.left_n <= left_n &&
                                                      one.right_n >= right_n;
                                             })) /
           count;
  };
  std::vector<IntervalShare> out;
  for (auto end = ends.begin(); end != ends.end(); ++end) {
    out.push_back({*end, *end, share(*end, *end)});
    const auto next = std::next(end);
    if (next == ends.end()) break;
    if (const double between = share(*end, *next); between > 0) out.push_back({*end, *next, between});
  }
  return out;
}

}  // namespace tactus::elicitation
