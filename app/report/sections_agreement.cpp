// How far the experts agree: in words (judgements, answers) and in newtons (leaving one out).
#include <algorithm>
#include <map>
#include <string>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "elicitation/agreement/agreement.h"
#include "questionnaires/form_file.h"
#include "questionnaires/questionnaire.h"

namespace tactus::report {

void addUsability(HtmlPage& page, const ReportContext& context) {
  if (context.in.usability.empty()) return;
  const auto form = questionnaires::usabilityForm();
  const auto asked = questionnaires::questionnaire(context.about(), form.id, "en");
  page.section("Usability of the simulator");
  Table table{.caption = strong("Usability.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Answers from 1 (" + form.low + ") to " + std::to_string(form.points) + " (" + form.high +
                         "), as in Table 3 of Choi et al.",
              .head = {{{.text = "Statement"},
                        numberCell("Answers", true),
                        numberCell("Mean"),
                        numberCell("SD"),
                        numberCell("Min"),
                        numberCell("Max")}},
              .body = {},
              .note = "SD with n − 1. A participant who skipped a statement is not counted there."};
  for (const auto& row : context.in.usability) {
    const auto item = std::find_if(asked->questions.begin(), asked->questions.end(),
                                   [&](const auto& one) { return one.number == row.item; });
    const std::string statement = item == asked->questions.end() ? std::string() : ". " + item->text;
    const bool some = row.n > 0;
    const auto number = [some](const std::string& text) { return numberCell(some ? text : "–"); };
    table.body.push_back({{.text = std::to_string(row.item) + statement},
                          numberCell(std::to_string(row.n), true),
                          number(base::formatFixed(row.mean, 2)),
                          number(base::formatFixed(row.sd, 2)),
                          number(std::to_string(row.min)),
                          number(std::to_string(row.max))});
  }
  page.table(table);
}

namespace {

using elicitation::Agreement;
using elicitation::AgreementData;
using elicitation::OrReason;

std::vector<std::string> termIds(const ReportContext& context) {
  std::vector<std::string> ids;
  for (const auto& term : context.in.built.model.output.terms) ids.push_back(term.id);
  return ids;
}

Markup numberOr(const OrReason<double>& value) { return value ? Markup(base::formatFixed(*value, 3)) : muted("none"); }

/// Why a measure has no value, each reason once.
std::string reasons(const Agreement& agreement) {
  std::vector<std::string> out;
  const auto take = [&out](const auto& value) {
    if (value || std::find(out.begin(), out.end(), value.error()) != out.end()) return;
    out.push_back(value.error());
  };
  take(agreement.alpha_ordinal);
  take(agreement.alpha_interval);
  take(agreement.alpha_nominal);
  take(agreement.kendall_w);
  take(agreement.fleiss_kappa);
  return out.empty() ? std::string() : " None: " + base::joined(out, "; ") + ".";
}

/// One row of the table of measures.
std::vector<Cell> measures(const Markup& what, const AgreementData& data, const Agreement& agreement) {
  const auto& kappa = agreement.fleiss_kappa;
  const auto& w = agreement.kendall_w;
  return {headingCell(what),
          numberCell(std::to_string(data.units.size()) + " × " + std::to_string(data.raters.size())),
          numberCell(strong(numberOr(agreement.alpha_ordinal)), true),
          numberCell(agreement.mean_consensus ? base::formatFixed(*agreement.mean_consensus, 3) : "none"),
          numberCell(numberOr(agreement.alpha_interval), true),
          numberCell(numberOr(agreement.alpha_nominal)),
          numberCell(w ? Markup(base::formatFixed(w->w, 3)) : muted("none")),
          numberCell(kappa ? base::formatFixed(kappa->kappa, 3) + " (" + base::formatFixed(kappa->z, 2) + ")"
                           : muted("none"))};
}

/// Consensus of each force as bars.
std::string consensusPlot(const ReportContext& context, const AgreementData& data, const Agreement& agreement) {
  constexpr double kHalfBarN = 0.035;
  const fuzzy::Variable& force = context.in.built.model.output;
  SvgPlot plot({.title = "Consensus at each force",
                .description = "1 where all choose the same term.",
                .width = 460,
                .height = 240,
                .x = {.label = "Insertion force (N)", .min = 0, .max = force.max + 2 * kHalfBarN},
                .y = {.label = "Consensus", .min = 0, .max = 1.05, .ticks = {0, 0.25, 0.5, 0.75, 1}},
                .simulated = context.simulated()});
  for (std::size_t i = 0; i < data.units.size(); ++i) {
    if (!agreement.items[i]) continue;
    const double at_n = data.units[i].force_n.value_or(0);
    plot.bars({at_n - kHalfBarN, at_n + kHalfBarN}, {agreement.items[i]->consensus}, kMuted);
  }
  return plot.svg();
}

/// The label of a term of one of the model's inputs; its id where the model has no such term.
std::string labelOf(const ReportContext& context, const std::string& input, const std::string& term) {
  for (const auto& variable : context.in.built.model.inputs) {
    if (variable.id != input) continue;
    if (const auto* found = fuzzy::findTerm(variable.terms, term)) return found->label;
  }
  return term;
}

/// Consensus of the answers, condition by region; items of another kind are passed over.
void addItemTable(HtmlPage& page, const ReportContext& context, const study::Form& form, const AgreementData& data,
                  const Agreement& agreement) {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::map<std::pair<std::string, std::string>, const elicitation::ItemConsensus*> cells;
  for (std::size_t i = 0; i < data.units.size(); ++i) {
    const auto item = std::find_if(form.items.begin(), form.items.end(),
                                   [&](const study::FormItem& one) { return one.number == data.units[i].item; });
    if (item == form.items.end() || item->conditions.size() != 2) continue;
    std::string row;
    std::string column;
    for (const auto& condition : item->conditions) {
      const std::string label = labelOf(context, condition.input, condition.term);
      if (condition.input == depthVariable(context.in.built.model).id) {
        column = label;
      } else {
        std::string input = condition.input;
        std::replace(input.begin(), input.end(), '_', ' ');
        row = input + " " + base::lowered(label);
      }
    }
    if (row.empty() || column.empty()) continue;
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
    cells[{row, column}] = agreement.items[i] ? &*agreement.items[i] : nullptr;
  }
  if (cells.empty()) return;
  Table table{.caption = strong("Consensus on each item of the form.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Tastle–Wierman consensus of the answers, and in brackets how many terms the answers are "
                         "apart. "
                         "Bold: two terms or more.",
              .head = {{{.text = "Condition"}}},
              .body = {}};
  for (const auto& column : columns) table.head.front().push_back(numberCell(column));
  for (const auto& row : rows) {
    table.body.push_back({headingCell(row)});
    for (const auto& column : columns) {
      const auto cell = cells.find({row, column});
      if (cell == cells.end() || cell->second == nullptr) {
        table.body.back().push_back(numberCell(muted("–")));
        continue;
      }
      const Markup consensus(base::formatFixed(cell->second->consensus, 2));
      const int spread = cell->second->spread_terms;
      table.body.back().push_back(
          numberCell((spread >= 2 ? strong(consensus) : consensus) + " " + muted("(" + std::to_string(spread) + ")")));
    }
  }
  page.table(table);
}

}  // namespace

void addAgreement(HtmlPage& page, const ReportContext& context) {
  page.section("How far the experts agree");
  const auto ids = termIds(context);
  const auto judgements =
      elicitation::agreementData(context.in.study.judgements, context.in.build_settings.series, ids);
  const auto answers = elicitation::agreementData(context.in.study.answers, {}, context.in.forms, ids);
  Table table{.caption = strong("Agreement in words.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Ordinal alpha and consensus know that neighboring terms are close. 1 is full agreement, 0 "
                         "is what chance gives.",
              .head = {{{.text = "Ratings"},
                        numberCell("Units × raters"),
                        numberCell("Ordinal alpha", true),
                        numberCell("Mean consensus"),
                        numberCell("Interval alpha", true),
                        numberCell("Nominal alpha"),
                        numberCell("Kendall’s W"),
                        numberCell("Fleiss’ kappa (z)")}},
              .body = {},
              .note = Markup(elicitation::nominalCaution()),
              .wide = true};
  if (judgements) {
    const auto agreement = elicitation::agreement(*judgements);
    table.body.push_back(
        measures(context.demo != nullptr ? "Judgements (Table 2)" : "Judgements", *judgements, agreement));
    table.note += reasons(agreement);
    if (context.demo != nullptr) {
      table.note +=
          " Table 2 says how many chose a term, not who: its W is that of one reconstructed split of the "
          "votes over four persons, the other measures need the votes alone.";
    }
  }
  if (answers) {
    const auto agreement = elicitation::agreement(*answers);
    table.body.push_back(measures(context.demo != nullptr ? "Answers (simulated)" : "Answers", *answers, agreement));
    table.note += reasons(agreement);
    if (context.demo != nullptr) {
      table.note += " The answers are those of " + base::joined(answers->raters, ", ") + "; " +
                    context.demo->published_expert + "’s rules were given directly and answer no item.";
    }
  }
  if (!judgements && !answers) {
    page.paragraph("There are no judgements and no answers of two participants to compare.");
    return;
  }
  page.table(table);
  if (judgements) {
    page.figure({.caption = strong("Consensus at each force.") + " " +
                            marks(context, {Badge::kComputed, Badge::kSimulated}) +
                            " From the votes (Tastle and Wierman 2007): 1 where all choose the same term, 0 where half "
                            "are at each end of the scale.",
                 .panels = {{.svg = consensusPlot(context, *judgements, elicitation::agreement(*judgements))}},
                 .columns = 2});
  }
  if (answers) {
    const auto form = std::find_if(context.in.forms.begin(), context.in.forms.end(),
                                   [&](const study::Form& one) { return one.id == answers->form; });
    if (form != context.in.forms.end()) {
      addItemTable(page, context, *form, *answers, elicitation::agreement(*answers));
    }
  }
}

}  // namespace tactus::report
