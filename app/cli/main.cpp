#include <iostream>

#include "app/cli/program.h"

int main(int argc, char** argv) { return tactus::cli::run({argv + 1, argv + argc}, std::cout, std::cerr); }
