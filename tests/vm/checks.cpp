#include "tests/vm/checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tactus::vm {

bool Checks::expect(bool good, const std::string& sentence) {
  ++made_;
  if (good) return true;
  ++failed_;
  std::printf("FAIL %s: %s\n", model_.c_str(), sentence.c_str());
  std::fflush(stdout);
  return false;
}

bool Checks::near(double found, double wanted, double tolerance, const std::string& what) {
  const bool good = std::abs(found - wanted) <= tolerance;
  return expect(good, what + " is " + std::to_string(found) + " instead of " + std::to_string(wanted));
}

bool Checks::atMost(double found, double most, const std::string& what) {
  const std::string sentence = what + ": " + std::to_string(found) + ", at most " + std::to_string(most) + " expected";
  return expect(found >= 0 && found <= most, sentence);
}

void Checks::number(const std::string& what, double value, const std::string& unit) {
  std::printf("NUMBER %s: %s %.6g %s\n", model_.c_str(), what.c_str(), value, unit.c_str());
  std::fflush(stdout);
}

void Checks::finish() const {
  std::printf("RESULT %s %s (%d checks, %d failed)\n", failed_ == 0 && made_ > 0 ? "PASS" : "FAIL", model_.c_str(),
              made_, failed_);
  std::fflush(stdout);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(at));
  return values[at];
}

}  // namespace tactus::vm
