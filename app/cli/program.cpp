// The command line: options to option structs, results to streams, errors to exit statuses.
#include "app/cli/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "app/session/simulated_study.h"
#include "app/version.h"
#include "core/base/text.h"
#include "elicitation/clustering/fcm.h"
#include "questionnaires/published_rules.h"

namespace tactus::cli {
namespace {

// A line on the terminal while a command takes long: it shows that the command is still working.

/// From 2 s on, writes `what` and the seconds that have passed to standard error, each second in the same line; the end
/// clears the line. Does nothing where standard error is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void show(const std::string& what);

  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread writer_;
};

using std::chrono::seconds;

constexpr seconds kQuiet{2};

ProgressLine::ProgressLine(std::string what) {
  if (::isatty(STDERR_FILENO) == 1) writer_ = std::thread([this, what = std::move(what)] { show(what); });
}

ProgressLine::~ProgressLine() {
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  writer_.join();
}

void ProgressLine::show(const std::string& what) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  if (ended_.wait_for(lock, kQuiet, [this] { return end_; })) return;
  do {
    const auto passed = std::chrono::duration_cast<seconds>(std::chrono::steady_clock::now() - start);
    std::fprintf(stderr, "\r%s: working, %lld s", what.c_str(), static_cast<long long>(passed.count()));
    std::fflush(stderr);
  } while (!ended_.wait_for(lock, seconds(1), [this] { return end_; }));
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

constexpr int kFine = 0;
constexpr int kWrongInput = 1;
constexpr int kWrongUsage = 2;

/// `exact`, `midpoint:N` or `linspace:N`; throws what CLI11 takes for wrong usage.
std::optional<analysis::Sampling> parseMethod(const std::string& text) {
  if (text == "exact") return std::nullopt;
  const auto colon = text.find(':');
  const std::string rule = text.substr(0, colon);
  const auto count =
      colon == std::string::npos ? std::nullopt : base::parseInteger(std::string_view(text).substr(colon + 1));
  const bool known = rule == "midpoint" || rule == "linspace";
  if (!known || !count || *count < 2 || *count > 10'000'000) {
    throw CLI::ValidationError(
        "--method", "found '" + text + "', wanted exact, midpoint:N or linspace:N with N from 2 to 10000000");
  }
  return analysis::Sampling{
      rule == "midpoint" ? analysis::Sampling::Rule::kMidpoint : analysis::Sampling::Rule::kLinspace,
      static_cast<std::size_t>(*count)};
}

std::vector<std::string> readingIds() {
  std::vector<std::string> ids;
  for (const auto& reading : questionnaires::s4Readings()) ids.push_back(reading.id);
  return ids;
}

CLI::Validator aboveZero(const std::string& what) {
  return numberThat(what + " above 0 and at most 10", [](double x) { return x > 0 && x <= 10; });
}

void addDuelCommands(CLI::App& app, Chosen& chosen) {
  CLI::App& duel = *app.add_subcommand("duel", "Blind comparison of two models by hand: plan, simulation, results");
  duel.require_subcommand(1);
  addCommand(duel, chosen, "plan", "How many trials it takes to feel a difference", duelPlan,
             [](CLI::App& command, DuelPlanOptions& o) {
               auto* const models = command.add_option("MODELS", o.models, "Two model files, A and B")->expected(2);
               auto* const at =
                   command.add_option("--at", o.at, "INPUT=VALUE for each input but the depth, separated by commas")
                       ->delimiter(',')
                       ->check(notEmpty());
               auto* const from = command.add_option("--from", o.from_mm, "Where the stroke begins, mm");
               auto* const to = command.add_option("--to", o.to_mm, "Where it ends, mm");
               models->needs(at)->needs(from)->needs(to);
               for (auto* const option : {at, from, to}) option->needs(models);
               command.add_option("--jnd", o.jnd, "Difference to look for, in just-noticeable differences")
                   ->check(aboveZero("a difference"));
               command.add_option("--power", o.power, "Chance to find it")
                   ->check(numberThat("a chance from 0.5 to 0.999", [](double x) { return x >= 0.5 && x <= 0.999; }));
               command.parse_complete_callback([&o] {
                 if (!o.jnd && o.models.empty()) throw CLI::RequiredError("--jnd or two models");
               });
               addJson(command, o.json);
             });
  addCommand(
      duel, chosen, "simulate", "Simulated persons in a blind comparison, beside the exact chances", duelSimulate,
      [](CLI::App& command, DuelSimulateOptions& o) {
        const auto share = [] { return numberThat("a share from 0 to 1", [](double x) { return x >= 0 && x <= 1; }); };
        const auto count = [](int most) {
          return numberThat("a whole number from 1 to " + std::to_string(most),
                            [most](double x) { return x >= 1 && x <= most && x == std::floor(x); });
        };
        command.add_option("--rule", o.rule, "When it ends")->check(oneOf({"fixed", "sequential", "own-jnd"}));
        command.add_option("--trials", o.trials, "Trials; of a sequential comparison at most")->check(count(1000));
        command.add_option("--sought", o.sought_jnd, "Difference that the plan looks for, JND")
            ->check(aboveZero("a difference"));
        command.add_option("--jnd", o.jnd, "Difference that is there, JND")
            ->check(numberThat("a difference from 0 to 10", [](double x) { return x >= 0 && x <= 10; }));
        command.add_option("--own-jnd", o.own_jnd, "The persons' own JND, as a multiple of the usual one")
            ->check(aboveZero("a multiple"));
        command.add_option("--cant-tell", o.cant_tell, "Share of answers that are \"can't tell\"")->check(share());
        command.add_option("--order-bias", o.order_bias, "How much the first stroke seems heavier, JND")
            ->check(numberThat("a bias from -10 to 10", [](double x) { return x >= -10 && x <= 10; }));
        command.add_option("--runs", o.runs, "Simulated comparisons")->check(count(100'000));
        command.add_option("--seed", o.seed, "Seed, a whole number")->check(wholeNumberUpTo(session::kLargestSeed));
        addJson(command, o.json);
      });
  addCommand(duel, chosen, "results", "The blind comparisons of a study, each with its verdict", duelResults,
             [](CLI::App& command, DuelResultsOptions& o) {
               command.add_option("STUDY", o.study, "Study file")->required()->check(notEmpty());
               command.add_option("--out", o.out, "CSV file of all trials of finished comparisons")->check(notEmpty());
               addJson(command, o.json);
             });
}

void addCommands(CLI::App& app, Chosen& chosen) {
  addCommand(app, chosen, "demo", "The whole main job on the published data: study, models, export and report", demo,
             [](CLI::App& command, DemoOptions& o) {
               command.add_option("DIR", o.folder, "Folder to write into")->required()->check(outputFolder());
               command.add_option("--seed", o.seed, "Seed of the simulation, a whole number")
                   ->check(wholeNumberUpTo(session::kLargestSeed))
                   ->default_str(std::to_string(session::kDefaultSeed));
               command.add_option("--reading", o.reading, "Reading of Table A2")
                   ->check(oneOf(readingIds()))
                   ->default_str(std::string(questionnaires::kDefaultReading));
               command
                   .add_option("--pack", o.pack,
                               "Another procedure, with simulated experts: a folder with a pack, or one that `tactus "
                               "pack show` lists; default: that of the published data")
                   ->check(notEmpty());
               addJson(command, o.json);
             });
  addBuildCommands(app, chosen);
  addCommand(app, chosen, "cluster", "Fuzzy C-Means of one column of speeds", cluster,
             [](CLI::App& command, ClusterOptions& o) {
               command.add_option("SPEEDS", o.speeds, "CSV file")->required()->transform(inputFile());
               const auto most = std::to_string(elicitation::kMostClusters);
               command.add_option("-c", o.clusters, "Number of clusters, 1 to " + most)
                   ->check(numberThat("a whole number of clusters from 1 to " + most, [](double x) {
                     return x >= 1 && x <= static_cast<double>(elicitation::kMostClusters) && x == std::floor(x);
                   }));
               command.add_option("-m", o.m, "Fuzziness, above 1 and at most 100")
                   ->check(numberThat("a number above 1 and at most 100", [](double x) { return x > 1 && x <= 100; }));
               command.add_option("--column", o.column, "Column to cluster")->check(notEmpty());
               addJson(command, o.json);
             });
  addCommand(app, chosen, "agreement", "How far raters agree: answers, judgements or a table of counts", agreement,
             [](CLI::App& command, AgreementOptions& o) {
               command.add_option("FILE", o.file, "Table of answers, of judgements, or of vote counts as in Table 2")
                   ->required()
                   ->transform(inputFile());
               command.add_option("--series", o.series, "Series of the judgements to compare")->check(notEmpty());
               command.add_option("--form", o.form, "Form of the answers to compare; by default the one answered most")
                   ->check(notEmpty());
               addTablePack(command, o.pack);
               addJson(command, o.json);
             });
  addCommand(app, chosen, "eval", "The force of a model at the points of a CSV file", eval,
             [](CLI::App& command, EvalOptions& o) {
               addModel(command, o.model);
               command.add_option("--in", o.points, "CSV file with one column per input of the model")
                   ->required()
                   ->transform(inputFile());
               command.add_option("--out", o.out, "CSV file to write; without it, to standard output");
               command.add_option("--expert", o.expert, "One expert; by default the mean of all")->check(notEmpty());
               command
                   .add_option_function<std::string>(
                       "--method", [&o](const std::string& text) { o.sampling = parseMethod(text); },
                       "exact, or sampled like other tools: midpoint:N, linspace:N")
                   ->default_str("exact");
             });
  addCommand(
      app, chosen, "check", "Validation, lint and contracts of a model", check, [](CLI::App& command, CheckOptions& o) {
        addModel(command, o.model);
        command
            .add_option("--contract", o.contracts,
                        "Sentence to prove or refute, such as 'more lubrication never raises the force'; repeatable")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(app, chosen, "why", "Why the force at a point is what it is, and what would change it", why,
             [](CLI::App& command, WhyOptions& o) {
               addModel(command, o.model);
               addPoint(command, o.at);
               command.add_option("--expert", o.expert, "One expert; by default the mean of all")->check(notEmpty());
               addJson(command, o.json);
             });
  addCommand(
      app, chosen, "tell", "The insertion that tells two models apart, and a bound on all others", tellApart,
      [](CLI::App& command, TellOptions& o) {
        command.add_option("A", o.first, "Model file")->required()->transform(inputFile());
        command.add_option("B", o.second, "Model file")->required()->transform(inputFile());
        command.add_option("--expert-a", o.first_expert, "One expert of A; by default the mean")->check(notEmpty());
        command.add_option("--expert-b", o.second_expert, "One expert of B; by default the mean")->check(notEmpty());
        command.add_option("--strokes", o.strokes, "File to write the stroke to, for tactus replay")->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(
      app, chosen, "replay", "Recorded strokes through another model: what would feel different", replayStrokes,
      [](CLI::App& command, ReplayOptions& o) {
        command.add_option("STUDY", o.study, "Study file with recorded strokes, or a file of strokes")
            ->required()
            ->check(notEmpty());
        addModel(command, o.model);
        auto* const before =
            command.add_option("--before", o.before, "Model to compare with; by default the last one in the study")
                ->transform(inputFile());
        command
            .add_flag("--last-sign-off", o.last_sign_off,
                      "Compare with the version of the study that was signed off last")
            ->excludes(before);
        command
            .add_option("--at", o.at, "INPUT=VALUE, separated by commas: conditions of strokes that have none recorded")
            ->delimiter(',')
            ->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(app, chosen, "pull", "The smallest edits that give a wanted force at a point", pull,
             [](CLI::App& command, PullOptions& o) {
               addModel(command, o.model);
               addPoint(command, o.at);
               command.add_option("--force", o.force_n, "Wanted force in newtons; not needed with --curve")
                   ->check(numberThat("a finite force, such as 0.55", [](double x) { return std::isfinite(x); }));
               command.add_option("--expert", o.expert, "One expert; by default the mean of all, without its rules")
                   ->check(notEmpty());
               command
                   .add_option("--curve", o.curve,
                               "CSV file of wanted forces: columns of inputs, and force, or force_min and force_max")
                   ->transform(inputFile());
               command.parse_complete_callback([&o] {
                 if (!o.force_n && o.curve.empty()) throw CLI::RequiredError("--force or --curve");
               });
               command
                   .add_option("--lock", o.locked,
                               "Variable whose terms stay as they are, or the word rules; as often as needed")
                   ->check(notEmpty());
               command
                   .add_option("--pin", o.pins,
                               "INPUT=VALUE,...: a point whose force stays; other inputs as in --at; repeatable")
                   ->expected(1)
                   ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
                   ->check(notEmpty());
               command.add_option("--study", o.study, "Study file in which the model may have been signed off")
                   ->check(notEmpty());
               auto* const apply = command.add_option("--apply", o.apply, "Number of the edit to write, from 1");
               auto* const out = command.add_option("--out", o.out, "Model file to write")->check(notEmpty());
               apply->needs(out)->check(numberThat("a whole number from 1",
                                                   [](double x) { return x >= 1 && x <= 1e6 && x == std::floor(x); }));
               out->needs(apply);
               addJson(command, o.json);
             });
  addCommand(
      app, chosen, "bench", "Run time against error on this machine", bench, [](CLI::App& command, BenchOptions& o) {
        addModel(command, o.model);
        command.add_option("--seconds", o.seconds, "Time for each row, from 0.001 to 60")
            ->check(numberThat("a number of seconds from 0.001 to 60", [](double x) { return x >= 0.001 && x <= 60; }));
        addJson(command, o.json);
      });
  addCommand(app, chosen, "simulate", "The insertion renderer on a model, with a simulated hand and device", simulate,
             [](CLI::App& command, SimulateOptions& o) {
               addModel(command, o.model);
               command.add_option("--scenario", o.scenario, "Scenario file: hand, device, what happens when")
                   ->required()
                   ->transform(inputFile());
               command.add_option("--out", o.out, "CSV file of the trace, one row per millisecond")
                   ->required()
                   ->check(notEmpty());
               addJson(command, o.json);
             });
}

/// What CLI11 says of a wrong command line, with the arguments that it repeats escaped.
std::string harmless(std::string text, const std::vector<std::string>& arguments) {
  for (const auto& argument : arguments) {
    const auto value = argument.find('=');  // of `--option=value`
    for (const auto& part : {argument, value == std::string::npos ? std::string() : argument.substr(value + 1)}) {
      const std::string escaped = base::oneLine(part);
      if (escaped == part) continue;
      text = base::replaced(std::move(text), {{part, escaped}});
    }
  }
  return base::plainLines(text);
}

int cannotWrite(std::ostream& err) {
  err << "tactus: found a standard output that cannot be written to, wanted a pipe or file with room\n";
  return kWrongInput;
}

int report(const base::Result<Output>& result, std::ostream& out, std::ostream& err) {
  if (!result) {
    err << "tactus: " << result.error().message() << '\n';
    return kWrongInput;
  }
  for (const auto& warning : result->warnings) err << "tactus: warning: " << base::oneLine(warning) << '\n';
  // Each name in it is escaped where it is put in, so that it makes no line of its own; this is for what is forgotten.
  out << (result->is_table ? result->text : base::plainLines(result->text)) << std::flush;
  if (!result->failure.empty()) err << "tactus: " << base::oneLine(result->failure) << '\n';
  if (out.good()) return result->failure.empty() ? kFine : kWrongInput;
  return cannotWrite(err);
}

}  // namespace

int run(std::vector<std::string> arguments, std::ostream& out, std::ostream& err) {
  return run(std::move(arguments), std::cin, out, err);
}

int run(std::vector<std::string> arguments, std::istream& in, std::ostream& out, std::ostream& err) {
  CLI::App app("Tactus turns what experts know by feel into a force model.", "tactus");
  app.set_version_flag("--version", std::string(kGenerator));
  app.option_defaults()->always_capture_default();
  app.require_subcommand(1);
  Chosen chosen;
  addCommands(app, chosen);
  addDuelCommands(app, chosen);
  addStudyCommands(app, chosen);
  addDeliveryCommands(app, chosen);
  addServeCommand(app, chosen, out, err);
  addDeviceCommands(app, chosen, {&in, &out}, {&in, &err});
  addEmulateCommands(app, chosen, out);
  addHelpCommands(app, chosen);
  arrangeHelp(app);
  arguments = withoutHelpCommand(std::move(arguments));
  if (arguments.empty()) {
    err << app.help();
    return kWrongUsage;
  }
  if (const auto unknown = unknownWord(app, arguments)) {
    err << *unknown << "\nRun with --help for more information.\n";
    return kWrongUsage;
  }
  const std::vector<std::string> typed = arguments;
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    std::ostringstream help;
    std::ostringstream wrong;  // says what was typed
    const int status = app.exit(error, help, wrong) == 0 ? kFine : kWrongUsage;
    out << help.str() << std::flush;
    if (!out.good()) return cannotWrite(err);
    if (status != kFine) err << commandOf(app, typed) << ": ";
    err << harmless(wrong.str(), typed);
    return status;
  }
  try {
    const std::string command = app.get_subcommands().front()->get_name();
    const bool talks = command == "serve" || command == "devices";
    base::Result<Output> result = Output{};
    {
      const auto line = talks ? nullptr : std::make_unique<ProgressLine>("tactus " + command);
      result = chosen();
    }
    return report(result, out, err);
  } catch (const std::exception& error) {
    err << "tactus: stopped: " << base::oneLine(error.what()) << '\n';
    return kWrongInput;
  }
}

}  // namespace tactus::cli
