#include "app/cli/command_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "app/cli/study_build.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

std::string refused(const std::string& found, const std::string& wanted) {
  return "found " + base::quoted(found) + ", wanted " + wanted;
}

std::vector<std::string> commandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> optionsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// A word such as -3 or -.5 is a value.
bool isOption(const std::string& word) {
  if (word.size() < 2 || word[0] != '-') return false;
  return word[1] != '.' && std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

}  // namespace

CLI::Validator inputFile() {
  return CLI::Validator(
      [](std::string& text) {
        if (text == "-") text = "/dev/stdin";
        return text.empty() ? std::string("found an empty text") : std::string();
      },
      "");
}

CLI::Validator oneOf(std::vector<std::string> words) {
  const std::string name = "{" + base::joined(words, ",") + "}";
  return CLI::Validator(
      [words = std::move(words)](const std::string& text) {
        if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
        return refused(text, "one of " + base::joined(words, ", ") + base::suggestion(text, words));
      },
      name);
}

CLI::Validator numberThat(std::string wanted, std::function<bool(double)> holds) {
  return CLI::Validator(
      [wanted = std::move(wanted), holds = std::move(holds)](const std::string& text) {
        const auto value = base::parseNumber(text);
        return value && holds(*value) ? std::string() : refused(text, wanted);
      },
      "");
}

CLI::Validator wholeNumberUpTo(std::uint64_t largest) {
  return CLI::Validator(
      [largest](const std::string& text) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && end == text.data() + text.size() && value <= largest;
        return whole ? std::string() : refused(text, "a whole number from 0 to " + std::to_string(largest));
      },
      "");
}

void addAccept(CLI::App& command, std::vector<std::string>& kinds, const std::string& what) {
  command
      .add_option("--accept", kinds,
                  "A kind of refused data that does not stop the " + what +
                      ", because the data are right as they are; again for each kind")
      ->allow_extra_args(false)
      ->check(oneOf(acceptableWords()));
}

std::optional<std::string> unknownWord(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  std::string said = "tactus";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "--") return std::nullopt;
    if (!isOption(word)) {
      const auto names = commandsOf(*command);
      if (names.empty()) continue;
      if (std::find(names.begin(), names.end(), word) == names.end()) {
        return said + ": found the word " + base::quoted(word) + ", wanted a command: " + base::joined(names, ", ") +
               base::suggestion(word, names);
      }
      command = command->get_subcommand(word);
      said += ' ' + word;
      continue;
    }
    const std::size_t equals = word.find('=');
    // Letters behind a short option are its value.
    const std::string name = word[1] == '-' ? word.substr(0, equals) : word.substr(0, 2);
    const CLI::Option* option = command->get_option_no_throw(name);
    if (option == nullptr) {
      const auto names = optionsOf(*command);
      return said + ": found the option " + base::quoted(name) + ", wanted one of " + base::joined(names, ", ") +
             base::suggestion(name, names);
    }
    const bool value_follows =
        option->get_items_expected_max() > 0 && equals == std::string::npos && (word[1] == '-' || word.size() == 2);
    if (value_follows) ++i;
  }
  return std::nullopt;
}

}  // namespace tactus::cli
