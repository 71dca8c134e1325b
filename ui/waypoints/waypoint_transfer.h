// Waypoints in and out of the window: copied between maps and to spreadsheets, pasted, imported from files
// and exported. What comes from outside is shown before it changes anything. GUI thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QDialog>
#include <QLabel>
#include <QObject>
#include <QPointer>
#include <tl/expected.hpp>

#include "exchange/waypoint_file.h"
#include "exchange/waypoint_plan.h"
#include "map/catalogue.h"
#include "ui/shell/window_context.h"
#include "ui/view/map_tool.h"
#include "ui/waypoints/waypoint_editing.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QTableWidget;

namespace mapwright::ui {

/// The imported data, unparsed.
struct ImportSource {
  exchange::WaypointFormat format = exchange::WaypointFormat::Table;
  QString name;      // of the file; empty = the clipboard
  std::string text;  // untrusted
};

/// What a file or a pasted table would change, with options for reading it.
class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  using Edits = std::vector<exchange::WaypointEdit>;
  /// `kept`: the present waypoints; `keeps`: what the store can keep.
  ImportDialog(ImportSource source, exchange::WaypointItems kept, const robot::KeptFields& keeps,
               QWidget* parent = nullptr);

  QTableWidget* table() const { return table_; }
  QCheckBox* headerBox() const { return header_; }
  QCheckBox* commaBox() const { return comma_; }
  QComboBox* turnChoice() const { return turns_; }
  QCheckBox* othersBox() const { return others_; }
  QPushButton* applyButton() const { return apply_; }
  QString statusShown() const { return status_->text(); }

 Q_SIGNALS:
  void chosen(const std::vector<mapwright::exchange::WaypointEdit>& edits);

 private:
  bool isTable() const;
  void look();
  void fill(const std::vector<exchange::WaypointStep>& steps);

  ImportSource source_;
  exchange::WaypointItems kept_;
  robot::KeptFields keeps_;
  Edits edits_;
  QTableWidget* table_;
  QLabel* status_;
  QCheckBox *header_, *comma_, *others_;
  QComboBox *separator_, *turns_;
  QPushButton* apply_;
};

class WaypointTransfer : public QObject {
  Q_OBJECT
 public:
  /// GeoJSON of what was copied, as other windows of this program take it.
  static constexpr const char* kMime = "application/x-mapwright-waypoints";

  /// All must outlive this. While `tool` is in the hand, Ctrl+C and Ctrl+V on the map are about waypoints.
  WaypointTransfer(WindowContext& context, WaypointEditing* editing, const MapTool* tool, QObject* parent);
  /// Which map they are of; nullopt = none.
  void setMap(const std::optional<map::MapKey>& map) { map_ = map; }

  /// What is selected: for other maps, and as a table between tabs.
  void copy();
  /// Waypoints of this program at once, as one command; a table after a look at what it changes.
  void paste();
  void importFile(const QString& path);
  /// Waypoints of another map of the site, at their places on this one: new ones, as one command. Their keys
  /// in this order; empty: nothing has changed, and the user was told why.
  std::vector<edit::Key> carryOver(const std::vector<map::Waypoint>& points);
  /// All of the list; .csv is CSV, else GeoJSON.
  void exportTo(const QString& path);
  ImportDialog* dialog() const { return dialog_; }  // null = none is open

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addActions();
  void refresh();
  void ask(ImportSource source);
  void pasteCopied(std::vector<exchange::WantedWaypoint> points);
  /// As new ones, under free names; the ids are their keys. `what` and `made` have %1 for what it is about.
  /// The error is a sentence.
  tl::expected<void, QString> addNew(std::vector<exchange::WantedWaypoint> points, const QString& what,
                                     const QString& made);
  void say(bool good, const QString& text);
  std::vector<map::Waypoint> listed(const std::set<edit::Key>* only) const;

  WindowContext& context_;
  WaypointEditing* editing_;
  const MapTool* tool_;
  std::optional<map::MapKey> map_;
  QPointer<ImportDialog> dialog_;
  QAction *copy_ = nullptr, *paste_ = nullptr, *import_ = nullptr, *export_ = nullptr;
};

}  // namespace mapwright::ui
