// tactus.hpp without exceptions, as engines compile it: no_exceptions MODEL. Prints the force in the middle of all
// inputs.
#include <cstdio>
#include <vector>

#include "tactus/tactus.hpp"

#ifdef __cpp_exceptions
#error "this file is compiled without exceptions"
#endif

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto model = tactus::Model::open(argv[1]);
  std::vector<double> inputs;
  for (std::size_t i = 0; i < model.inputs(); ++i) inputs.push_back((model.inputMin(i) + model.inputMax(i)) / 2);
  std::printf("%g N\n", model.force(inputs));
  return 0;
}
