// The text of a message. Numbers in it can be dragged into a plot, or added by the menu.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QMimeData>
#include <QPlainTextEdit>

#include "ui/plots/plot_selection.h"

namespace mapwright::ui {

struct FieldAt {
  series::FieldPath path;
  qsizetype from = 0, until = 0;  // range of its value in the text
};

/// `text` is JSON formatted by prettyJson(): strings and its end may be truncated. nullopt: there is no
/// number, boolean or null at `offset`, nor the key of one.
std::optional<FieldAt> fieldAt(const QString& text, qsizetype offset, const QString& topic);

class MessageView : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit MessageView(QWidget* parent = nullptr);

  /// The topic of the message; empty = nothing can be plotted.
  void setTopic(const QString& topic) { topic_ = topic; }
  /// The field at a point of the viewport.
  std::optional<FieldAt> fieldBelow(const QPoint& at) const;
  /// Performs the drag; for tests. None = the system.
  std::function<void(std::unique_ptr<QMimeData>)> carry;

 Q_SIGNALS:
  void plotWanted(const mapwright::ui::PlotSelection& selection);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  QString topic_;
  std::optional<FieldAt> pressed_;
  QPoint pressed_at_;
};

}  // namespace mapwright::ui
