#include "app/planning/band_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/planning/simulated_studies.h"
#include "core/base/in_parallel.h"
#include "core/base/statistics.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/uncertainty/force_bands.h"

namespace tactus::planning {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

/// What one study says at one place.
struct Statement {
  bool covers = false;
  double error_n = 0;
  double half_width_n = 0;
};

std::vector<Statement> statementsOf(const Questions& questions, const NurseSource& source,
                                    const TrialSettings& settings, std::size_t number,
                                    const std::vector<std::vector<double>>& points, const std::vector<double>& truth) {
  const study::Form& form = questions.about->forms.front();
  study::Study study;
  study.name = "trial";
  study.procedure = questions.about;
  const auto people =
      peopleOf(questions, source, settings.plan, number, settings.design.nurses, settings.design.strokes);
  if (people.empty()) return {};
  for (std::size_t who = 0; who < people.size(); ++who) addTo(study, form, "N" + std::to_string(who + 1), people[who]);
  elicitation::BuildSettings build;
  build.force_terms = settings.plan.force_terms;
  const auto built = elicitation::buildModel(study, {&form, 1}, build);
  if (!built) return {};
  elicitation::BandSettings wanted;
  wanted.points = points;
  wanted.coverage = settings.coverage;
  wanted.seed = settings.plan.seed + number;
  wanted.again = wanted.split = wanted.words = false;
  auto bands = elicitation::ForceBands::of(study, *built, build, std::move(wanted));
  if (!bands) return {};
  while (bands->add(bands->planned())) {
  }
  std::vector<Statement> out;
  const auto band = bands->band(elicitation::BandKind::kOthers);
  for (std::size_t p = 0; p < band.points.size(); ++p) {
    const auto& at = band.points[p];
    out.push_back({at.low_n <= truth[p] && truth[p] <= at.high_n, at.force_n.value_or(0) - truth[p], at.half_width_n});
  }
  return out;
}

/// `first` to `last`: the places.
RegionTrial summary(std::string region, const std::vector<std::vector<Statement>>& studies,
                    const std::vector<double>& truth, std::size_t first, std::size_t last) {
  RegionTrial out;
  out.region = std::move(region);
  const auto places = static_cast<double>(last - first);
  std::vector<double> shares;  // of each study
  double square = 0, noticeable = 0, width = 0;
  for (const auto& study : studies) {
    if (study.empty()) continue;
    double covered = 0;
    for (std::size_t p = first; p < last; ++p) {
      covered += study[p].covers ? 1 / places : 0;
      square += std::pow(study[p].error_n, 2);
      noticeable += std::pow(study[p].error_n / elicitation::justNoticeableDifference(truth[p]), 2);
      width += study[p].half_width_n;
    }
    shares.push_back(covered);
  }
  if (shares.size() < 2) return out;
  const auto count = static_cast<double>(shares.size());
  const double half = 1.96 * base::standardDeviation(shares) / std::sqrt(count);
  out.covered = base::mean(shares);
  out.low = std::max(0.0, out.covered - half);
  out.high = std::min(1.0, out.covered + half);
  out.error_n = std::sqrt(square / count / places);
  out.error_jnd = std::sqrt(noticeable / count / places);
  out.half_width_n = width / count / places;
  return out;
}

}  // namespace

Result<BandTrial> tryBands(const Questions& questions, const NurseSource& source, const TrialSettings& settings,
                           const std::function<bool(double share)>& go_on) {
  if (settings.design.nurses < 2 || settings.design.nurses > kMostNurses) {
    return fail(ErrorCode::kValue, "nurses", std::to_string(settings.design.nurses),
                "2 to " + std::to_string(kMostNurses) + ": one nurse has no band");
  }
  if (settings.plan.studies < 2 || settings.places == 0 || settings.plan.population == 0 || settings.plan.threads == 0)
    return fail(ErrorCode::kValue, "trial", "too few studies, places, nurses or threads",
                "2 studies, one of each else");
  std::vector<std::vector<double>> points;
  std::vector<std::string> regions;
  const std::size_t way = fuzzy::wayOf(questions.inputs).value();
  for (const auto& term : questions.inputs[way].terms) {
    TACTUS_TRY(const auto some, planPoints(questions, term.id, settings.places));
    points.insert(points.end(), some.begin(), some.end());
    regions.push_back(term.id);
  }
  constexpr double kTruthShare = 0.1;  // of the time, about
  TACTUS_TRY(const auto truth, truthOf(questions, source, settings.plan, points,
                                       [&](double share) { return !go_on || go_on(kTruthShare * share); }));
  std::vector<std::vector<Statement>> studies(settings.plan.studies);
  const auto one = [&](std::size_t number) {
    studies[number] = statementsOf(questions, source, settings, number, points, truth);
  };
  if (!base::inParallel(studies.size(), settings.plan.threads, one,
                        [&](double share) { return !go_on || go_on(kTruthShare + (1 - kTruthShare) * share); }))
    return fail(ErrorCode::kCancelled, "trial", "canceled", "the whole run");
  BandTrial out;
  for (std::size_t r = 0; r < regions.size(); ++r)
    out.regions.push_back(summary(regions[r], studies, truth, r * settings.places, (r + 1) * settings.places));
  out.all = summary({}, studies, truth, 0, points.size());
  out.studies = static_cast<std::size_t>(
      std::count_if(studies.begin(), studies.end(), [](const auto& study) { return !study.empty(); }));
  out.refused = 1 - static_cast<double>(out.studies) / static_cast<double>(studies.size());
  return out;
}

}  // namespace tactus::planning
