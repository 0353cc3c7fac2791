// The report of a bundle: two printed pages, and a section for the screen in which the model moves.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "app/bundle/bundle.h"
#include "app/bundle/report_parts.h"
#include "app/figures/colors.h"
#include "app/living/living.h"
#include "app/report/html.h"
#include "app/report/palette.h"
#include "app/report/svg_plot.h"
#include "core/analysis/force_difference.h"
#include "core/base/text.h"
#include "core/contracts/contract_check.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::bundle {
namespace {

using base::formatFixed;
using elicitation::justNoticeableDifference;
using elicitation::RuleFinding;
using report::headingCell;
using report::Markup;
using report::numberCell;

constexpr int kCurvePoints = 240;
constexpr std::size_t kMostExpertLines = 6;
constexpr std::size_t kMostPanels = 3;

/// So that two printed pages hold everything.
constexpr std::string_view kStyle = R"(
@media print {
  @page { margin: 11mm 13mm 14mm; }
  body { font-size: 9.5pt; line-height: 1.35; }
  nav { display: none; }
  .page { padding-top: 6px; }
  header h1 { font-size: 15pt; }
  header .subtitle { margin-top: 3px; max-width: none; }
  h2 { font-size: 12pt; margin: 9px 0 4px; padding-top: 5px; border-top-width: 1px; }
  #experts { break-before: page; margin-top: 0; border-top: 0; }
  p, ul { margin-bottom: 5px; max-width: none; }
  li { margin-bottom: 1px; }
  .notice { padding: 4px 10px; margin-bottom: 6px; }
  .table, figure { margin: 4px 0 6px; }
  table { width: 100%; }
  table, caption, figcaption { font-size: 8.5pt; }
  caption { padding-bottom: 3px; }
  th, td { padding: 1px 5px; }
  figcaption { margin-top: 2px; max-width: none; }
  .panels { gap: 8px; }
}
)";

std::string newtons(const fuzzy::ForceModel& model, double force) { return shortly(force) + " " + model.output.unit; }

/// `0.16 N (1.4 JND)`; just-noticeable differences only of a force in N.
std::string withNoticeable(const fuzzy::ForceModel& model, double change, double around) {
  const std::string text = newtons(model, change);
  if (model.output.unit != "N") return text;
  return text + " (" + shortly(change / justNoticeableDifference(std::abs(around))) + " JND)";
}

/// `insertion depth 117 mm, tube lubrication 0.1`, all inputs or all but `without`.
std::string placeText(const fuzzy::ForceModel& model, const std::vector<double>& point,
                      std::optional<std::size_t> without = std::nullopt) {
  std::string out;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (i == without) continue;
    const fuzzy::Variable& input = model.inputs[i];
    const bool wide = input.max - input.min > 50;
    out += (out.empty() ? "" : ", ") + base::lowered(labelOf(input)) + " " +
           (wide ? formatFixed(point[i], 0) : shortly(point[i])) +
           (input.unit == "1" || input.unit.empty() ? "" : " " + input.unit);
  }
  return out;
}

/// `5f1c… …`: 64 digits in four groups.
std::string inGroups(const std::string& sha256) {
  std::string out;
  for (std::size_t at = 0; at < sha256.size(); at += 16) out += (at == 0 ? "" : " ") + sha256.substr(at, 16);
  return out;
}

/// Whether any source of the model is simulated, as `build` notes it.
bool isSimulated(const fuzzy::ForceModel& model) {
  return model.provenance && std::any_of(model.provenance->sources.begin(), model.provenance->sources.end(),
                                         [](const fuzzy::NamedJson& source) {
                                           return source.key == "simulated" && source.json != "[]" &&
                                                  source.json != "false";
                                         });
}

void addOrigin(report::HtmlPage& page, const fuzzy::ForceModel& model) {
  if (!model.provenance) {
    page.notice("The file does not say what data the model is from.");
  } else if (isSimulated(model)) {
    const std::string& notes = model.provenance->notes;
    page.notice(notes.starts_with("Simulated") ? notes : "Simulated, not measured. " + notes);
  }
}

/// The force over one input with the band of the experts; `point` has the others.
std::string curves(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t input,
                   std::vector<double> point) {
  const fuzzy::Variable& x = model.inputs[input];
  report::PlotFrame frame;
  frame.title = "Force over " + labelOf(x);
  frame.simulated = isSimulated(model);
  frame.x = {labelOf(x) + " (" + x.unit + ")", x.min, x.max};
  frame.y = {labelOf(model.output) + " (" + model.output.unit + ")", model.output.min, model.output.max};
  report::SvgPlot plot(frame);
  const std::size_t experts = model.experts.size();
  std::vector<report::Series> own(experts);
  report::Series mean;
  report::Series low;
  report::Series high;
  for (int i = 0; i <= kCurvePoints; ++i) {
    point[input] = x.min + (x.max - x.min) * i / kCurvePoints;
    std::optional<double> least;
    std::optional<double> most;
    for (std::size_t e = 0; e < experts; ++e) {
      const auto force = compiled.evaluateExpert(e, point);
      own[e].push_back({point[input], force.fired ? std::optional(force.force_n) : std::nullopt});
      if (!force.fired) continue;
      least = std::min(least.value_or(force.force_n), force.force_n);
      most = std::max(most.value_or(force.force_n), force.force_n);
    }
    const auto force = compiled.evaluate(point);
    mean.push_back({point[input], force.fired ? std::optional(force.force_n) : std::nullopt});
    low.push_back({point[input], least});
    high.push_back({point[input], most});
  }
  const std::vector<std::size_t> numbers = figures::expertNumbers(model.experts);
  if (experts > 1) plot.between(low, high, report::kInk, 0.1, "between the experts");
  for (std::size_t e = 0; e < experts && experts > 1 && experts <= kMostExpertLines; ++e)
    plot.line(own[e], {report::seriesColor(numbers[e]), 1.2, report::Dash::kDashed}, model.experts[e].id);
  plot.line(mean, {report::kInk, 2.4, report::Dash::kSolid}, experts > 1 ? "mean" : "");
  return plot.svg();
}

/// The input whose words tell the curves apart: the rate, else the first condition.
std::optional<std::size_t> variedInput(const fuzzy::ForceModel& model) {
  if (const auto rate = fuzzy::rateOf(model.inputs)) return rate;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (fuzzy::roleOf(model.inputs[i]) == fuzzy::Role::kCondition) return i;
  }
  return std::nullopt;
}

/// Over the way at the cores of the words of another input; without them, over each input.
void addCurves(report::HtmlPage& page, const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  const auto depth = fuzzy::wayOf(model.inputs);
  const auto varied = variedInput(model);
  std::vector<double> point = middleWords(model);
  report::Figure figure;
  if (depth && varied) {
    const fuzzy::Variable& words = model.inputs[*varied];
    const std::size_t count = std::min(words.terms.size(), kMostPanels);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t term = count == 1 ? 0 : k * (words.terms.size() - 1) / (count - 1);
      point[*varied] = coreMiddle(words, words.terms[term]);
      const std::string unit = words.unit == "1" ? "" : " " + words.unit;
      figure.panels.push_back(
          {labelOf(words.terms[term]) + ", " + shortly(point[*varied]) + unit, curves(model, compiled, *depth, point)});
    }
    point[*depth] = point[*varied] = 0;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      if (i == *depth || i == *varied) continue;
      const std::string unit = model.inputs[i].unit == "1" ? "" : " " + model.inputs[i].unit;
      others.push_back(base::lowered(labelOf(model.inputs[i])) + " " + shortly(point[i]) + unit);
    }
    const bool rate = fuzzy::roleOf(words) == fuzzy::Role::kRate;
    const std::string of = rate ? std::string("the speed") : "“" + labelOf(words) + "”";
    figure.caption = "The force over the depth at the middle of " + std::to_string(count) + " words of " + of +
                     (others.empty() ? "." : "; " + base::joined(others, ", ") + ".");
  } else {
    for (std::size_t i = 0; i < std::min(model.inputs.size(), kMostPanels); ++i)
      figure.panels.push_back({"", curves(model, compiled, i, point)});
    figure.caption = "The force over the inputs, the others in the middle of their middle words.";
  }
  figure.columns = static_cast<int>(std::min(figure.panels.size(), kMostPanels));
  page.figure(figure);
}

constexpr double kRoundingN = 1e-9;  // experts who differ by less say the same

report::Table regionTable(const fuzzy::ForceModel& model, const std::vector<RegionNumbers>& regions) {
  report::Table table;
  table.caption = "Regions along the depth, each from where its word is the truest, with the forces at all conditions.";
  const std::string unit = " (" + model.output.unit + ")";
  table.head = {{headingCell("region"), numberCell("from (mm)"), numberCell("to (mm)"), numberCell("lowest" + unit),
                 numberCell("highest" + unit), numberCell("experts apart up to" + unit)}};
  for (const RegionNumbers& region : regions) {
    if (table.body.size() == kMostReportRows) break;
    table.body.push_back({headingCell(region.label), numberCell(formatFixed(region.from_mm, 0)),
                          numberCell(formatFixed(region.to_mm, 0)),
                          numberCell(region.lowest_n ? shortly(*region.lowest_n) : "none"),
                          numberCell(region.highest_n ? shortly(*region.highest_n) : "none"),
                          numberCell(model.experts.size() < 2      ? std::string()
                                     : region.apart_n > kRoundingN ? shortly(region.apart_n)
                                                                   : std::string("0"))});
  }
  return table;
}

/// What is known of the places without a force.
std::string holeText(const Bundle& bundle) {
  const std::string accepted =
      bundle.holes.empty() ? std::string() : "Accepted: " + base::joined(bundle.holes, "; ") + ".";
  if (bundle.every_hole_is_known) return bundle.holes.empty() ? "There is no such place." : accepted;
  return (bundle.holes.empty() ? std::string("None was found") : accepted + " No other was found") +
         ", but the search was cut off, because the model is too finely divided: there may be more.";
}

/// The largest finding of a kind, of the average (`expert` empty) or of experts, as one item; with how many there are.
void addFinding(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                const std::vector<RuleFinding>& findings, RuleFinding::Kind kind, bool of_average,
                const std::string& what, std::vector<Markup>& items) {
  const RuleFinding* largest = nullptr;
  std::size_t count = 0;
  for (const RuleFinding& one : findings) {
    if (one.kind != kind || one.experts.empty() != of_average) continue;
    ++count;
    if (largest == nullptr || one.newtons.value_or(0) > largest->newtons.value_or(0)) largest = &one;
  }
  if (largest == nullptr) return;
  std::string text = what;
  if (largest->newtons && !largest->from.empty()) {
    // A step of one expert is felt around that expert's own force.
    const bool own = largest->experts.size() == 1 && kind == RuleFinding::Kind::kForceStep;
    const auto expert = std::find_if(model.experts.begin(), model.experts.end(),
                                     [&](const auto& one) { return own && one.id == largest->experts.front(); });
    const auto force = [&](const std::vector<double>& point) {
      if (expert == model.experts.end()) return compiled.evaluate(point).force_n;
      return compiled.evaluateExpert(static_cast<std::size_t>(expert - model.experts.begin()), point).force_n;
    };
    const double around = std::min(force(largest->from), force(largest->to));
    text += " " + withNoticeable(model, *largest->newtons, around);
  }
  if (!largest->experts.empty()) text += ", " + base::joined(largest->experts, " and ");
  text += largest->from.empty() ? ": " + largest->place : ": " + placeText(model, largest->from);
  items.emplace_back(text + (count > 1 ? "; " + std::to_string(count) + " places in all." : "."));
}

std::vector<Markup> stepTexts(const Bundle& bundle, const fuzzy::CompiledModel& compiled) {
  using Kind = RuleFinding::Kind;
  const fuzzy::ForceModel& model = bundle.model;
  const auto lint = elicitation::ruleLint(model, compiled);
  std::vector<Markup> items = {"Places where no rule of any expert fires have the default force, " +
                               newtons(model, model.default_force_n) + ", and fired is 0. " + holeText(bundle)};
  addFinding(model, compiled, lint.findings, Kind::kHole, true, "Largest jump at the edge of such a place:", items);
  const std::size_t before = items.size();
  addFinding(model, compiled, lint.findings, Kind::kForceStep, true, "Largest step of the average:", items);
  if (items.size() == before)
    items.emplace_back("The average has no step of more than one just-noticeable difference (JND) within 1 mm.");
  addFinding(model, compiled, lint.findings, Kind::kForceStep, false, "Largest step of one expert:", items);
  addFinding(model, compiled, lint.findings, Kind::kAbstentionJump, false,
             "Largest jump of the average, where an expert falls silent:", items);
  addFinding(model, compiled, lint.findings, Kind::kExpertsApart, false, "Experts apart by up to", items);
  return items;
}

void addSlopes(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::vector<Markup>& items) {
  for (const fuzzy::Role role : {fuzzy::Role::kWay, fuzzy::Role::kRate}) {
    const bool depth = role == fuzzy::Role::kWay;
    const auto input = depth ? fuzzy::wayOf(model.inputs) : fuzzy::rateOf(model.inputs);
    const auto slope = input ? largestSlope(model, compiled, *input) : std::nullopt;
    if (!slope) continue;
    const std::string unit = depth ? model.output.unit + "/" + model.inputs[*input].unit
                                   : model.output.unit + " per " + model.inputs[*input].unit;
    items.emplace_back(std::string("Largest slope over the ") + (depth ? "depth, dF/dx: " : "speed, dF/dv: ") +
                       shortly(slope->slope) + " " + unit + " at " + placeText(model, slope->point) +
                       (depth ? " (what the device must render as stiffness)." : " (as damping)."));
  }
}

/// What the model promises, and whether that holds in the whole input space.
std::vector<Markup> promiseTexts(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  std::vector<Markup> items;
  for (const fuzzy::Contract& contract : model.contracts) {
    const auto result = contracts::checkContract(model, compiled, contract);
    std::string text = contracts::sentenceOf(model, contract) + ": ";
    switch (result.verdict) {
      case contracts::Verdict::kProved: text += "proved at every place of the inputs."; break;
      case contracts::Verdict::kViolated: {
        const auto& at = result.counterexample.front().inputs;
        text += "NOT kept" + (result.excess_n > 0 ? ", by " + newtons(model, result.excess_n) : std::string()) +
                " at " + placeText(model, at) + ".";
        break;
      }
      case contracts::Verdict::kOpen:
        text += result.bound_n ? "not proved; exceeded by at most " + newtons(model, *result.bound_n) + "."
                               : "not proved. " + result.reason;
    }
    items.emplace_back(std::move(text));
  }
  return items;
}

/// All digits of a parameter, without an exponent.
std::string inFull(double value) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
  return {text, end.ptr};
}

report::Table rendererTable(const fuzzy::ForceModel& model) {
  report::Table table;
  table.caption =
      model.renderer ? "Renderer, as the model sets it." : "Renderer: the model sets none, so the defaults.";
  const fuzzy::RendererParameters values = model.renderer.value_or(fuzzy::RendererParameters());
  table.head = {{headingCell("parameter"), numberCell("value"), headingCell("parameter"), numberCell("value")}};
  for (const fuzzy::RendererField& field : fuzzy::kRendererFields) {
    if (table.body.empty() || table.body.back().size() == 4) table.body.emplace_back();
    table.body.back().push_back(headingCell(field.key));
    table.body.back().push_back(numberCell(inFull(values.*field.member)));
  }
  return table;
}

}  // namespace

std::string bundleReport(const Bundle& bundle, const fuzzy::CompiledModel& compiled) {
  const fuzzy::ForceModel& model = bundle.model;
  const model_io::BundleManifest& manifest = bundle.manifest;
  report::HtmlPage page(model.name,
                        "Force model for a simulator, " + manifest.created_utc + ", " + manifest.generator + ".");
  page.style(kStyle);
  addOrigin(page, model);

  page.section("Model");
  const auto range = analysis::reachableRange(model, compiled);
  page.list({"Model SHA-256 " + inGroups(bundle.model_sha256) + ".",
             "Reachable force: " +
                 (range.fired > 0 ? shortly(range.min_n) + " to " + newtons(model, range.max_n) : std::string("none")) +
                 ", seen at " + std::to_string(range.points) + " points."});
  if (const auto regions = regionNumbers(model, compiled); !regions.empty()) page.table(regionTable(model, regions));
  addCurves(page, model, compiled);
  page.section("Steps and slopes");
  std::vector<Markup> items = stepTexts(bundle, compiled);
  addSlopes(model, compiled, items);
  for (const std::string& event : fuzzy::eventTexts(model))
    items.emplace_back("Puncture: " + event +
                       ", once in a stroke. Only the tube has it: all forces here are without it.");
  page.list(items);
  page.table(rendererTable(model));
  if (const auto promises = promiseTexts(model, compiled); !promises.empty()) {
    page.section("Promises");
    page.list(promises);
  }

  if (const auto living = living::sectionOf(model, compiled, isSimulated(model),
                                            {bundle.model_sha256, model.created_utc, manifest.generator})) {
    page.style(living->style);
    page.screenSection("Try the model", Markup::raw(living->html));
  }

  addSecondPage(page, bundle, compiled);
  return page.html();
}

}  // namespace tactus::bundle
