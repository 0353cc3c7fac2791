// The commands that hand a model to other programs.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/certify/foreign_program.h"
#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "core/exchange/dialect.h"

namespace tactus::cli {

void addDeviceCommands(CLI::App& app, Chosen& chosen, const Terminal& terminal, const Terminal& aside) {
  CLI::App& devices = *app.add_subcommand("devices", "List, test and calibrate devices");
  devices.require_subcommand(0, 1);
  const auto list = std::make_shared<DevicesOptions>();
  addJson(devices, list->json);
  // Runs after the callbacks of the subcommands.
  devices.callback([&devices, &chosen, list] {
    if (devices.get_subcommands().empty()) chosen = [list] { return cli::devices(*list); };
  });
  addCommand(devices, chosen, "test", "Guided self-test with at most 0.1 N", testDevice,
             [&](CLI::App& command, DeviceTestOptions& o) {
               command.add_option("ID", o.id, "Device as `tactus devices` names it; by default the first that works")
                   ->check(notEmpty());
               command.add_flag_callback(
                   "--json",
                   [&o, aside] {
                     o.json = true;
                     o.terminal = aside;
                   },
                   "Print the results as JSON; the conversation goes to standard error");
               o.terminal = terminal;
               o.results = terminal.out;
             });
  addCommand(devices, chosen, "calibrate", "Guided calibration; stored for this computer", calibrateDevice,
             [&](CLI::App& command, DeviceCalibrateOptions& o) {
               command.add_option("ID", o.id, "Device as `tactus devices` names it")->required()->check(notEmpty());
               command.add_option("--method", o.method, "How newtons are measured: with a spring scale or a weight")
                   ->check(oneOf({"spring", "weight"}));
               command
                   .add_option("--inwards", o.inwards,
                               "Store the insertion axis of an OpenHaptics or Haply device, x,y,z (right, up, "
                               "toward you): --inwards=0,0,-1; by default the calibration runs")
                   ->check(notEmpty());
               o.terminal = terminal;
             });
}

void addServeCommand(CLI::App& app, Chosen& chosen, std::ostream& out, std::ostream& err) {
  const auto o = std::make_shared<ServeOptions>();
  CLI::App& command = *app.add_subcommand("serve", "The live link: gives a model to simulators while they run");
  command.add_option("MODEL", o->model, "Model file")->required()->check(notEmpty());
  command.add_option("--port", o->port, "TCP port on the loopback, 0 for a free one")->check(wholeNumberUpTo(65535));
  command.add_option("--socket", o->socket, "Socket file to listen on as well")->check(notEmpty());
  command
      .add_option("--token-file", o->token_file,
                  "File with the token that clients must know: read, or made if there is none; without it a new one in "
                  "a private folder")
      ->check(notEmpty());
  command.add_flag("--watch", o->watch, "Serve the file again when it changes");
  command.callback([&chosen, &out, &err, o] { chosen = [&out, &err, o] { return serve(*o, out, err); }; });
}

void addEmulateCommands(CLI::App& app, Chosen& chosen, std::ostream& out) {
  CLI::App& emulate = *app.add_subcommand("emulate", "Simulates a device for other programs");
  emulate.require_subcommand(1);
  const auto o = std::make_shared<EmulateHaplyOptions>();
  CLI::App& command = *emulate.add_subcommand(
      "haply", "The service of a Haply Inverse3 with a simulated hand; prints at the end what was commanded");
  const auto seconds = [] {
    return numberThat("seconds from 0 to 1000000", [](double x) { return x >= 0 && x <= 1e6; });
  };
  command.add_option("--port", o->port, "TCP port on the loopback, 0 for a free one")
      ->capture_default_str()
      ->check(wholeNumberUpTo(65535));
  command.add_option("--devices", o->devices, "How many devices it has: SIM-1, SIM-2, …")
      ->capture_default_str()
      ->check(
          numberThat("a whole number from 1 to 8", [](double x) { return x >= 1 && x <= 8 && x == std::floor(x); }));
  command
      .add_option("--hand", o->hand,
                  "What the hands do: strokes of 60 mm with the button held, nothing, or the steps of `devices test`")
      ->capture_default_str()
      ->check(oneOf({"strokes", "still", "self-test"}));
  command.add_flag("--no-grip", o->without_grip, "Without a grip, so without a button");
  command.add_option("--rate", o->rate_hz, "The most replies per second and client")
      ->capture_default_str()
      ->check(numberThat("a number from 1 to 1000000", [](double x) { return x >= 1 && x <= 1e6; }));
  command.add_option("--late", o->late_ms, "Milliseconds that a reply is late")
      ->check(numberThat("milliseconds from 0 to 10000", [](double x) { return x >= 0 && x <= 1e4; }));
  command.add_option("--late-share", o->late_share, "Share of the replies that are late")
      ->capture_default_str()
      ->check(numberThat("a share from 0 to 1", [](double x) { return x >= 0 && x <= 1; }));
  command.add_option("--dead-after", o->dead_after_s, "Seconds after the first message until it dies: it ends")
      ->check(seconds());
  command
      .add_option("--silent-after", o->silent_after_s,
                  "Seconds after the first message until it replies no more, though it is there")
      ->check(seconds());
  command.add_option("--trace", o->trace, "CSV file for position and force of each command, written at the end")
      ->check(notEmpty());
  command.callback([&chosen, &out, o] { chosen = [&out, o] { return emulateHaply(*o, out); }; });
}

void addDeliveryCommands(CLI::App& app, Chosen& chosen) {
  addCommand(
      app, chosen, "bundle", "Everything that a simulator team needs of a model, with what each file promises", bundle,
      [](CLI::App& command, BundleOptions& o) {
        addModel(command, o.model);
        command
            .add_option("--out", o.out, "Folder to write, new or with an earlier bundle; or a file that ends with .zip")
            ->required()
            ->check(outputFolder());
        command.add_option("--accept-hole", o.accept_holes, "Name of a hole that may stay; as often as needed")
            ->check(notEmpty());
        command
            .add_option(
                "--table-error", o.table_error_n,
                "The most that the look-up table may be off, in N; default: 0.01, of a force beyond 1.25 N 2 % of "
                "its largest")
            ->check(numberThat("a number of newtons above 0", [](double x) { return x > 0; }));
        command.add_option("--study", o.study, "Study file whose sign-offs on the model go along")->check(notEmpty());
        command.add_option("--sign", o.sign, "Private key of OpenSSH to sign with: ssh-keygen writes the signature")
            ->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(
      app, chosen, "verify", "Reads a bundle back: nothing missing, altered or beyond its tolerance, contracts kept",
      verify, [](CLI::App& command, VerifyOptions& o) {
        command
            .add_option("DIR", o.folder,
                        "Folder of the bundle, its manifest, or its zip file; by default the present folder")
            ->check(notEmpty());
        command.add_option("--expect", o.expect, "The fingerprint that its sender told you: that of the manifest")
            ->check(notEmpty());
        command.add_option("--key", o.key, "Public key of OpenSSH (*.pub) by which the bundle must be signed")
            ->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(
      app, chosen, "certify", "Asks a foreign program for the forces of a model: how far off, how fast", certifyProgram,
      [](CLI::App& command, CertifyOptions& o) {
        command
            .add_option("TARGET", o.target,
                        "A program, tcp:HOST:PORT, unix:PATH, a shared library (*.so), or node:FILE.js")
            ->required()
            ->check(CLI::Validator(certify::targetMistake, ""));
        command.add_option("ARGUMENTS", o.arguments, "Of a program that is started; behind --");
        command.add_option("--model", o.model, "Model file, or folder of a bundle")->required()->transform(inputFile());
        command.add_option("--out", o.out, "Page to write (HTML)")->check(notEmpty());
        command.add_option("--points", o.points, "At most so many points; without it all, 2,000 or more")
            ->check(
                numberThat("a whole number from 1", [](double x) { return x >= 1 && x <= 1e9 && x == std::floor(x); }));
        command.add_option("--tolerance", o.tolerance, "What an answer may be off, in N, and in mm for depths")
            ->capture_default_str()
            ->check(numberThat("a number of newtons from 0", [](double x) { return x >= 0; }));
        command.add_option("--timeout", o.timeout_s, "Seconds for an answer")
            ->capture_default_str()
            ->check(numberThat("a number of seconds from 0.01 to 600", [](double x) { return x >= 0.01 && x <= 600; }));
        addJson(command, o.json);
      });
  addCommand(app, chosen, "convert", "A model for other fuzzy programs, one file per expert, or as C source", convert,
             [](CLI::App& command, ConvertOptions& o) {
               addModel(command, o.model);
               std::vector<std::string> formats;
               for (const exchange::Dialect dialect : exchange::kDialects) formats.emplace_back(name(dialect));
               formats.emplace_back("c");
               command.add_option("--to", o.to, "Format")->required()->check(oneOf(std::move(formats)));
               command.add_option("--out", o.out, "Folder for the files")->required()->check(outputFolder());
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
  addCommand(app, chosen, "rebase", "The edits of a tuned model, carried over to a model that was built anew", rebase,
             [](CLI::App& command, RebaseOptions& o) {
               command.add_option("BASE", o.base, "Model file as it was built")->required()->transform(inputFile());
               command.add_option("TUNED", o.tuned, "Its tuned version")->required()->transform(inputFile());
               command.add_option("NEW", o.target, "The model that was built anew")->required()->transform(inputFile());
               command.add_option("--only", o.only, "Number of an edit to carry over; may be repeated. Without: all");
               command.add_option("-o,--out", o.out, "Model file to write: NEW with the edits")->check(notEmpty());
               addJson(command, o.json);
             });
}

}  // namespace tactus::cli
