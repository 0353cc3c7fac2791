// Chromium without a window and without a network, for tests of pages.
#pragma once

#include <optional>
#include <string>

namespace tactus::support {

/// Whether Chromium is installed.
bool hasChromium();

/// The page `file` after its scripts have run, as text.
std::string renderedPage(const std::string& file);

/// The number of printed pages of `file` as the page itself says, A4. Writes `pdf`. Nothing if it was not printed.
std::optional<int> printedPages(const std::string& file, const std::string& pdf);

}  // namespace tactus::support
