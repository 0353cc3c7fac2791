#include "tests/support/chromium.h"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace tactus::support {
namespace {

/// No host has an address, so every request fails.
std::string command(const std::string& more) {
  return "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage "
         "--host-resolver-rules='MAP * ~NOTFOUND' " +
         more;
}

std::string bytesOf(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

}  // namespace

bool hasChromium() { return std::system("chromium --version >/dev/null 2>&1") == 0; }

std::string renderedPage(const std::string& file) {
  const std::string out = file + ".dom";
  const std::string profile = file + ".profile";
  const std::string run = command("--user-data-dir=" + profile + " --virtual-time-budget=5000 --dump-dom file://" +
                                  file + " >" + out + " 2>/dev/null");
  if (std::system(run.c_str()) != 0) return {};
  return bytesOf(out);
}

std::optional<int> printedPages(const std::string& file, const std::string& pdf) {
  const std::string run = command("--user-data-dir=" + pdf + ".profile --no-pdf-header-footer --print-to-pdf=" + pdf +
                                  " file://" + file + " >/dev/null 2>&1");
  if (std::system(run.c_str()) != 0) return std::nullopt;
  const std::string bytes = bytesOf(pdf);
  const std::string page = "/Type /Page";
  int count = 0;
  for (std::size_t at = bytes.find(page); at != std::string::npos; at = bytes.find(page, at + 1)) {
    if (std::isalpha(static_cast<unsigned char>(bytes[at + page.size()])) == 0) ++count;
  }
  return count;
}

}  // namespace tactus::support
