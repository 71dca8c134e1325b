// Lets the robot write its map to a file on its own disk: asks for the file name.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>

#include "robot/map_dispatch.h"
#include "ui/kit/status_text.h"

namespace mapwright::window {

class SaveMapDialog;

class MapSaving : public QObject {
  Q_OBJECT
 public:
  /// `parent_of_dialog` outlives this; `toast` shows the result.
  MapSaving(QWidget& parent_of_dialog, std::function<void(Mark, const QString&)> toast,
            QObject* parent = nullptr);

  /// Asks for a name first. Does nothing while the question is open.
  void ask(robot::MapDispatch* dispatch);
  bool asking() const { return !dialog_.isNull(); }
  void close();

 Q_SIGNALS:
  void changed();  // asking()

 private:
  QWidget& window_;
  std::function<void(Mark, const QString&)> toast_;
  QPointer<robot::MapDispatch> dispatch_;
  QPointer<SaveMapDialog> dialog_;
  robot::Call saving_;
};

}  // namespace mapwright::window
