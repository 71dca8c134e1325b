// A preview of the changes that a file or a pasted table makes to the waypoints, with options for reading it.
// GUI thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QDialog>

#include "exchange/waypoint_table.h"
#include "exchange/waypoint_plan.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace mapwright::window {

/// The imported data, unparsed.
struct ImportSource {
  enum class Kind { Table, GeoJson };
  Kind kind = Kind::Table;
  QString name;      // of the file; empty = the clipboard
  std::string text;  // untrusted
};

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
  QString statusShown() const;

 Q_SIGNALS:
  void chosen(const std::vector<mapwright::exchange::WaypointEdit>& edits);

 private:
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

}  // namespace mapwright::window
