// Asks which robot to connect to: by its kind, by a host where robots are looked for, or by a complete
// address.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QDialog>

#include "robot/probe.h"
#include "ui/robot/recent_robots.h"
#include "ui/robot/robot_look.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace mapwright::ui {

class FoundRobots;

class ConnectDialog : public QDialog {
  Q_OBJECT
 public:
  struct Wish {
    QString address;
    QByteArray secret;
    RobotLook look;
  };
  /// Starts a connection; returns a sentence if that is impossible.
  using Attempt = std::function<std::optional<QString>(const Wish& wish)>;
  /// The questions that tell which robots answer at a host; null: a host alone is a complete address.
  using Probes = std::function<std::vector<robot::Probe>(const robot::Host& host)>;

  /// `recents` must outlive the dialog.
  ConnectDialog(RecentRobots& recents, Attempt attempt, Probes probes = {}, QWidget* parent = nullptr);

  void setAddress(const QString& address);
  /// For a robot that refused: shows its address with `why`, and puts the cursor into the secret field.
  /// `look`: what the user called it when it refused.
  void askForSecret(const QString& address, const QString& why, const RobotLook& look);
  QString errorText() const;

 private:
  QWidget* buildForm();
  QWidget* buildRecents();
  void fillRecents();
  void showRecent(const QString& address);
  void chooseKind();
  /// A kind was chosen for a whole address of another one: its host stays.
  void splitAddress();
  /// A port that is none is being typed.
  bool portBeyond() const;
  QString hint(const QString& made, const std::optional<robot::Host>& host) const;
  void check();  // while typing: does not complain about unfinished input
  void go();     // what the main button does now
  void search(const robot::Host& host);
  void start(const QString& address, const QByteArray& secret);
  void setError(const QString& sentence);
  void updateLook();

  const robot::AddressScheme* kind() const;  // null: it is found out
  /// What the fields say; empty: not enough.
  QString address() const;
  /// Where robots have to be looked for first.
  std::optional<robot::Host> unknownHost() const;

  RecentRobots& recents_;
  Attempt attempt_;
  Probes probes_;
  QComboBox* kind_;
  QLineEdit* address_;
  QSpinBox* port_;
  QCheckBox* encrypted_;
  QLabel* made_;  // the address that results
  QLineEdit* secret_;
  QLabel* error_;
  LookFields look_;
  QStackedWidget* below_;
  QWidget* recents_page_;
  QListWidget* list_;
  FoundRobots* found_;
  QPushButton* connect_;
};

}  // namespace mapwright::ui
