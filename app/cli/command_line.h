// Declares commands on the command line. For program.cpp and its parts.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.h"

namespace tactus::cli {

/// The chosen command with its bound options.
using Chosen = std::function<base::Result<Output>()>;

/// Adds the subcommand `name`. `define` declares its options; `function` is called with them.
template <class Options, class Define>
void addCommand(CLI::App& app, Chosen& chosen, const std::string& name, const std::string& description,
                base::Result<Output> (*function)(const Options&), Define define) {
  const auto options = std::make_shared<Options>();
  CLI::App* const command = app.add_subcommand(name, description);
  define(*command, *options);
  command->callback([&chosen, options, function] { chosen = [options, function] { return function(*options); }; });
}

/// Refuses an empty text, which most often comes from an unset shell variable.
inline CLI::Validator notEmpty() {
  return CLI::Validator(
      [](const std::string& text) { return text.empty() ? std::string("found an empty text") : std::string(); }, "");
}

/// A folder to write: neither an empty text nor `-`, because a folder does not go to standard output.
inline CLI::Validator outputFolder() {
  return notEmpty() & CLI::Validator(
                          [](const std::string& text) {
                            return text == "-" ? std::string("found '-', wanted the name of a folder") : std::string();
                          },
                          "");
}

/// A file to read, for `transform`: `-` is standard input. Refuses an empty text.
CLI::Validator inputFile();

/// One of `words`. Another word is refused with the closest of them as a suggestion.
CLI::Validator oneOf(std::vector<std::string> words);

/// `--force-terms`, for options with a member `force_terms`.
template <class Options>
void addForceTermsFrom(CLI::App& command, Options& o) {
  command
      .add_option_function<std::string>(
          "--force-terms",
          [&o](const std::string& word) {
            using enum elicitation::ForceTermsFrom;
            for (const auto from : {kVote, kFrequency, kThresholds, kProbit}) {
              if (word == name(from)) o.force_terms = from;
            }
          },
          "Terms of the force from the judgements")
      ->check(oneOf({"vote", "frequency", "thresholds", "probit"}))
      ->default_str("vote");
}

/// The procedure that a table is about.
inline void addTablePack(CLI::App& command, std::string& pack) {
  command
      .add_option("--pack", pack,
                  "Procedure of the table: a name or a folder; by default the pack beside it, or nasogastric tube "
                  "insertion")
      ->check(notEmpty());
}

/// A number for which `holds` is true; the sentence `wanted` describes the condition.
CLI::Validator numberThat(std::string wanted, std::function<bool(double)> holds);

/// A whole number from 0 to `largest`, digits only.
CLI::Validator wholeNumberUpTo(std::uint64_t largest);

/// The error line for the first word of `arguments` that is neither a command nor an option of `app`; nothing if there
/// is none. Needed because CLI11 ignores an unknown command, or names the option without its command.
std::optional<std::string> unknownWord(const CLI::App& app, const std::vector<std::string>& arguments);

/// The model file that the command reads.
inline void addModel(CLI::App& command, std::string& model) {
  command.add_option("MODEL", model, "Model file, or - for standard input")->required()->transform(inputFile());
}

/// `--at`: one point of the model, read by `pointOption` (model_arguments.h).
inline void addPoint(CLI::App& command, std::vector<std::string>& at) {
  command.add_option("--at", at, "INPUT=VALUE for each input, separated by commas")
      ->required()
      ->delimiter(',')
      ->check(notEmpty());
}

inline void addJson(CLI::App& command, bool& json) { command.add_flag("--json", json, "Print the results as JSON"); }

/// Adds `--accept KIND`, which may be repeated (study_build.h). `what`: the work that findings of these kinds do not
/// stop, for the help text.
void addAccept(CLI::App& command, std::vector<std::string>& kinds, const std::string& what);

/// Adds STUDY and the options of `build` that say how the model is made. `stops`: the work that the findings named by
/// `--accept` do not stop.
void addBuildOptions(CLI::App& command, BuildOptions& options, const std::string& stops);

/// `build`, `report`, `vote`.
void addBuildCommands(CLI::App& app, Chosen& chosen);

/// `study` with its subcommands (commands.h).
void addStudyCommands(CLI::App& app, Chosen& chosen);

/// `bundle`, `verify`, `certify`, `convert`, `import`, `diff`.
void addDeliveryCommands(CLI::App& app, Chosen& chosen);

/// `serve`. While it runs, it writes its address to `out` and its messages to `err`.
void addServeCommand(CLI::App& app, Chosen& chosen, std::ostream& out, std::ostream& err);

/// `emulate` with its subcommands. While one runs, it writes its address to `out`.
void addEmulateCommands(CLI::App& app, Chosen& chosen, std::ostream& out);

/// `help` and `completion`, which tell about all commands of `app`; it outlives `chosen`.
void addHelpCommands(CLI::App& app, Chosen& chosen);

/// Puts the commands of `app` into the groups of its help, and ends each help with what holds for that command.
void arrangeHelp(CLI::App& app);

/// `help COMMAND ...` as the arguments `COMMAND ... --help`; others unchanged.
std::vector<std::string> withoutHelpCommand(std::vector<std::string> arguments);

/// The command that `arguments` begin with: `tactus study new`.
std::string commandOf(const CLI::App& app, const std::vector<std::string>& arguments);

struct Terminal;
/// Adds `devices` with its subcommands (commands.h). `terminal`: for the dialog with the person; `aside`: the
/// same while standard output is used for JSON.
void addDeviceCommands(CLI::App& app, Chosen& chosen, const Terminal& terminal, const Terminal& aside);

}  // namespace tactus::cli
