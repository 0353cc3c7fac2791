#include "elicitation/agreement/agreement_data.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::elicitation {

Ratings::Ratings(std::size_t units, std::size_t raters, std::size_t categories)
    : units_(units), raters_(raters), categories_(categories), values_(units * raters) {}

std::size_t Ratings::place(std::size_t unit, std::size_t rater) const {
  TACTUS_CHECK(unit < units_ && rater < raters_);
  return unit * raters_ + rater;
}

std::optional<std::size_t> Ratings::at(std::size_t unit, std::size_t rater) const {
  return values_[place(unit, rater)];
}

void Ratings::set(std::size_t unit, std::size_t rater, std::size_t category) {
  TACTUS_CHECK(category < categories_);
  values_[place(unit, rater)] = category;
}

RatingCounts countRatings(const Ratings& ratings) {
  RatingCounts counts{ratings.categories(), {}};
  for (std::size_t unit = 0; unit < ratings.units(); ++unit) {
    auto& row = counts.units.emplace_back(ratings.categories());
    for (std::size_t rater = 0; rater < ratings.raters(); ++rater) {
      if (const auto category = ratings.at(unit, rater)) ++row[*category];
    }
  }
  return counts;
}

long long ratingsOf(const std::vector<int>& unit) { return std::accumulate(unit.begin(), unit.end(), 0LL); }

// Puts ratings into a table. Internal to agreement_data.h.

/// A rating before units and raters have indices.
template <class Unit>
struct Rating {
  std::string participant;
  Unit unit;
  std::size_t term;
};

/// Puts `ratings` into a table: units in the order of `units`, raters in the order of their first rating.
template <class Unit>
void fillTable(AgreementData& data, const std::vector<Rating<Unit>>& ratings, const std::vector<Unit>& units) {
  std::map<std::string, std::size_t> raters;
  for (const auto& rating : ratings) {
    if (raters.emplace(rating.participant, raters.size()).second) data.raters.push_back(rating.participant);
  }
  std::map<Unit, std::size_t> places;
  for (const auto& unit : units) places.emplace(unit, places.size());
  Ratings table(units.size(), raters.size(), data.terms.size());
  for (const auto& rating : ratings) table.set(places.at(rating.unit), raters.at(rating.participant), rating.term);
  data.counts = countRatings(table);
  data.ratings = std::move(table);
}

/// Notes the units without a rating, which are therefore not in `data`.
void noteUnrated(const std::vector<std::string>& units, AgreementData& data);

/// Notes the participants among `all` who gave no rating.
void noteSilent(const std::set<std::string>& all, AgreementData& data);

namespace {

using base::ErrorCode;
using base::Result;

std::string count(std::size_t number, const std::string& what) {
  return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
}

struct FormRatings {
  std::string form;
  std::size_t answers = 0;
  std::size_t ratings = 0;
};

/// The forms of `answers` in the order of their first answer.
std::vector<FormRatings> formsOf(std::span<const study::Answer> answers) {
  std::vector<FormRatings> out;
  std::map<std::string, std::size_t> places;
  for (const auto& answer : answers) {
    const auto [place, added] = places.emplace(answer.form, out.size());
    if (added) out.push_back({answer.form, 0, 0});
    ++out[place->second].answers;
    out[place->second].ratings += answer.status == study::Answer::Status::kAnswered ? 1 : 0;
  }
  return out;
}

/// The form asked for, or the one with the most ratings, with a note about the others.
Result<std::string> chooseForm(std::span<const study::Answer> answers, std::string_view asked, AgreementData& data) {
  const auto forms = formsOf(answers);
  std::vector<std::string> names;
  names.reserve(forms.size());
  for (const auto& form : forms) names.push_back(form.form);
  const auto table_line = answers.empty() ? study::TableLine{} : answers.front().line;
  if (forms.empty() || (!asked.empty() && std::find(names.begin(), names.end(), asked) == names.end())) {
    return study::inTable({ErrorCode::kData,
                           {},
                           "answers",
                           asked.empty() ? "no row" : "no row of form " + base::quoted(asked),
                           "answers to a form" + (names.empty() ? "" : " (there are: " + base::listed(names) + ")")},
                          study::kAnswersTable, table_line);
  }
  std::string chosen(asked);
  if (chosen.empty()) {
    chosen = std::max_element(forms.begin(), forms.end(), [](const FormRatings& a, const FormRatings& b) {
               return a.ratings < b.ratings;
             })->form;
  }
  std::vector<std::string> others;
  for (const auto& form : forms) {
    if (form.form != chosen) others.push_back(base::quoted(form.form) + " (" + count(form.ratings, "rating") + ")");
  }
  if (!others.empty()) {
    data.notes.push_back("Only the answers to form " + base::quoted(chosen) +
                         " are compared; there are also answers to " + base::joined(others, ", ") +
                         ". Items of different forms are different questions.");
  }
  return chosen;
}

struct AnswerReader {
  const study::Form* form;  ///< null where it is not known
  std::span<const std::string> terms;

  /// The place of the answer's term; nothing where the answer is missing.
  Result<std::optional<std::size_t>> termOf(const study::Answer& answer) const {
    if (form != nullptr && std::none_of(form->items.begin(), form->items.end(), [&answer](const study::FormItem& item) {
          return item.number == answer.item;
        })) {
      const std::string number = "item " + std::to_string(answer.item);
      return refused(answer, ErrorCode::kReference, "item", number + ", which form " + form->id + " does not have",
                     "one of its " + count(form->items.size(), "item"));
    }
    if (answer.status != study::Answer::Status::kAnswered) return std::nullopt;
    const auto term = std::find(terms.begin(), terms.end(), answer.term);
    if (term == terms.end()) {
      return refused(answer, ErrorCode::kReference, "term", base::quoted(answer.term),
                     "one of " + base::joined(terms, ", "));
    }
    return static_cast<std::size_t>(term - terms.begin());
  }

  static tl::unexpected<base::Error> refused(const study::Answer& answer, ErrorCode code, std::string_view column,
                                             const std::string& found, std::string wanted) {
    const std::string place = "answer of participant " + answer.participant + " to item " +
                              std::to_string(answer.item) + " of form " + answer.form;
    return study::atCell({code, {}, place, found, std::move(wanted)}, {study::kAnswersTable, answer.line, column},
                         found);
  }
};

}  // namespace

Result<AgreementData> agreementData(std::span<const study::Answer> answers, std::string_view form_id,
                                    std::span<const study::Form> forms, std::span<const std::string> terms) {
  AgreementData data;
  TACTUS_TRY(auto chosen, chooseForm(answers, form_id, data));
  data.form = std::move(chosen);
  const auto known = std::find_if(forms.begin(), forms.end(), [&data](const study::Form& form) {
    return form.id == data.form && !form.items.empty();
  });
  const study::Form* form = known == forms.end() ? nullptr : &*known;
  data.terms.assign(terms.begin(), terms.end());
  if (form != nullptr && !form->answers.empty()) {
    data.terms.clear();
    for (const auto& word : form->answers) data.terms.push_back(word.term);
  }
  if (form == nullptr) {
    data.notes.push_back("Form " + base::quoted(data.form) +
                         " is not known here: its items are those that the table names.");
  }

  const AnswerReader reader{form, data.terms};
  std::vector<Rating<int>> ratings;
  std::set<std::string> people;
  std::set<int> items;
  std::set<int> rated;
  std::set<std::pair<std::string, int>> seen;
  for (const auto& answer : answers) {
    if (answer.form != data.form) continue;
    TACTUS_TRY(const auto term, reader.termOf(answer));
    if (!seen.emplace(answer.participant, answer.item).second) {
      return AnswerReader::refused(
          answer, ErrorCode::kData, "item",
          "item " + std::to_string(answer.item) + " of participant " + answer.participant + " again",
          "one answer per participant and item");
    }
    people.insert(answer.participant);
    items.insert(answer.item);
    if (!term) continue;
    rated.insert(answer.item);
    ratings.push_back({answer.participant, answer.item, *term});
  }
  if (form != nullptr) {
    for (const auto& item : form->items) items.insert(item.number);
  }

  fillTable(data, ratings, std::vector<int>(rated.begin(), rated.end()));
  for (const int item : rated) {
    RatedUnit unit{"item " + std::to_string(item), {}, item, {}};
    if (form != nullptr) {
      unit.text = std::find_if(form->items.begin(), form->items.end(), [item](const study::FormItem& one) {
                    return one.number == item;
                  })->text;
    }
    data.units.push_back(std::move(unit));
  }
  std::vector<std::string> unrated;
  for (const int item : items) {
    if (!rated.contains(item)) unrated.push_back("item " + std::to_string(item));
  }
  noteUnrated(unrated, data);
  noteSilent(people, data);
  return data;
}

namespace {

std::string forceName(double force_n) { return base::formatNumber(force_n) + " N"; }

}  // namespace

void noteUnrated(const std::vector<std::string>& units, AgreementData& data) {
  if (units.empty()) return;
  data.notes.push_back("Left out, because no participant chose a term: " + base::joined(units, ", ") + ".");
}

void noteSilent(const std::set<std::string>& all, AgreementData& data) {
  std::vector<std::string> silent;
  for (const auto& one : all) {
    if (std::find(data.raters.begin(), data.raters.end(), one) == data.raters.end()) silent.push_back(one);
  }
  if (silent.empty()) return;
  data.notes.push_back("Left out, because they chose no term: " + base::listed(silent) + ".");
}

base::Result<AgreementData> agreementData(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                          std::span<const std::string> terms) {
  const auto steps = countVotes(judgements, series, terms);
  if (!steps) return tl::unexpected(steps.error());
  AgreementData data = agreementData(*steps, terms);

  const auto step_at = [&steps](double force_n) {
    return static_cast<std::size_t>(
        std::find_if(steps->begin(), steps->end(),
                     [force_n](const VoteCounts& step) { return force_n - step.force_n <= kSameForceN; }) -
        steps->begin());
  };
  std::vector<Rating<std::size_t>> ratings;
  std::vector<std::size_t> rated;
  std::set<std::string> people;
  for (std::size_t i = 0; i < steps->size(); ++i) {
    if (ratingsOf((*steps)[i].votes) > 0) rated.push_back(i);
  }
  for (const auto& judgement : judgements) {
    if (judgement.series != series) continue;
    people.insert(judgement.participant);
    if (judgement.kind != study::ForceJudgement::Kind::kTerm) continue;
    const auto term = std::find(terms.begin(), terms.end(), judgement.term) - terms.begin();
    ratings.push_back({judgement.participant, step_at(judgement.force_n), static_cast<std::size_t>(term)});
  }
  fillTable(data, ratings, rated);
  noteSilent(people, data);
  return data;
}

AgreementData agreementData(std::span<const VoteCounts> steps, std::span<const std::string> terms) {
  AgreementData data;
  data.terms.assign(terms.begin(), terms.end());
  data.counts.categories = terms.size();
  std::vector<std::string> unrated;
  for (const auto& step : steps) {
    if (ratingsOf(step.votes) == 0) {
      unrated.push_back(forceName(step.force_n));
      continue;
    }
    data.counts.units.push_back(step.votes);
    data.units.push_back({forceName(step.force_n), step.force_n, {}, {}});
  }
  noteUnrated(unrated, data);
  return data;
}

}  // namespace tactus::elicitation
