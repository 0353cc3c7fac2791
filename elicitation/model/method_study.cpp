#include "elicitation/model/method_study.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/analysis/force_difference.h"
#include "core/analysis/term_conversion.h"
#include "core/base/error.h"
#include "core/base/in_parallel.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/model/record_influence.h"

namespace tactus::elicitation {
namespace {

using base::formatFixed;

constexpr std::pair<std::string_view, std::string_view> kTitles[] = {
    {"shapes", "Shapes of the terms"},
    {"implication", "Implication"},
    {"depths", "Depths of the regions"},
    {"alpha", "Core of the speed terms (alpha)"},
    {"m", "Fuzziness of the clusters (m)"},
    {"trim", "Trimming of slow samples"},
    {"centres", "Centers of the speed terms"},
    {"averaging", "Averaging of the speed terms"},
    {"terms", "Whose speed terms"},
    {"force_terms", "Force terms from the judgements"},
    {"weights", "Weights of the experts"},
};

/// A share as percent that is never rounded to nothing.
std::string percentText(double share) {
  if (share > 0 && share < 0.0005) return "less than 0.1 %";
  return formatFixed(100 * share, 1) + " %";
}

std::string whyNot(const MethodStudy& study, const MethodFactor& factor) {
  const auto first = std::find_if(study.variants.begin(), study.variants.end(),
                                  [&](const MethodVariant& one) { return one.factor == factor.factor; });
  return first == study.variants.end() ? "nothing was tried" : first->unavailable;
}

std::string effectOf(const MethodVariant& one) {
  return formatFixed(one.rms_n, 3) + " N rms, " + formatFixed(one.rms_noticeable, 2) +
         " just-noticeable differences; at most " + formatFixed(one.largest_n, 3) + " N";
}

}  // namespace

std::string factorTitle(std::string_view factor) {
  const auto* const found =
      std::find_if(std::begin(kTitles), std::end(kTitles), [&](const auto& one) { return one.first == factor; });
  return std::string(found == std::end(kTitles) ? factor : found->second);
}

std::string factorVerdict(const MethodStudy& study, const MethodFactor& factor) {
  if (!factor.worst) return "Cannot be compared: " + whyNot(study, factor) + '.';
  const MethodVariant& worst = study.variants[*factor.worst];
  if (worst.largest_n == 0 && worst.only_one_share == 0) return "No: no other choice moves the force.";
  const std::string gaps = worst.only_one_share > 0
                               ? " At " + percentText(worst.only_one_share) + " only one of them gives a force."
                               : std::string();
  if (factor.matters)
    return "Yes: \"" + worst.value + "\" is felt at " + percentText(worst.noticeable_share) + '.' + gaps;
  const std::string where =
      worst.noticeable_share > 0 ? "at only " + percentText(worst.noticeable_share) : std::string("nowhere");
  return "No: even \"" + worst.value + "\" is felt " + where + '.' + gaps;
}

std::string factorSentence(const MethodStudy& study, const MethodFactor& factor) {
  if (!factor.worst) return "Cannot be compared here: " + whyNot(study, factor) + '.';
  const MethodVariant& worst = study.variants[*factor.worst];
  if (worst.largest_n == 0 && worst.only_one_share == 0) {
    return "Does not matter here: no other choice moves the force.";
  }
  const std::string instead = "\"" + worst.value + "\" instead of \"" + factor.unchanged + "\"";
  const std::string gaps = worst.only_one_share > 0
                               ? " At " + percentText(worst.only_one_share) + " only one of the two gives a force."
                               : std::string();
  if (factor.matters) {
    return "Matters here: " + instead + " is felt at " + percentText(worst.noticeable_share) + " of the input space (" +
           effectOf(worst) + ")." + gaps;
  }
  const std::string where = worst.noticeable_share > 0
                                ? "at only " + percentText(worst.noticeable_share) + " of the input space"
                                : std::string("at none of the points");
  return "Does not matter here: even " + instead + " is felt " + where + " (" + effectOf(worst) + ")." + gaps;
}

std::vector<std::size_t> factorsByEffect(const MethodStudy& study) {
  std::vector<std::size_t> order(study.factors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto effect = [&](std::size_t index) {
    const MethodFactor& factor = study.factors[index];
    return std::pair(factor.matters, factor.worst ? study.variants[*factor.worst].rms_noticeable : -1.0);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return effect(a) > effect(b); });
  return order;
}

namespace {

using base::Result;
using fuzzy::ForceModel;

/// A choice to try, and how its model is made.
struct Choice {
  std::string factor;
  std::string value;
  std::function<Result<ForceModel>()> model;
};

/// `model` with every term as `shape`.
Result<ForceModel> inShape(ForceModel model, fuzzy::Shape shape) {
  const auto convert = [&](const fuzzy::Variable& variable, std::vector<fuzzy::Term>& terms) -> Result<void> {
    for (auto& term : terms) {
      TACTUS_TRY(auto other, analysis::convertedTerm(term, shape, variable.min, variable.max));
      term = std::move(other);
    }
    return {};
  };
  std::vector<fuzzy::Variable*> variables;
  for (auto& input : model.inputs) variables.push_back(&input);
  variables.push_back(&model.output);
  for (auto* variable : variables) {
    if (auto ok = convert(*variable, variable->terms); !ok) return tl::unexpected(ok.error());
    for (auto& expert : model.experts) {
      for (auto& own : expert.overrides) {
        if (own.variable != variable->id) continue;
        if (auto ok = convert(*variable, own.terms); !ok) return tl::unexpected(ok.error());
      }
    }
  }
  return model;
}

class Choices {
 public:
  Choices(const study::Study& study, std::span<const study::Form> forms, const BuildSettings& settings,
          const BuiltModel& built)
      : study_(study), forms_(forms), settings_(settings), built_(built) {}

  std::vector<Choice> all() {
    for (const auto shape : {fuzzy::Shape::kTriangle, fuzzy::Shape::kGaussian}) {
      add("shapes", std::string(fuzzy::name(shape)), [this, shape] { return inShape(built_.model, shape); });
    }
    const auto other =
        built_.model.implication == fuzzy::Implication::kClip ? fuzzy::Implication::kScale : fuzzy::Implication::kClip;
    add("implication", std::string(fuzzy::name(other)), [this, other]() -> Result<ForceModel> {
      auto model = built_.model;
      model.implication = other;
      return model;
    });
    if (settings_.measured_depths) {
      const auto depths = settings_.depths == DepthsFrom::kMeasured ? DepthsFrom::kTemplate : DepthsFrom::kMeasured;
      rebuilt("depths", std::string(name(depths)), [depths](BuildSettings& s) { s.depths = depths; });
    }
    if (!built_.speeds.empty()) addSpeedChoices();
    if (built_.force_terms) {
      for (const auto from :
           {ForceTermsFrom::kVote, ForceTermsFrom::kFrequency, ForceTermsFrom::kThresholds, ForceTermsFrom::kProbit}) {
        if (from != settings_.force_terms) {
          rebuilt("force_terms", std::string(name(from)), [from](BuildSettings& s) { s.force_terms = from; });
        }
      }
    }
    if (built_.model.experts.size() > 1) {
      for (const auto policy :
           {WeightPolicy::kEqual, WeightPolicy::kYears, WeightPolicy::kCategory, WeightPolicy::kColumn}) {
        if (policy == settings_.weights.policy) continue;
        add("weights", std::string(name(policy)), [this, policy]() {
          auto settings = settings_;
          settings.weights.policy = policy;
          return reweightedModel(built_, study_, settings);
        });
      }
    }
    return std::move(choices_);
  }

  /// The value of a factor in the settings.
  std::string unchanged(const std::string& factor) const {
    if (factor == "shapes") return "as they are";
    if (factor == "implication") return std::string(fuzzy::name(built_.model.implication));
    if (factor == "depths") return std::string(name(settings_.depths));
    if (factor == "alpha") return base::formatNumber(settings_.speed.alpha);
    if (factor == "m") return base::formatNumber(settings_.speed.fcm.m);
    if (factor == "trim") return base::formatNumber(settings_.speed.trim);
    if (factor == "centres") return std::string(name(settings_.speed.centres));
    if (factor == "averaging") return std::string(name(settings_.averaging));
    if (factor == "terms") return std::string(name(settings_.terms));
    if (factor == "force_terms") return std::string(name(settings_.force_terms));
    return std::string(name(settings_.weights.policy));
  }

 private:
  void add(std::string factor, std::string value, std::function<Result<ForceModel>()> model) {
    choices_.push_back({std::move(factor), std::move(value), std::move(model)});
  }

  template <class Change>
  void rebuilt(const std::string& factor, const std::string& value, Change change, SpeedsOf speeds = SpeedsOf::kBuilt) {
    add(factor, value, [this, change, speeds] {
      auto settings = settings_;
      change(settings);
      return rebuiltModel(built_, study_, forms_, settings, speeds);
    });
  }

  void addSpeedChoices() {
    for (const double alpha : {0.8, 0.9, 0.95, 1.0}) {
      if (alpha == settings_.speed.alpha) continue;
      rebuilt("alpha", base::formatNumber(alpha), [alpha](BuildSettings& s) { s.speed.alpha = alpha; });
    }
    for (const double m : {1.5, 2.0, 2.5, 3.0}) {
      if (m == settings_.speed.fcm.m) continue;
      rebuilt(
          "m", base::formatNumber(m), [m](BuildSettings& s) { s.speed.fcm.m = m; }, SpeedsOf::kStudy);
    }
    for (const double trim : {0.0, 0.2}) {
      if (trim == settings_.speed.trim) continue;
      rebuilt(
          "trim", base::formatNumber(trim), [trim](BuildSettings& s) { s.speed.trim = trim; }, SpeedsOf::kStudy);
    }
    for (const auto centres : {SpeedCentres::kClusters, SpeedCentres::kLevelMeans}) {
      if (centres == settings_.speed.centres) continue;
      rebuilt(
          "centres", std::string(name(centres)), [centres](BuildSettings& s) { s.speed.centres = centres; },
          SpeedsOf::kStudy);
    }
    if (built_.speeds.size() < 2) return;
    for (const auto averaging : {Averaging::kMean, Averaging::kMedian}) {
      if (averaging == settings_.averaging) continue;
      rebuilt("averaging", std::string(name(averaging)), [averaging](BuildSettings& s) { s.averaging = averaging; });
    }
    const auto terms = settings_.terms == SpeedTermsOf::kOwn ? SpeedTermsOf::kAveraged : SpeedTermsOf::kOwn;
    rebuilt("terms", std::string(name(terms)), [terms](BuildSettings& s) { s.terms = terms; });
  }

  const study::Study& study_;
  std::span<const study::Form> forms_;
  const BuildSettings& settings_;
  const BuiltModel& built_;
  std::vector<Choice> choices_;
};

/// The forces of the unchanged model at the points of the box.
struct Unchanged {
  const ForceModel& model;
  const fuzzy::CompiledModel& compiled;
  std::vector<std::vector<double>> points;
  std::vector<fuzzy::Evaluation> forces;
};

Result<void> compare(const Unchanged& unchanged, const ForceModel& changed, MethodVariant& out) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(changed));
  double squares_n = 0;
  double squares_noticeable = 0;
  std::size_t both = 0;
  std::size_t noticeable = 0;
  std::size_t only_one = 0;
  const auto take = [&](double newtons, double noticeable_n, const std::vector<double>& point) {
    if (newtons <= out.largest_n) return;
    out.largest_n = newtons;
    out.largest_noticeable = newtons / noticeable_n;
    out.at = point;
  };
  for (std::size_t p = 0; p < unchanged.points.size(); ++p) {
    const auto& before = unchanged.forces[p];
    const auto after = compiled.evaluate(unchanged.points[p]);
    if (before.fired != after.fired) ++only_one;
    if (!before.fired || !after.fired) continue;
    const double newtons = std::abs(after.force_n - before.force_n);
    const double noticeable_n = justNoticeableDifference(std::abs(before.force_n));
    squares_n += newtons * newtons;
    squares_noticeable += newtons * newtons / (noticeable_n * noticeable_n);
    if (newtons > noticeable_n) ++noticeable;
    ++both;
    take(newtons, noticeable_n, unchanged.points[p]);
  }
  if (both > 0) {
    out.rms_n = std::sqrt(squares_n / static_cast<double>(both));
    out.rms_noticeable = std::sqrt(squares_noticeable / static_cast<double>(both));
  }
  const auto all = static_cast<double>(unchanged.points.size());
  out.noticeable_share = static_cast<double>(noticeable) / all;
  out.only_one_share = static_cast<double>(only_one) / all;
  // The centroid of Gaussians is an integral: tens of thousands of them would take minutes.
  const auto& words = changed.output.terms;
  if (std::any_of(words.begin(), words.end(), [](const auto& one) { return one.shape == fuzzy::Shape::kGaussian; })) {
    return {};
  }
  const auto kinks = analysis::forceDifference(unchanged.model, unchanged.compiled, changed, compiled);
  take(kinks.largest_n, justNoticeableDifference(std::abs(kinks.first_n)), kinks.at);
  return {};
}

/// What `study`, which may be null, has of this choice; null: nothing.
const MethodVariant* variantOf(const MethodStudy* study, const Choice& choice) {
  if (study == nullptr) return nullptr;
  const auto found = std::find_if(study->variants.begin(), study->variants.end(), [&](const MethodVariant& one) {
    return one.factor == choice.factor && one.value == choice.value;
  });
  return found == study->variants.end() ? nullptr : &*found;
}

std::vector<MethodFactor> factorsOf(const std::vector<MethodVariant>& variants, const Choices& choices) {
  std::vector<MethodFactor> out;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    if (out.empty() || out.back().factor != variants[v].factor) {
      out.push_back({variants[v].factor, choices.unchanged(variants[v].factor), std::nullopt, false});
    }
    auto& factor = out.back();
    if (!variants[v].unavailable.empty()) continue;
    if (!factor.worst || variants[*factor.worst].rms_noticeable < variants[v].rms_noticeable) factor.worst = v;
    factor.matters = factor.matters || variants[v].noticeable_share > kMattersShare;
  }
  return out;
}

}  // namespace

Result<MethodStudy> methodStudy(const study::Study& study, std::span<const study::Form> forms,
                                const BuildSettings& settings, const BuiltModel& built, const MethodStudyRun& run) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(built.model));
  Unchanged unchanged{built.model, compiled, analysis::boxPoints(built.model), {}};
  for (const auto& point : unchanged.points) unchanged.forces.push_back(compiled.evaluate(point));

  Choices choices(study, forms, settings, built);
  auto all = choices.all();
  if (run.wanted) std::erase_if(all, [&run](const Choice& one) { return !run.wanted(one.factor); });
  MethodStudy out;
  out.points = unchanged.points.size();
  out.variants.resize(all.size());
  const auto look = [&](std::size_t which) {
    auto& variant = out.variants[which];
    if (const auto* const known = variantOf(run.known, all[which])) {
      variant = *known;
      return;
    }
    variant.factor = all[which].factor;
    variant.value = all[which].value;
    const auto model = all[which].model();
    if (!model) {
      variant.unavailable = model.error().message();
    } else if (auto ok = compare(unchanged, *model, variant); !ok) {
      variant.unavailable = ok.error().message();
    }
  };
  const auto go_on = [&run](double share) {
    if (run.progress) run.progress(share);
    return !run.stop.stop_requested();
  };
  if (run.stop.stop_requested() || !base::inParallel(all.size(), base::spareThreads(), look, go_on)) {
    return base::fail(base::ErrorCode::kCancelled, "method study", "a request to stop", "time to end");
  }
  out.factors = factorsOf(out.variants, choices);
  return out;
}

Result<MethodVariant> methodDifference(const ForceModel& unchanged, const ForceModel& changed) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(unchanged));
  Unchanged before{unchanged, compiled, analysis::boxPoints(unchanged), {}};
  for (const auto& point : before.points) before.forces.push_back(compiled.evaluate(point));
  MethodVariant out;
  if (auto ok = compare(before, changed, out); !ok) return tl::unexpected(ok.error());
  return out;
}

Result<ForceModel> methodModel(const study::Study& study, std::span<const study::Form> forms,
                               const BuildSettings& settings, const BuiltModel& built, const MethodVariant& variant) {
  Choices choices(study, forms, settings, built);
  for (const Choice& choice : choices.all()) {
    if (choice.factor == variant.factor && choice.value == variant.value) return choice.model();
  }
  return base::fail(base::ErrorCode::kReference, variant.factor, variant.value, "a choice that this study has");
}

}  // namespace tactus::elicitation
