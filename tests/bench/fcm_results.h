// What the benchmark of the clustering found, and how it is written down.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tactus::bench {

struct FcmRow {
  std::string part;  ///< comparison, samples, clusters, fuzziness
  std::size_t samples = 0;
  std::size_t clusters = 3;
  double m = 2;
  std::string method;
  double median_ms = 0;
  double min_ms = 0;
  std::optional<double> error;  ///< largest distance of a centre from the reference, mm/s
  std::optional<double> reads;  ///< median in reads of the same data once
  std::optional<double> ratio;  ///< median of e1071 with reltol 1e-15 on the same data by this median
};

struct FcmResults {
  std::vector<std::string> circumstances;
  std::vector<FcmRow> rows;
};

std::string fcmTables(const FcmResults& results);
std::string fcmCsv(const FcmResults& results);

}  // namespace tactus::bench
