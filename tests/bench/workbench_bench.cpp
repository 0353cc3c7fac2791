// What an edit costs in the workbench until every plot shows it, stage by stage. Prints tables and writes
// workbench.txt.
#include <CLI/CLI.hpp>
#include <QProcess>
#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

#include "app/workbench/base/theme.h"
#include "core/base/files/file.h"
#include "core/model_io/model_file.h"

#include "tests/bench/cases.h"
#include "tests/bench/machine.h"
#include "tests/bench/text_table.h"
#include "tests/bench/workbench_drag.h"
#include "tests/bench/workbench_idle.h"
#include "tests/bench/workbench_lab_report.h"
#include "tests/bench/workbench_stages.h"

namespace tactus::bench {
namespace {

struct Options {
  std::string out;
  std::string against;
  int edits = 40;
  int rounds = 3;
  int idle_s = 10;
  int measured_experts = 0;
  std::string measured_stage;
  std::string measured_model;
  bool labs = false;
  std::string visited_study;
};

using Series = std::map<std::string, std::vector<double>>;

double quantile(std::vector<double> all, double share) {
  if (all.empty()) return 0;
  std::sort(all.begin(), all.end());
  return all[std::min(all.size() - 1, static_cast<std::size_t>(share * static_cast<double>(all.size())))];
}

/// What a process of its own does: one window, its series as lines of text.
int measure(TimedApplication& application, const Options& options) {
  const auto stage = options.measured_stage == "Tune" ? workbench::Stage::kTune : workbench::Stage::kUnderstand;
  fuzzy::ForceModel model = syntheticExperts(std::max(1, options.measured_experts));
  if (!options.measured_model.empty()) {
    auto read = model_io::readModel(options.measured_model);
    if (!read) {
      std::cerr << read.error().message() << '\n';
      return 1;
    }
    model = std::move(read->model);
  }
  const DragTimes times = dragVertex(application, model, stage, options.edits);
  const auto print = [](const std::string& name, const std::vector<double>& all) {
    std::cout << name;
    for (const double value : all) std::cout << ' ' << value;
    std::cout << '\n';
  };
  print("call", times.call_ms);
  print("shown", times.shown_ms);
  print("cpu", times.cpu_ms);
  print("strip", times.strip_ms);
  print("drag", times.drag_ms);
  print("felt", times.felt_ticks);
  for (const auto& [panel, ms] : times.panel_ms) print("panel:" + panel, ms);
  return 0;
}

/// Adds the series of one window of `program`, in a process of its own: the scale of the screen holds for a process.
void addWindow(Series& series, const std::string& program, int experts, const std::string& stage, int scale,
               int edits) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QString::number(scale));
  process.setProcessEnvironment(environment);
  process.start(QString::fromStdString(program),
                {QStringLiteral("--measure"), QString::number(experts), QStringLiteral("--stage"),
                 QString::fromStdString(stage), QStringLiteral("--edits"), QString::number(edits)});
  process.waitForFinished(-1);
  std::istringstream lines(process.readAllStandardOutput().toStdString());
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    for (double value = 0; words >> value;) series[name].push_back(value);
  }
}

std::string panelsText(const Series& series) {
  std::vector<std::pair<double, std::string>> panels;
  for (const auto& [name, values] : series) {
    const double ms = quantile(values, 0.5);
    if (name.starts_with("panel:") && ms >= 0.05) panels.emplace_back(ms, name.substr(6));
  }
  std::sort(panels.rbegin(), panels.rend());
  std::string out;
  for (const auto& [ms, panel] : panels) out += (out.empty() ? "" : ", ") + panel + " " + threeDigits(ms);
  return out;
}

/// The windows of the tables, measured once.
struct Window {
  int experts;
  std::string stage;
  int scale;
  Series series;
};

std::vector<Window> measureWindows(const Options& options, const std::string& self) {
  std::vector<Window> windows;
  for (const int experts : {1, 4, 32, 256}) {
    for (const std::string stage : {"Tune", "Understand"}) {
      for (const int scale : {1, 2}) {
        windows.push_back({experts, stage, scale, {}});
        addWindow(windows.back().series, self, experts, stage, scale, options.edits);
      }
    }
  }
  return windows;
}

std::string panelTable(const std::vector<Window>& windows) {
  constexpr double kSmallest = 0.5;  // ms; others are of no account
  std::vector<std::vector<std::string>> rows = {{"experts", "stage", "scale", "p50", "p95", "max", "panel"}};
  for (const Window& window : windows) {
    for (const auto& [name, values] : window.series) {
      if (!name.starts_with("panel:") || quantile(values, 0.95) < kSmallest) continue;
      rows.push_back({std::to_string(window.experts), window.stage, std::to_string(window.scale),
                      threeDigits(quantile(values, 0.5)), threeDigits(quantile(values, 0.95)),
                      threeDigits(quantile(values, 1)), name.substr(6)});
    }
  }
  return alignedTable(rows, 2);
}

std::string windowTable(const std::vector<Window>& windows) {
  std::vector<std::vector<std::string>> rows = {{"experts", "stage", "scale", "call", "shown", "p95", "on a processor",
                                                 "its p95", "in the strip", "in a drag", "its p95", "felt after, ticks",
                                                 "most", "by panel, per edit"}};
  for (const Window& window : windows) {
    const auto at = [&window](const char* name, double share) {
      const auto found = window.series.find(name);
      return threeDigits(found == window.series.end() ? 0 : quantile(found->second, share));
    };
    rows.push_back({std::to_string(window.experts), window.stage, std::to_string(window.scale), at("call", 0.5),
                    at("shown", 0.5), at("shown", 0.95), at("cpu", 0.5), at("cpu", 0.95), at("strip", 0.5),
                    at("drag", 0.5), at("drag", 0.95), at("felt", 0.5), at("felt", 1), panelsText(window.series)});
  }
  return alignedTable(rows, 2);
}

std::string againstTable(const Options& options, const std::string& self) {
  std::vector<std::vector<std::string>> rows = {
      {"experts", "stage", "scale", "before: shown", "now: shown", "ratio", "before: on a processor", "now", "ratio"}};
  constexpr int kExperts = 4;
  for (const std::string stage : {"Tune", "Understand"}) {
    for (const int scale : {1, 2}) {
      Series before;
      Series now;
      for (int round = 0; round < options.rounds; ++round) {
        addWindow(before, options.against, kExperts, stage, scale, options.edits);
        addWindow(now, self, kExperts, stage, scale, options.edits);
      }
      std::vector<std::string> row = {std::to_string(kExperts), stage, std::to_string(scale)};
      for (const char* series : {"shown", "cpu"}) {
        const double before_ms = quantile(before[series], 0.5);
        const double now_ms = quantile(now[series], 0.5);
        for (const double value : {before_ms, now_ms, before_ms / now_ms}) row.push_back(threeDigits(value));
      }
      rows.push_back(std::move(row));
    }
  }
  return alignedTable(rows, 2);
}

/// Prints `text` and writes it to `folder`, if one is given.
int tell(const std::string& text, const std::string& folder, const std::string& file) {
  std::cout << text;
  if (folder.empty()) return 0;
  auto written = base::makeFolder(folder);
  if (written) written = base::writeFileAtomically(folder + "/" + file, text);
  if (!written) std::cerr << written.error().message() << '\n';
  return written ? 0 : 1;
}

int run(const Options& options, const std::string& self) {
  const std::vector<Window> windows = measureWindows(options, self);
  std::string text;
  for (const std::string& line : machineLines()) text += line + '\n';
  text += "Model: S4's 45 rules with five depth terms, and synthetic variations of it as further experts\n";
  text += "Window: 1920 x 1080 px, not on a screen; a foot of a depth term is dragged\n";
  text += "\nWhat is computed for one edit, medians in ms\n\n" + alignedTable(stageTimes(256), 1);
  text += "\nLargest differences from the evaluation of single points\n\n" + alignedTable(stageDifferences(), 1);
  text += "\nFrom an edit until every visible plot is painted with it, medians in ms\n\n" + windowTable(windows);
  text += "\nOf each panel, work and painting of an edit on a processor, ms\n\n" + panelTable(windows);
  if (!options.against.empty()) {
    text += "\nThe same in turns with an earlier version, medians in ms\n\n" + againstTable(options, self);
  }
  if (options.idle_s > 0) {
    std::vector<std::vector<std::string>> rows = {{"without input", "% of a core"}};
    for (const auto& [what, percent] : idleShares(syntheticExperts(4), options.idle_s)) {
      rows.push_back({what, threeDigits(percent)});
    }
    text += "\nFour experts, " + std::to_string(options.idle_s) + " s each\n\n" + alignedTable(rows, 1);
  }
  return tell(text, options.out, "workbench.txt");
}

}  // namespace
}  // namespace tactus::bench

int main(int argc, char** argv) {
  tactus::bench::Options options;
  CLI::App app{"What an edit costs in the workbench until every plot shows it"};
  app.add_option("--out", options.out, "folder for workbench.txt; without it nothing is written");
  app.add_option("--edits", options.edits, "edits of each window")->check(CLI::Range(5, 10000));
  app.add_option("--against", options.against, "this program of an earlier version, measured in turns");
  app.add_option("--rounds", options.rounds, "turns of each version")->check(CLI::Range(1, 1000));
  app.add_option("--idle", options.idle_s, "seconds at rest in each stage; 0: not measured")->check(CLI::Range(0, 600));
  app.add_option("--measure", options.measured_experts, "one window with so many experts, as numbers");
  app.add_option("--model", options.measured_model, "of that window: this file instead, such as one with contracts");
  app.add_option("--stage", options.measured_stage, "of that window: Tune or Understand");
  app.add_flag("--labs", options.labs, "the speed lab in the place of the bench, written to labs.txt");
  app.add_option("--visit", options.visited_study, "with --labs: all labs of this study file instead, a large one");
  CLI11_PARSE(app, argc, argv);
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  tactus::bench::TimedApplication application(argc, argv);
  tactus::workbench::theme::apply(application);
  if (options.measured_experts > 0) return tactus::bench::measure(application, options);
  if (options.labs) {
    const std::string text = options.visited_study.empty() ? tactus::bench::labReport(application, options.edits)
                                                           : tactus::bench::visitReport(options.visited_study);
    return tactus::bench::tell(text, options.out, options.visited_study.empty() ? "labs.txt" : "labs_large.txt");
  }
  return tactus::bench::run(options, QApplication::applicationFilePath().toStdString());
}
