#include "ui/plots/plot_widget.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>

#include "ui/kit/plot_ticks.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {
constexpr double kPlotMargin = 0.06, kShortest_s = 0.01;
constexpr double kZoom = 1.25;
}  // namespace

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAcceptDrops(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Plot"));
}

void PlotWidget::setCurves(std::vector<PlotCurve> curves) {
  curves_ = std::move(curves);
  QStringList names;
  for (const PlotCurve& curve : curves_) names << plotName(curve.selection);
  setAccessibleDescription(words::listed(names));
  refresh();
}

void PlotWidget::refresh() {
  stale_ = true;
  auto_.reset();
  update();
}

void PlotWidget::setSpan(Range span) {
  if (!(span.second - span.first >= kShortest_s / 2) || span == span_) return;
  span_ = span;
  refresh();
}

void PlotWidget::setCurrent(std::optional<double> at_s) {
  if (std::exchange(cursor_s_, at_s) != at_s) update();
}

void PlotWidget::setPresent(std::optional<double> at_s) {
  if (std::exchange(present_s_, at_s) != at_s) update();
}

void PlotWidget::setPointed(std::optional<double> at_s) {
  if (std::exchange(pointed_s_, at_s) != at_s) update();
}

void PlotWidget::setFixedValues(std::optional<Range> values) {
  if (values && !(values->first < values->second && std::isfinite(values->second - values->first))) return;
  if (std::exchange(fixed_, values) != values) refresh();
}

void PlotWidget::setSince(std::optional<double> since_s) {
  if (std::exchange(since_s_, since_s) != since_s) refresh();
}

void PlotWidget::setHint(const QString& hint) {
  if (std::exchange(hint_, hint) != hint) refresh();
}

PlotWidget::Range PlotWidget::autoValues() const {
  std::optional<Range> all;
  const auto add = [&](double least, double greatest) {
    all = all ? Range{std::min(all->first, least), std::max(all->second, greatest)} : Range{least, greatest};
  };
  for (const PlotCurve& curve : curves_) {
    if (!curve.series) continue;
    if (const auto extent = curve.series->extent(span_.first, span_.second))
      add(extent->first, extent->second);
    // The line begins at the sample before.
    if (const auto before = curve.series->at(span_.first)) add(before->value, before->value);
  }
  if (!all) return {0, 1};
  double high = all->second - all->first;
  // A single value: a range around it.
  if (!(high > std::max(std::abs(all->first), std::abs(all->second)) * 1e-9))
    high = std::max(std::abs(all->first) * 0.2, 1.0);
  if (!std::isfinite(high)) return {-1e300, 1e300};
  const double middle = all->first / 2 + all->second / 2;
  const double half = high / 2 * (1 + 2 * kPlotMargin);
  return {middle - half, middle + half};
}

PlotWidget::Range PlotWidget::values() const {
  if (fixed_) return *fixed_;
  if (!auto_) auto_ = autoValues();
  return *auto_;
}

double PlotWidget::timeAt(double x_px) const {
  const QRect area = this->area();
  return span_.first + (x_px - area.left()) / area.width() * (span_.second - span_.first);
}

double PlotWidget::xOf(double at_s) const {
  const QRect area = this->area();
  return area.left() + (at_s - span_.first) / (span_.second - span_.first) * area.width();
}

double PlotWidget::yOf(double value) const {
  const QRect area = this->area();
  const auto [least, greatest] = values();
  return area.bottom() - (value - least) / (greatest - least) * area.height();
}

QString PlotWidget::valueAtCursor(std::size_t curve) const {
  const std::optional<double> at_s = pointed_s_ ? pointed_s_ : cursor_s_ ? cursor_s_ : present_s_;
  const PlotCurve& of = curves_[curve];
  const auto sample = at_s && of.series ? of.series->at(*at_s) : std::nullopt;
  // No value here, or none anywhere: an invalid name must not look like a gap.
  if (!sample && of.series && of.series->empty() && !of.series->covered().empty()) return tr("none yet");
  if (!sample) return QStringLiteral("–");
  const QString unit = plotUnit(of.selection);
  return unit.isEmpty() ? valueText(sample->value) : valueText(sample->value) + QChar(QChar::Nbsp) + unit;
}

void PlotWidget::want(double from_s, double until_s) {
  if (!std::isfinite(from_s) || !std::isfinite(until_s)) return;
  Q_EMIT spanWanted(from_s, until_s);
}

void PlotWidget::zoomTime(double factor, double about_s) {
  const double long_s = span_.second - span_.first,
               most_s = std::max(bounds_.second - bounds_.first, kShortest_s) * 1.1;
  factor = std::clamp(factor, kShortest_s / long_s, std::max(most_s / long_s, 1.0));
  want(about_s - (about_s - span_.first) * factor, about_s + (span_.second - about_s) * factor);
}

void PlotWidget::moveTime(double by_s) {
  // Part of the bag stays visible.
  const double keep_s = (span_.second - span_.first) / 10;
  by_s = std::clamp(by_s, std::min(bounds_.first - span_.second + keep_s, 0.0),
                    std::max(bounds_.second - span_.first - keep_s, 0.0));
  want(span_.first + by_s, span_.second + by_s);
}

void PlotWidget::zoomValues(double factor, double about) {
  const auto [least, greatest] = values();
  setFixedValues(Range{about - (about - least) * factor, about + (greatest - about) * factor});
}

void PlotWidget::moveValues(double by) {
  const auto [least, greatest] = values();
  setFixedValues(Range{least + by, greatest + by});
}

void PlotWidget::resizeEvent(QResizeEvent*) { refresh(); }

void PlotWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange ||
      event->type() == QEvent::FontChange)
    refresh();
  QWidget::changeEvent(event);
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
    QString name = plainWords(plotName(curves_[i].selection), 80);
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
  if (plotFromMime(*event->mimeData())) event->acceptProposedAction();
}

void PlotWidget::dropEvent(QDropEvent* event) {
  const auto selection = plotFromMime(*event->mimeData());
  if (!selection) return;
  event->acceptProposedAction();
  Q_EMIT dropped(*selection);
}

}  // namespace mapwright::ui

#include "moc_plot_widget.cpp"
