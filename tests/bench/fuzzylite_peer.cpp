#include "tests/bench/fuzzylite_peer.h"

#include <fl/Headers.h>
#include <memory>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::bench {
namespace {

using fuzzy::Shape;

// fuzzylite takes ownership of what is added to it.
void addTerms(fl::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  for (const fuzzy::Term& term : terms) {
    const auto& p = term.points;
    TACTUS_CHECK(term.shape != Shape::kGaussian);
    if (term.shape == Shape::kTrapezoid) {
      variable.addTerm(new fl::Trapezoid(term.id, p[0], p[1], p[2], p[3]));
    } else {
      variable.addTerm(new fl::Triangle(term.id, p[0], p[1], p[2]));
    }
  }
}

std::string ruleText(const fuzzy::Rule& rule, const std::string& output) {
  std::vector<std::string> conditions;
  for (const auto& condition : rule.conditions) conditions.push_back(condition.input + " is " + condition.term);
  std::string text = "if " + base::joined(conditions, " and ") + " then " + output + " is " + rule.then;
  if (rule.weight != 1) text += " with " + base::formatNumber(rule.weight);
  return text;
}

std::shared_ptr<fl::Engine> engineOf(const fuzzy::ForceModel& model, int resolution) {
  const fuzzy::Expert& expert = model.experts.front();
  auto engine = std::make_shared<fl::Engine>();
  for (const fuzzy::Variable& variable : model.inputs) {
    auto* const input = new fl::InputVariable(variable.id, variable.min, variable.max);
    addTerms(*input, termsFor(expert, variable));
    engine->addInputVariable(input);
  }
  auto* const output = new fl::OutputVariable(model.output.id, model.output.min, model.output.max);
  addTerms(*output, termsFor(expert, model.output));
  output->setAggregation(new fl::Maximum);
  output->setDefuzzifier(new fl::Centroid(resolution));
  engine->addOutputVariable(output);

  auto* const block = new fl::RuleBlock;
  block->setConjunction(new fl::Minimum);
  if (model.implication == fuzzy::Implication::kClip) {
    block->setImplication(new fl::Minimum);
  } else {
    block->setImplication(new fl::AlgebraicProduct);
  }
  block->setActivation(new fl::General);
  for (const fuzzy::Rule& rule : expert.rules) {
    if (rule.enabled) block->addRule(fl::Rule::parse(ruleText(rule, model.output.id), engine.get()));
  }
  engine->addRuleBlock(block);
  TACTUS_CHECK(engine->isReady());
  return engine;
}

}  // namespace

std::string fuzzyliteVersion() { return "version " + fl::fuzzylite::version(); }

PeerEvaluator fuzzylitePeer(const fuzzy::ForceModel& model, int resolution) {
  const auto engine = engineOf(model, resolution);
  return [engine, inputs = engine->inputVariables(), output = engine->getOutputVariable(0)](
             std::span<const double> rows, std::span<double> out) {
    const std::size_t width = inputs.size();
    for (std::size_t p = 0; p < out.size(); ++p) {
      for (std::size_t i = 0; i < width; ++i) inputs[i]->setValue(rows[p * width + i]);
      engine->process();
      out[p] = output->getValue();
    }
  };
}

}  // namespace tactus::bench
