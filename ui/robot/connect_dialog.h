// Asks which robot to connect to.
#pragma once

#include <functional>
#include <optional>

#include <QDialog>

#include "ui/robot/recent_robots.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace mapwright::window {

class ConnectDialog : public QDialog {
  Q_OBJECT
 public:
  /// Starts a connection; returns a sentence if that is impossible.
  using Attempt = std::function<std::optional<QString>(const QString& address, const QByteArray& secret)>;

  /// `recents` must outlive the dialog.
  ConnectDialog(RecentRobots& recents, Attempt attempt, QWidget* parent = nullptr);

  void setAddress(const QString& address);
  /// For a robot that refused: shows its address with `why`, and puts the cursor into the secret field.
  void askForSecret(const QString& address, const QString& why);
  QString errorText() const;

 private:
  QWidget* buildForm();
  QWidget* buildRecents();
  void fillRecents();
  void check();  // while typing: does not complain about unfinished input
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
