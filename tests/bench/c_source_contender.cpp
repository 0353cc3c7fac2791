// The C source as a contender: of the whole model, or of the scene where inputs are fixed.
#include "core/base/check.h"

#include "tests/bench/contenders.h"
#include "tests/bench/loaded_source.h"

namespace tactus::bench {
namespace {

constexpr const char* kCompiler = "cc -O2";  // as a simulator is built that knows nothing of its processor

/// The inputs that vary, point after point.
std::vector<double> freeRows(const Case& about) {
  std::vector<double> rows;
  for (std::size_t p = 0; p < about.points.count(); ++p) {
    for (std::size_t i = 0; i < about.fixed.size(); ++i) {
      if (!about.fixed[i]) rows.push_back(about.points.row(p)[i]);
    }
  }
  return rows;
}

}  // namespace

std::vector<Contender> cSource(const Case& about) {
  std::vector<exchange::FixedInput> fixed;
  for (std::size_t i = 0; i < about.fixed.size(); ++i) {
    if (about.fixed[i]) fixed.push_back({i, *about.fixed[i]});
  }
  const auto source = exchange::cSource(about.model, fixed);
  TACTUS_CHECK(source.has_value());
  const auto loaded = loadSource(*source, kCompiler);
  if (!loaded) return {};
  const std::size_t width = about.fixed.size() - fixed.size();
  const std::string family = fixed.empty() ? "C source" : "C source, scene";
  const auto one_point = [force = loaded->force, rows = freeRows(about), width](std::size_t first,
                                                                                std::span<double> out) {
    int fired = 0;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = force(rows.data() + (first + i) * width, &fired);
  };
  const auto batch = [batch = loaded->batch, rows = freeRows(about), width,
                      fired = std::vector<unsigned char>(about.points.count())](std::size_t first,
                                                                                std::span<double> out) mutable {
    batch(rows.data() + first * width, out.size(), out.data(), fired.data());
  };
  const std::string name = about.name + ": " + family;
  return {{family + ", one point", 0, &about, {name + ", one point", about.points.count(), one_point}},
          {family + ", batch", 0, &about, {name + ", batch", about.points.count(), batch}}};
}

}  // namespace tactus::bench
