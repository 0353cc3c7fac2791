// A hand pushes a tube 60 mm in one second: insertion MODEL prints time, position, depth and force every 50 ms.
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <tactus/tactus.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: insertion MODEL\n");
    return 2;
  }
  try {
    const tactus::Model model = tactus::Model::open(argv[1]);
    // All inputs but depth and speed are fixed, here in the middle of their universes.
    std::map<std::string, double> conditions;
    for (std::size_t i = 0; i < model.inputs(); ++i) {
      const std::string id = model.inputId(i);
      if (std::string_view(model.inputRole(i)) == "condition")
        conditions[id] = (model.inputMin(i) + model.inputMax(i)) / 2;
    }
    tactus::Tube tube(model.scene(conditions));
    std::printf("time_s,position_mm,depth_mm,force_n\n");
    for (int tick = 0; tick <= 1000; ++tick) {
      const double time_s = tick * 0.001;
      const double position_mm = 60 * time_s;
      const tactus::Feel feel = tube.step(position_mm, true, 0.001);
      if (tick % 50 == 0) std::printf("%.3f,%.3f,%.3f,%.6f\n", time_s, position_mm, feel.depth_mm, feel.force_n);
    }
  } catch (const tactus::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
