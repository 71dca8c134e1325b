// Asks which robot to connect to.
#pragma once

#include <functional>
#include <optional>

#include <QDialog>

#include "window/dialogs/recent_robots.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace mapwright::window {

class ConnectDialog : public QDialog {
  Q_OBJECT
 public:
  /// Tries to start a connection; the answer is a sentence when it could not even start.
  using Attempt = std::function<std::optional<QString>(const QString& address, const QByteArray& secret)>;

  /// `recents` must outlive the dialog.
  ConnectDialog(RecentRobots& recents, Attempt attempt, QWidget* parent = nullptr);

  void setAddress(const QString& address);
  /// For a robot that refused: its address stands there, `why` beside it, the cursor is where the secret
  /// goes.
  void askForSecret(const QString& address, const QString& why);
  QString errorText() const;

 private:
  QWidget* buildForm();
  QWidget* buildRecents();
  void fillRecents();
  void check();  // while typing: no complaint about what is not finished
  void start(const QString& address, const QByteArray& secret);
  void setError(const QString& sentence);

  RecentRobots& recents_;
  Attempt attempt_;
  QLineEdit* address_;
  QLineEdit* secret_;
  QLabel* error_;
  QListWidget* list_;
  QPushButton* connect_;
};

}  // namespace mapwright::window
