// Looks for haptic devices in the background: a driver can take its time.
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

  /// What was found last; before the first search the virtual device alone.
  const devices::DeviceList& list() const { return list_; }
  bool isSearching() const { return pending_.valid(); }

 public slots:
  /// Ends with `found`. Without effect while a search runs.
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
