// The program's use of threads and memory, and how long its window was busy; and the limits for the next
// start.
#pragma once

#include <functional>

#include <QDialog>
#include <QList>
#include <QSettings>

#include "robot/offers_topics.h"
#include "ui/window/stalls.h"
#include "work/budgets.h"

class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace mapwright::ui {

class PlainLabel;

struct Diagnostics {
  int threads = 0, running = 0, waiting = 0;  // of the thread pool; includes work outside of it
  work::Budgets held, allowed;
  std::optional<robot::Reception> reception = {};  // for a robot with statistics
  std::optional<Stalls> stalls = {};               // nullopt: nobody measures
};

/// All tables as tab-separated lines.
QString textOf(const Diagnostics& diagnostics);

/// Updates once a second while it is open.
class DiagnosticsDialog : public QDialog {
  Q_OBJECT
 public:
  /// `look` and `settings` outlive this.
  DiagnosticsDialog(std::function<Diagnostics()> look, QSettings& settings, QWidget* parent = nullptr);

  /// As textOf() gives it.
  QString text() const;
  QSpinBox* threadsBox() const { return threads_; }
  QSpinBox* memoryBox() const { return memory_; }
  QPushButton* copyButton() const { return copy_; }

 Q_SIGNALS:
  void copyWanted();

 private:
  void refresh();
  /// Lays out cells for tables with this many rows each, replacing the old ones.
  void layOut();
  void keep();

  std::function<Diagnostics()> look_;
  QSettings& settings_;
  QWidget* tables_ = nullptr;
  QVBoxLayout* column_;
  QList<PlainLabel*> cells_;  // in the order of the tables' cells
  QList<qsizetype> rows_;     // of each table
  QSpinBox *threads_, *memory_;
  QPushButton* copy_;
};

}  // namespace mapwright::ui
