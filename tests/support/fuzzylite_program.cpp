#include "tests/support/fuzzylite_program.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

#include "core/base/text.h"

namespace tactus::support {

FuzzyliteProgram::FuzzyliteProgram() {
  FILE* const program = ::popen("fuzzylite 2>/dev/null", "r");
  if (program == nullptr) return;
  for (int c = std::fgetc(program); c != EOF; c = std::fgetc(program)) said_ += static_cast<char>(c);
  ::pclose(program);
}

std::vector<double> FuzzyliteProgram::outputs(const std::string& text, const std::string& format,
                                              const std::vector<std::vector<double>>& points) const {
  std::ofstream(folder_.file("model." + format)) << text;
  std::ofstream data(folder_.file("points.fld"));
  for (const auto& point : points) {
    std::string line;
    for (const double x : point) line += (line.empty() ? "" : " ") + base::formatNumber(x);
    data << line << '\n';
  }
  data.close();
  const std::string command = "fuzzylite -i " + folder_.file("model." + format) + " -if " + format + " -o " +
                              folder_.file("forces.fld") + " -of fld -decimals 17 -dheader false -dinputs false -d " +
                              folder_.file("points.fld") + " >" + folder_.file("log") + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command << '\n' << text;
  std::vector<double> out;
  std::ifstream in(folder_.file("forces.fld"));
  for (std::string word; in >> word;) out.push_back(base::parseNumber(word).value_or(HUGE_VAL));
  return out;
}

}  // namespace tactus::support
