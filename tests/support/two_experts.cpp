#include "tests/support/two_experts.h"

namespace tactus::tests {
namespace {

fuzzy::Term trapezoid(const char* id, const char* label, double a, double b, double c, double d) {
  return {id, label, fuzzy::Shape::kTrapezoid, {a, b, c, d}};
}

}  // namespace

fuzzy::ForceModel twoExperts() {
  fuzzy::ForceModel model;
  model.name = "Two experts";
  model.created_utc = "2026-11-21T08:00:00Z";
  model.generator = "tactus tests";
  model.inputs = {
      {"speed",
       "Speed",
       "mm/s",
       0,
       100,
       {trapezoid("slow", "Slow", 0, 0, 40, 60), trapezoid("fast", "Fast", 40, 60, 100, 100)}},
      {"depth", "Depth", "mm", 0, 10, {trapezoid("near", "Near", 0, 0, 4, 5), trapezoid("far", "Far", 6, 7, 10, 10)}}};
  model.output = {"force", "Force",
                  "N",     0,
                  1,       {trapezoid("low", "Low", 0, 0, 0.5, 0.5), trapezoid("high", "High", 0.5, 0.5, 1, 1)}};
  fuzzy::Expert a;
  a.id = "A";
  a.label = "A";
  a.rules = {{{{"speed", "slow"}, {"depth", "near"}}, "low"},
             {{{"speed", "fast"}, {"depth", "near"}}, "high"},
             {{{"depth", "far"}}, "high"}};
  fuzzy::Expert b;
  b.id = "B";
  b.label = "B";
  b.overrides = {{"speed", {trapezoid("any", "Any speed", 0, 0, 100, 100)}}};
  b.rules = {{{{"depth", "far"}}, "low"}};
  model.experts = {a, b};
  return model;
}

}  // namespace tactus::tests
