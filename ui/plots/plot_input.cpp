// Mouse and keyboard in a plot.
#include <cmath>

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleValidator>
#include <QFormLayout>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>

#include "ui/kit/plot_ticks.h"
#include "ui/plots/field_drag.h"
#include "ui/plots/plot_widget.h"

namespace mapwright::window {

namespace {
constexpr double kZoom = 1.25;
}

void PlotWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
  grip_ = Grip{event->pos(), span_, values(), false, isOnValueAxis(event->pos())};
}

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
  const QRect area = this->area();
  const bool inside = event->pos().x() >= area.left() && event->pos().x() <= area.right();
  Q_EMIT pointed(inside ? std::optional(timeAt(event->pos().x())) : std::nullopt);
  if (!grip_) return;
  const QPoint by = event->pos() - grip_->at;
  if (!grip_->moved && by.manhattanLength() < QApplication::startDragDistance()) return;
  grip_->moved = true;
  setCursor(Qt::ClosedHandCursor);
  if (grip_->values_only || (fixed_ && !grip_->values_only)) {
    const double shift = by.y() / double(area.height()) * (grip_->values.second - grip_->values.first);
    setFixedValues(Range{grip_->values.first + shift, grip_->values.second + shift});
  }
  if (grip_->values_only) return;
  const double shift_s = -by.x() / double(area.width()) * (grip_->span.second - grip_->span.first);
  moveTime(grip_->span.first + shift_s - span_.first);
}

void PlotWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (!grip_ || (event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) return;
  const Grip grip = *std::exchange(grip_, std::nullopt);
  unsetCursor();
  if (!grip.moved && event->button() == Qt::LeftButton && area().contains(event->pos()))
    Q_EMIT seekWanted(timeAt(event->pos().x()));
}

void PlotWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setFixedValues(std::nullopt);
  if (!isOnValueAxis(event->pos())) Q_EMIT allWanted();
}

void PlotWidget::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0, across = event->angleDelta().x() / 120.0;
  const QPoint at = event->position().toPoint();
  if (event->modifiers() & Qt::ControlModifier || isOnValueAxis(at)) {
    const auto [least, greatest] = values();
    const QRect area = this->area();
    if (notches != 0)
      zoomValues(std::pow(kZoom, -notches),
                 least + (area.bottom() - at.y()) / double(area.height()) * (greatest - least));
  } else if (event->modifiers() & Qt::ShiftModifier || (notches == 0 && across != 0)) {
    moveTime(-(notches + across) * (span_.second - span_.first) / 10);
  } else if (notches != 0) {
    zoomTime(std::pow(kZoom, -notches), timeAt(at.x()));
  }
  event->accept();
}

void PlotWidget::leaveEvent(QEvent*) { Q_EMIT pointed(std::nullopt); }
void PlotWidget::focusInEvent(QFocusEvent*) { update(); }
void PlotWidget::focusOutEvent(QFocusEvent*) { update(); }

void PlotWidget::keyPressEvent(QKeyEvent* event) {
  const auto [least, greatest] = values();
  const double long_s = span_.second - span_.first, high = greatest - least;
  const double middle_s = cursor_s_ && *cursor_s_ > span_.first && *cursor_s_ < span_.second
                              ? *cursor_s_
                              : span_.first + long_s / 2;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomTime(1 / kZoom, middle_s);
    case Qt::Key_Minus:
      return zoomTime(kZoom, middle_s);
    case Qt::Key_Left:
      return moveTime(-long_s / 10);
    case Qt::Key_Right:
      return moveTime(long_s / 10);
    case Qt::Key_Up:
      return moveValues(high / 10);
    case Qt::Key_Down:
      return moveValues(-high / 10);
    case Qt::Key_Home:
      return moveTime(bounds_.first - span_.first);
    case Qt::Key_End:
      return moveTime(bounds_.second - span_.second);
    case Qt::Key_F:
      setFixedValues(std::nullopt);
      Q_EMIT allWanted();
      return;
    case Qt::Key_Delete:
      if (!curves_.empty()) Q_EMIT curveUnwanted(int(curves_.size()) - 1);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void PlotWidget::fillMenu(QMenu& menu) {
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    QString name = plotName(curves_[i].wish).left(80);
    name.replace(QLatin1Char('&'), QLatin1String("&&"));
    menu.addAction(tr("Remove %1").arg(name), this, [this, i] { Q_EMIT curveUnwanted(int(i)); });
  }
  menu.addAction(tr("Remove this plot"), this, &PlotWidget::plotUnwanted);
  menu.addSeparator();
  menu.addAction(tr("Show the whole time range"), this, &PlotWidget::allWanted);
  QAction* const fits =
      menu.addAction(tr("Values: fit automatically"), this, [this] { setFixedValues(std::nullopt); });
  fits->setCheckable(true);
  fits->setChecked(!fixed_);
  QAction* const stays =
      menu.addAction(tr("Values: keep this range"), this, [this] { setFixedValues(values()); });
  stays->setCheckable(true);
  stays->setChecked(fixed_.has_value());
  menu.addAction(tr("Values: range…"), this, &PlotWidget::askForValues);
  menu.addSeparator();
  QAction* const seconds = menu.addAction(tr("Time as seconds since the start"));
  seconds->setCheckable(true);
  seconds->setChecked(since_s_.has_value());
  connect(seconds, &QAction::toggled, this, &PlotWidget::sinceWanted);
}

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  fillMenu(menu);
  menu.exec(event->globalPos());
}

void PlotWidget::askForValues() {
  auto* const dialog = new QDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Range of values"));
  auto* const form = new QFormLayout(dialog);
  const auto [least, greatest] = values();
  const auto field = [&](const QString& label, double value, const char* name) {
    auto* const edit = new QLineEdit(valueText(value), dialog);
    edit->setObjectName(QLatin1String(name));
    form->addRow(label, edit);
    return edit;
  };
  auto* const from = field(tr("&From"), least, "from");
  auto* const until = field(tr("&To"), greatest, "until");
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
  form->addRow(buttons);
  // Accepts decimal points and commas.
  const auto number = [](const QLineEdit* edit) -> std::optional<double> {
    bool sound = false;
    double value = edit->text().trimmed().toDouble(&sound);
    if (!sound) value = QLocale().toDouble(edit->text().trimmed(), &sound);
    return sound && std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  const auto check = [=] {
    const auto a = number(from), b = number(until);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(a && b && *a < *b);
  };
  connect(from, &QLineEdit::textChanged, dialog, check);
  connect(until, &QLineEdit::textChanged, dialog, check);
  check();
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, dialog, [=, this] {
    setFixedValues(Range{*number(from), *number(until)});
    dialog->accept();
  });
  dialog->open();
}

void PlotWidget::dragEnterEvent(QDragEnterEvent* event) {
  if (wishFromMime(*event->mimeData())) event->acceptProposedAction();
}

void PlotWidget::dropEvent(QDropEvent* event) {
  const auto wish = wishFromMime(*event->mimeData());
  if (!wish) return;
  event->acceptProposedAction();
  Q_EMIT dropped(*wish);
}

}  // namespace mapwright::window
