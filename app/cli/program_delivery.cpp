// The commands that hand a model to other programs.
#include "app/cli/command_line.h"

namespace tactus::cli {

void addDeliveryCommands(CLI::App& app, Chosen& chosen) {
  addCommand(app, chosen, "bundle", "Everything that a simulator team needs of a model, with what each file promises",
             bundle, [](CLI::App& command, BundleOptions& o) {
               addModel(command, o.model);
               command
                   .add_option("--out", o.out,
                               "Folder to write, new or with an earlier bundle; or a file that ends with .zip")
                   ->required()
                   ->check(notEmpty());
               command.add_option("--accept-hole", o.accept_holes, "Name of a hole that may stay; as often as needed")
                   ->check(notEmpty());
               command.add_option("--table-error", o.table_error_n, "The most that the look-up table may be off, in N")
                   ->capture_default_str()
                   ->check(numberThat("a number of newtons above 0", [](double x) { return x > 0; }));
               addJson(command, o.json);
             });
  addCommand(
      app, chosen, "verify", "Reads a bundle back: nothing missing, altered or beyond its tolerance", verify,
      [](CLI::App& command, VerifyOptions& o) {
        command.add_option("DIR", o.folder, "Folder of the bundle, or its zip file")->required()->check(notEmpty());
        command.add_option("--expect", o.expect, "The fingerprint that its sender told you: that of the manifest")
            ->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(app, chosen, "convert", "A model for other fuzzy programs, one file per expert, or as C source", convert,
             [](CLI::App& command, ConvertOptions& o) {
               addModel(command, o.model);
               command.add_option("--to", o.to, "Format")
                   ->required()
                   ->check(oneOf({"fll", "fcl", "fcl-fuzzylite", "fis", "fml", "c"}));
               command.add_option("--out", o.out, "Folder for the files")->required()->check(notEmpty());
               command.add_option("--fix", o.fixed, "INPUT=VALUE: C source with this input fixed; may be repeated");
               addJson(command, o.json);
             });
  addCommand(app, chosen, "import", "A model file from a model of another fuzzy program: FLL, FCL or FIS", import,
             [](CLI::App& command, ImportOptions& o) {
               command.add_option("FILE", o.file, "File of fuzzylite, jFuzzyLogic, MATLAB, Octave and others")
                   ->required()
                   ->transform(inputFile());
               command.add_option("--out", o.out, "Model file to write")->required()->check(notEmpty());
               command.add_option("--from", o.from, "Format, where the content does not tell it")
                   ->check(oneOf({"fll", "fcl", "fis"}));
               command.add_option("--output", o.output, "Name of the output to take, where there are several")
                   ->check(notEmpty());
               addJson(command, o.json);
             });
  addCommand(app, chosen, "diff", "What differs between two models: terms, rules, settings, newtons", diff,
             [](CLI::App& command, DiffOptions& o) {
               command.add_option("A", o.first, "Model file")->required()->transform(inputFile());
               command.add_option("B", o.second, "Model file")->required()->transform(inputFile());
               addJson(command, o.json);
             });
}

}  // namespace tactus::cli
