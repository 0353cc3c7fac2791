// The command line of `build`, `report` and `vote`.
#include <algorithm>

#include "app/cli/command_line.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

/// A policy of weights, or the name of a file: that has a dot or a slash, or is there.
CLI::Validator weightsWord() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::vector<std::string> policies = {"equal", "years", "category", "column"};
        const bool known = std::find(policies.begin(), policies.end(), text) != policies.end();
        if (known || text.find_first_of("./") != std::string::npos || CLI::ExistingFile(text).empty())
          return std::string();
        return "found " + base::quoted(text) + ", wanted one of " + base::joined(policies, ", ") + " or a CSV file" +
               base::suggestion(text, policies);
      },
      "");
}

/// The options of `build` and `vote` for the terms of the force.
template <class Options>
void addForceTerms(CLI::App& command, Options& o) {
  addForceTermsFrom(command, o);
  command
      .add_option(
          "--force-end", o.force_end_n,
          "End of the universe of the force in N (default: the last force that half of the participants judged)")
      ->check(numberThat("a number from 0.001 to 100", [](double x) { return x >= 0.001 && x <= 100; }));
}

}  // namespace

void addBuildOptions(CLI::App& command, BuildOptions& o, const std::string& stops) {
  command.add_option("STUDY", o.study, "Study file, or folder with the CSV tables")->required()->check(notEmpty());
  command
      .add_option("--weights", o.weights,
                  "equal, years, category (beginner 1, intermediate 2, expert 3), column, or a CSV file "
                  "participant,weight")
      ->check(weightsWord());
  command.add_option("--alpha", o.alpha, "Membership at which a cluster's core ends, in (0.5, 1]")
      ->check(numberThat("a number above 0.5 and at most 1", [](double x) { return x > 0.5 && x <= 1; }));
  command.add_option("--trim", o.trim, "Drop samples below this share of their stroke's peak speed, in [0, 1)")
      ->check(numberThat("a share of 0 or more and below 1", [](double x) { return x >= 0 && x < 1; }));
  command
      .add_option_function<std::string>(
          "--centres",
          [&o](const std::string& word) {
            using enum elicitation::SpeedCentres;
            o.centres = word == name(kLevelMeans) ? kLevelMeans : kClusters;
          },
          "Middles of a participant's speed terms")
      ->check(oneOf({"clusters", "level_means"}))
      ->default_str("clusters");
  command
      .add_option_function<std::string>(
          "--averaging",
          [&o](const std::string& word) {
            using enum elicitation::Averaging;
            o.averaging = word == name(kMedian) ? kMedian : word == name(kWeightedMean) ? kWeightedMean : kMean;
          },
          "Of the speed terms over the participants; weighted_mean goes by --weights")
      ->check(oneOf({"mean", "weighted_mean", "median"}))
      ->default_str("mean");
  addForceTerms(command, o);
  command
      .add_option_function<std::string>(
          "--depths",
          [&o](const std::string& word) {
            using enum elicitation::DepthsFrom;
            o.depths = word == name(kMeasured) ? kMeasured : kTemplate;
          },
          "Depths of the regions: the template's, or those measured on the image that the study file holds")
      ->check(oneOf({"template", "measured"}))
      ->default_str("template");
  addAccept(command, o.accept, stops);
  command
      .add_option("--replicates", o.replicates, "Draws of whole strokes for the intervals of the speeds, 0 for none")
      ->check(wholeNumberUpTo(1000000));
  command
      .add_option_function<std::string>(
          "--terms", [&o](const std::string& terms) { o.own_terms = terms == "own"; }, "Speed terms of the experts")
      ->check(oneOf({"averaged", "own"}))
      ->default_str("averaged");
}

void addBuildCommands(CLI::App& app, Chosen& chosen) {
  addCommand(app, chosen, "build", "Elicitation: from a study to its averaged force model", build,
             [](CLI::App& command, BuildOptions& o) {
               addBuildOptions(command, o, "build");
               command.add_option("--out", o.out, "Model file to write")->required()->check(notEmpty());
               addJson(command, o.json);
             });
  addCommand(app, chosen, "report", "The report of a study: its data, every step to its model, and what is missing",
             writeReport, [](CLI::App& command, ReportOptions& o) {
               addBuildOptions(command, o, "report");
               command.add_option("--out", o.out, "HTML file to write")->required()->check(notEmpty());
               addJson(command, o.json);
             });
  addCommand(app, chosen, "vote", "The vote on force judgements and the terms that follow", vote,
             [](CLI::App& command, VoteOptions& o) {
               command
                   .add_option(
                       "JUDGEMENTS", o.judgements,
                       "Table of judgements, or of vote counts as in Table 2; or a study, as a file or a folder")
                   ->required()
                   ->transform(inputFile());
               command.add_option("--series", o.series, "Series of stimuli to count")->check(notEmpty());
               addTablePack(command, o.pack);
               addForceTerms(command, o);
               addJson(command, o.json);
             });
}

}  // namespace tactus::cli
