// How a command is declared on the command line; for program.cpp and its parts.
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

/// The command that the command line chose, with its options bound.
using Chosen = std::function<base::Result<Output>()>;

/// Adds the subcommand `name`; `define` declares its options, `function` is called with them.
template <class Options, class Define>
void addCommand(CLI::App& app, Chosen& chosen, const std::string& name, const std::string& description,
                base::Result<Output> (*function)(const Options&), Define define) {
  const auto options = std::make_shared<Options>();
  CLI::App* const command = app.add_subcommand(name, description);
  define(*command, *options);
  command->callback([&chosen, options, function] { chosen = [options, function] { return function(*options); }; });
}

/// An empty text is most often a shell variable that is not set.
inline CLI::Validator notEmpty() {
  return CLI::Validator(
      [](const std::string& text) { return text.empty() ? std::string("found an empty text") : std::string(); }, "");
}

/// One of `words`; another one is refused with the closest of them.
CLI::Validator oneOf(std::vector<std::string> words);

/// A number that `holds`, as the sentence `wanted` says.
CLI::Validator numberThat(std::string wanted, std::function<bool(double)> holds);

/// A whole number from 0 to `largest`, in digits only.
CLI::Validator wholeNumberUpTo(std::uint64_t largest);

/// The first word of `arguments` that is neither a command nor an option of `app`, as one line for standard error;
/// nothing where there is none. CLI11 would pass over an unknown command, or name the option without its command.
std::optional<std::string> unknownWord(const CLI::App& app, const std::vector<std::string>& arguments);

inline void addJson(CLI::App& command, bool& json) { command.add_flag("--json", json, "Print the results as JSON"); }

/// `--accept KIND`, as often as there are kinds (accepted_data.h); `what` is what they do not stop.
void addAccept(CLI::App& command, std::vector<std::string>& kinds, const std::string& what);

/// `study` with its subcommands (study_commands.h).
void addStudyCommands(CLI::App& app, Chosen& chosen);

struct Terminal;
/// `devices` with its subcommands (device_commands.h). `terminal`: where they talk; `aside`: where they talk when
/// standard output is for JSON.
void addDeviceCommands(CLI::App& app, Chosen& chosen, const Terminal& terminal, const Terminal& aside);

}  // namespace tactus::cli
