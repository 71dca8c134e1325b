// What the program takes of the computer: threads and memory, now; and how much it may take from the next
// start on.
#pragma once

#include <functional>

#include <QDialog>
#include <QList>
#include <QSettings>

#include "robot/offers_topics.h"
#include "work/budgets.h"

class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace mapwright::window {

class PlainLabel;

struct Diagnostics {
  int threads = 0, running = 0, waiting = 0;  // of the crew; what runs beyond it counts, too
  work::Budgets held, allowed;
  std::optional<robot::Reception> reception = {};  // of a robot that counts
};

/// All tables as lines of words and figures between tabs.
QString textOf(const Diagnostics& diagnostics);

/// Looks again once a second as long as it is open.
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
  void copyWanted(const QString& text);

 private:
  void refresh();
  /// Cells for tables of so many rows each, in place of those before.
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

}  // namespace mapwright::window
