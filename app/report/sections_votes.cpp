#include <algorithm>
#include <cmath>
#include <set>

#include "app/report/report_sections.h"
#include "core/base/text.h"

namespace tactus::report {

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
