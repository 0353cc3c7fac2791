// The second page of a bundle's report: who made the model, what it takes, what its files promise.
#include <algorithm>

#include "app/bundle/report_parts.h"
#include "core/base/text.h"
#include "core/render/tube_checks.h"

namespace tactus::bundle {
namespace {

using base::formatFixed;
using base::formatNumber;
using report::headingCell;
using report::Markup;
using report::numberCell;

report::Table inputTable(const fuzzy::ForceModel& model) {
  report::Table table;
  table.caption = "Inputs in their order, and the output. Values outside a universe are clamped.";
  table.head = {{headingCell("id"), headingCell("label"), numberCell("from"), numberCell("to"), headingCell("unit"),
                 headingCell("terms")}};
  const auto row = [&](const fuzzy::Variable& variable) {
    std::vector<std::string> terms;
    for (const fuzzy::Term& term : variable.terms) {
      if (terms.size() < kMostReportRows) terms.push_back(term.id);
    }
    if (variable.terms.size() > terms.size()) terms.emplace_back("…");
    table.body.push_back({headingCell(variable.id), report::Cell{variable.label},
                          numberCell(formatNumber(variable.min)), numberCell(formatNumber(variable.max)),
                          report::Cell{variable.unit}, report::Cell{base::joined(terms, ", ")}});
  };
  for (const fuzzy::Variable& input : model.inputs) row(input);
  row(model.output);
  return table;
}

report::Table expertTable(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  report::Table table;
  table.caption =
      "Experts. The force is their weighted mean, without those of whom no rule fires at a point. Agreement: how far "
      "an expert is from that mean, over the whole box of the inputs.";
  table.head = {{headingCell("expert"), numberCell("weight"), numberCell("rules"), numberCell("disabled"),
                 headingCell("own terms"), numberCell("mean distance (" + model.output.unit + ")"),
                 numberCell("within one JND")}};
  for (std::size_t e = 0; e < std::min(model.experts.size(), kMostReportRows); ++e) {
    const fuzzy::Expert& expert = model.experts[e];
    const auto disabled =
        std::count_if(expert.rules.begin(), expert.rules.end(), [](const fuzzy::Rule& rule) { return !rule.enabled; });
    std::vector<std::string> own;
    for (const fuzzy::TermOverride& terms : expert.overrides) own.push_back(terms.variable);
    const auto agreement = model.experts.size() > 1 ? agreementOf(model, compiled, e) : std::nullopt;
    table.body.push_back({headingCell(expert.id), numberCell(formatNumber(expert.weight)),
                          numberCell(std::to_string(expert.rules.size())), numberCell(std::to_string(disabled)),
                          report::Cell{base::joined(own, ", ")},
                          numberCell(agreement ? shortly(agreement->mean_n) : ""),
                          numberCell(agreement ? formatFixed(100 * agreement->within_jnd, 0) + " %" : "")});
  }
  if (model.experts.size() > kMostReportRows)
    table.note = "And " + std::to_string(model.experts.size() - kMostReportRows) + " more, in the model file.";
  return table;
}

/// The files of a kind: `experts/*.fll`, or their paths.
struct FileGroup {
  std::string kind;
  std::string paths;
  model_io::Promise worst;
};

report::Table fileTable(const model_io::BundleManifest& manifest) {
  std::vector<FileGroup> groups;
  for (const model_io::BundleFile& file : manifest.files) {
    if (!file.promise) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.kind == file.kind; });
    const std::string path = file.expert.empty()
                                 ? file.path
                                 : "experts/*" + file.path.substr(std::min(file.path.find('.'), file.path.size()));
    if (group == groups.end()) {
      groups.push_back({file.kind, path, *file.promise});
      continue;
    }
    if (group->paths.find(path) == std::string::npos) group->paths += ", " + path;
    group->worst.measured = group->worst.measured && file.promise->measured;
    group->worst.largest_error_n = std::max(group->worst.largest_error_n, file.promise->largest_error_n);
    group->worst.tolerance_n = std::max(group->worst.tolerance_n, file.promise->tolerance_n);
  }
  report::Table table;
  table.caption =
      "What the files promise: the largest error of a program that computes its centroid in the way given, against the "
      "exact force; of several files, the worst.";
  table.head = {
      {headingCell("files"), headingCell("centroid"), numberCell("largest error (N)"), numberCell("promised (N)")}};
  for (const FileGroup& group : groups) {
    table.body.push_back({headingCell(group.paths), report::Cell{group.worst.rule},
                          numberCell((group.worst.measured ? "" : "at most ") + shortly(group.worst.largest_error_n)),
                          numberCell(shortly(group.worst.tolerance_n))});
  }
  return table;
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

void addSecondPage(report::HtmlPage& page, const Bundle& bundle, const fuzzy::CompiledModel& compiled) {
  const fuzzy::ForceModel& model = bundle.model;
  page.section("Experts");
  page.table(expertTable(model, compiled));
  page.list(approvalTexts(bundle));
  page.section("Inputs and limits");
  page.table(inputTable(model));
  page.list({"A simulator adds its own limits: Tactus does not know the device or the person.",
             "The model holds inside its universes; what it says of other tubes, patients and procedures is not known.",
             "A force of the model is friction between tube and passage; the renderer makes it what a hand feels, with "
             "at most " +
                 shortly(render::kTubeCapN) + " N."});
  page.section("Files");
  page.table(fileTable(bundle.manifest));
  page.paragraph(
      "Check this bundle at any time with the command tactus verify and its folder, or with tactus_verify of "
      "libtactus. tactus verify prints its fingerprint: it is the same that the sender saw when the bundle was made, "
      "or this is another bundle.");
}

}  // namespace tactus::bundle
