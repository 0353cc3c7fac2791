// The tables of the speed clusters: centers and ramps, their intervals, and the levels that were asked for.
#include <algorithm>
#include <array>

#include "app/report/report_sections.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

using base::formatFixed;
using elicitation::Interval;
using elicitation::ParticipantSpeeds;

constexpr std::size_t kValues = 7;  // three centers and the four ends of two ramps

bool hasThreeTerms(const ParticipantSpeeds& subject) {
  return subject.centres.size() == 3 && subject.ramps.size() == 2;
}

bool startsGroup(std::size_t value) { return value == 0 || value == 3 || value == 5; }

std::vector<std::vector<Cell>> valueHead() {
  return {{{.text = ""},
           {.text = "Centers", .columns = 3, .group_start = true},
           {.text = "Ramp slow, medium", .columns = 2, .group_start = true},
           {.text = "Ramp medium, fast", .columns = 2, .group_start = true}},
          {{.text = "Participant"},
           numberCell("slow", true),
           numberCell("medium"),
           numberCell("fast"),
           numberCell("p", true),
           numberCell("q"),
           numberCell("p", true),
           numberCell("q")}};
}

Table clusterTable(const ReportContext& context) {
  Table table{.caption = strong("Cluster centers and ramps.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Fuzzy C-Means of each participant’s samples, in mm/s. A ramp falls from 1 at p to 0 "
                         "at q; the next term rises there.",
              .head = valueHead(),
              .body = {}};
  std::array<std::vector<double>, kValues> columns;
  for (const ParticipantSpeeds& subject : context.in.built.speeds) {
    if (!hasThreeTerms(subject)) continue;
    const std::array<double, kValues> values = {subject.centres[0], subject.centres[1], subject.centres[2],
                                                subject.ramps[0].p, subject.ramps[0].q, subject.ramps[1].p,
                                                subject.ramps[1].q};
    std::vector<Cell> row = {headingCell(subject.participant)};
    for (std::size_t i = 0; i < kValues; ++i) {
      columns[i].push_back(values[i]);
      row.push_back(numberCell(formatFixed(values[i], 1), startsGroup(i)));
    }
    table.body.push_back(std::move(row));
  }
  if (!columns[0].empty()) {
    std::vector<Cell> row = {headingCell("Mean")};
    for (std::size_t i = 0; i < kValues; ++i) {
      row.push_back(numberCell(strong(formatFixed(base::mean(columns[i]), 1)), startsGroup(i)));
    }
    table.body.push_back(std::move(row));
  }
  return table;
}

Cell intervalCell(const Interval& interval, std::size_t value) {
  return numberCell(formatFixed(interval.low, 1) + "–" + formatFixed(interval.high, 1), startsGroup(value));
}

Table intervalTable(const ReportContext& context) {
  const auto& intervals = *context.speed_intervals;
  Table table{.caption = strong("95 % intervals.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) + " " +
                         std::to_string(intervals.replicates) +
                         " draws of whole strokes within each level, with replacement; Student’s t times the standard "
                         "deviation of the draws, widened for few strokes; in mm/s.",
              .head = valueHead(),
              .body = {}};
  for (std::size_t who = 0; who < context.in.built.speeds.size(); ++who) {
    const ParticipantSpeeds& subject = context.in.built.speeds[who];
    if (!hasThreeTerms(subject)) continue;
    const auto& own = intervals.participants[who];
    table.body.push_back({headingCell(subject.participant), intervalCell(own.centres[0], 0),
                          intervalCell(own.centres[1], 1), intervalCell(own.centres[2], 2),
                          intervalCell(own.ramps[0].p, 3), intervalCell(own.ramps[0].q, 4),
                          intervalCell(own.ramps[1].p, 5), intervalCell(own.ramps[1].q, 6)});
  }
  if (intervals.averaged.size() == 2) {
    table.body.push_back({headingCell("Mean"),
                          {.text = "", .columns = 3, .group_start = true},
                          intervalCell(intervals.averaged[0].p, 3),
                          intervalCell(intervals.averaged[0].q, 4),
                          intervalCell(intervals.averaged[1].p, 5),
                          intervalCell(intervals.averaged[1].q, 6)});
  }
  table.note =
      "Samples within a stroke hang together, so strokes are drawn, not samples: intervals from single samples would "
      "be "
      "ten times too narrow. The intervals of the mean say how these participants’ strokes vary, not how other "
      "participants would.";
  return table;
}

/// `text`, in bold where it is something to look at.
Cell markedCell(const std::string& text, bool marked, bool group_start = false) {
  return numberCell(marked ? strong(text) : Markup(text), group_start);
}

std::string pText(const elicitation::LevelTrend& trend) {
  return trend.p < 0.001 ? "< 0.001" : formatFixed(trend.p, 3);
}

Table levelTable(const ReportContext& context) {
  Table table{.caption = strong("Levels against clusters.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Commanded levels, measured speeds, and the clusters of the samples. Speeds in mm/s.",
              .head = {{{.text = "", .columns = 2},
                        {.text = "Speed", .columns = 3, .group_start = true},
                        {.text = "% nearest to the center", .columns = 3, .group_start = true},
                        {.text = "Agreement", .columns = 2, .group_start = true},
                        {.text = "Order of strokes", .columns = 2, .group_start = true},
                        {.text = "", .group_start = true}},
                       {{.text = "Participant"},
                        {.text = "Level"},
                        numberCell("mean", true),
                        numberCell("SD"),
                        numberCell("d′ to next"),
                        numberCell("slow", true),
                        numberCell("medium"),
                        numberCell("fast"),
                        numberCell("adj. Rand", true),
                        numberCell("accuracy"),
                        numberCell("J", true),
                        numberCell("p"),
                        {.text = "Reads as", .group_start = true}}},
              .body = {},
              .wide = true};
  const fuzzy::Variable& speed = speedVariable(context);
  for (const ParticipantSpeeds& subject : context.in.built.speeds) {
    const auto& found = subject.diagnostics;
    if (!hasThreeTerms(subject)) continue;
    for (std::size_t k = 0; k < found.levels.size(); ++k) {
      const auto& level = found.levels[k];
      std::vector<Cell> row = {headingCell(k == 0 ? subject.participant : ""),
                               {.text = level.level},
                               numberCell(formatFixed(level.mean_mm_s, 1), true),
                               numberCell(formatFixed(level.sd_mm_s, 1))};
      if (k < found.separations.size() && found.separations[k].has_value()) {
        const double separation = found.separations[k].value();
        row.push_back(markedCell(formatFixed(separation, 2), separation < 1));
      } else {
        row.push_back(numberCell(""));
      }
      for (std::size_t cluster = 0; cluster < subject.centres.size(); ++cluster) {
        const auto count = static_cast<double>(found.confusion.counts[k][cluster]);
        const double share = level.samples == 0 ? 0 : 100 * count / static_cast<double>(level.samples);
        row.push_back(numberCell(formatFixed(share, 0), cluster == 0));
      }
      const auto& confusion = found.confusion;
      const bool first = k == 0;
      row.push_back(markedCell(first ? formatFixed(confusion.adjusted_rand_index, 2) : "",
                               confusion.adjusted_rand_index < 0.3, true));
      row.push_back(markedCell(first ? formatFixed(confusion.accuracy, 2) : "", confusion.accuracy < 0.6));
      const bool tested = first && found.trend;
      row.push_back(numberCell(
          tested ? formatFixed(found.trend->j, 0) + " of " + formatFixed(found.trend->most_j, 0) : "", true));
      row.push_back(markedCell(tested ? pText(*found.trend) : "", tested && found.trend->p > 0.05));
      row.push_back({.text = speed.terms[elicitation::termAt(speed, level.mean_mm_s)].label, .group_start = true});
      table.body.push_back(std::move(row));
    }
  }
  table.note =
      "Clusters know nothing of the level a participant was asked for. d′: distance of the means by the pooled SD. "
      "Adjusted Rand index and accuracy: how far clusters and levels agree, 1 is perfect. J, p: Jonckheere-Terpstra "
      "test that the means of the strokes rise with the level, one-sided, over every arrangement of the strokes. Reads "
      "as: the averaged term of the mean speed. Bold: d′ below 1, index below 0.3, accuracy below 0.6, p above 0.05.";
  return table;
}

}  // namespace

void addClusterTables(HtmlPage& page, const ReportContext& context) {
  page.table(clusterTable(context));
  if (context.speed_intervals) page.table(intervalTable(context));
  page.table(levelTable(context));
}

}  // namespace tactus::report
