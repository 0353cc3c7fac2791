// The two tables of table.c in C++: table MODEL POINTS.csv OUT.csv ALL.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <tactus/tactus.hpp>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t kGroup = 1000;  // points of one scene
constexpr std::size_t kFixed = 2;     // inputs that it fixes

std::string shortest(double value) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

// The scene for the group that begins at `point`.
tactus::Scene sceneAt(const tactus::Model& model, const double* point) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < kFixed; ++i) ids.push_back(model.inputId(i));
  std::vector<std::pair<std::string_view, double>> fixed;
  for (std::size_t i = 0; i < kFixed; ++i) fixed.emplace_back(ids[i], point[i]);
  return model.scene(fixed);
}

// The points of a group without the inputs that are fixed.
std::vector<double> freeInputs(const double* points, std::size_t count, std::size_t inputs) {
  std::vector<double> out;
  for (std::size_t p = 0; p < count; ++p)
    out.insert(out.end(), points + p * inputs + kFixed, points + (p + 1) * inputs);
  return out;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) return 2;
  const tactus::Model model = tactus::Model::open(argv[1]);
  const std::size_t inputs = model.inputs();
  std::ifstream in(argv[2]);
  std::ofstream out(argv[3], std::ios::binary);
  std::ofstream all(argv[4], std::ios::binary);
  std::vector<double> points;
  std::string line;
  std::getline(in, line);
  out << line << ",force,fired\n";
  while (std::getline(in, line)) {
    std::vector<double> point;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) point.push_back(std::stod(cell));
    bool fired = false;
    out << line << ',' << shortest(model.force(point, &fired)) << ',' << (fired ? 1 : 0) << '\n';
    points.insert(points.end(), point.begin(), point.end());
  }
  const std::vector<double> batch = model.batch(points);
  for (std::size_t first = 0; first < batch.size(); first += kGroup) {
    const std::size_t count = std::min(kGroup, batch.size() - first);
    const double* const group = points.data() + first * inputs;
    const tactus::Scene scene = sceneAt(model, group);
    const std::vector<double> rest = freeInputs(group, count, inputs);
    const std::vector<double> scene_batch = scene.batch(rest);
    for (std::size_t p = 0; p < count; ++p) {
      const double* const point = group + p * inputs;
      bool fired = false;
      const double force_n = model.force(point, inputs, &fired);
      const double row[] = {force_n,
                            fired ? 1.0 : 0.0,
                            model.expertForce(model.experts() - 1, point, inputs),
                            batch[first + p],
                            scene.force(rest.data() + p * scene.inputs(), scene.inputs()),
                            scene_batch[p]};
      all.write(reinterpret_cast<const char*>(point), static_cast<std::streamsize>(inputs * sizeof *point));
      all.write(reinterpret_cast<const char*>(row), sizeof row);
    }
  }
  out.close();
  all.close();
  return out && all ? 0 : 1;
} catch (const tactus::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
