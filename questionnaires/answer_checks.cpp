#include "questionnaires/answer_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/study/data_finding.h"

namespace tactus::questionnaires {
namespace {

using study::Answer;
using study::DataFinding;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;

constexpr std::size_t kFewest = 20;
constexpr double kOneAnswerShare = 0.9;
constexpr double kOpposite = -0.5;
constexpr double kCopiedShare = 0.95;
constexpr std::size_t kFewestOthers = 2;
// Correlations of well-made answers: tests/app/session/false_alarms_test.cpp.
constexpr double kShifted = 0.5;
constexpr double kShiftedBetter = 0.3;
// The same where two or more levels of an input are exchanged: few items say it, so it must be plain.
constexpr double kExchanged = 0.6;
constexpr std::size_t kFewestMoved = 9;
constexpr int kNoItem = -1;
// A pattern of three can be meant: the form asks about three levels of one input after another.
constexpr std::array<std::size_t, 3> kPatterns = {2, 4, 5};

/// The answers of one participant to one form, as places of terms by item.
struct Sheet {
  std::vector<const Answer*> rows;
  std::map<int, int> terms;

  const std::string& who() const { return rows.front()->participant; }
};

DataFinding unknown(Kind kind, const Answer& row, std::string_view column, const std::string& found,
                    const std::string& wanted) {
  auto out = study::remark(kind, Severity::kRefused, row, column,
                           row.participant + " has " + found + " to form " + row.form + "; wanted " + wanted + '.');
  out.found = found;
  out.wanted = wanted;
  return out;
}

class FormChecks {
 public:
  explicit FormChecks(const study::Form& form) : form_(form) {
    for (const auto& word : form.answers) terms_.push_back(word.term);
  }

  std::vector<DataFinding> check(std::span<const Answer> answers) {
    for (const auto& answer : answers) {
      if (answer.form == form_.id) add(answer);
    }
    for (auto& sheet : sheets_) readTerms(sheet);
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
      if (checkOneAnswer(sheets_[i]) || checkPattern(sheets_[i])) continue;
      checkOpposite(i);
      if (!checkCopied(i) && !checkShifted(i)) checkExchanged(i);
    }
    return std::move(out_);
  }

 private:
  void add(const Answer& answer) {
    auto sheet = std::find_if(sheets_.rbegin(), sheets_.rend(),
                              [&answer](const Sheet& other) { return other.who() == answer.participant; });
    if (sheet == sheets_.rend()) {
      sheets_.emplace_back();
      sheet = sheets_.rbegin();
    }
    sheet->rows.push_back(&answer);
  }

  void readTerms(Sheet& sheet) {
    bool unknown_item = false;
    bool unknown_term = false;
    for (const auto* row : sheet.rows) {
      const bool known = std::any_of(form_.items.begin(), form_.items.end(),
                                     [row](const study::FormItem& item) { return item.number == row->item; });
      if (!known && !unknown_item) {
        unknown_item = true;
        out_.push_back(unknown(Kind::kUnknownItem, *row, "item",
                               "item " + std::to_string(row->item) + ", which form " + form_.id + " does not have",
                               "one of its " + std::to_string(form_.items.size()) + " items"));
      }
      if (row->status != Answer::Status::kAnswered) continue;
      const auto term = std::find(terms_.begin(), terms_.end(), row->term);
      if (term != terms_.end()) {
        sheet.terms[row->item] = static_cast<int>(term - terms_.begin());
      } else if (!unknown_term) {
        unknown_term = true;
        out_.push_back(unknown(Kind::kUnknownAnswerTerm, *row, "term", base::quoted(row->term),
                               "one of " + base::joined(terms_, ", ") + base::suggestion(row->term, terms_)));
      }
    }
  }

  bool checkOneAnswer(const Sheet& sheet) {
    if (sheet.terms.size() < kFewest) return false;
    std::vector<std::size_t> counts(terms_.size());
    for (const auto& [item, term] : sheet.terms) ++counts[static_cast<std::size_t>(term)];
    const auto most = std::max_element(counts.begin(), counts.end());
    if (static_cast<double>(*most) < kOneAnswerShare * static_cast<double>(sheet.terms.size())) return false;
    out_.push_back(study::remark(Kind::kOneAnswer, Severity::kWarning, *sheet.rows.front(), "term",
                                 sheet.who() + " answers " + std::to_string(*most) + " of " +
                                     std::to_string(sheet.terms.size()) + " items with " +
                                     base::quoted(terms_[static_cast<std::size_t>(most - counts.begin())]) +
                                     ": the force would hardly depend on anything."));
    return true;
  }

  bool checkPattern(const Sheet& sheet) {
    if (sheet.terms.size() < kFewest) return false;
    std::vector<int> terms;
    for (const auto& [item, term] : sheet.terms) terms.push_back(term);
    std::size_t runs = 1;
    for (std::size_t i = 1; i < terms.size(); ++i) runs += terms[i] == terms[i - 1] ? 0 : 1;
    if (runs == std::set<int>(terms.begin(), terms.end()).size()) {
      out_.push_back(study::remark(
          Kind::kAnswerPattern, Severity::kWarning, *sheet.rows.front(), "term",
          "All equal answers of " + sheet.who() + " stand one below the other: the column sorted without its items?"));
      return true;
    }
    for (const std::size_t length : kPatterns) {
      const auto begin = static_cast<std::ptrdiff_t>(length);
      if (!std::equal(terms.begin() + begin, terms.end(), terms.begin())) continue;
      out_.push_back(study::remark(Kind::kAnswerPattern, Severity::kWarning, *sheet.rows.front(), "term",
                                   sheet.who() + " repeats the same " + std::to_string(length) +
                                       " answers through the whole form: filled in without reading?"));
      return true;
    }
    return false;
  }

  /// Correlation of the answers of one participant with the mean that the others gave to the item `of(item)`, over
  /// items that two others answered.
  template <class Of>
  std::optional<double> agreementWith(std::size_t i, Of of, std::size_t fewest = kFewest) const {
    std::vector<std::pair<double, double>> pairs;
    for (const auto& [item, term] : sheets_[i].terms) {
      double sum = 0;
      std::size_t count = 0;
      for (std::size_t k = 0; k < sheets_.size(); ++k) {
        const auto other = sheets_[k].terms.find(of(item));
        if (k == i || other == sheets_[k].terms.end()) continue;
        sum += other->second;
        ++count;
      }
      if (count >= kFewestOthers) pairs.emplace_back(term, sum / static_cast<double>(count));
    }
    return pairs.size() < fewest ? std::nullopt : correlation(pairs);
  }

  std::optional<double> agreement(std::size_t i, int shift) const {
    return agreementWith(i, [shift](int item) { return item + shift; });
  }

  /// The item that asks for the same situation but for the levels of `input`, which are exchanged as `levels` says.
  std::map<int, int> exchanged(const std::string& input, const std::map<std::string, std::string>& levels) const {
    std::map<int, int> out;
    for (const study::FormItem& item : form_.items) {
      auto wanted = item.conditions;
      for (auto& condition : wanted) {
        const auto level = condition.input == input ? levels.find(condition.term) : levels.end();
        if (level != levels.end()) condition.term = level->second;
      }
      const auto found = std::find_if(form_.items.begin(), form_.items.end(),
                                      [&](const study::FormItem& other) { return other.conditions == wanted; });
      if (found != form_.items.end()) out[item.number] = found->number;
    }
    return out;
  }

  /// The inputs of the form with their levels, in the order in which they are asked for first.
  std::vector<std::pair<std::string, std::vector<std::string>>> inputs() const {
    std::vector<std::pair<std::string, std::vector<std::string>>> out;
    for (const study::FormItem& item : form_.items) {
      for (const study::ItemCondition& condition : item.conditions) {
        auto input =
            std::find_if(out.begin(), out.end(), [&](const auto& one) { return one.first == condition.input; });
        if (input == out.end()) input = out.insert(out.end(), {condition.input, {}});
        auto& levels = input->second;
        if (std::find(levels.begin(), levels.end(), condition.term) == levels.end()) levels.push_back(condition.term);
      }
    }
    return out;
  }

  /// Whether the answers fit those of the others far better with the levels of one input in the reverse order, or two
  /// of them exchanged. Only the items that would be others say something of it.
  void checkExchanged(std::size_t i) {
    std::optional<double> best;
    double best_own = 0;
    std::string what;
    const auto look = [&](const std::string& input, const std::map<std::string, std::string>& levels,
                          const std::string& words) {
      auto items = exchanged(input, levels);
      std::erase_if(items, [](const auto& one) { return one.first == one.second; });
      const auto moved = [&items](int item) { return items.contains(item) ? items.at(item) : kNoItem; };
      const auto own = agreementWith(
          i, [&](int item) { return items.contains(item) ? item : kNoItem; }, kFewestMoved);
      const auto r = agreementWith(i, moved, kFewestMoved);
      if (!own || !r || *r < kExchanged || *r < *own + kExchanged || (best && *r - *own <= *best - best_own)) return;
      best = r;
      best_own = *own;
      what = words;
    };
    for (const auto& [input, levels] : inputs()) {
      std::map<std::string, std::string> reversed;
      for (std::size_t k = 0; k < levels.size(); ++k) reversed[levels[k]] = levels[levels.size() - 1 - k];
      look(input, reversed, "the levels of " + base::quoted(input) + " in the reverse order");
      for (std::size_t a = 0; a < levels.size(); ++a) {
        for (std::size_t b = a + 1; b < levels.size(); ++b) {
          look(input, {{levels[a], levels[b]}, {levels[b], levels[a]}},
               base::quoted(levels[a]) + " and " + base::quoted(levels[b]) + " of " + base::quoted(input) +
                   " exchanged");
        }
      }
    }
    if (!best) return;
    out_.push_back(study::remark(Kind::kAnswersShifted, Severity::kWarning, *sheets_[i].rows.front(), "item",
                                 "The answers of " + sheets_[i].who() + " fit those of the others far better with " +
                                     what + " (correlation " + base::formatFixed(*best, 2) + " instead of " +
                                     base::formatFixed(best_own, 2) + " there): typed in another order?"));
  }

  void checkOpposite(std::size_t i) {
    const auto r = agreement(i, 0);
    if (!r || *r > kOpposite) return;
    out_.push_back(study::remark(Kind::kAnswersReversed, Severity::kWarning, *sheets_[i].rows.front(), "term",
                                 sheets_[i].who() + " answers the opposite of the others (correlation " +
                                     base::formatFixed(*r, 2) + "): the scale the other way round?"));
  }

  /// Whether the answers fit the items before or after far better than their own.
  bool checkShifted(std::size_t i) {
    const auto own = agreement(i, 0);
    if (!own) return false;
    for (const int shift : {1, -1}) {
      const auto r = agreement(i, shift);
      if (!r || *r < kShifted || *r < *own + kShiftedBetter) continue;
      out_.push_back(study::remark(Kind::kAnswersShifted, Severity::kWarning, *sheets_[i].rows.front(), "item",
                                   "The answers of " + sheets_[i].who() + " fit what the others say of the item " +
                                       (shift > 0 ? "after" : "before") + " (correlation " + base::formatFixed(*r, 2) +
                                       ") far better than of the same item (" + base::formatFixed(*own, 2) +
                                       "): shifted by a row?"));
      return true;
    }
    return false;
  }

  static std::optional<double> correlation(const std::vector<std::pair<double, double>>& pairs) {
    double mean_a = 0;
    double mean_b = 0;
    for (const auto& [a, b] : pairs) {
      mean_a += a / static_cast<double>(pairs.size());
      mean_b += b / static_cast<double>(pairs.size());
    }
    double aa = 0;
    double bb = 0;
    double ab = 0;
    for (const auto& [a, b] : pairs) {
      aa += (a - mean_a) * (a - mean_a);
      bb += (b - mean_b) * (b - mean_b);
      ab += (a - mean_a) * (b - mean_b);
    }
    if (aa <= 0 || bb <= 0) return std::nullopt;
    return ab / std::sqrt(aa * bb);
  }

  bool checkCopied(std::size_t i) {
    for (std::size_t k = 0; k < i; ++k) {
      std::size_t both = 0;
      std::map<int, std::size_t> differences;
      for (const auto& [item, term] : sheets_[i].terms) {
        const auto other = sheets_[k].terms.find(item);
        if (other == sheets_[k].terms.end()) continue;
        ++both;
        ++differences[term - other->second];
      }
      if (both < kFewest) continue;
      for (const int shift : {0, 1, -1}) {
        const std::size_t alike = differences[shift];
        if (static_cast<double>(alike) < kCopiedShare * static_cast<double>(both)) continue;
        out_.push_back(study::remark(Kind::kAnswersCopied, Severity::kWarning, *sheets_[i].rows.front(), "term",
                                     "The answers of " + sheets_[i].who() + " are those of " + sheets_[k].who() +
                                         (shift == 0 ? "" : ", one term away,") + " in " + std::to_string(alike) +
                                         " of " + std::to_string(both) + " items: copied?"));
        return true;
      }
    }
    return false;
  }

  const study::Form& form_;
  std::vector<std::string> terms_;
  std::vector<Sheet> sheets_;
  std::vector<DataFinding> out_;
};

/// Whether all were asked the same: two wordings of a form are two questions.
std::optional<DataFinding> mixedWordings(std::span<const Answer> answers, const std::string& form) {
  std::map<std::string, std::vector<std::string>> people;  // by wording; empty: not known
  const Answer* first = nullptr;
  for (const Answer& answer : answers) {
    if (answer.form != form || answer.status != Answer::Status::kAnswered) continue;
    auto& asked = people[answer.wording];
    if (std::find(asked.begin(), asked.end(), answer.participant) == asked.end()) asked.push_back(answer.participant);
    if (first == nullptr) first = &answer;
  }
  const std::size_t known = people.size() - people.count({});
  if (people.size() < 2) return std::nullopt;
  std::vector<std::string> parts;
  for (const auto& [wording, codes] : people) {
    if (!wording.empty()) parts.push_back(base::quoted(wording) + " (" + base::joined(codes, ", ") + ")");
  }
  if (const auto it = people.find({}); it != people.end())
    parts.push_back("words that are not known (" + base::joined(it->second, ", ") + ")");
  const std::string asked = base::joined(parts, ", ");
  DataFinding mixed;
  mixed.kind = Kind::kWordingsMixed;
  mixed.severity = known > 1 ? Severity::kWarning : Severity::kNote;
  mixed.cell = study::cellOf(*first, "wording");
  mixed.sentence = "The form " + base::quoted(form) + " was asked in " + asked +
                   (known > 1 ? ": these are two questions; compare the models of each group before they are averaged."
                              : "; give the column `wording` where it is known.");
  return mixed;
}

}  // namespace

std::vector<DataFinding> answerFindings(std::span<const Answer> answers, std::span<const study::Form> forms) {
  std::vector<DataFinding> out;
  for (const auto& form : forms) {
    if (form.items.empty()) continue;
    study::append(out, FormChecks(form).check(answers));
    if (auto mixed = mixedWordings(answers, form.id)) out.push_back(std::move(*mixed));
  }
  return out;
}

}  // namespace tactus::questionnaires
