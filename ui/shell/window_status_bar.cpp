#include "ui/shell/window_status_bar.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/view/replay_state.h"

namespace mapwright::ui {

namespace {

constexpr int kMapNamePx = 200;
// Enough for the usual ones.
constexpr double kScaleKept = 0.93, kRotationKept = 0.45;

/// Keeps a part of its text while there is room for that. (A minimum width would be kept in any case, and the
/// labels of a crowded bar would lie over each other.)
class BarLabel : public PlainLabel {
 public:
  explicit BarLabel(QWidget* parent, double kept = 1, int most_px = QWIDGETSIZE_MAX)
      : PlainLabel(parent), kept_(kept), most_px_(most_px) {}
  QSize minimumSizeHint() const override {
    const QSize hint = sizeHint();
    return {std::min(int(hint.width() * kept_), most_px_), hint.height()};
  }

 private:
  double kept_;
  int most_px_;
};

}  // namespace

ThinBar::ThinBar(QWidget* parent) : QWidget(parent) { setFixedSize(64, 20); }

void ThinBar::setFraction(double fraction) {
  if (fraction == fraction_) return;
  fraction_ = fraction;
  update();
}

void ThinBar::paintEvent(QPaintEvent*) {
  const UiColors colors = isEnabled() ? appColors() : greyed(appColors());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QRectF track(0, height() / 2.0 - 2, width(), 4);
  painter.setBrush(colors.border);
  painter.drawRoundedRect(track, 2, 2);
  painter.setBrush(colors.accent);
  painter.drawRoundedRect(
      QRectF(track.left(), track.top(), qMax(4.0, track.width() * qBound(0.0, fraction_, 1.0)), 4), 2, 2);
}

StateLabel::StateLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void StateLabel::setState(const StateText& state) {
  if (state == state_) return;
  const bool wider =
      fontMetrics().horizontalAdvance(state.text) != fontMetrics().horizontalAdvance(state_.text);
  state_ = state;
  setAccessibleName(state.text);
  if (wider) updateGeometry();
  update();
}

void StateLabel::setStrong(bool strong) {
  if (strong == strong_) return;
  strong_ = strong;
  QFont heavy = font();
  heavy.setWeight(strong ? QFont::Bold : QFont::Normal);
  setFont(heavy);
  update();
}

QSize StateLabel::sizeHint() const { return {fontMetrics().horizontalAdvance(state_.text) + 24, 20}; }
QSize StateLabel::minimumSizeHint() const { return {qMin(sizeHint().width(), 120), 20}; }

void StateLabel::paintEvent(QPaintEvent*) {
  const UiColors colors = isEnabled() ? appColors() : greyed(appColors());
  QPainter painter(this);
  paintMark(&painter, QRectF(2, height() / 2.0 - 6, 12, 12), state_.mark, colors);
  painter.setPen(strong_       ? markTextColor(state_.mark, colors)
                 : isEnabled() ? colors.text
                               : colors.secondary_text);
  const QRect area = rect().adjusted(20, 0, 0, 0);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   fontMetrics().elidedText(state_.text, Qt::ElideRight, area.width()));
}

bool StateLabel::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), plainToolTip(state_.text), this);
    return true;
  }
  return QWidget::event(event);
}

WindowStatusBar::WindowStatusBar(QWidget* parent)
    : QStatusBar(parent),
      connection_(new StateLabel(this)),
      loading_(new BarLabel(this)),
      bar_(new ThinBar(this)),
      traffic_(new PlainLabel(this)),
      map_(new BarLabel(this, 1, kMapNamePx)),
      map_bar_(new ThinBar(this)),
      problems_(new QToolButton(this)),
      coordinates_(new BarLabel(this, 0)),
      occupancy_(new BarLabel(this, 0)),
      scale_(new BarLabel(this, kScaleKept)),
      rotation_(new BarLabel(this, kRotationKept)) {
  setSizeGripEnabled(false);
  setFixedHeight(28);
  // What it says comes and goes: the window is not to become wider for it. What is under the cursor gives way
  // first, then the longest text.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  problems_->setIcon(themedIcon(QStringLiteral("problem")));
  problems_->setIconSize({14, 14});
  problems_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  problems_->setFixedHeight(22);
  problems_->setToolTip(tr("Show the list of problems"));
  problems_->hide();
  coordinates_->setSample(QStringLiteral("x -12345.678 y -12345.678 m"));
  coordinates_->setAlignment(Qt::AlignRight);
  coordinates_->setHint(tr("World coordinates under the cursor"));
  occupancy_->setSample(QStringLiteral("occupied 100 %"));
  occupancy_->setHint(tr("Map value under the cursor"));
  scale_->setSample(QStringLiteral("1:100,000  12.5 cm/px"));
  scale_->setAlignment(Qt::AlignRight);
  scale_->setHint(tr("Scale of the map on this screen"));
  rotation_->setSample(QStringLiteral("-179.5°"));
  rotation_->setAlignment(Qt::AlignRight);
  rotation_->setHint(tr("Rotation of the view, counter-clockwise"));
  loading_->setSample({});
  traffic_->setSecondary(true);
  map_bar_->hide();

  auto* row = new QWidget(this);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(8, 0, 8, 0);
  line->setSpacing(10);
  line->addWidget(connection_, 0);
  line->addWidget(loading_, 0);
  line->addWidget(bar_, 0);
  line->addWidget(traffic_, 0);
  line->addWidget(map_, 0);
  line->addWidget(map_bar_, 0);
  line->addWidget(problems_, 0);
  line->addStretch(1);
  for (PlainLabel* label : {coordinates_, occupancy_, scale_, rotation_}) {
    label->setMaximumWidth(label->sizeHint().width());
    line->addWidget(label, 0);
  }
  for (ThinBar* bar : {bar_, map_bar_}) bar->setMinimumWidth(0);
  addWidget(row, 1);

  countdown_.setInterval(250);
  connect(&countdown_, &QTimer::timeout, this, &WindowStatusBar::refreshCountdown);
  connect(problems_, &QToolButton::clicked, this, &WindowStatusBar::problemsWanted);
  setSession(nullptr);
}

void WindowStatusBar::setSession(session::Session* session) {
  if (session_) {
    session_->disconnect(this);
    session_->wholeMap().disconnect(this);
  }
  session_ = session;
  if (session) {
    connect(&session->wholeMap(), &session::MapSlot::changed, this, &WindowStatusBar::refreshMap);
    connect(&session->wholeMap(), &session::MapSlot::rowsArrived, this, &WindowStatusBar::refreshMap);
    connect(session, &session::Session::connectionChanged, this, &WindowStatusBar::refreshConnection);
    connect(session, &session::Session::rowsChanged, this, &WindowStatusBar::refreshRows);
    connect(session, &session::Session::listChanged, this, &WindowStatusBar::refreshRows);
    connect(session, &session::Session::problemsChanged, this, &WindowStatusBar::refreshProblems);
  }
  refreshConnection();
  refreshRows();
  refreshMap();
  refreshProblems();
}

void WindowStatusBar::setInView(bool submaps, bool whole, const QString& submaps_of) {
  if (submaps == submaps_in_view_ && whole == whole_in_view_ && submaps_of == submaps_of_) return;
  submaps_of_ = submaps_of;
  submaps_in_view_ = submaps;
  whole_in_view_ = whole;
  refreshRows();
  refreshMap();
}

void WindowStatusBar::refreshConnection() {
  if (!session_) {
    countdown_.stop();
    connection_->setState({Mark::Neutral, tr("no robot")});
    return;
  }
  read_ = session_->connection();
  read_clock_.start();
  refreshCountdown();
}

void WindowStatusBar::refreshCountdown() {
  connection_->setState(
      sourceText(session_).value_or(linkText(read_, silentOnline(*session_), read_clock_.elapsed())));
  const bool counts =
      (read_.phase == robot::ConnectionPhase::Interrupted && read_.retry_in_ms) || silentOnline(*session_);
  if (counts && !countdown_.isActive()) countdown_.start();
  if (!counts) countdown_.stop();
}

void WindowStatusBar::refreshRows() {
  const session::SubmapCounts counts = session_ ? session_->counts() : session::SubmapCounts{};
  loading_->setText(session_ && submaps_in_view_ ? loadingText(counts) : QString());
  loading_->setHidden(loading_->text().isEmpty());
  traffic_->setText(trafficText(counts));
  traffic_->setHidden(traffic_->text().isEmpty());
  // The bar is only visible while something is loading.
  const bool loading = submaps_in_view_ && counts.listed > 0 && counts.pending + counts.updating > 0;
  if (bar_->isHidden() == loading) bar_->setVisible(loading);
  if (loading) bar_->setFraction(1.0 - double(counts.pending + counts.updating) / double(counts.listed));
}

void WindowStatusBar::refreshMap() {
  QString text;
  if (session_)
    text = whole_in_view_ ? mapShownText(session_->wholeMap()) : mapProgressText(session_->wholeMap());
  if (session_ && text.isEmpty() && submaps_in_view_ && !whole_in_view_) text = submaps_of_;
  map_->setText(text);
  if (map_->isHidden() != text.isEmpty()) map_->setVisible(!text.isEmpty());
  const bool reading = session_ && session_->wholeMap().phase() == session::MapSlot::Phase::Reading;
  if (map_bar_->isHidden() == reading) map_bar_->setVisible(reading);
  if (reading) map_bar_->setFraction(session_->wholeMap().progress());
}

void WindowStatusBar::refreshProblems() {
  const int unresolved = session_ ? session_->problems().unresolved() : 0;
  if (unresolved > 0) problems_->setText(problemsText(unresolved));
  if (problems_->isHidden() == (unresolved > 0)) problems_->setVisible(unresolved > 0);
}

void WindowStatusBar::showCursor(const QString& coordinates, const QString& occupancy) {
  coordinates_->setText(coordinates);
  occupancy_->setText(occupancy);
  for (PlainLabel* label : {coordinates_, occupancy_}) label->setHidden(label->text().isEmpty());
}

void WindowStatusBar::showView(const geometry::ViewTransform& view) {
  scale_->setText(scaleText(view.scale_m_per_px, logicalDpiX()));
  rotation_->setText(rotationText(view.rotation_rad));
}

QString WindowStatusBar::loadingShown() const { return loading_->text(); }
QString WindowStatusBar::mapShown() const { return map_->text(); }
QString WindowStatusBar::cursorShown() const { return coordinates_->text(); }
QString WindowStatusBar::occupancyShown() const { return occupancy_->text(); }
QString WindowStatusBar::scaleShown() const { return scale_->text(); }
QString WindowStatusBar::rotationShown() const { return rotation_->text(); }

}  // namespace mapwright::ui

#include "moc_window_status_bar.cpp"
