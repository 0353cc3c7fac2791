// The places of panels in the default layout of a stage.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tactus::workbench {

struct PanelPlace {
  enum class How {
    kFirst,  ///< takes the whole area
    kRight,  ///< the right part of the place of `beside`
    kBelow,  ///< the lower part of the place of `beside`
    kTab,    ///< a tab behind `beside`
  };
  const char* panel = "";  ///< id given to PanelArea::addPanel
  How how = How::kFirst;
  const char* beside = "";
  int percent = 50;  ///< of the place of `beside`, for this panel
};

/// `places` without the panels that are missing. The first tab behind a missing panel takes its place; the panels
/// beside it take the space.
std::vector<PanelPlace> placesOfPresent(const std::vector<PanelPlace>& places,
                                        const std::function<bool(const std::string& panel)>& is_there);

}  // namespace tactus::workbench
