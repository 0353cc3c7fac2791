#include <algorithm>
#include <cmath>

#include "app/report/claims.h"
#include "core/base/text.h"

namespace tactus::report {
namespace {

Verdict verdictFor(const Profile& profile) {
  Verdict verdict{
      .subject = profile.subject, .holds = std::nullopt, .basis = profile.basis, .numbers = {}, .reason = {}};
  if (profile.curve.empty()) verdict.reason = "No rule fires at this setting.";
  return verdict;
}

/// The first rise of a curve that is followed by a drop, both at least kVisibleN.
struct Bump {
  CurvePoint before, top, after;
  bool risen = false;
  bool dropped = false;
};

Bump firstBump(const ForceCurve& curve) {
  Bump bump{curve.front(), curve.front(), curve.front()};
  for (const CurvePoint& point : curve) {
    const double force_n = *point.force_n;
    if (!bump.risen) {
      if (force_n < *bump.before.force_n) bump.before = point;
      bump.risen = force_n - *bump.before.force_n >= kVisibleN;
      if (bump.risen) bump.top = bump.after = point;
    } else if (!bump.dropped && force_n > *bump.top.force_n) {
      bump.top = bump.after = point;
    } else if (force_n < *bump.after.force_n) {
      bump.after = point;
      bump.dropped = bump.dropped || *bump.top.force_n - force_n >= kVisibleN;
    } else if (bump.dropped && force_n - *bump.after.force_n >= kVisibleN) {
      break;
    }
  }
  return bump;
}

/// Why the force is constant in the nasal cavity, if its term is a shoulder from the start.
std::string shoulderReason(const ClaimContext& context, const Profile& profile) {
  const fuzzy::Variable& depth = context.input("depth");
  const auto& terms = profile.expert ? fuzzy::termsFor(context.model.experts[*profile.expert], depth) : depth.terms;
  const fuzzy::Term* nasal = fuzzy::findTerm(terms, "nasal_cavity");
  if (nasal == nullptr || nasal->shape != fuzzy::Shape::kTrapezoid || nasal->points[1] > depth.min) return {};
  return "The membership function of the nasal cavity is a shoulder: 1 from " + millimeters(depth.min) + " to " +
         millimeters(nasal->points[2]) + ", so there the force cannot change with depth.";
}

Verdict nasalBump(const ClaimContext& context, const Profile& profile) {
  Verdict verdict = verdictFor(profile);
  if (profile.curve.empty()) return verdict;
  const double nasal_end_mm = regionOf(context.regions, "nasal_cavity").to_mm;
  const Bump bump = firstBump(profile.curve);
  verdict.holds = bump.risen && bump.dropped && bump.top.depth_mm <= nasal_end_mm;
  if (!bump.risen) {
    verdict.numbers = "The force never rises by " + newtons(kVisibleN) + " or more.";
  } else {
    verdict.numbers = "First rise from " + newtons(*bump.before.force_n) + " at " + millimeters(bump.before.depth_mm) +
                      " to " + newtons(*bump.top.force_n) + " at " + millimeters(bump.top.depth_mm) + " (" +
                      whereabouts(context.regions, bump.top.depth_mm) + ")";
    verdict.numbers += bump.dropped ? ", then a drop to " + newtons(*bump.after.force_n) + " at " +
                                          millimeters(bump.after.depth_mm) + "."
                                    : ", no drop after it.";
  }
  if (!*verdict.holds) verdict.reason = shoulderReason(context, profile);
  return verdict;
}

Verdict oropharyngealPeak(const ClaimContext& context, const Profile& profile) {
  Verdict verdict = verdictFor(profile);
  if (profile.curve.empty()) return verdict;
  const Region& nasopharynx = regionOf(context.regions, "nasopharynx");
  const Region& oropharynx = regionOf(context.regions, "oropharynx");
  const std::vector<CurvePoint> peaks = peaksOf(profile.curve);
  const auto inside = std::find_if(peaks.begin(), peaks.end(), [&](const CurvePoint& point) {
    return point.depth_mm >= oropharynx.from_mm && point.depth_mm <= oropharynx.to_mm;
  });
  double low_n = *peaks.front().force_n;
  for (const CurvePoint& point : profile.curve) {
    if (point.depth_mm >= nasopharynx.from_mm && point.depth_mm <= peaks.front().depth_mm) {
      low_n = std::min(low_n, *point.force_n);
    }
  }
  const double rise_n = *peaks.front().force_n - low_n;
  verdict.holds = inside != peaks.end() && rise_n >= kVisibleN;
  verdict.numbers = "Peak " + peakText(context, peaks) + ", " + newtons(rise_n) +
                    " above the lowest force since the nasopharynx was reached at " + millimeters(nasopharynx.from_mm) +
                    ".";
  if (!*verdict.holds && profile.expert) {
    const fuzzy::Expert& expert = context.model.experts[*profile.expert];
    if (!wasAsked(expert, "oropharynx")) verdict.reason = "No rule of this expert is about the oropharynx.";
  }
  return verdict;
}

}  // namespace

std::vector<Claim> claimsOfProfile(const ClaimContext& context) {
  std::vector<Profile> profiles = {profileOf(context, context.published_expert), profileOf(context, std::nullopt)};
  for (std::size_t i = 0; i < context.model.experts.size(); ++i) {
    if (i != context.published_expert) profiles.push_back(profileOf(context, i));
  }
  const std::string visible = newtons(kVisibleN);
  Claim bump{"11a",
             "In the nasal cavity the force first rises, then drops slightly.",
             "Yes if the first rise of at least " + visible + " that is followed by a drop of at least " + visible +
                 " has its top inside the nasal cavity.",
             {}};
  Claim peak{"11b",
             "After the nasopharynx is reached the force rises again and peaks in the oropharynx.",
             "Yes if the largest force of the whole curve lies inside the oropharynx, limits included, at least " +
                 visible + " above the lowest force since the nasopharynx was reached.",
             {}};
  for (const Profile& profile : profiles) {
    bump.verdicts.push_back(nasalBump(context, profile));
    peak.verdicts.push_back(oropharyngealPeak(context, profile));
  }
  return {std::move(bump), std::move(peak)};
}

namespace {

/// A statement that one input moves the force one way at a fixed setting.
struct OrderStatement {
  std::string id;
  std::string statement;
  std::string input;                   ///< id of the input that is varied
  std::vector<std::string> terms;      ///< its terms, in the order in which the force should fall
  std::vector<PaperSetting> settings;  ///< one per value
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
  for (const PaperSetting& setting : statement.settings) curves.push_back(context.curve(setting, expert));
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
