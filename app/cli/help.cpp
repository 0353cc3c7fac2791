// What the program says about its own commands: groups of the list, completion for shells, the manual page. All of it
// is made from the command line's declaration.
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "app/cli/command_line.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kGroups = {{
    {"Study", " demo build report vote cluster agreement study pack duel "},
    {"Model", " eval check why pull replay simulate bench diff tell rebase import "},
    {"Deliver", " bundle verify convert certify serve "},
    {"Device", " devices emulate "},
    {"Help", " help completion "},
}};

/// One command, or the program: what it is called by, and what may follow.
struct Command {
  std::string path;  ///< `tactus study new`
  const CLI::App* app;
};

void collect(const CLI::App& app, const std::string& path, std::vector<Command>& out) {
  out.push_back({path, &app});
  for (const CLI::App* command : app.get_subcommands(nullptr)) collect(*command, path + ' ' + command->get_name(), out);
}

std::vector<Command> commandsBelow(const CLI::App& app) {
  std::vector<Command> out;
  collect(app, app.get_name(), out);
  return out;
}

constexpr const char* kAlways =
    "Exit status: 0 fine, 1 the input is wrong or a check failed, 2 wrong usage: an unknown word, a value out of its "
    "range.\nFrom a pipe at most 256 MiB are read.";
constexpr const char* kTables = "\nA CSV table may have 2 GiB. How tables may be written: docs/csv-tables.md.";

/// The last lines of each help: those about tables where the command has something to do with one.
void endHelp(CLI::App& app) {
  bool tables = app.get_description().find("CSV") != std::string::npos;
  for (const CLI::Option* option : app.get_options()) {
    tables = tables || option->get_description().find("CSV") != std::string::npos;
  }
  app.footer(std::string(kAlways) + (tables ? kTables : ""));
  for (CLI::App* command : app.get_subcommands(nullptr)) endHelp(*command);
}

/// The first name of an option with its dashes, the long one if there is one; empty for a value by its place.
std::string optionName(const CLI::Option& option) {
  if (!option.get_lnames().empty()) return "--" + option.get_lnames().front();
  return option.get_snames().empty() ? std::string() : "-" + option.get_snames().front();
}

bool takesValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// The lines of a `case` of bash and zsh that follow the commands typed so far; `word` is the next one.
std::string pathCase(const std::vector<Command>& commands, const std::string& word) {
  std::string patterns;
  for (const auto& command : commands) {
    if (command.path.find(' ') == std::string::npos) continue;
    patterns += (patterns.empty() ? "'" : "|'") + command.path + '\'';
  }
  return "    case \"$at " + word + "\" in\n      " + patterns + ") at=\"$at " + word + "\" ;;\n    esac\n";
}

std::string bashCompletion(const std::vector<Command>& commands) {
  std::string text =
      "# Completion of tactus for bash: source <(tactus completion bash)\n"
      "_tactus() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} at=tactus names= options= i\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n" +
      pathCase(commands, "${COMP_WORDS[i]}") + "  done\n  case $at in\n";
  for (const auto& command : commands) {
    std::string names;
    for (const CLI::App* below : command.app->get_subcommands(nullptr)) names += ' ' + below->get_name();
    std::string options;
    for (const CLI::Option* option : command.app->get_options()) {
      if (const auto name = optionName(*option); !name.empty()) options += ' ' + name;
    }
    text += "    '" + command.path + "') names='" + std::string(base::trimmed(names)) + "' options='" +
            std::string(base::trimmed(options)) + "' ;;\n";
  }
  return text +
         "  esac\n"
         "  if [[ $word == -* ]]; then names=$options; fi\n"
         "  COMPREPLY=($(compgen -W \"$names\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _tactus tactus\n";
}

std::string zshCompletion(const std::vector<Command>& commands) {
  const auto item = [](const std::string& name, const std::string& description) {
    return " '" + base::replaced(name, {{":", "\\:"}}) + ':' +
           base::replaced(description, {{"'", "'\\''"}, {"\n", " "}}) + '\'';
  };
  std::string text =
      "#compdef tactus\n"
      "# Completion of tactus for zsh: tactus completion zsh > a folder of $fpath/_tactus\n"
      "_tactus() {\n"
      "  local at=tactus i\n"
      "  local -a names options\n"
      "  for ((i = 2; i < CURRENT; i++)); do\n" +
      pathCase(commands, "$words[i]") + "  done\n  case $at in\n";
  for (const auto& command : commands) {
    text += "    '" + command.path + "')\n      names=(";
    for (const CLI::App* below : command.app->get_subcommands(nullptr)) {
      text += item(below->get_name(), below->get_description());
    }
    text += " )\n      options=(";
    for (const CLI::Option* option : command.app->get_options()) {
      if (const auto name = optionName(*option); !name.empty()) text += item(name, option->get_description());
    }
    text += " ) ;;\n";
  }
  return text +
         "  esac\n"
         "  if [[ $PREFIX == -* ]]; then _describe option options\n"
         "  elif (( $#names )); then _describe command names\n"
         "  else _files; fi\n"
         "}\n"
         "if [[ $funcstack[1] == _tactus ]]; then _tactus; else compdef _tactus tactus; fi\n";
}

std::string fishCompletion(const std::vector<Command>& commands) {
  std::string patterns;
  for (const auto& command : commands) patterns += " '" + command.path + '\'';
  std::string text =
      "# Completion of tactus for fish: tactus completion fish | source\n"
      "function __tactus_at\n"
      "  set -l at tactus\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    if contains -- \"$at $word\"" +
      patterns +
      "\n      set at \"$at $word\"\n    end\n  end\n"
      "  test \"$at\" = \"$argv[1]\"\n"
      "end\n";
  for (const auto& command : commands) {
    const std::string here = "complete -c tactus -n \"__tactus_at '" + command.path + "'\"";
    const auto said = [](const std::string& description) {
      return " -d '" + base::replaced(description, {{"\\", "\\\\"}, {"'", "\\'"}, {"\n", " "}}) + "'\n";
    };
    for (const CLI::App* below : command.app->get_subcommands(nullptr)) {
      text += here + " -f -a " + below->get_name() + said(below->get_description());
    }
    for (const CLI::Option* option : command.app->get_options()) {
      const std::string name = optionName(*option);
      if (name.empty()) continue;
      text += here + (name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1)) +
              (takesValue(*option) ? " -r" : "") + said(option->get_description());
    }
  }
  return text;
}

/// `text` as a line of a manual page.
std::string roff(const std::string& text) {
  const std::string escaped = base::replaced(text, {{"\\", "\\e"}, {"-", "\\-"}, {"\n", " "}});
  return escaped.starts_with('.') || escaped.starts_with('\'') ? "\\&" + escaped : escaped;
}

/// The commands as sections of a manual page.
std::string manual(const std::vector<Command>& commands) {
  std::string text;
  for (const auto& command : commands) {
    if (command.path.find(' ') == std::string::npos) continue;
    std::string values;
    std::string options;
    for (const CLI::Option* option : command.app->get_options()) {
      const std::string name = optionName(*option);
      if (name == "--help") continue;
      const std::string called = name.empty() ? option->get_name(true) : name;
      if (name.empty()) values += ' ' + called;
      options += ".TP\n.B " + roff(called) + '\n' + roff(option->get_description()) + '\n';
    }
    text += ".SS \"" + roff(command.path + values) + "\"\n" + roff(command.app->get_description()) + ".\n" + options;
  }
  return text;
}

Output completion(const CLI::App& app, const std::string& shell) {
  const auto commands = commandsBelow(app);
  Output output;
  output.text = shell == "bash"  ? bashCompletion(commands)
                : shell == "zsh" ? zshCompletion(commands)
                                 : fishCompletion(commands);
  return output;
}

}  // namespace

void addHelpCommands(CLI::App& app, Chosen& chosen) {
  CLI::App& help = *app.add_subcommand("help", "The options of a command: help COMMAND");
  help.add_flag("--man")->description("All commands as sections of a manual page")->required();
  help.callback([&app, &chosen] {
    chosen = [&app] {
      Output output;
      output.text = manual(commandsBelow(app));
      return base::Result<Output>(std::move(output));
    };
  });
  CLI::App& command = *app.add_subcommand("completion", "Completion of commands and options for a shell");
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(oneOf({"bash", "zsh", "fish"}));
  command.callback(
      [&app, &chosen, shell] { chosen = [&app, shell] { return base::Result<Output>(completion(app, *shell)); }; });
}

void arrangeHelp(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    for (const auto& [group, names] : kGroups) {
      if (names.find(' ' + command->get_name() + ' ') != std::string_view::npos) command->group(std::string(group));
    }
  }
  endHelp(app);
}

std::vector<std::string> withoutHelpCommand(std::vector<std::string> arguments) {
  const auto option = [](const std::string& word) { return word.starts_with('-'); };
  if (arguments.empty() || arguments.front() != "help" || std::any_of(arguments.begin(), arguments.end(), option)) {
    return arguments;
  }
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
  return arguments;
}

std::string commandOf(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  std::string path = app.get_name();
  for (const auto& word : arguments) {
    const auto below = command->get_subcommands([&word](const CLI::App* one) { return one->get_name() == word; });
    if (below.empty()) break;
    command = below.front();
    path += ' ' + word;
  }
  return path;
}

}  // namespace tactus::cli
