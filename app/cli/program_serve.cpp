// The command that serves a model while it runs.
#include "app/cli/command_line.h"

namespace tactus::cli {

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

}  // namespace tactus::cli
