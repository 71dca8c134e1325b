// The maps that the robot keeps: search, look, compare. Opening one changes nothing on the robot.
#pragma once

#include <QDockWidget>
#include <QPointer>

#include "session/session.h"
#include "window/docks/maps_model.h"

class QLabel;
class QLineEdit;
class QListView;
class QMenu;
class QPushButton;
class QToolButton;

namespace mapwright::window {

class PlainLabel;

class MapsDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit MapsDock(QWidget* parent = nullptr);
  ~MapsDock() override;
  void setSession(session::Session* session);

  MapsModel* model() const { return model_; }
  QListView* list() const { return list_; }
  QLineEdit* search() const { return search_; }
  QToolButton* refreshButton() const { return refresh_; }
  QPushButton* retryButton() const { return retry_; }
  /// The sentence under the list: as of when, or what is wrong.
  QString statusShown() const;
  /// What stands in the place of rows; empty while there are some.
  QString emptyShown() const;

 Q_SIGNALS:
  void openWanted(const mapwright::map::MapKey& key);
  void compareWanted(const mapwright::map::MapKey& key);
  void exportWanted(const mapwright::map::MapKey& key);
  /// What was fetched is not needed any more.
  void forgetWanted(const mapwright::map::MapKey& key);
  void copyWanted(const QString& text, const QString& what);
  /// The menu of this map is about to be shown: others put entries into it.
  void menuOpening(QMenu* menu, const mapwright::map::MapKey& key);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void showMenu(const QPoint& at);
  QString emptyText() const;

  QPointer<session::Session> session_;
  MapsModel* model_;
  QLineEdit* search_;
  QToolButton* refresh_;
  QListView* list_;
  QLabel *empty_, *status_;
  QPushButton* retry_;
};

}  // namespace mapwright::window
