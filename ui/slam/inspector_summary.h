// The head of the SLAM inspector: the session in numbers.
#pragma once

#include <QWidget>

#include "session/session.h"

class QGridLayout;
class QToolButton;

namespace mapwright::window {

class PlainLabel;

class InspectorSummary : public QWidget {
  Q_OBJECT
 public:
  explicit InspectorSummary(QWidget* parent = nullptr);
  /// null = no robot: dashes everywhere.
  void refresh(const session::Session* session);

 Q_SIGNALS:
  void copyWanted(const QString& text, const QString& what);

 private:
  PlainLabel* addRow(QGridLayout* grid, const QString& name, int columns = 2);
  PlainLabel *state_, *uuid_, *submaps_, *cache_, *fetches_, *transferred_;
  QToolButton* copy_;
};

/// "positioning, reliable": the SLAM state reported by the robot, in words.
QString slamStateText(const session::Session& session);

}  // namespace mapwright::window
