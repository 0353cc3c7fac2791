// The command line of `tactus devices`.
#include "app/cli/command_line.h"
#include "app/cli/device_commands.h"

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
                               "Store the insertion axis of an OpenHaptics device, x,y,z (right, up, toward "
                               "you): --inwards=0,0,-1; by default the calibration runs")
                   ->check(notEmpty());
               o.terminal = terminal;
             });
}

}  // namespace tactus::cli
