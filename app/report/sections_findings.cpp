#include <algorithm>
#include <map>

#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/model/expert_weights_compared.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::report {

namespace {

using elicitation::RuleFinding;

// Rows of one kind; `tactus build --json` has them all.
constexpr std::size_t kMostRows = 5;

std::string_view words(RuleFinding::Kind kind) {
  using Kind = RuleFinding::Kind;
  switch (kind) {
    case Kind::kHole: return "Hole";
    case Kind::kAbstentionJump: return "Jump of the mean";
    case Kind::kForceStep: return "Step of the force";
    case Kind::kRegionWithoutRule: return "Region without a rule";
    case Kind::kMissingItem: return "Missing answer";
    case Kind::kConflict: return "Contradiction";
    case Kind::kExpertsApart: return "Experts far apart";
    case Kind::kAgainstDeclaration: return "Against the declared direction";
    case Kind::kLevelJump: return "Jump between neighboring answers";
    case Kind::kDirectionChange: return "Change of direction";
    case Kind::kDisagreement: return "Opposite direction";
    case Kind::kRedundantRule: return "Rule without effect";
    case Kind::kUnreachableRule: return "Rule that never fires";
    case Kind::kUnreachableTerm: return "Term out of reach";
    case Kind::kUnusedTerm: return "Unused term";
  }
  return "";
}

/// `text` with the ids of inputs and terms written as words.
std::string inWords(std::string text, const fuzzy::ForceModel& model) {
  const auto spell = [&text](const std::string& id) {
    std::string spaced = id;
    std::replace(spaced.begin(), spaced.end(), '_', ' ');
    if (spaced != id) text = base::replaced(std::move(text), {{id, spaced}});
  };
  const auto spell_all = [&spell](const fuzzy::Variable& variable) {
    spell(variable.id);
    for (const auto& term : variable.terms) spell(term.id);
  };
  for (const auto& input : model.inputs) spell_all(input);
  spell_all(model.output);
  return text;
}

/// The sentence of a finding without what the column of its kind says already.
std::string sentenceOf(const RuleFinding& finding, const fuzzy::ForceModel& model) {
  constexpr std::string_view kKnown = "against the declared direction: ";
  const bool known = finding.kind == RuleFinding::Kind::kAgainstDeclaration && finding.text.rfind(kKnown, 0) == 0;
  return inWords(known ? finding.text.substr(kKnown.size()) : finding.text, model);
}

std::string forceText(const RuleFinding& finding) {
  if (!finding.newtons) return "";
  return (finding.at_least ? "≥ " : "") + base::formatFixed(*finding.newtons, 3);
}

/// `1 : 1 : 2 : 1`
std::string weightsText(const fuzzy::ForceModel& model) {
  std::vector<std::string> parts;
  for (const auto& expert : model.experts) parts.push_back(base::formatNumber(expert.weight));
  if (parts.size() > kMostDrawn) parts = {parts[0], parts[1], parts[2], "…"};
  return base::joined(parts, " : ");
}

std::string expertsText(const fuzzy::ForceModel& model) {
  std::vector<std::string> parts;
  for (const auto& expert : model.experts) parts.push_back(expert.id);
  if (parts.size() > kMostDrawn) parts = {parts[0], parts[1], parts[2], "…"};
  return base::joined(parts, " : ");
}

std::vector<Cell> weightRow(const elicitation::WeightedModel& one) {
  std::vector<Cell> row = {headingCell(one.table.empty() ? std::string(name(one.policy)) : one.table)};
  if (!one.model) {
    row.push_back({.text = muted("not possible: " + one.unavailable), .columns = 4});
    return row;
  }
  row.push_back(numberCell(weightsText(*one.model)));
  row.push_back(numberCell(base::formatFixed(one.from_equal.largest_n, 3), true));
  row.push_back(numberCell(base::formatFixed(one.from_equal.rms_n, 3)));
  row.push_back(
      {.text = one.from_equal.largest_n > 0 ? settingText(*one.model, one.from_equal.at) : "", .group_start = true});
  return row;
}

}  // namespace

namespace {

/// `more gel less force, more speed more`, as the procedure declares; empty if it declares none.
std::string declaredText(const ReportContext& context) {
  std::vector<std::string> parts;
  const procedure::Procedure& about = context.about();
  for (std::size_t i = 0; i < about.inputs.size(); ++i) {
    const auto direction = about.input_notes[i].direction;
    if (direction == procedure::Direction::kNone) continue;
    parts.push_back("more " + base::lowered(about.inputs[i].label) +
                    (direction == procedure::Direction::kFalls ? " less" : " more") + (parts.empty() ? " force" : ""));
  }
  return base::joined(parts, ", ");
}

}  // namespace

std::string valueText(const fuzzy::Variable& input, double value) {
  const int decimals = input.max - input.min > 10 ? 0 : 2;
  return base::lowered(input.label) + " " + base::formatFixed(value, decimals) +
         (input.unit == "1" ? "" : " " + input.unit);
}

std::string settingText(const fuzzy::ForceModel& model, const std::vector<double>& point) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < point.size(); ++i) parts.push_back(valueText(model.inputs[i], point[i]));
  return base::joined(parts, ", ");
}

std::string settingText(const ReportContext& context, const std::vector<double>& point,
                        const std::vector<std::size_t>& without) {
  const auto& inputs = context.in.built.model.inputs;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool left_out = std::find(without.begin(), without.end(), i) != without.end();
    if (!left_out && fuzzy::roleOf(inputs[i]) != fuzzy::Role::kWay) parts.push_back(valueText(inputs[i], point[i]));
  }
  return base::joined(parts, ", ");
}

std::string atUsual(const ReportContext& context) {
  const std::string text = settingText(context, context.usual);
  return text.empty() ? text : " at " + text;
}

void addFindings(HtmlPage& page, const ReportContext& context) {
  page.section("Findings in the rules");
  const auto& model = context.in.built.model;
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return;
  const auto lint = elicitation::ruleLint(model, *compiled, context.in.built.experts);
  if (lint.findings.empty()) {
    page.paragraph("The lint found nothing in the rules of this model.");
    return;
  }
  const std::string declared = declaredText(context);
  page.paragraph(
      "Places in the rules to look at together with the expert. None of them is an error, and nothing was changed. The "
      "force is the one at stake: how far the force jumps there, or how far two experts or two answers are apart; “≥” "
      "marks the largest one of many settings looked at." +
      (declared.empty() ? std::string()
                        : " The declared directions (" + declared + ") follow the procedure and are no law."));
  Table table{.caption = strong("Findings.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " By kind, the largest force first." +
                         (context.demo != nullptr ? " Rules of " + context.demo->published_expert +
                                                        " are published, those of the others simulated."
                                                  : ""),
              .head = {{{.text = "Kind"}, {.text = "Expert"}, {.text = "Where"}, numberCell("Force (N)")}},
              .body = {},
              .wide = true};
  std::map<RuleFinding::Kind, std::size_t> of_kind;
  for (const auto& finding : lint.findings) ++of_kind[finding.kind];
  std::map<RuleFinding::Kind, std::size_t> shown;
  for (const auto& finding : lint.findings) {
    auto& rows = shown[finding.kind];
    const Cell kind = rows == 0 ? headingCell(std::string(words(finding.kind))) : Cell{};
    if (++rows <= kMostRows) {
      const std::string who = finding.experts.empty() ? "mean" : base::joined(finding.experts, ", ");
      table.body.push_back({kind, {.text = who}, {.text = sentenceOf(finding, model)}, numberCell(forceText(finding))});
    } else if (rows == of_kind[finding.kind]) {
      table.body.push_back({kind, {.text = muted("and " + std::to_string(rows - kMostRows) + " more"), .columns = 3}});
    }
  }
  page.table(table);
}

void addWeights(HtmlPage& page, const ReportContext& context) {
  const bool few = context.in.built.model.experts.size() <= kMostDrawn;
  const auto compared = elicitation::compareWeights(
      context.in.built, context.in.study, context.in.build_settings,
      few ? elicitation::eachCountsTwice(context.in.built) : std::vector<elicitation::WeightSettings>{});
  if (!compared) return;
  page.subsection("The mean under other weights");
  page.paragraph(
      "The same experts and the same terms, weighted in every way that the data of the study allow, against equal "
      "weights as in Eq. 2 of Choi et al." +
      std::string(context.demo != nullptr ? " The paper discusses weights by experience and says only that all four "
                                            "nurses have more than ten years. So the last rows show what it would mean "
                                            "to let one of them count twice."
                  : few                   ? " The last rows show what it would mean to let one expert count twice."
                                          : ""));
  Table table{.caption = strong("Weights.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Difference of the averaged force to equal weights.",
              .head = {{{.text = "Weights"},
                        numberCell(expertsText(context.in.built.model)),
                        numberCell("Largest (N)", true),
                        numberCell("RMS (N)"),
                        {.text = "Where it is largest", .group_start = true}}},
              .body = {},
              .wide = true};
  for (const auto& one : *compared) table.body.push_back(weightRow(one));
  page.table(table);
}

}  // namespace tactus::report
