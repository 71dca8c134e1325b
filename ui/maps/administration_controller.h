// Changes of the maps stored on the robot: rename, load, archive, delete; start, stop and save mapping. Asks
// before, and stays open until the robot has answered, so that typed text is not lost.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QDialog>
#include <QElapsedTimer>
#include <QPointer>

#include "map/catalogue.h"
#include "robot/call.h"
#include "robot/map_administration.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"
#include "ui/view/toast_stack.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTimer;

namespace mapwright::ui {

class MappingDock;

/// The question to ask before a map of the robot is changed.
struct ChangeQuestion {
  robot::MapOrder order;  // as far as known
  QString title, text, accept;
  std::optional<QString> name = {};  // asks for a name, with this initial value
  bool asks_place = false;           // asks where the robot is
  QStringList typed = {};            // one of them must be typed to prevent accidents; empty = nothing
  bool ends_something = false;       // it cannot be undone: Enter does not trigger it
  QString done = {};                 // the message on success; %1 is the new name of the map
  /// What is worth knowing of a name that may be given.
  std::function<QString(const robot::MapOrder&)> remark = {};
};

class ChangeDialog : public QDialog {
  Q_OBJECT
 public:
  using Outcome = robot::Outcome<map::CatalogueEntry>;
  using Ask = std::function<robot::Call(const robot::MapOrder&, robot::OutcomeTo<map::CatalogueEntry>)>;

  /// `ask` is called once for every press of the button, never while an answer is pending.
  ChangeDialog(ChangeQuestion question, Ask ask, QWidget* parent = nullptr);

  /// Where the robot may be, most likely first. None is preselected.
  void setPlaces(const std::vector<std::string>& names);

  QLineEdit* nameEdit() const { return name_; }    // null: not asked for
  QLineEdit* typedEdit() const { return typed_; }  // likewise
  QComboBox* places() const { return places_; }    // likewise
  QPushButton* acceptButton() const { return accept_; }
  QString textShown() const;
  QString errorShown() const;
  bool waiting() const { return call_.has_value(); }

  /// Looks again at what is typed, and says what is to be said of it.
  void check();

  void reject() override;

 Q_SIGNALS:
  /// `as_asked`: false if the robot accepted it but reports something else.
  void done(const mapwright::map::CatalogueEntry& now, const QString& said, bool as_asked);

 private:
  QString unavailableReason() const;
  std::string place() const;
  void send();
  void onOutcome(const Outcome& outcome);

  ChangeQuestion question_;
  Ask ask_;
  std::optional<robot::Call> call_;
  QLabel *text_, *error_;
  QLineEdit *name_ = nullptr, *typed_ = nullptr;
  QComboBox* places_ = nullptr;
  QPushButton *accept_, *cancel_;
};

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
  MappingDock* mappingDock() const { return mapping_dock_; }
  /// Asks the robot how its mapping is going.
  void lookAtMapping();

 Q_SIGNALS:
  /// The robot is asked for what may begin a new session, of which `sentence` is said (empty: nothing);
  /// nullopt: it was not done, or is over.
  void sessionExpected(const std::optional<QString>& sentence);

 private:
  robot::MapAdministration* maps() const;
  /// First what becomes of unsaved changes, where they would go with the map.
  void ask(robot::MapChange change, const map::CatalogueEntry* map);
  void showQuestion(robot::MapChange change, const map::CatalogueEntry* map);
  QString unconfirmed() const;
  QString withUnconfirmed(const QString& tip) const;
  ToastOffer offerToLoad(const map::CatalogueEntry& map);
  void askForPlaces(const map::MapKey& key);
  bool anyFinishedMapping() const;
  void refresh();
  void showMapping();
  void onMapping();
  void showNewMap();

  WindowContext& context_;
  struct Row {
    robot::MapChange change;
    QAction* action;
  };
  std::vector<Row> mapping_;  // of no map
  QPointer<ChangeDialog> dialog_;
  MappingDock* mapping_dock_;
  QTimer* look_;                                    // while the robot may be mapping
  std::optional<robot::MappingProgress> progress_;  // as last told
  QString trouble_;                                 // why it told nothing
  std::optional<bool> was_mapping_;                 // nullopt: not known yet
  std::optional<robot::MapChange> ended_;           // of the last mapping: Save, CancelMapping
  std::optional<map::MapKey> used_;                 // the robot's current map before the mapping
  bool new_map_shown_ = false;
  bool came_ = false, left_ = false;  // the dock, for a mapping of this robot, of the one before
  robot::Call looking_;
  QElapsedTimer noticed_;  // since was_mapping_
};

}  // namespace mapwright::ui
