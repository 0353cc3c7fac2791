#include "tests/bench/workbench_lab_report.h"

#include <algorithm>

#include "tests/bench/machine.h"
#include "tests/bench/text_table.h"
#include "tests/bench/workbench_lab_visit.h"
#include "tests/bench/workbench_labs.h"

namespace tactus::bench {
namespace {

constexpr int kSamples = 24'000;
constexpr double kWantedMs = 33;

std::string_view name(Rhythm rhythm) {
  switch (rhythm) {
    case Rhythm::kAlone: return "alone";
    case Rhythm::kIntervals: return "during intervals";
    case Rhythm::kDrag: return "in a drag";
  }
  return {};
}

/// Median, 95 % and largest, separated by slashes; a hyphen without values.
std::string spreadText(std::vector<double> all) {
  if (all.empty()) return "-";
  std::sort(all.begin(), all.end());
  const auto at = [&all](double share) {
    return threeDigits(
        all[std::min(all.size() - 1, static_cast<std::size_t>(share * static_cast<double>(all.size())))]);
  };
  return at(0.5) + " / " + at(0.95) + " / " + at(1);
}

std::string heading() {
  std::string text;
  for (const std::string& line : machineLines()) text += line + '\n';
  return text + "Window: 1920 x 1080 px, not on a screen\n";
}

}  // namespace

std::string labReport(TimedApplication& application, int moves) {
  const auto all = moveLabSettings(application, kSamples, moves);
  std::vector<std::vector<std::string>> times = {{"setting", "when", "moves", "clusters and terms back",
                                                  "their threads", "shown", "window's thread", "in the strip",
                                                  "above 33 ms", "shown in the drag"}};
  std::vector<std::vector<std::string>> parts = {{"setting", "when", "work and painting", "of"}};
  for (const LabTimes& one : all) {
    const std::string when(name(one.rhythm));
    const auto late = std::count_if(one.strip_ms.begin(), one.strip_ms.end(), [](double ms) { return ms > kWantedMs; });
    times.push_back({one.setting, when, std::to_string(one.strip_ms.size()), spreadText(one.result_ms),
                     spreadText(one.worker_ms), spreadText(one.shown_ms), spreadText(one.window_ms),
                     spreadText(one.strip_ms), std::to_string(late),
                     one.rhythm == Rhythm::kDrag ? std::to_string(one.results) : "-"});
    for (const auto& [part, ms] : one.part_ms) parts.push_back({one.setting, when, spreadText(ms), part});
  }
  return heading() + "Study: the demo's four simulated participants, 24,000 samples each, in the speed lab\n" +
         "\nFrom a move of a slider until every visible plot is painted: median / 95 % / largest, ms\n\n" +
         alignedTable(times, 2) + "\nOf this on a processor, in the thread of the window, ms\n\n" +
         alignedTable(parts, 2);
}

std::string visitReport(const std::string& path) {
  std::vector<std::vector<std::string>> rows = {
      {"step", "told, s", "shown, s", "done, s", "window held, ms", "on a processor", "peak, MB", "said"}};
  for (const LabVisit& one : visitLabs(path)) {
    std::string said;
    for (const std::string& text : one.said) said += (said.empty() ? "" : " | ") + text;
    rows.push_back({one.lab, threeDigits(one.first_s), threeDigits(one.shown_s), threeDigits(one.done_s),
                    threeDigits(one.longest_ms), threeDigits(one.longest_cpu_ms), threeDigits(one.peak_mb), said});
  }
  return heading() + "\nA large study, lab by lab\n\n" + alignedTable(rows, 1);
}

}  // namespace tactus::bench
