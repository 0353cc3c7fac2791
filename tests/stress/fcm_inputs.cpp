#include "tests/stress/fcm_inputs.h"

#include <array>
#include <cmath>

#include "core/base/text.h"

namespace tactus::stress {
namespace {

using base::Random;

std::vector<double> plainSamples(Random& random, int count) {
  std::vector<double> out(static_cast<std::size_t>(count));
  const int kind = random.below(6);
  const double width = std::pow(10.0, random.uniform(-3, 1));
  for (std::size_t i = 0; i < out.size(); ++i) {
    double& x = out[i];
    switch (kind) {
      case 0: x = random.uniform(-50, 350); break;
      case 1: x = 100 * random.below(4) + width * random.normal(); break;
      case 2: x = random.below(8); break;
      case 3: x = i % 2 == 0 ? 20 * random.normal() : -out[i - 1]; break;
      case 4: x = std::abs(random.normal()) * std::exp(random.normal()); break;
      default: x = random.below(10) == 0 ? random.uniform(0, 3) : 1.25;
    }
  }
  return out;
}

void addTraps(Random& random, std::vector<double>& samples) {
  const auto any = [&]() -> double& {
    return samples[static_cast<std::size_t>(random.below(static_cast<int>(samples.size())))];
  };
  if (random.below(8) == 0) any() = random.below(2) == 0 ? 1e6 : -1e6;
  if (random.below(8) == 0) any() = any();
  if (random.below(16) == 0) any() = std::nextafter(any(), 1e300);
  constexpr std::array kOffsets = {1e3, -1e6, 1e9, 1e15};
  constexpr std::array kScales = {1e-160, 1e-30, 1e30, 1e160};
  const double offset = random.below(6) == 0 ? kOffsets[static_cast<std::size_t>(random.below(4))] : 0;
  const double scale = random.below(6) == 0 ? kScales[static_cast<std::size_t>(random.below(4))] : 1;
  for (double& x : samples) x = (x + offset) * scale;
}

std::vector<double> randomWeights(Random& random, std::size_t count) {
  std::vector<double> out(count);
  for (double& weight : out) weight = random.below(5) == 0 ? 0 : std::exp(random.normal());
  out[0] = 1;
  return out;
}

std::string list(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  texts.reserve(numbers.size());
  for (const double number : numbers) texts.push_back(base::formatNumber(number));
  return base::joined(texts, ", ");
}

}  // namespace

std::string FcmInput::describe() const {
  return "c = " + std::to_string(clusters) + ", m = " + base::formatNumber(m) + "\nsamples: " + list(samples) +
         (weights.empty() ? "" : "\nweights: " + list(weights)) + '\n';
}

FcmInput randomFcmInput(Random& random) {
  constexpr std::array kM = {1.01, 1.05, 1.2, 1.5, 1.7, 2.5, 3.0, 4.0, 5.0, 6.0, 10.0};
  FcmInput out;
  out.samples = plainSamples(random, 1 + random.below(random.below(2) == 0 ? 12 : 40));
  addTraps(random, out.samples);
  if (random.below(4) == 0) out.weights = randomWeights(random, out.samples.size());
  out.clusters = 1 + static_cast<std::size_t>(random.below(6));
  out.m = random.below(2) == 0 ? 2.0 : kM[static_cast<std::size_t>(random.below(static_cast<int>(kM.size())))];
  return out;
}

}  // namespace tactus::stress
