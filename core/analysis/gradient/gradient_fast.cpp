// The fast path: only active terms, only rules that can fire, the closed form of the centroid.
#include <algorithm>
#include <bit>

#include "core/analysis/gradient/gradient_paths.h"

namespace tactus::analysis {
namespace {

void fuzzify(const GradientTables& tables, const GradientExpert& expert, std::span<const double> clamped,
             FastPoint& point) noexcept {
  for (std::size_t i = 0; i < clamped.size(); ++i) {
    if (point.bank[i] == expert.bank[i]) continue;
    point.bank[i] = expert.bank[i];
    const InputPieces& pieces = *tables.banks[expert.bank[i]].pieces;
    point.segment[i] = pieces.segmentOf(clamped[i]);
    for (const MembershipPiece& piece : pieces.piecesOf(point.segment[i])) {
      const std::size_t place = i * fuzzy::kMostTerms + piece.term;
      point.membership[place] = piece.membership(clamped[i]);
      point.piece[place] = &piece;
    }
  }
}

/// For each lane the largest strength, the first rule that gives it, and the place of that rule's first smallest
/// membership.
struct Winners {
  OrderedSets::Strengths strength;
  std::array<std::uint32_t, OrderedSets::kSpare + 1> rule;
  std::array<std::uint32_t, OrderedSets::kSpare + 1> place;
  std::uint64_t active = 0;  ///< lanes with a strength > 0, a bit each
};

void fire(const FastRules& fast, std::size_t lanes, const FastPoint& point, Winners& winners) noexcept {
  std::fill_n(winners.strength.begin(), lanes + 1, 0.0);
  const FastRules::Rule* const all = fast.rules.data();
  const std::uint16_t* const all_places = fast.places.data();
  const std::size_t stride = fast.stride;
  for (std::size_t word = 0; word < fast.words; ++word) {
    std::uint64_t rules = ~std::uint64_t{0};
    for (const FastRules::Input& input : fast.inputs)
      rules &= fast.bits[input.first_word + point.segment[input.input] * fast.words + word];
    for (; rules != 0; rules &= rules - 1) {
      const std::size_t r = word * 64 + static_cast<std::size_t>(std::countr_zero(rules));
      const std::uint16_t* const places = all_places + r * stride;
      std::uint32_t place = places[0];
      double membership = point.membership[place];
      for (std::size_t c = 1; c < stride; ++c) {
        const double other = point.membership[places[c]];
        place = other < membership ? places[c] : place;
        membership = std::min(other, membership);
      }
      // Losers are written beside the lanes: a branch here could not be foreseen.
      const std::size_t lane = all[r].lane;
      const double strength = all[r].weight * membership;
      const bool wins = strength > winners.strength[lane];
      const std::size_t to = OrderedSets::kSpare - wins * (OrderedSets::kSpare - lane);
      winners.strength[to] = strength;
      winners.rule[to] = static_cast<std::uint32_t>(r);
      winners.place[to] = place;
      winners.active |= static_cast<std::uint64_t>(wins) << lane;
    }
  }
}

/// From the strength of an output term to its winning rule: its weight, and its smallest membership.
void addRule(const FastRules::Rule& rule, std::size_t place, std::span<const double> clamped, const FastPoint& point,
             double by_strength, GradientSink& sink) noexcept {
  const double membership = point.membership[place];
  sink.touch(rule.slot);
  sink.add(rule.slot, by_strength * membership);

  const std::size_t input = place / fuzzy::kMostTerms;
  const MembershipPiece& piece = *point.piece[place];
  const double by_input = by_strength * rule.weight * piece.slope;
  sink.addInput(input, by_input);
  sink.touch(piece.group);
  sink.add(piece.foot_slot, -by_input * piece.rest(clamped[input]));
  sink.add(piece.shoulder_slot, -by_input * membership);
}

}  // namespace

Firing addFast(const GradientTables& tables, const GradientExpert& expert, std::span<const double> clamped,
               FastPoint& point, GradientSink& sink, double& offset) noexcept {
  const OrderedSets& sets = *tables.banks[expert.bank.back()].ordered;
  fuzzify(tables, expert, clamped, point);
  Winners winners;
  fire(*expert.fast, sets.count(), point, winners);
  if (winners.active == 0) return Firing::kAbstains;

  OrderedSets::Gradients gradients;
  const auto centroid = sets.centroid(winners.strength, winners.active, gradients);
  if (!centroid) return Firing::kOpen;
  offset = *centroid;
  for (std::uint64_t left = winners.active; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const auto& [a, b, c, d] = sets.slotsOf(lane);
    const LaneGradient& by = gradients[lane];
    sink.touch(a);
    sink.add(a, expert.weight * by.foot[0]);
    sink.add(b, expert.weight * by.shoulder[0]);
    sink.add(c, expert.weight * by.shoulder[1]);
    sink.add(d, expert.weight * by.foot[1]);
    addRule(expert.fast->rules[winners.rule[lane]], winners.place[lane], clamped, point, expert.weight * by.strength,
            sink);
  }
  return Firing::kFires;
}

}  // namespace tactus::analysis
