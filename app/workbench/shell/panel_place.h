// Where panels stand in the first layout of a stage.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tactus::workbench {

struct PanelPlace {
  enum class How {
    kFirst,  ///< takes all there is
    kRight,  ///< the right part of what `beside` had
    kBelow,  ///< the lower part of what `beside` had
    kTab,    ///< behind `beside`
  };
  const char* panel = "";  ///< name given to PanelArea::addPanel
  How how = How::kFirst;
  const char* beside = "";
  int percent = 50;  ///< of what `beside` had, for this panel
};

/// `places` without the panels that are not there: the first panel that stood behind such a one takes its place, and
/// what stood beside it moves up.
std::vector<PanelPlace> placesOfPresent(const std::vector<PanelPlace>& places,
                                        const std::function<bool(const std::string& panel)>& is_there);

}  // namespace tactus::workbench
