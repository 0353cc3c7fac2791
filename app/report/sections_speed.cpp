#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "experiments/stroke_speeds.h"

namespace tactus::report {

namespace {

// A drawn trace needs no more points than this; the report stays small.
constexpr std::size_t kMostTracePoints = 300;
constexpr std::array<Dash, 4> kLevelDashes = {Dash::kSolid, Dash::kDashed, Dash::kDashDot, Dash::kDotted};

std::string signedFixed(double value, int decimals) {
  const std::string text = base::formatFixed(std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return zero ? text : (value < 0 ? "−" : "+") + text;
}

/// The strokes of one participant at one level, each a series of speed over time, thinned out.
std::vector<Series> traces(const study::Study& study, const std::string& participant, const std::string& level) {
  std::vector<Series> strokes;
  int current = 0;
  for (const study::SpeedSample& sample : study.speeds) {
    if (sample.participant != participant || sample.level != level) continue;
    if (strokes.empty() || sample.stroke != current) strokes.emplace_back();
    current = sample.stroke;
    strokes.back().push_back({sample.time_s, sample.speed_mm_s});
  }
  for (Series& stroke : strokes) {
    const std::size_t step = (stroke.size() + kMostTracePoints - 1) / kMostTracePoints;
    Series thinned;
    for (std::size_t i = 0; i < stroke.size(); i += std::max<std::size_t>(1, step)) thinned.push_back(stroke[i]);
    if (thinned.back().x != stroke.back().x) thinned.push_back(stroke.back());
    stroke = std::move(thinned);
  }
  return strokes;
}

std::string tracePlot(const ReportContext& context, const std::string& participant, const std::vector<Series>& strokes,
                      std::string_view color, double speed_max_mm_s) {
  double end_s = 0;
  for (const Series& stroke : strokes) end_s = std::max(end_s, stroke.back().x);
  SvgPlot plot({.title = speedVariable(context).terms.back().label + " strokes of " + participant,
                .description = "Insertion speed over time.",
                .width = 460,
                .height = 240,
                .x = {.label = "Time from the start of the stroke (s)", .min = 0, .max = end_s > 0 ? end_s : 1},
                .y = {.label = "Speed (mm/s)", .min = 0, .max = speed_max_mm_s},
                .simulated = context.simulated(participant)});
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    plot.line(strokes[i], {.color = color, .width = 1.6, .dash = kLevelDashes[i % kLevelDashes.size()]},
              "Stroke " + std::to_string(i + 1));
  }
  return plot.svg();
}

Table table1(const ReportContext& context) {
  Table table{
      .caption =
          strong("Table 1, published and simulated.") + " " + marks(context, {Badge::kPublished, Badge::kSimulated}) +
          " Insertion speed in mm/s, over all samples of four strokes per cell. The strokes are simulated "
          "as the positions of a device, from which the speeds are computed; they are made to have the published "
          "means and standard deviations.",
      .head = {{{.text = ""},
                {.text = ""},
                {.text = "Published", .columns = 2, .group_start = true},
                {.text = "Simulated", .columns = 2, .group_start = true},
                {.text = "Difference", .columns = 2, .group_start = true},
                {.text = "Data", .columns = 2, .group_start = true}},
               {{.text = "Participant"},
                {.text = "Level"},
                numberCell("mean", true),
                numberCell("SD"),
                numberCell("mean", true),
                numberCell("SD"),
                numberCell("mean", true),
                numberCell("SD"),
                numberCell("strokes", true),
                numberCell("samples")}},
      .body = {}};
  const auto summaries = experiments::summarizeSpeeds(context.in.study.speeds);
  double worst = 0;
  std::string last;
  for (const experiments::PublishedSpeed& cell : context.demo->published_speeds) {
    const auto found = std::find_if(summaries.begin(), summaries.end(), [&](const experiments::SpeedSummary& summary) {
      return summary.participant == cell.participant && summary.level == cell.level;
    });
    std::vector<Cell> row = {headingCell(cell.participant == last ? "" : cell.participant),
                             {.text = cell.level},
                             numberCell(base::formatFixed(cell.mean_mm_s, 1), true),
                             numberCell(base::formatFixed(cell.sd_mm_s, 1))};
    last = cell.participant;
    if (found == summaries.end()) {
      row.push_back({.text = "no strokes", .columns = 6, .group_start = true});
    } else {
      worst = std::max({worst, std::abs(found->mean_mm_s - cell.mean_mm_s), std::abs(found->sd_mm_s - cell.sd_mm_s)});
      for (Cell& each : std::array<Cell, 6>{numberCell(base::formatFixed(found->mean_mm_s, 2), true),
                                            numberCell(base::formatFixed(found->sd_mm_s, 2)),
                                            numberCell(signedFixed(found->mean_mm_s - cell.mean_mm_s, 2), true),
                                            numberCell(signedFixed(found->sd_mm_s - cell.sd_mm_s, 2)),
                                            numberCell(std::to_string(found->strokes), true),
                                            numberCell(std::to_string(found->samples))}) {
        row.push_back(std::move(each));
      }
    }
    table.body.push_back(std::move(row));
  }
  table.note = "Largest difference " + base::formatFixed(worst, 3) + " mm/s. The paper prints one decimal.";
  return table;
}

/// Mean and SD of each participant and level.
Table levelSpeeds(const ReportContext& context) {
  Table table{.caption = strong("Insertion speeds.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " In mm/s, over all samples of a participant’s strokes at the level that was asked for.",
              .head = {{{.text = "Participant"},
                        {.text = "Level"},
                        numberCell("Mean", true),
                        numberCell("SD"),
                        numberCell("Strokes", true),
                        numberCell("Samples")}},
              .body = {}};
  std::string last;
  for (const auto& one : experiments::summarizeSpeeds(context.in.study.speeds)) {
    table.body.push_back({headingCell(one.participant == last ? "" : one.participant),
                          {.text = one.level},
                          numberCell(base::formatFixed(one.mean_mm_s, 1), true),
                          numberCell(base::formatFixed(one.sd_mm_s, 1)),
                          numberCell(std::to_string(one.strokes), true),
                          numberCell(std::to_string(one.samples))});
    last = one.participant;
  }
  return table;
}

}  // namespace

void addSpeeds(HtmlPage& page, const ReportContext& context) {
  if (context.in.study.speeds.empty() || !fuzzy::rateOf(context.in.built.model.inputs)) return;
  const fuzzy::Term& fastest = speedVariable(context).terms.back();
  page.section("Insertion speed");
  page.table(context.demo != nullptr ? table1(context) : levelSpeeds(context));
  double speed_max_mm_s = 0;
  for (const study::SpeedSample& sample : context.in.study.speeds) {
    if (sample.level == fastest.id) speed_max_mm_s = std::max(speed_max_mm_s, sample.speed_mm_s);
  }
  if (speed_max_mm_s <= 0) return;
  Figure figure{
      .caption = context.demo != nullptr
                     ? strong("Fig. 6, recomputed.") + " " + badge(Badge::kSimulated) +
                           " Speed traces at the level “fast”, four simulated strokes of each participant. The speed "
                           "axes are the same, the time axes are not. The recordings of the paper are not published."
                     : strong("Strokes at the level “" + base::lowered(fastest.label) + "”.") + " " +
                           marks(context, {Badge::kSimulated}) +
                           " Speed over time. The speed axes are the same, the time axes are not.",
      .panels = {},
      .columns = 2};
  char letter = 'a';
  for (std::size_t who = 0; who < context.in.study.participants.size(); ++who) {
    const study::Participant& participant = context.in.study.participants[who];
    const std::vector<Series> strokes = traces(context.in.study, participant.code, fastest.id);
    if (strokes.empty()) continue;
    if (figure.panels.size() == kMostDrawn) {
      figure.caption += " The first " + std::to_string(kMostDrawn) + " participants with such strokes are drawn.";
      break;
    }
    figure.panels.push_back(
        {.heading = std::string("(") + letter++ + ") " + participant.code,
         .svg = tracePlot(context, participant.code, strokes, seriesColor(who), std::ceil(speed_max_mm_s / 50) * 50)});
  }
  page.figure(figure);
}

}  // namespace tactus::report
