#include "app/workbench/shell/panel_place.h"

#include <map>

namespace tactus::workbench {

std::vector<PanelPlace> placesOfPresent(const std::vector<PanelPlace>& places,
                                        const std::function<bool(const std::string& panel)>& is_there) {
  using How = PanelPlace::How;
  std::vector<PanelPlace> present;
  std::map<std::string, PanelPlace> vacant;       // places of panels that are not there
  std::map<std::string, const char*> taken_over;  // a panel that is not there -> the one in its place
  for (PanelPlace place : places) {
    const char* const panel = place.panel;
    for (auto took = taken_over.find(place.beside); took != taken_over.end(); took = taken_over.find(place.beside)) {
      place.beside = took->second;
    }
    if (!is_there(panel)) {
      vacant.emplace(panel, place);
      continue;
    }
    // The panel that stood before it is missing: behind it, take its place; beside it, stand beside what it stood at.
    for (auto gap = vacant.find(place.beside); gap != vacant.end(); gap = vacant.find(place.beside)) {
      const PanelPlace left = gap->second;
      if (place.how == How::kTab || left.how == How::kFirst) {
        taken_over.emplace(place.beside, panel);
        vacant.erase(gap);
        place = {panel, left.how, left.beside, left.percent};
      } else {
        place.beside = left.beside;
      }
    }
    present.push_back(place);
  }
  return present;
}

}  // namespace tactus::workbench
