#include "app/editing/edit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::editing {
namespace {

bool same(double one, double other) { return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other); }

bool same(const fuzzy::Term& one, const fuzzy::Term& other);
bool same(const fuzzy::Variable& one, const fuzzy::Variable& other);
bool same(const fuzzy::TermOverride& one, const fuzzy::TermOverride& other);
bool same(const fuzzy::Rule& one, const fuzzy::Rule& other);
bool same(const fuzzy::Expert& one, const fuzzy::Expert& other);
bool same(const fuzzy::Check& one, const fuzzy::Check& other);

template <class List>
bool allSame(const List& one, const List& other) {
  return one.size() == other.size() &&
         std::equal(one.begin(), one.end(), other.begin(), [](const auto& a, const auto& b) { return same(a, b); });
}

bool same(const fuzzy::Term& one, const fuzzy::Term& other) { return allSame(one.points, other.points); }

bool same(const fuzzy::Variable& one, const fuzzy::Variable& other) {
  return same(one.min, other.min) && same(one.max, other.max) && allSame(one.terms, other.terms);
}

bool same(const fuzzy::TermOverride& one, const fuzzy::TermOverride& other) { return allSame(one.terms, other.terms); }

bool same(const fuzzy::Rule& one, const fuzzy::Rule& other) { return same(one.weight, other.weight); }

bool same(const fuzzy::Expert& one, const fuzzy::Expert& other) {
  return same(one.weight, other.weight) && allSame(one.overrides, other.overrides) && allSame(one.rules, other.rules);
}

bool same(const fuzzy::Check& one, const fuzzy::Check& other) {
  return same(one.force, other.force) && allSame(one.in, other.in);
}

bool same(const fuzzy::RendererParameters& one, const fuzzy::RendererParameters& other) {
  return std::all_of(std::begin(fuzzy::kRendererFields), std::end(fuzzy::kRendererFields),
                     [&](const auto& field) { return same(one.*field.member, other.*field.member); });
}

}  // namespace

// Everything but the numbers is compared by ==, the numbers once more by their bits.
bool sameBits(const fuzzy::Expert& one, const fuzzy::Expert& other) { return one == other && same(one, other); }

bool sameBits(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other) {
  return one == other && same(one.default_force_n, other.default_force_n) && allSame(one.inputs, other.inputs) &&
         same(one.output, other.output) && allSame(one.experts, other.experts) && allSame(one.checks, other.checks) &&
         (!one.renderer || same(*one.renderer, *other.renderer));
}

base::Result<SharedModel> ready(fuzzy::ForceModel model) {
  TACTUS_TRY(auto compiled, fuzzy::compile(model));
  return std::make_shared<const ReadyModel>(ReadyModel{std::move(model), std::move(compiled)});
}

SharedModel withFreshChecks(SharedModel model) {
  if (model->model.checks.empty()) return model;
  ReadyModel fresh = *model;
  refreshChecks(fresh.model, fresh.compiled);
  return std::make_shared<const ReadyModel>(std::move(fresh));
}

namespace {

struct UnitSteps {
  const char* unit;
  double fine;
  double coarse;
};

constexpr UnitSteps kSteps[] = {{"mm", 1, 10}, {"mm/s", 1, 10}, {"deg", 1, 5}, {"N", 0.01, 0.05}};

double roundBelow(double value) {
  constexpr double kRounding = 1 + 1e-9;  // a hundredth of 1 is a step itself
  const double power = std::pow(10, std::floor(std::log10(value * kRounding)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value * kRounding) return factor * power;
  }
  return power;
}

}  // namespace

double editStep(const fuzzy::Variable& variable, StepSize size) {
  for (const auto& steps : kSteps) {
    if (variable.unit == steps.unit) return size == StepSize::kFine ? steps.fine : steps.coarse;
  }
  constexpr double kFineShare = 0.01;
  constexpr double kCoarseShare = 0.1;
  return roundBelow((variable.max - variable.min) * (size == StepSize::kFine ? kFineShare : kCoarseShare));
}

double stepped(double value, double step, int count) {
  constexpr double kOnGrid = 1e-9;
  const double steps = value / step;
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) > kOnGrid * std::fmax(1, std::abs(nearest))) return value + count * step;
  // Dividing by a whole number rounds once, so 0.3 is the double nearest to 0.3.
  const double inverse = std::round(1 / step);
  const double place = nearest + count;
  return step < 1 && std::abs(inverse * step - 1) < kOnGrid ? place / inverse : place * step;
}

base::Result<Edit> finished(fuzzy::ForceModel model, std::string label, std::string stopped) {
  TACTUS_TRY(auto compiled, fuzzy::compile(model));
  return Edit{std::move(model), std::move(compiled), std::move(label), std::move(stopped)};
}

void refreshChecks(fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  for (auto& check : model.checks) {
    const auto result = compiled.evaluate(check.in);
    check.force = result.force_n;
    check.fired = result.fired;
  }
}

std::string labelOf(const fuzzy::Variable& variable) { return variable.label.empty() ? variable.id : variable.label; }
std::string labelOf(const fuzzy::Term& term) { return term.label.empty() ? term.id : term.label; }
std::string labelOf(const fuzzy::Expert& expert) { return expert.label.empty() ? expert.id : expert.label; }

std::string pointName(fuzzy::Shape shape, std::size_t point) {
  constexpr const char* kTrapezoid[] = {"left foot", "left shoulder", "right shoulder", "right foot"};
  constexpr const char* kTriangle[] = {"left foot", "peak", "right foot"};
  constexpr const char* kGaussian[] = {"mean", "sigma"};
  switch (shape) {
    case fuzzy::Shape::kTrapezoid: return kTrapezoid[point];
    case fuzzy::Shape::kTriangle: return kTriangle[point];
    case fuzzy::Shape::kGaussian: return kGaussian[point];
  }
  return {};
}

std::string numberText(const fuzzy::Variable& variable, double value) {
  constexpr double kSteps = 10000;
  constexpr int kMostDecimals = 12;
  constexpr double kLargestInDigits = 1e12;
  if (std::abs(value) > kLargestInDigits) return base::formatNumber(value);
  const double step = (variable.max - variable.min) / kSteps;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, kMostDecimals);
  std::string text = base::formatFixed(value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string quantityText(const fuzzy::Variable& variable, double value) {
  const std::string number = numberText(variable, value);
  return variable.unit.empty() || variable.unit == "1" ? number : number + ' ' + variable.unit;
}

std::string conditionsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule) {
  std::string out;
  for (const auto& condition : rule.conditions) {
    out += out.empty() ? "IF " : " AND ";
    const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&](const fuzzy::Variable& v) { return v.id == condition.input; });
    if (input == model.inputs.end()) {
      out += condition.input + " is " + condition.term;
      continue;
    }
    const fuzzy::Term* const term = findTerm(termsFor(expert, *input), condition.term);
    out += labelOf(*input) + " is " + (term == nullptr ? condition.term : labelOf(*term));
  }
  return out;
}

std::string consequentText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& id) {
  const fuzzy::Term* const term = findTerm(termsFor(expert, model.output), id);
  return term == nullptr ? id : labelOf(*term);
}

}  // namespace tactus::editing
