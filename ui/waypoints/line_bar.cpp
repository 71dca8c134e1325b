#include "ui/waypoints/line_bar.h"

#include <algorithm>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr int kLineBarMarginPx = 16;
constexpr int kPrefixPx = 130, kNumberPx = 64, kLongestPrefix = 400, kMostStep = 1'000, kMostFromDigits = 9;

}  // namespace

LineBar::LineBar(LineTool* tool, WaypointEditing* editing, QWidget* map)
    : QFrame(map),
      tool_(tool),
      editing_(editing),
      spacing_(numberField(this, {.least = LineTool::kLeastSpacingM,
                                  .most = LineTool::kMostSpacingM,
                                  .decimals = 2,
                                  .step = 0.25,
                                  .name = tr("Distance between two waypoints")})),
      prefix_(new QLineEdit(QStringLiteral("Waypoint "), this)),  // it is stored, whatever language is spoken
      first_(new QLineEdit(this)),
      step_(new WholeBox(this)),
      count_(new PlainLabel(this)),
      names_(new PlainLabel(this)),
      create_(new QPushButton(tr("Create"), this)),
      close_(new QPushButton(tr("Cancel"), this)) {
  spacing_->setAlignment(Qt::AlignLeft);
  setObjectName(QStringLiteral("card"));
  setCursor(Qt::ArrowCursor);
  setLongest(*prefix_, kLongestPrefix);
  prefix_->setAccessibleName(tr("What their names begin with"));
  prefix_->setMinimumWidth(kPrefixPx);
  first_->setAccessibleName(tr("First number"));
  first_->setToolTip(
      tr("The first number, with as many digits as all shall have: 1, 01, 001. Empty: the next "
         "free one"));
  first_->setFixedWidth(kNumberPx);
  step_->setRange(1, kMostStep);
  step_->setAccessibleName(tr("Step from number to number"));
  step_->setFixedWidth(kNumberPx);
  const auto labelled = [this](const QString& text, QWidget* buddy) {
    auto* const label = new QLabel(text, this);
    label->setBuddy(buddy);
    return label;
  };
  count_->setSample(tr("%1 on 123.45 m").arg(waypointsText(1888)));
  names_->setSample(QStringLiteral("x"));
  names_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  names_->setSecondary(true);
  create_->setObjectName(QStringLiteral("primary"));
  close_->setObjectName(QStringLiteral("secondary"));
  auto* const rows = columnOf({rowOf({labelled(tr("&Spacing"), spacing_), spacing_, LayoutItem::gap(8),
                                      LayoutItem(count_, 1), close_, create_},
                                     8),
                               rowOf({labelled(tr("&Names"), prefix_), prefix_, labelled(tr("fr&om"), first_),
                                      first_, labelled(tr("ste&p"), step_), step_},
                                     8),
                               names_},
                              8, QMargins(12, 8, 12, 8));
  setLayout(rows);
  hide();
  connect(spacing_, &QDoubleSpinBox::valueChanged, tool_, &LineTool::setSpacing);
  connect(prefix_, &QLineEdit::textChanged, this, &LineBar::refreshNames);
  connect(first_, &QLineEdit::textChanged, this, &LineBar::refreshNames);
  connect(step_, &QSpinBox::valueChanged, this, &LineBar::refreshNames);
  connect(create_, &QPushButton::clicked, this, &LineBar::createWanted);
  connect(close_, &QPushButton::clicked, this, &LineBar::closed);
  connect(tool_, &LineTool::lineChanged, this, &LineBar::refresh);
  // What is typed next is their name, and no command.
  connect(tool_, &LineTool::lineEnded, this, [this] {
    prefix_->setFocus();
    prefix_->selectAll();
  });
  connect(tool_, &LineTool::activated, this, [this](bool active) {
    // Otherwise the focus would hop to some button.
    if (!active && isAncestorOf(QApplication::focusWidget())) parentWidget()->setFocus();
    setVisible(active);
    layOut();
    if (active) raise();
  });
  const auto look_anew = [this] {
    taken_.reset();
    if (isVisible()) refreshNames();
  };
  connect(editing_, &WaypointEditing::opened, this, [this, look_anew] {
    if (editing_->document())
      connect(editing_->document(), &edit::WaypointDocument::changed, this, look_anew);
    look_anew();
  });
  map->installEventFilter(this);
  refresh();
}

QString LineBar::countShown() const { return count_->text(); }
QString LineBar::namesShown() const { return names_->text(); }

const exchange::TakenNames& LineBar::taken() const {
  if (!taken_) taken_ = editing_->names();
  return *taken_;
}

/// Why the names cannot be counted from what is typed; empty if they can.
QString LineBar::notFromReason() const {
  static const QRegularExpression number(QStringLiteral("^\\d{0,%1}$").arg(kMostFromDigits));
  return number.match(first_->text().trimmed()).hasMatch()
             ? QString()
             : tr("The first number has digits only, at most %1.").arg(kMostFromDigits);
}

exchange::SeriesNames LineBar::series() const {
  return exchange::namesOf({prefix_->text(), first_->text(), step_->value()},
                           qsizetype(tool_->spots().size()), taken());
}

QStringList LineBar::names() const { return series().names; }

void LineBar::onCreated() { first_->clear(); }

void LineBar::refreshNames() {
  first_->setPlaceholderText(exchange::nextNumber(prefix_->text(), taken()));
  const QString unavailable_reason = notFromReason();
  create_->setEnabled(tool_->ready() && !tool_->spots().empty() && unavailable_reason.isEmpty());
  names_->setSecondary(unavailable_reason.isEmpty());
  if (!unavailable_reason.isEmpty()) return names_->setText(unavailable_reason);
  const exchange::SeriesNames series = this->series();
  const auto shown = [](const QString& name) { return words::plainName(name); };
  QString text;
  if (series.names.size() == 1) text = shown(series.names.front());
  if (series.names.size() > 1)
    text = tr("%1 … %2").arg(shown(series.names.front()), shown(series.names.back()));
  if (series.skipped.size() == 1) text += tr("; %1 is taken and left out").arg(shown(series.skipped.front()));
  if (series.skipped.size() > 1)
    text += sentences::counted(
        tr("; %1 names are taken and left out", nullptr, sentences::formOf(series.skipped.size())),
        series.skipped.size());
  names_->setText(text);
}

void LineBar::refresh() {
  const QSignalBlocker quiet(spacing_);
  if (!spacing_->hasFocus()) spacing_->setValue(tool_->spacing());
  const auto count = qsizetype(tool_->spots().size());
  const QString length = QLocale::c().toString(tool_->length(), 'f', 2);
  count_->setText(tool_->length() <= 0 ? tr("No line yet")
                  : count == 0 ? tr("More than %1").arg(waypointsText(qsizetype(placing::kMostAlongLine)))
                               : tr("%1 on %2 m").arg(waypointsText(count), length));
  refreshNames();
}

void LineBar::layOut() {
  const QWidget* const map = parentWidget();
  const QSize size =
      sizeHint().boundedTo({std::max(map->width(), minimumSizeHint().width()), QWIDGETSIZE_MAX});
  setGeometry(std::max(0, (map->width() - size.width()) / 2),
              map->height() - size.height() - kLineBarMarginPx, size.width(), size.height());
}

bool LineBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) layOut();
  return QFrame::eventFilter(watched, event);
}

void LineBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (create_->isEnabled()) Q_EMIT createWanted();
    return;
  }
  if (event->key() == Qt::Key_Escape) {
    // As on the map: first the line, then the tool.
    if (!tool_->ready()) return Q_EMIT closed();
    parentWidget()->setFocus();
    return tool_->forget();
  }
  QFrame::keyPressEvent(event);
}

}  // namespace mapwright::ui

#include "moc_line_bar.cpp"
