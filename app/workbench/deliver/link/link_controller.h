// Serves the shown model to simulators over the live link (docs/live-link.md), from `start` to `stop`. Never by itself,
// and never remembered: each run of the program begins without it.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "app/link/link_server.h"
#include "app/link/link_sockets.h"
#include "app/workbench/base/worker.h"

namespace tactus::workbench {

class ModelController;

/// A simulator that says where it is.
struct Simulator {
  std::uint64_t client = 0;  ///< its connection
  QString name;              ///< as it says; may be empty
  link::Felt felt;           ///< the newest
  std::chrono::steady_clock::time_point heard;
};

/// Thread: gui. The server has a thread of its own, which also writes the text of each model.
class LinkController : public QObject {
  Q_OBJECT

 public:
  explicit LinkController(const ModelController& models, QObject* parent = nullptr);
  ~LinkController() override;

  bool isServing() const { return server_ != nullptr; }
  /// Where a simulator connects: `127.0.0.1:45123`; empty while nothing is served.
  QString address() const;
  /// The file with the token that it needs; empty while nothing is served.
  QString tokenFile() const;
  /// The port to serve at; 0: none is chosen. Takes effect with the next `start`.
  void choosePort(std::uint16_t port) { chosen_port_ = port; }
  /// Who is connected.
  const std::vector<link::LinkClient>& clients() const { return clients_; }
  /// When the last client left, since serving began. Nothing while one is connected, or before the first one was.
  const std::optional<QDateTime>& allLeftAt() const { return all_left_at_; }
  /// The simulators that said within the last second where they are.
  const std::vector<Simulator>& simulators() const { return simulators_; }
  /// Whether a client wants to know what the hand feels.
  bool wantsStates() const { return server_ && server_->wantsStates(); }
  /// Tells the clients what the hand feels.
  void tell(link::LinkStates states);

 public slots:
  /// Ends with `changed` or `failed`. Without a chosen port it takes the previous one if it is free, else any free one.
  void start();
  void stop();

 signals:
  /// Serving began or ended, or a client came or went.
  void changed();
  /// A simulator moved, came or went; at most 60 times a second.
  void simulatorsMoved();
  /// The last client left; after `changed`.
  void allLeft();
  /// One sentence: why nothing can be served.
  void failed(const QString& sentence);

 private:
  base::Result<void> serve(std::uint16_t port);
  void publish();
  void showClients();
  void listen();
  void hear();
  /// Forgets simulators that left or fell silent.
  void forget();

  const ModelController& models_;
  std::uint16_t chosen_port_ = 0;  ///< 0: any
  std::uint16_t port_ = 0;         ///< the previous one
  std::optional<link::TokenFile> token_;
  std::vector<link::LinkClient> clients_;
  std::optional<QDateTime> all_left_at_;
  std::vector<Simulator> simulators_;
  QTimer frame_;  ///< until the next look at what simulators said
  QTimer watch_;  ///< runs while there are simulators, which may fall silent
  CallQueue calls_;
  std::unique_ptr<link::LinkServer> server_;  ///< last: its thread ends before the queue goes
};

}  // namespace tactus::workbench
