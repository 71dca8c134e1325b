// Changes of the maps stored on the robot: rename, load, archive, delete; start, stop and save mapping.
#pragma once

#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/maps/change_dialog.h"
#include "ui/shell/window_context.h"

class QMenu;

namespace mapwright::window {

class AdministrationController : public Controller {
  Q_OBJECT
 public:
  explicit AdministrationController(WindowContext& context, QObject* parent = nullptr);

  void setSession(session::Session* session) override;
  /// Adds the possible changes of this map to its menu; those that are impossible now are disabled with the
  /// reason.
  void fillMenu(QMenu* menu, const map::MapKey& key);
  /// The question that is open; null = none.
  ChangeDialog* dialog() const { return dialog_; }

 private:
  robot::MapAdministration* maps() const;
  void ask(robot::MapChange change, const map::CatalogueEntry* map);
  void askForPlaces(const map::MapKey& key);
  void refresh();

  WindowContext& context_;
  struct Row {
    robot::MapChange change;
    QAction* action;
  };
  std::vector<Row> mapping_;  // of no map
  QPointer<ChangeDialog> dialog_;
};

}  // namespace mapwright::window
