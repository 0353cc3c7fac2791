// Searches for haptic devices in the background, because drivers can be slow.
#pragma once

#include <QObject>
#include <QTimer>
#include <future>

#include "app/devices/device_list.h"

namespace tactus::workbench {

class DeviceSearch : public QObject {
  Q_OBJECT

 public:
  explicit DeviceSearch(QObject* parent = nullptr);

  /// The result of the last search; before the first search only the virtual device.
  const devices::DeviceList& list() const { return list_; }
  bool isSearching() const { return pending_.valid(); }

 public slots:
  /// Starts a search, which ends with `found`. Does nothing while a search is in progress.
  void search();

 signals:
  void searching();
  void found();

 private:
  void look();

  devices::DeviceList list_;
  std::future<devices::DeviceList> pending_;  ///< Its destructor waits for the search to end.
  QTimer poll_;
};

}  // namespace tactus::workbench
