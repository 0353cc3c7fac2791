// What one descriptor was found to do, said line by line on the guest's console.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tactus::vm {

class Checks {
 public:
  explicit Checks(std::string model) : model_(std::move(model)) {}

  /// Says what is wrong unless `good`. Returns `good`.
  bool expect(bool good, const std::string& sentence);
  /// |found - wanted| <= tolerance.
  bool near(double found, double wanted, double tolerance, const std::string& what);
  /// 0 <= found <= most.
  bool atMost(double found, double most, const std::string& what);
  /// A measured number, for the README and for the reader.
  void number(const std::string& what, double value, const std::string& unit);
  /// Says RESULT PASS or RESULT FAIL.
  void finish() const;

 private:
  std::string model_;
  int made_ = 0;
  int failed_ = 0;
};

/// The value that `share` of all do not exceed; 0 without any.
double quantile(std::vector<double> values, double share);

}  // namespace tactus::vm
