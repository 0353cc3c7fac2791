#include <algorithm>
#include <cmath>

#include "app/report/claim_parts.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

/// A statement that one input moves the force one way at a fixed setting.
struct OrderStatement {
  std::string id;
  std::string statement;
  std::string input;                   ///< id of the input that is varied
  std::vector<std::string> terms;      ///< its terms, in the order in which the force should fall
  std::vector<CurveSetting> settings;  ///< one per value
  std::string setting_text;
};

std::vector<OrderStatement> statements() {
  return {
      {"10a",
       "Lubricating the tube lowers the insertion force.",
       "lubrication",
       {"poor", "medium", "well"},
       {{0, 90, 30}, {0.5, 90, 30}, {1, 90, 30}},
       "lubrication 0, 0.5, 1 at neck flexion 90 deg, 30 mm/s"},
      {"10b",
       "The insertion force is larger when the neck is not flexed.",
       "neck_flexion",
       {"small", "medium", "large"},
       {{1, 0, 30}, {1, 90, 30}},
       "neck flexion 0, 90 deg at lubrication 1, 30 mm/s"},
      {"10c",
       "The insertion force grows with the insertion speed.",
       "speed",
       {"fast", "medium", "slow"},
       {{1, 90, 200}, {1, 90, 110}, {1, 90, 30}},
       "speed 200, 110, 30 mm/s at lubrication 1, neck flexion 90 deg"},
  };
}

/// How well curves keep the order from the largest to the smallest force.
struct Order {
  std::vector<double> means_n;
  std::size_t depths = 0;    ///< where all curves have a value
  std::size_t in_order = 0;  ///< of those, no later curve above an earlier one
  std::size_t falling = 0;   ///< of those, each curve below the one before
  double worst_n = 0;        ///< largest step against the order
  double worst_depth_mm = 0;
};

Order compare(const std::vector<ForceCurve>& curves) {
  Order order;
  order.means_n.assign(curves.size(), 0);
  for (std::size_t i = 0; i < curves.front().size(); ++i) {
    if (!std::all_of(curves.begin(), curves.end(), [&](const ForceCurve& c) { return c[i].force_n.has_value(); })) {
      continue;
    }
    ++order.depths;
    bool in_order = true;
    bool falling = true;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      order.means_n[k] += *curves[k][i].force_n;
      if (k == 0) continue;
      const double step_n = *curves[k][i].force_n - *curves[k - 1][i].force_n;
      in_order = in_order && step_n <= kTieN;
      falling = falling && step_n < -kTieN;
      if (step_n > order.worst_n) {
        order.worst_n = step_n;
        order.worst_depth_mm = curves[k][i].depth_mm;
      }
    }
    order.in_order += in_order ? 1 : 0;
    order.falling += falling ? 1 : 0;
  }
  for (double& mean_n : order.means_n) mean_n /= std::max<double>(1, static_cast<double>(order.depths));
  return order;
}

std::size_t rankOf(const std::vector<fuzzy::Term>& terms, std::string_view id) {
  std::size_t rank = 0;
  while (rank < terms.size() && terms[rank].id != id) ++rank;
  return rank;
}

/// Places where the expert's own rules go against the statement: a region and two neighboring terms of the input.
std::string opposingRules(const ClaimContext& context, const fuzzy::Expert& expert, const OrderStatement& statement) {
  const auto& output_terms = fuzzy::termsFor(expert, context.model.output);
  const fuzzy::Variable& input = context.input(statement.input);
  std::vector<std::string> places;
  for (const fuzzy::Term& region : fuzzy::termsFor(expert, context.input("depth"))) {
    const fuzzy::Rule* before = nullptr;
    const fuzzy::Condition* before_condition = nullptr;
    for (const std::string& term : statement.terms) {
      for (const fuzzy::Rule& rule : expert.rules) {
        const fuzzy::Condition varied{statement.input, term};
        const auto has = [&](const fuzzy::Condition& wanted) {
          return std::find(rule.conditions.begin(), rule.conditions.end(), wanted) != rule.conditions.end();
        };
        if (!rule.enabled || rule.conditions.size() != 2 || !has(varied) || !has({"depth", region.id})) continue;
        if (before != nullptr && rankOf(output_terms, rule.then) > rankOf(output_terms, before->then)) {
          const auto label = [](const std::vector<fuzzy::Term>& terms, std::string_view id) {
            const fuzzy::Term* found = fuzzy::findTerm(terms, id);
            return base::lowered(found != nullptr && !found->label.empty() ? found->label : std::string(id));
          };
          const auto& input_terms = fuzzy::termsFor(expert, input);
          places.push_back(base::lowered(region.label) + " (" + label(input_terms, before_condition->term) + ": " +
                           label(output_terms, before->then) + ", " + label(input_terms, term) + ": " +
                           label(output_terms, rule.then) + ")");
        }
        before = &rule;
        before_condition = &*std::find(rule.conditions.begin(), rule.conditions.end(), varied);
      }
    }
  }
  return base::joined(places, "; ");
}

std::vector<ForceCurve> curvesOf(const ClaimContext& context, const OrderStatement& statement,
                                 std::optional<std::size_t> expert) {
  std::vector<ForceCurve> curves;
  for (const CurveSetting& setting : statement.settings) curves.push_back(context.curves.curve(setting, expert));
  return curves;
}

Verdict judge(const ClaimContext& context, const OrderStatement& statement, std::optional<std::size_t> expert) {
  const Order order = compare(curvesOf(context, statement, expert));
  Verdict verdict{.subject = expert ? context.model.experts[*expert].id : "mean",
                  .holds = std::nullopt,
                  .basis = expert ? context.basisOf(*expert) : ClaimBasis::kByConstruction,
                  .numbers = {},
                  .reason = {}};
  if (order.depths == 0) {
    verdict.reason = "No rule fires at these settings.";
    return verdict;
  }
  const double share = static_cast<double>(order.in_order) / static_cast<double>(order.depths);
  const double falling = static_cast<double>(order.falling) / static_cast<double>(order.depths);
  bool means_fall = true;
  std::vector<std::string> means;
  for (std::size_t k = 0; k < order.means_n.size(); ++k) {
    means.push_back(base::formatFixed(order.means_n[k], 3));
    means_fall = means_fall && (k == 0 || order.means_n[k] < order.means_n[k - 1] - kTieN);
  }
  verdict.holds = means_fall && share >= kEnoughDepths;
  verdict.numbers = "Mean over depth " + base::joined(means, ", ") + " N for " + statement.setting_text + ". At " +
                    percent(share) + " of the depths no step goes against the statement; every step follows it at " +
                    percent(falling) + '.';
  if (order.worst_n > kTieN) {
    verdict.numbers += " Largest step against it " + newtons(order.worst_n) + " at " +
                       base::formatFixed(order.worst_depth_mm, 0) + " mm (" +
                       whereabouts(context.regions, order.worst_depth_mm) + ").";
  }
  if (!*verdict.holds && expert) {
    const std::string places = opposingRules(context, context.model.experts[*expert], statement);
    verdict.reason = places.empty()
                         ? "No rule of this expert goes against it, but the centroid of several joined terms does not "
                           "always follow a single one of them."
                         : "The rules themselves say otherwise: " + places + '.';
  }
  return verdict;
}

/// For a mean that does not hold: the experts whose own force goes the other way on average.
std::string opposingExperts(const ClaimContext& context, const OrderStatement& statement) {
  std::vector<std::string> opposing;
  for (std::size_t i = 0; i < context.model.experts.size(); ++i) {
    const Order order = compare(curvesOf(context, statement, i));
    if (order.means_n.back() > order.means_n.front() + kTieN) {
      opposing.push_back(context.model.experts[i].id + " (" + newtons(order.means_n.back() - order.means_n.front()) +
                         " on average)");
    }
  }
  return opposing.empty() ? std::string() : "Against it: " + base::joined(opposing, ", ") + '.';
}

}  // namespace

std::vector<Claim> claimsOfOrder(const ClaimContext& context) {
  std::vector<Claim> claims;
  for (const OrderStatement& statement : statements()) {
    Claim claim{.id = statement.id,
                .statement = statement.statement,
                .rule =
                    "Yes if the mean over depth falls from each setting to the next and no curve lies above the one "
                    "before it at " +
                    percent(kEnoughDepths) + " of the depths (ties allowed).",
                .verdicts = {}};
    claim.verdicts.push_back(judge(context, statement, context.published_expert));
    claim.verdicts.push_back(judge(context, statement, std::nullopt));
    Verdict& mean = claim.verdicts.back();
    if (mean.holds && !*mean.holds) mean.reason = opposingExperts(context, statement);
    claims.push_back(std::move(claim));
  }
  return claims;
}

}  // namespace tactus::report
