#include "tests/support/ngt_model.h"

#include <array>
#include <string>

namespace tactus::support {
namespace {

using fuzzy::ForceModel;
using fuzzy::Shape;
using fuzzy::Term;
using fuzzy::Variable;

Term trapezoid(std::string id, double a, double b, double c, double d) {
  return {id, id, Shape::kTrapezoid, {a, b, c, d}};
}

using Regions = std::array<const char*, 5>;

/// Table A2 as a matrix: rows are conditions, columns the five regions in the printed order.
ForceModel s4(ForceModel model, const Regions& regions) {
  struct Row {
    const char *input, *term;
    std::array<const char*, 5> force;
  };
  const char *vs = "very_small", *s = "small", *m = "medium", *l = "large", *vl = "very_large";
  const std::array<Row, 9> rows = {{
      {"lubrication", "well", {vs, s, s, m, vs}},
      {"lubrication", "medium", {vs, s, s, l, s}},
      {"lubrication", "poor", {l, vl, vl, vl, l}},
      {"neck_flexion", "small", {vs, m, m, m, s}},
      {"neck_flexion", "medium", {vs, m, m, m, s}},
      {"neck_flexion", "large", {vs, m, l, vl, m}},
      {"speed", "slow", {vs, m, m, s, vs}},
      {"speed", "medium", {s, l, l, l, s}},
      {"speed", "fast", {m, vl, vl, vl, l}},
  }};
  fuzzy::Expert expert;
  expert.id = expert.label = "S4";
  for (const auto& row : rows) {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      expert.rules.push_back({{{row.input, row.term}, {"depth", regions[r]}}, row.force[r]});
    }
  }
  model.experts.push_back(std::move(expert));
  return model;
}

}  // namespace

ForceModel ngtVariables() {
  ForceModel model;
  model.name = "NGT";
  model.inputs = {
      {"lubrication",
       "Tube lubrication",
       "1",
       0,
       1,
       {trapezoid("poor", 0, 0, .2, .4), trapezoid("medium", .2, .4, .6, .8), trapezoid("well", .6, .8, 1, 1)}},
      {"neck_flexion",
       "Neck flexion",
       "deg",
       0,
       90,
       {trapezoid("small", 0, 0, 15, 35), trapezoid("medium", 15, 35, 55, 75), trapezoid("large", 55, 75, 90, 90)}},
      {"depth",
       "Depth",
       "mm",
       0,
       600,
       {trapezoid("nasal_cavity", 0, 0, 60, 80), trapezoid("nasopharynx", 60, 80, 105, 125),
        trapezoid("oropharynx", 105, 125, 138, 162), trapezoid("laryngopharynx", 138, 162, 185, 215),
        trapezoid("esophagus", 185, 215, 420, 460), trapezoid("stomach", 420, 460, 600, 600)}},
      {"speed",
       "Speed",
       "mm/s",
       0,
       400,
       {trapezoid("slow", 0, 0, 64, 100), trapezoid("medium", 64, 100, 120, 163),
        trapezoid("fast", 120, 163, 400, 400)}},
  };
  model.output = {
      "force",
      "Force",
      "N",
      0,
      1.1,
      {trapezoid("very_small", 0, 0, .2, .3), trapezoid("small", .2, .3, .4, .5), trapezoid("medium", .4, .5, .6, .7),
       trapezoid("large", .6, .7, .7, .8), trapezoid("very_large", .7, .8, 1.1, 1.1)}};
  return model;
}

ForceModel s4AsPrinted() {
  return s4(ngtVariables(), {"nasal_cavity", "nasopharynx", "laryngopharynx", "esophagus", "stomach"});
}

ForceModel s4Shifted() {
  return s4(ngtVariables(), {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"});
}

ForceModel s4FiveRegions() {
  ForceModel model = s4AsPrinted();
  model.inputs[2].terms = {trapezoid("nasal_cavity", 0, 0, 60, 80), trapezoid("nasopharynx", 60, 80, 105, 125),
                           trapezoid("laryngopharynx", 105, 125, 185, 215), trapezoid("esophagus", 185, 215, 420, 460),
                           trapezoid("stomach", 420, 460, 600, 600)};
  return model;
}

}  // namespace tactus::support
