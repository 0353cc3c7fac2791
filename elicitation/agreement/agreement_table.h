// Puts ratings into a table. Internal to agreement_data.h.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elicitation/agreement/agreement_data.h"

namespace tactus::elicitation {

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

}  // namespace tactus::elicitation
