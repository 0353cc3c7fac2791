// The table that `tactus eval` writes, in C++: table MODEL POINTS.csv OUT.csv.
#include <charconv>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <tactus/tactus.hpp>
#include <vector>

int main(int argc, char** argv) try {
  if (argc != 4) return 2;
  const tactus::Model model = tactus::Model::open(argv[1]);
  std::ifstream in(argv[2]);
  std::ofstream out(argv[3], std::ios::binary);
  std::string line;
  std::getline(in, line);
  out << line << ",force,fired\n";
  while (std::getline(in, line)) {
    std::vector<double> inputs;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) inputs.push_back(std::stod(cell));
    bool fired = false;
    const double force_n = model.force(inputs, &fired);
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, force_n).ptr;
    out << line << ',' << std::string(digits, end) << ',' << (fired ? 1 : 0) << '\n';
  }
  out.close();
  return out ? 0 : 1;
} catch (const tactus::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
