// The table of docs/type-2.md: what an interval type-2 model of the force words would say. The program has no such
// model; this one is exact for piecewise-linear sets and serves the page alone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/membership.h"
#include "elicitation/uncertainty/own_words.h"

#include "tests/elicitation/four_people.h"

namespace tactus::elicitation {
namespace {

/// A continuous piecewise-linear set: values at ascending forces.
struct Set {
  std::vector<double> x;
  std::vector<double> y;
};

using Words = std::map<std::string, fuzzy::MembershipFunction>;
using Strengths = std::map<std::string, double>;

/// The places where something bends: vertices, and where two clipped words or a word and its strength meet.
std::vector<double> bendsOf(const std::vector<Words>& people, const Strengths& strengths, double end_n) {
  std::vector<double> bends = {0, end_n};
  std::vector<std::pair<double, double>> lines;  // y = first + second x
  for (const auto& words : people) {
    for (const auto& [id, m] : words) {
      bends.insert(bends.end(), {m.a, m.b, m.c, m.d});
      if (m.b > m.a) lines.emplace_back(-m.a / (m.b - m.a), 1 / (m.b - m.a));
      if (m.d > m.c) lines.emplace_back(m.d / (m.d - m.c), -1 / (m.d - m.c));
    }
  }
  for (const auto& [id, strength] : strengths) lines.emplace_back(strength, 0);
  for (const auto& [p, q] : lines) {
    for (const auto& [r, s] : lines) {
      if (q != s) bends.push_back((r - p) / (q - s));
    }
  }
  std::erase_if(bends, [end_n](double x) { return !(x >= 0 && x <= end_n); });
  std::sort(bends.begin(), bends.end());
  bends.erase(std::unique(bends.begin(), bends.end(), [](double a, double b) { return b - a < 1e-12; }), bends.end());
  return bends;
}

double wordAt(const Words& words, const std::string& id, double x) {
  const auto found = words.find(id);
  return found == words.end() ? 0 : found->second(x);
}

/// The aggregated set of one person: the highest of the words, each clipped at its strength.
double aggregatedAt(const Words& words, const Strengths& strengths, double x) {
  double y = 0;
  for (const auto& [id, strength] : strengths) y = std::max(y, std::min(strength, wordAt(words, id, x)));
  return y;
}

struct Bounds {
  Set lower;
  Set upper;
};

/// Lowest and highest of the words of all, then the rules.
Bounds boundsOfWords(const std::vector<Words>& people, const Strengths& strengths, double end_n) {
  Bounds out;
  for (const double x : bendsOf(people, strengths, end_n)) {
    double lower = 0;
    double upper = 0;
    for (const auto& [id, strength] : strengths) {
      double least = 1;
      double most = 0;
      for (const auto& words : people) {
        least = std::min(least, wordAt(words, id, x));
        most = std::max(most, wordAt(words, id, x));
      }
      lower = std::max(lower, std::min(strength, least));
      upper = std::max(upper, std::min(strength, most));
    }
    for (auto* set : {&out.lower, &out.upper}) set->x.push_back(x);
    out.lower.y.push_back(lower);
    out.upper.y.push_back(upper);
  }
  return out;
}

/// The rules of each, then lowest and highest of the aggregated sets.
Bounds boundsOfSets(const std::vector<Words>& people, const Strengths& strengths, double end_n) {
  Bounds out;
  for (const double x : bendsOf(people, strengths, end_n)) {
    double lower = 1;
    double upper = 0;
    for (const auto& words : people) {
      lower = std::min(lower, aggregatedAt(words, strengths, x));
      upper = std::max(upper, aggregatedAt(words, strengths, x));
    }
    for (auto* set : {&out.lower, &out.upper}) set->x.push_back(x);
    out.lower.y.push_back(lower);
    out.upper.y.push_back(upper);
  }
  return out;
}

/// Area and moment of `set` between two forces.
std::pair<double, double> momentsOf(const Set& set, double from_n, double to_n) {
  double area = 0;
  double moment = 0;
  for (std::size_t i = 0; i + 1 < set.x.size(); ++i) {
    const double l = std::max(from_n, set.x[i]);
    const double r = std::min(to_n, set.x[i + 1]);
    if (!(r > l)) continue;
    const double slope = (set.y[i + 1] - set.y[i]) / (set.x[i + 1] - set.x[i]);
    const double yl = set.y[i] + slope * (l - set.x[i]);
    const double yr = set.y[i] + slope * (r - set.x[i]);
    area += (r - l) * (yl + yr) / 2;
    moment += (r - l) * (l * (2 * yl + yr) + r * (yl + 2 * yr)) / 6;
  }
  return {area, moment};
}

/// An end of the Karnik-Mendel interval: the switch point that is its own centroid, upper set on one side of it and
/// lower set on the other (Karnik and Mendel 2001).
double karnikMendel(const Bounds& bounds, bool left) {
  const double end_n = bounds.lower.x.back();
  double y = end_n / 2;
  for (int step = 0; step < 2000; ++step) {
    const auto [a1, m1] = momentsOf(left ? bounds.upper : bounds.lower, 0, y);
    const auto [a2, m2] = momentsOf(left ? bounds.lower : bounds.upper, y, end_n);
    if (!(a1 + a2 > 0)) return y;
    y = (m1 + m2) / (a1 + a2);
  }
  return y;
}

Strengths strengthsOf(const fuzzy::ForceModel& model, const std::vector<double>& point) {
  Strengths out;
  for (const auto& rule : model.experts.front().rules) {
    double strength = 1;
    for (const auto& condition : rule.conditions) {
      for (std::size_t i = 0; i < model.inputs.size(); ++i) {
        if (model.inputs[i].id != condition.input) continue;
        const auto* const term = fuzzy::findTerm(model.inputs[i].terms, condition.term);
        strength = std::min(strength, fuzzy::MembershipFunction::of(*term)(point[i]));
      }
    }
    if (strength > 0) out[rule.then] = std::max(out[rule.then], strength);
  }
  return out;
}

/// `.469`; `1.056`.
std::string printed(double force_n) {
  char text[16];
  std::snprintf(text, sizeof text, "%.3f", force_n);
  return text[0] == '0' ? text + 1 : text;
}

struct Row {
  double voted_n = 0;
  std::vector<double> own_n;
  double mean_n = 0;
  Bounds words;
  Bounds sets;
};

Row rowAt(const std::vector<double>& point) {
  auto study = fourPeople();
  std::erase_if(study.rules, [](const auto& rule) { return rule.participant != "S4"; });
  const auto built = buildModel(study, {}, {}).value();
  Row row;
  row.voted_n = fuzzy::compile(built.model)->evaluate(point).force_n;
  std::vector<Words> people;
  for (const auto& own : ownWords(study, built, {})) {
    row.own_n.push_back(fuzzy::compile(*underWords(built.model, own))->evaluate(point).force_n);
    row.mean_n += row.own_n.back() / 4;
    auto& words = people.emplace_back();
    for (const auto& term : own.terms) words[term.id] = fuzzy::MembershipFunction::of(term);
  }
  const auto strengths = strengthsOf(built.model, point);
  row.words = boundsOfWords(people, strengths, built.model.output.max);
  row.sets = boundsOfSets(people, strengths, built.model.output.max);
  return row;
}

std::string intervalText(const Bounds& bounds) {
  const bool empty = momentsOf(bounds.lower, 0, bounds.lower.x.back()).first == 0;
  return (empty ? "**empty lower set**" : printed(karnikMendel(bounds, true))) + " … " +
         printed(karnikMendel(bounds, false));
}

std::string page() {
  std::ifstream in(TACTUS_SOURCE_DIR "/docs/type-2.md");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Type2Table, IsThatOfThePage) {
  const std::string text = page();
  const std::pair<const char*, std::vector<double>> points[] = {
      {"A", {1, 60, 200, 50}}, {"B", {1, 60, 70, 50}}, {"E", {1, 60, 300, 50}}, {"C", {.3, 45, 170, 80}}};
  for (const auto& [name, point] : points) {
    const Row row = rowAt(point);
    std::string line = "| " + std::string(name) + " | " + printed(row.voted_n) + " |";
    for (const double own_n : row.own_n) line += ' ' + printed(own_n);
    line += " | " + printed(row.mean_n) + " | " + intervalText(row.words) + " | " + intervalText(row.sets) + " |";
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

// Reference figures of another program at A and B.
TEST(Type2Table, HasTheReferenceIntervals) {
  const Row a = rowAt({1, 60, 200, 50});
  EXPECT_NEAR(karnikMendel(a.words, true), .263, 5.1e-4);
  EXPECT_NEAR(karnikMendel(a.words, false), 1.056, 5.1e-4);
  EXPECT_NEAR(karnikMendel(a.sets, true), .456, 5.1e-4);
  EXPECT_NEAR(karnikMendel(a.sets, false), .719, 5.1e-4);
  const Row b = rowAt({1, 60, 70, 50});
  EXPECT_EQ(momentsOf(b.words.lower, 0, 1.1).first, 0) << "E1 never used the lowest word";
  EXPECT_NEAR(karnikMendel(b.sets, true), .138, 5.1e-4);
  EXPECT_NEAR(karnikMendel(b.sets, false), .457, 5.1e-4);
}

// Each aggregated set lies between the two bounds, and so does its centroid.
TEST(Type2Table, TheIntervalOfTheSetsHoldsTheForceOfEachPerson) {
  for (double depth_mm = 5; depth_mm < 600; depth_mm += 35) {
    const Row row = rowAt({.5, 50, depth_mm, 90});
    for (const double own_n : row.own_n) {
      EXPECT_GE(own_n, karnikMendel(row.sets, true) - 1e-9) << depth_mm;
      EXPECT_LE(own_n, karnikMendel(row.sets, false) + 1e-9) << depth_mm;
    }
  }
}

}  // namespace
}  // namespace tactus::elicitation
