// How far the experts agree: in words (judgements, answers) and in newtons (leaving one out).
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
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

namespace {

/// A reason in a word or two, for the table.
std::string_view words(elicitation::VoteReason reason) {
  switch (reason) {
    case elicitation::VoteReason::kMajority: return "majority";
    case elicitation::VoteReason::kTieHigher: return "tie, higher wins";
    case elicitation::VoteReason::kNextLevel: return "next level";
    case elicitation::VoteReason::kClamped: return "next level, limited";
    case elicitation::VoteReason::kFirstMedian: return "median";
    case elicitation::VoteReason::kNoVotes: return "no votes";
  }
  return "";
}

/// What a reason means, for the note below the table.
std::string_view explain(elicitation::VoteReason reason) {
  switch (reason) {
    case elicitation::VoteReason::kMajority: return "one term has half of the votes or more";
    case elicitation::VoteReason::kTieHigher: return "two terms have half of the votes each, the higher wins";
    case elicitation::VoteReason::kNextLevel: return "no term has half, so one above the own term of the force before";
    case elicitation::VoteReason::kClamped: return "the same, kept within the terms that were voted for";
    case elicitation::VoteReason::kFirstMedian:
      return "no term has half and no force was decided before, so the lower median";
    case elicitation::VoteReason::kNoVotes: return "no votes";
  }
  return "";
}

std::string shortPoints(const fuzzy::Term& term) {
  std::vector<std::string> parts;
  for (const double point : term.points) parts.push_back(base::formatNumber(std::round(point * 1e6) / 1e6));
  return base::joined(parts, ", ");
}

/// Whether the votes are those of the paper's Table 2.
bool votesArePublished(const ReportContext& context) {
  std::size_t matched = 0;
  for (const elicitation::VoteStep& step : context.in.built.votes) {
    if (!step.term) continue;
    const auto published = std::find_if(context.demo->published_votes.begin(), context.demo->published_votes.end(),
                                        [&](const auto& row) { return std::abs(row.force_n - step.force_n) < 1e-9; });
    if (published == context.demo->published_votes.end() || published->votes != step.votes) return false;
    ++matched;
  }
  return matched == context.demo->published_votes.size();
}

/// Where the corners of the terms come from.
std::string termsOrigin(const ReportContext& context) {
  switch (context.in.build_settings.force_terms) {
    case elicitation::ForceTermsFrom::kFrequency:
      return " From the shares of all answers: the trapezoids that sum to 1 and are closest to them.";
    case elicitation::ForceTermsFrom::kThresholds:
      return " From each participant’s thresholds between the words, averaged.";
    case elicitation::ForceTermsFrom::kProbit:
      return " From one ordered probit over all answers: a ramp around each force at which the words change, as wide "
             "as "
             "their spread.";
    case elicitation::ForceTermsFrom::kVote: break;
  }
  return std::string(context.demo != nullptr ? " From the published votes:" : " From the vote:") +
         " the core of a term runs from the first to the last force it won, ramps join neighboring cores.";
}

}  // namespace

void addVotes(HtmlPage& page, const ReportContext& context) {
  if (context.in.built.votes.empty()) return;
  page.section("Insertion force");
  const auto& terms = context.in.built.model.output.terms;
  std::vector<Cell> head = {numberCell("Force (N)")};
  for (std::size_t i = 0; i < terms.size(); ++i) head.push_back(numberCell(terms[i].label, i == 0));
  head.push_back({.text = "Winner", .group_start = true});
  head.push_back({.text = "Reason"});
  Table table{
      .caption = (context.demo != nullptr
                      ? strong("Table 2 with its winners.") + " " + badges({Badge::kPublished, Badge::kComputed}) +
                            " Votes of the four nurses on each force"
                      : strong("Votes on the forces.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                            " Answers of the " + context.in.build_settings.series + " series at each commanded force") +
                 ", and the term that wins by the paper’s rule. The winning term’s votes are bold.",
      .head = {std::move(head)},
      .body = {}};
  std::set<elicitation::VoteReason> reasons;
  std::size_t without_votes = 0;
  for (const elicitation::VoteStep& step : context.in.built.votes) {
    if (!step.term) {
      ++without_votes;
      continue;
    }
    std::vector<Cell> row = {numberCell(base::formatFixed(step.force_n, 1))};
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const std::string count = i < step.votes.size() ? std::to_string(step.votes[i]) : "0";
      row.push_back(numberCell(i == *step.term ? strong(count) : count == "0" ? muted(count) : Markup(count), i == 0));
    }
    row.push_back({.text = strong(*step.term < terms.size() ? terms[*step.term].label : ""), .group_start = true});
    row.push_back({.text = Markup(words(step.reason)) + (step.monotone_raised ? Markup(", raised") : Markup()) +
                           (step.below_quorum ? Markup(", below quorum") : Markup()) +
                           (elicitation::isUnsaid(step)          ? strong(", nobody said it")
                            : !elicitation::isMostFrequent(step) ? Markup(", not the most frequent")
                                                                 : Markup())});
    reasons.insert(step.reason);
    table.body.push_back(std::move(row));
  }
  for (const elicitation::VoteReason reason : reasons) {
    if (!table.note.empty()) table.note += "; ";
    table.note += strong(words(reason)) + ": " + Markup(explain(reason));
  }
  table.note += ".";
  page.table(table);
  Markup origin;
  if (context.demo != nullptr) {
    origin = badge(Badge::kSimulated) +
             " The votes are counted from simulated judgements, one series for each participant. ";
    origin += votesArePublished(context) ? "They are exactly those that the paper prints."
                                         : "They differ from those that the paper prints!";
  }
  if (without_votes > 0) {
    origin +=
        " At " +
        (without_votes == 1 ? std::string("one larger force") : std::to_string(without_votes) + " larger forces") +
        (context.demo != nullptr ? " all participants said “beyond practice”" : " there is no vote for a term") +
        "; no term is given there and the universe ends below.";
  }
  if (!origin.empty()) page.paragraph(origin);
  if (context.in.build_settings.force_terms == elicitation::ForceTermsFrom::kVote) {
    const auto unsaid = elicitation::unsaidNotes(context.in.built.about().output, context.in.built.votes,
                                                 context.in.build_settings.force_end_n);
    page.list({unsaid.begin(), unsaid.end()});
  }

  Table points{
      .caption = strong("Terms of the force.") + " " + marks(context, {Badge::kComputed}) + termsOrigin(context),
      .head = {{{.text = "Term"}, {.text = "Corners (N)"}}},
      .body = {}};
  for (const fuzzy::Term& term : terms) {
    points.body.push_back({headingCell(term.label), {.text = shortPoints(term)}});
  }
  page.table(points);
}

}  // namespace tactus::report
