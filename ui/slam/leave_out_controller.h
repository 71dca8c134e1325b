// Asks what to leave out of the state file that is open, and writes the new file.
#pragma once

#include <vector>

#include <QDialog>
#include <QPointer>

#include "map/graph_parts.h"
#include "ui/kit/background_run.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

class QButtonGroup;
class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;

namespace mapwright::ui {

struct ClosureRow;

struct LeaveOutChoice {
  QString text;  // "Submap 0-4"
  QString note;  // what goes with it: sentences
  QString file;  // "submap-0-4": of the proposed name
  map::GraphParts parts;
};

class LeaveOutDialog : public QDialog {
  Q_OBJECT
 public:
  /// `choices`: at least one, the first is proposed. `folder`: where the new file is proposed.
  LeaveOutDialog(const QString& from, std::vector<LeaveOutChoice> choices, const QString& folder,
                 const std::shared_ptr<work::Workers>& workers, QWidget* parent = nullptr);

  QButtonGroup* choices() const { return group_; }
  QLineEdit* pathEdit() const { return path_; }
  QPushButton* writeButton() const { return write_; }
  QPushButton* openButton() const { return open_; }
  QPushButton* cancelButton() const { return cancel_; }
  /// What goes, what is done, or what is wrong.
  QString noteText() const;
  QString saidText() const;

  void reject() override;

 Q_SIGNALS:
  void written(const QString& path);
  void openWanted(const QString& path);

 private:
  void sync();
  void browse();
  void start();
  void setRunning(bool running);
  void say(const QString& text, bool wrong);
  void onWritten(const QString& path, const QStringList& said);
  void onFailed(const QString& why);

  const QString from_, folder_;
  const std::vector<LeaveOutChoice> choices_;
  QString proposed_, written_;
  QWidget* form_;
  QButtonGroup* group_;
  QLabel *note_, *said_;
  QLineEdit* path_;
  QProgressBar* progress_;
  QPushButton *write_, *open_, *cancel_;
  BackgroundRun run_;
};

class LeaveOutController : public Controller {
  Q_OBJECT
 public:
  explicit LeaveOutController(WindowContext& context, QObject* parent = nullptr);

  /// Adds the entry to the menu of a constraint; of one without node: of its submap.
  void addForClosure(QMenu* menu, const ClosureRow& row);
  /// `whole`: they are all of their trajectory.
  void addForSubmaps(QMenu* menu, const std::vector<map::SubmapId>& ids, bool whole);
  LeaveOutDialog* dialog() const { return dialog_; }  // null: not open

 Q_SIGNALS:
  void openWanted(const QString& path);

 private:
  void add(QMenu& menu, const QString& text, std::vector<LeaveOutChoice> choices);
  void ask(const std::vector<LeaveOutChoice>& choices);

  WindowContext& context_;
  QPointer<LeaveOutDialog> dialog_;
};

}  // namespace mapwright::ui
