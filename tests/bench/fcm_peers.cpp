#include "tests/bench/fcm_peers.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"

#include "tests/support/temp_folder.h"

namespace tactus::bench {
namespace {

using base::quoted;
using base::Result;

/// Runs `script` with `command` in a folder that holds samples.bin (doubles); it leaves result.csv there: a column of
/// as many times in seconds as repetitions, then the centres.
Result<FcmPeerRun> runScript(const std::vector<double>& samples, const std::string& script, const std::string& command,
                             int repetitions, const std::string& wanted) {
  const support::TempFolder folder;
  const std::string_view bytes(reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(double));
  for (const auto& [file, text] :
       {std::pair<std::string, std::string_view>{"samples.bin", bytes}, {"script", script}}) {
    if (auto written = base::writeFileAtomically(folder.file(file), text); !written) {
      return tl::unexpected(written.error());
    }
  }
  const std::string line = "cd '" + folder.file("") + "' && " + command + " >/dev/null 2>&1";
  if (std::system(line.c_str()) != 0) {
    return base::fail(base::ErrorCode::kIo, "", "a failure of " + command, wanted + " to be installed");
  }
  const auto table = base::CsvTable::read(folder.file("result.csv"));
  if (!table) return tl::unexpected(table.error());
  FcmPeerRun out;
  std::vector<double> times_ms;
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    const auto value = table->number(row, 0);
    if (!value) return tl::unexpected(value.error());
    if (row < static_cast<std::size_t>(repetitions)) {
      times_ms.push_back(*value * 1e3);
    } else {
      out.centres.push_back(*value);
    }
  }
  std::sort(times_ms.begin(), times_ms.end());
  out.median_ms = times_ms[times_ms.size() / 2];
  out.min_ms = times_ms.front();
  return out;
}

}  // namespace

Result<FcmPeerRun> runE1071(const std::vector<double>& samples, std::size_t clusters, const std::string& control,
                            int repetitions) {
  const std::string script =
      "library(e1071)\n"
      "x <- matrix(readBin('samples.bin', 'double', n = " +
      std::to_string(samples.size()) + "), ncol = 1)\nset.seed(1)\nk <- " + std::to_string(clusters) +
      "\ncmeans(x[1:1000, , drop = FALSE], k)\ntimes <- c()\nfor (i in 1:" + std::to_string(repetitions) +
      ") {\n  start <- sum(proc.time()[1:2])\n  r <- cmeans(x, k, iter.max = 1000, m = 2, control = " + control +
      ")\n  times <- c(times, sum(proc.time()[1:2]) - start)\n}\n"
      "writeLines(c('value', sprintf('%.17g', c(times, r$centers[, 1]))), 'result.csv')\n";
  return runScript(samples, script, "Rscript --vanilla script", repetitions, "R and its package e1071");
}

Result<FcmPeerRun> runOctaveFcm(const std::vector<double>& samples, std::size_t clusters, int repetitions) {
  const std::string script =
      "pkg load fuzzy-logic-toolkit;\nf = fopen('samples.bin'); x = fread(f, Inf, 'double'); fclose(f);\n"
      "rand('twister', 1);\ntimes = [];\nfor i = 1:" +
      std::to_string(repetitions) + "\n  t = cputime(); v = fcm(x, " + std::to_string(clusters) +
      ", [2.0, 100, 1e-5, 0]); times(end + 1) = cputime() - t;\nend\n"
      "f = fopen('result.csv', 'w'); fprintf(f, 'value\\n'); fprintf(f, '%.17g\\n', times, v); fclose(f);\n";
  return runScript(samples, script, "octave --no-gui --norc --quiet script", repetitions,
                   "octave and octave-fuzzy-logic-toolkit");
}

std::string e1071Version() {
  const support::TempFolder folder;
  const std::string file = folder.file("version");
  const std::string line =
      "Rscript --vanilla -e \"cat(as.character(packageVersion('e1071')), R.version.string, sep = ', ')\" >'" + file +
      "' 2>/dev/null";
  if (std::system(line.c_str()) != 0) return {};
  const auto text = base::readFile(file, 1000);
  return text ? std::string(base::trimmed(*text)) : std::string();
}

}  // namespace tactus::bench
