// Whole maps on their way: downloaded into a folder, added from one, made of a picture.
#pragma once

#include <QDialog>
#include <QPointer>

#include "map/catalogue.h"
#include "robot/map_transfer.h"
#include "ui/kit/controller.h"
#include "ui/maps/new_map_dialog.h"
#include "ui/shell/window_context.h"
#include "work/workers.h"

class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;

namespace mapwright::ui {

/// A map on its way: how far it is, and what came of it.
class TransferDialog : public QDialog {
  Q_OBJECT
 public:
  TransferDialog(const QString& title, const QString& what, QWidget* parent = nullptr);

  void setCall(const robot::Call& call);
  void setProgress(const robot::Progress& progress);
  /// It stays open: `again` offers to try it again.
  void setFailed(const QString& sentence, const QString& again);
  bool failed() const { return failed_; }
  QString said() const;
  QPushButton* againButton() const { return again_; }
  QPushButton* cancelButton() const { return cancel_; }

  void reject() override;

 Q_SIGNALS:
  void againWanted();

 private:
  QLabel *what_, *said_;
  QProgressBar* bar_;
  QPushButton *again_, *cancel_;
  std::optional<robot::Call> call_;
  bool failed_ = false;
};

class TransferController : public Controller {
  Q_OBJECT
 public:
  explicit TransferController(WindowContext& context, QObject* parent = nullptr);

  void setSession(session::Session* session) override;
  /// Adds what can be done with this map to its menu.
  void fillMenu(QMenu* menu, const map::MapKey& key);
  /// Asks where to download this map to, then opens its submaps.
  void openSubmaps(const map::MapKey& key);
  /// Into this folder, which becomes a map's folder.
  /// `open`: then its submaps are opened.
  void download(const map::MapKey& key, const QString& name, const QString& folder, bool open = false);
  /// `as_new`: as another map, with a uid of its own.
  void upload(const QString& folder, bool as_new = false);
  /// Asks for the place of this picture.
  void create(const QString& path);
  TransferDialog* dialog() const { return dialog_; }       // null: none is in progress
  NewMapDialog* newMapDialog() const { return new_map_; }  // likewise

 Q_SIGNALS:
  /// A file of a map that was downloaded.
  void openWanted(const QString& path);

 private:
  robot::MapTransfer* transfer() const;
  void askWhereTo(const map::MapKey& key, bool open);
  void askForPlace(const QString& path, const QSize& size, const QImage& shown);
  /// `read` runs on another thread.
  void add(const QString& title, const QString& what,
           std::function<tl::expected<robot::NewMap, QString>()> read);
  void send(const robot::NewMap& map);
  void reportAdded(const QString& name, const QStringList& odd, const QString& also);
  /// A remark that other maps of the robot have this name; empty if none has.
  QString alsoCalledSo(const QString& name) const;
  void begin(const QString& title, const QString& what);
  void refresh();

  WindowContext& context_;
  QAction *upload_, *create_;
  QPointer<TransferDialog> dialog_;
  QPointer<NewMapDialog> new_map_;
  quint64 asked_ = 0;  // of a robot that is left nothing counts any more
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
