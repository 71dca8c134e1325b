// The status bar: connection, loading, problems, cursor, scale, rotation. All fields keep their positions.
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QStatusBar>
#include <QTimer>

#include "session/session.h"
#include "ui/kit/status_text.h"

class QToolButton;

namespace mapwright::ui {

class PlainLabel;

/// A bar of 4 px showing progress.
class ThinBar : public QWidget {
  Q_OBJECT
 public:
  explicit ThinBar(QWidget* parent = nullptr);
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  QSize sizeHint() const override { return {64, 20}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double fraction_ = 0;
};

/// A state's shape with its text.
class StateLabel : public QWidget {
  Q_OBJECT
 public:
  explicit StateLabel(QWidget* parent = nullptr);
  void setState(const StateText& state);
  const StateText& state() const { return state_; }
  /// In bold and in the colour of its mark: for important states.
  void setStrong(bool strong);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  StateText state_;
  bool strong_ = false;
};

class WindowStatusBar : public QStatusBar {
  Q_OBJECT
 public:
  explicit WindowStatusBar(QWidget* parent = nullptr);

  void setSession(session::Session* session);
  void recount() { refreshRows(); }
  /// Only counts what is on screen. `submaps_of`: the name of the map that the submaps belong to, if known.
  void setInView(bool submaps, bool whole, const QString& submaps_of);
  void showCursor(const QString& coordinates, const QString& occupancy);
  void showView(const geometry::ViewTransform& view);

  QString connectionShown() const { return connection_->state().text; }
  QString loadingShown() const;
  QString mapShown() const;
  QString cursorShown() const;
  QString occupancyShown() const;
  QString scaleShown() const;
  QString rotationShown() const;
  QToolButton* problemsButton() const { return problems_; }

 Q_SIGNALS:
  void problemsWanted();

 private:
  void refreshConnection();
  void refreshCountdown();
  void refreshRows();
  void refreshMap();
  void refreshProblems();

  QPointer<session::Session> session_;
  bool submaps_in_view_ = true, whole_in_view_ = false;
  QString submaps_of_;
  robot::ConnectionState read_;  // as of `read_clock_`
  QElapsedTimer read_clock_;
  QTimer countdown_;
  StateLabel* connection_;
  PlainLabel* loading_;
  ThinBar* bar_;
  PlainLabel* traffic_;
  PlainLabel* map_;
  ThinBar* map_bar_;
  QToolButton* problems_;
  PlainLabel *coordinates_, *occupancy_, *scale_, *rotation_;
};

}  // namespace mapwright::ui
