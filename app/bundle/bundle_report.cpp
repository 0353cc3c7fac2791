// The report of a bundle.

#include <algorithm>
#include <optional>
#include <vector>

#include "app/bundle/bundle.h"
#include "app/figures/colors.h"
#include "app/report/html.h"
#include "app/report/palette.h"
#include "app/report/svg_plot.h"
#include "core/analysis/force_difference.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::bundle {
namespace {

using base::formatFixed;
using base::formatNumber;
using report::headingCell;
using report::Markup;
using report::numberCell;

constexpr int kCurvePoints = 240;
constexpr std::size_t kMostExpertLines = 6;

/// Whether any source of the model is simulated, as `build` notes it.
std::optional<std::string> simulatedSources(const fuzzy::ForceModel& model) {
  if (!model.provenance) return std::nullopt;
  for (const fuzzy::NamedJson& source : model.provenance->sources) {
    if (source.key == "simulated" && source.json != "[]" && source.json != "false") return source.json;
  }
  return std::nullopt;
}

std::vector<double> middleOf(const fuzzy::ForceModel& model) {
  std::vector<double> point;
  for (const fuzzy::Variable& input : model.inputs) point.push_back((input.min + input.max) / 2);
  return point;
}

/// The force over one input, the others in the middle of their universes.
std::string curves(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t input) {
  const fuzzy::Variable& x = model.inputs[input];
  report::PlotFrame frame;
  frame.title = "Force over " + x.label;
  frame.simulated = simulatedSources(model).has_value();
  frame.x = {x.label + " (" + x.unit + ")", x.min, x.max};
  frame.y = {model.output.label + " (" + model.output.unit + ")", model.output.min, model.output.max};
  report::SvgPlot plot(frame);
  const auto line = [&](std::optional<std::size_t> expert) {
    report::Series series;
    std::vector<double> point = middleOf(model);
    for (int i = 0; i <= kCurvePoints; ++i) {
      point[input] = x.min + (x.max - x.min) * i / kCurvePoints;
      const auto force = expert ? compiled.evaluateExpert(*expert, point) : compiled.evaluate(point);
      series.push_back({point[input], force.fired ? std::optional(force.force_n) : std::nullopt});
    }
    return series;
  };
  const std::size_t experts = model.experts.size();
  const std::vector<std::size_t> numbers = figures::expertNumbers(model.experts);
  for (std::size_t e = 0; e < experts && experts > 1 && experts <= kMostExpertLines; ++e) {
    plot.line(line(e), {report::seriesColor(numbers[e]), 1.2, report::Dash::kDashed}, model.experts[e].id);
  }
  plot.line(line(std::nullopt), {report::kInk, 2.4, report::Dash::kSolid}, experts > 1 ? "mean" : "");
  return plot.svg();
}

report::Table inputTable(const fuzzy::ForceModel& model) {
  report::Table table;
  table.caption = "Inputs in their order, and the output. Values outside a universe are clamped.";
  table.head = {{headingCell("id"), headingCell("label"), headingCell("from"), headingCell("to"), headingCell("unit"),
                 headingCell("terms")}};
  const auto row = [&](const fuzzy::Variable& variable) {
    std::vector<std::string> terms;
    for (const fuzzy::Term& term : variable.terms) terms.push_back(term.id);
    table.body.push_back({headingCell(variable.id), report::Cell{variable.label},
                          numberCell(formatNumber(variable.min)), numberCell(formatNumber(variable.max)),
                          report::Cell{variable.unit}, report::Cell{base::joined(terms, ", ")}});
  };
  for (const fuzzy::Variable& input : model.inputs) row(input);
  row(model.output);
  return table;
}

report::Table expertTable(const fuzzy::ForceModel& model) {
  report::Table table;
  table.caption = "Experts. The force is their weighted mean, without those of whom no rule fires at a point.";
  table.head = {{headingCell("expert"), headingCell("weight"), headingCell("rules"), headingCell("disabled"),
                 headingCell("own terms")}};
  for (const fuzzy::Expert& expert : model.experts) {
    const auto disabled =
        std::count_if(expert.rules.begin(), expert.rules.end(), [](const fuzzy::Rule& rule) { return !rule.enabled; });
    std::vector<std::string> own;
    for (const fuzzy::TermOverride& terms : expert.overrides) own.push_back(terms.variable);
    table.body.push_back({headingCell(expert.id), numberCell(formatNumber(expert.weight)),
                          numberCell(std::to_string(expert.rules.size())), numberCell(std::to_string(disabled)),
                          report::Cell{base::joined(own, ", ")}});
  }
  return table;
}

report::Table fileTable(const model_io::BundleManifest& manifest) {
  report::Table table;
  table.caption =
      "What each file promises: the largest error of a program that computes its centroid in the way given, against "
      "the "
      "exact force.";
  table.head = {
      {headingCell("file"), headingCell("centroid"), headingCell("largest error (N)"), headingCell("tolerance (N)")}};
  for (const model_io::BundleFile& file : manifest.files) {
    if (!file.promise) continue;
    table.body.push_back(
        {headingCell(file.path), report::Cell{file.promise->rule},
         numberCell((file.promise->measured ? "" : "at most ") + formatNumber(file.promise->largest_error_n)),
         numberCell(formatNumber(file.promise->tolerance_n))});
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

/// Who approved the model, with the evidence.
std::vector<Markup> approvalTexts(const Bundle& bundle) {
  std::vector<Markup> out;
  for (const model_io::Approval& one : bundle.approvals)
    out.emplace_back("Approved by " + one.author + ", " + one.utc + ": " + one.text + ".");
  if (out.empty()) out.emplace_back("No expert's approval of this model comes with the bundle.");
  return out;
}

}  // namespace

std::string bundleReport(const Bundle& bundle, const fuzzy::CompiledModel& compiled) {
  const fuzzy::ForceModel& model = bundle.model;
  const model_io::BundleManifest& manifest = bundle.manifest;
  report::HtmlPage page(model.name, "Force model for a simulator, " + manifest.created_utc + ", " + manifest.generator +
                                        ". Model SHA-256 " + bundle.model_sha256);
  if (const auto simulated = simulatedSources(model)) {
    page.notice("Simulated, not measured: data of " + *simulated + ". " + model.provenance->notes);
  } else if (!model.provenance) {
    page.notice("The file does not say what data the model is from.");
  }

  page.section("Model");
  const auto range = analysis::reachableRange(model, compiled);
  page.list({"Reachable force: " +
                 (range.fired > 0 ? formatFixed(range.min_n, 3) + " to " + formatFixed(range.max_n, 3)
                                  : std::string("none,")) +
                 " " + model.output.unit + ", seen at " + std::to_string(range.points) + " points.",
             "Where no rule of any expert fires the force is " + formatNumber(model.default_force_n) + " " +
                 model.output.unit + " and fired is 0. " + holeText(bundle),
             "A simulator adds its own limits: Tactus does not know the device or the person."});
  page.table(inputTable(model));
  page.table(expertTable(model));
  page.list(approvalTexts(bundle));
  page.section("Forces");
  report::Figure figure;
  figure.caption = "The force over each input, the others in the middle of their universes.";
  figure.columns = 2;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) figure.panels.push_back({"", curves(model, compiled, i)});
  page.figure(figure);
  page.section("Files");
  page.table(fileTable(manifest));
  page.paragraph(
      "Check this bundle at any time with the command tactus verify and its folder, or with tactus_verify of "
      "libtactus. tactus verify prints its fingerprint: it is the same that the sender saw when the bundle was made, "
      "or "
      "this is another bundle.");
  return page.html();
}

}  // namespace tactus::bundle
