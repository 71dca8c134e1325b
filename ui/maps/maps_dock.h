// The maps stored on the robot: search, view, compare. Opening one changes nothing on the robot.
#pragma once

#include <QDockWidget>
#include <QPointer>

#include "session/session.h"
#include "ui/maps/maps_model.h"

class QLabel;
class QLineEdit;
class QListView;
class QMenu;
class QPushButton;
class QToolButton;

namespace mapwright::ui {

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
  /// The sentence under the list: its time, or what is wrong.
  QString statusShown() const;
  /// The text shown instead of rows; empty while there are rows.
  QString emptyShown() const;

 Q_SIGNALS:
  void openWanted(const mapwright::map::MapKey& key);
  /// To be downloaded, and opened.
  void submapsWanted(const mapwright::map::MapKey& key);
  void compareWanted(const mapwright::map::MapKey& key);
  void alignWanted(const mapwright::map::MapKey& key);
  void exportWanted(const mapwright::map::MapKey& key);
  /// The fetched map is no longer needed.
  void forgetWanted(const mapwright::map::MapKey& key);
  void copyWanted(const QString& text, const QString& what);
  /// The menu of this map is about to open: others may add entries.
  void menuOpening(QMenu* menu, const mapwright::map::MapKey& key);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void activate(const QModelIndex& index);
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

}  // namespace mapwright::ui
