#include "tests/bench/octave_peer.h"

#include <cstdlib>

#include "core/base/check.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"

#include "tests/support/temp_folder.h"

namespace tactus::bench {
namespace {

using base::formatNumber;

std::string fisTerm(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  TACTUS_CHECK(term.shape == fuzzy::Shape::kTrapezoid);
  std::vector<double> p = term.points;
  const double width = variable.max - variable.min;
  if (p[0] == p[1]) p[0] -= width;
  if (p[2] == p[3]) p[3] += width;
  std::vector<std::string> points;
  for (const double point : p) points.push_back(formatNumber(point));
  return "'" + term.id + "':'trapmf',[" + base::joined(points, " ") + "]\n";
}

std::string fisVariable(const std::string& heading, const fuzzy::Variable& variable) {
  std::string text = "\n[" + heading + "]\nName='" + variable.id + "'\nRange=[" + formatNumber(variable.min) + ' ' +
                     formatNumber(variable.max) + "]\nNumMFs=" + std::to_string(variable.terms.size()) + '\n';
  for (std::size_t t = 0; t < variable.terms.size(); ++t) {
    text += "MF" + std::to_string(t + 1) + '=' + fisTerm(variable.terms[t], variable);
  }
  return text;
}

std::size_t number(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  return static_cast<std::size_t>(findTerm(terms, id) - terms.data()) + 1;
}

std::string fisRule(const fuzzy::ForceModel& model, const fuzzy::Rule& rule) {
  std::string text;
  for (const auto& input : model.inputs) {
    std::size_t term = 0;
    for (const auto& condition : rule.conditions) {
      if (condition.input == input.id) term = number(input.terms, condition.term);
    }
    text += std::to_string(term) + (&input == &model.inputs.back() ? ", " : " ");
  }
  return text + std::to_string(number(model.output.terms, rule.then)) + " (" + formatNumber(rule.weight) + ") : 1\n";
}

std::string fisText(const fuzzy::ForceModel& model) {
  const auto& rules = model.experts.front().rules;
  const bool clip = model.implication == fuzzy::Implication::kClip;
  std::string text =
      "[System]\nName='bench'\nType='mamdani'\nVersion=2.0\nNumInputs=" + std::to_string(model.inputs.size()) +
      "\nNumOutputs=1\nNumRules=" + std::to_string(rules.size()) + "\nAndMethod='min'\nOrMethod='max'\nImpMethod='" +
      (clip ? "min" : "prod") + "'\nAggMethod='max'\nDefuzzMethod='centroid'\n";
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    text += fisVariable("Input" + std::to_string(i + 1), model.inputs[i]);
  }
  text += fisVariable("Output1", model.output) + "\n[Rules]\n";
  for (const auto& rule : rules) text += fisRule(model, rule);
  return text;
}

std::string script(const std::string& folder, int samples) {
  return "cd('" + folder +
         "');\npkg load fuzzy-logic-toolkit;\nfis = readfis('model.fis');\np = csvread('points.csv');\n"
         "best = Inf;\nfor k = 1:3\n  t = tic; y = evalfis(p, fis, " +
         std::to_string(samples) +
         "); best = min(best, toc(t));\nend\n"
         "f = fopen('forces.csv', 'w'); fprintf(f, 'force\\n'); fprintf(f, '%.17g\\n', best, y); fclose(f);\n";
}

}  // namespace

base::Result<OctaveRun> runOctave(const Case& about, std::size_t points, int samples) {
  TACTUS_CHECK(about.model.experts.size() == 1);
  const support::TempFolder folder;
  std::string rows;
  for (std::size_t p = 0; p < points; ++p) {
    std::vector<std::string> cells;
    for (const double value : about.points.row(p)) cells.push_back(formatNumber(value));
    rows += base::joined(cells, ",") + '\n';
  }
  const std::string results = folder.file("forces.csv");
  for (const auto& [file, text] : {std::pair{"model.fis", fisText(about.model)}, std::pair{"points.csv", rows},
                                   std::pair{"run.m", script(folder.file(""), samples)}}) {
    if (auto written = base::writeFileAtomically(folder.file(file), text); !written) {
      return tl::unexpected(written.error());
    }
  }
  const std::string command = "octave --no-gui --norc --quiet '" + folder.file("run.m") + "' >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) {
    return base::fail(base::ErrorCode::kIo, "", "no working Octave",
                      "octave and octave-fuzzy-logic-toolkit to be installed");
  }
  auto table = base::CsvTable::read(results);
  if (!table) return tl::unexpected(table.error());
  OctaveRun out;
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    const auto value = table->number(row, 0);
    if (!value) return tl::unexpected(value.error());
    if (row == 0) {
      out.evaluation_ns = *value * 1e9 / static_cast<double>(points);
    } else {
      out.forces_n.push_back(*value);
    }
  }
  TACTUS_CHECK(out.forces_n.size() == points);
  return out;
}

}  // namespace tactus::bench
