#include <csignal>
#include <iostream>

#include "app/cli/program.h"

int main(int argc, char** argv) {
  // A limit on the size of files is then an error that is told, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  return tactus::cli::run({argv + 1, argv + argc}, std::cout, std::cerr);
}
