#include "ui/robot/robot_dock.h"

#include <algorithm>

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "robot/offers_topics.h"
#include "robot/slam_file.h"
#include "sentences/absence_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/replay_state.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kRobotRefreshMs = 200, kRobotTickMs = 1000;
constexpr std::size_t kMostAlerts = 100;

map::Streams statusStreams() {
  using map::Stream;
  return {Stream::Battery, Stream::Wheels,  Stream::Alerts,           Stream::Planning,
          Stream::Sensors, Stream::MapInfo, Stream::GlobalPositioning};
}

PlainLabel* robotHeading(const QString& text, QWidget* parent) {
  auto* label = new PlainLabel(text, parent);
  makeHeading(*label);
  return label;
}

/// The names of the fields: while these are the same, only the values change.
bool sameShape(const std::vector<StatusSection>& a, const std::vector<StatusSection>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.title == y.title && std::equal(x.fields.begin(), x.fields.end(), y.fields.begin(),
                                            y.fields.end(), [](const auto& f, const auto& g) {
                                              return f.name == g.name &&
                                                     f.bar.has_value() == g.bar.has_value();
                                            });
  });
}

}  // namespace

RobotDock::RobotDock(QWidget* parent)
    : QDockWidget(tr("Robot"), parent),
      link_(new StateLabel(this)),
      stale_(new PlainLabel(this)),
      limits_(textLabel({}, this)),
      fields_(new QWidget(this)),
      alert_box_(new QWidget(this)),
      grid_(new QGridLayout(fields_)),
      alert_column_(new QVBoxLayout(alert_box_)) {
  setObjectName(QStringLiteral("robot"));
  auto* body = new QWidget;
  link_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  stale_->setSecondary(true);
  limits_->setObjectName(QStringLiteral("limits"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
  alert_column_->setContentsMargins(0, 0, 0, 0);
  alert_column_->setSpacing(6);
  body->setLayout(
      columnOf({link_, stale_, limits_, alert_box_, fields_, LayoutItem::rest()}, 4, QMargins(8, 8, 8, 8)));
  setScrolledWidget(*this, body);
  refresh_timer_.setSingleShot(true);
  refresh_timer_.setInterval(kRobotRefreshMs);
  connect(&refresh_timer_, &QTimer::timeout, this, &RobotDock::refresh);
  tick_.setInterval(kRobotTickMs);
  connect(&tick_, &QTimer::timeout, this, &RobotDock::refresh);
  refresh();
}

void RobotDock::setSession(session::Session* session) {
  if (session_) session_->disconnect(this);
  session_ = session;
  alerts_known_ = false;
  if (session) {
    connect(session, &session::Session::liveChanged, this, [this](int what) {
      using map::topicIndex;
      // Poses and points arrive many times a second; of other robots they are not shown here.
      if ((what == topicIndex<map::TrackedPose>() && !ofTopics()) ||
          what == topicIndex<map::PointCloudMessage>() || what == topicIndex<map::GridMessage>())
        return;
      if (what == topicIndex<map::AlertsMessage>()) alerts_known_ = true;
      if (!refresh_timer_.isActive()) refresh_timer_.start();
    });
    connect(session, &session::Session::frameChanged, this, &RobotDock::refresh);
    connect(session, &session::Session::connectionChanged, this, &RobotDock::refresh);
    session->want(QStringLiteral("status"), statusStreams());
  }
  refresh();
}

bool RobotDock::ofTopics() const { return session_ && robot::topicsOfferedBy(session_->robot()); }

void RobotDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  refresh();
}

void RobotDock::refresh() {
  const auto silent = session_ ? silentOnline(*session_) : std::nullopt;
  if (silent && !tick_.isActive()) tick_.start();
  if (!silent) tick_.stop();
  link_->setState(session_ ? sourceText(session_).value_or(linkText(session_->connection(), silent))
                           : StateText{Mark::Neutral, tr("No robot connected")});
  const auto since = session_ ? valuesAsOf(*session_) : std::nullopt;
  greyed_ = since.has_value();
  stale_->setVisible(greyed_);
  if (since) {
    stale_->setText(
        tr("Values as of %1, no longer live").arg(QLocale::c().toString(*since, QStringLiteral("HH:mm:ss"))));
  }
  const bool is_state_file = session_ && !robot::slamFileOf(session_->robot()).isEmpty();
  const QString limits = is_state_file ? tr("This is a file: there is no robot whose state could be shown.")
                         : session_    ? sentences::limitsOf(session_->robot())
                                       : QString();
  limits_->setText(words::plainText(limits));
  limits_->setVisible(!limits.isEmpty());
  setTextColor(*limits_, appColors().secondary_text);
  if (session_) {
    std::vector<StatusSection> sections = statusSections(session_->live());
    if (ofTopics()) {
      for (StatusSection& one : topicSections(session_->live())) sections.push_back(std::move(one));
    }
    showSections(std::move(sections));
    const bool live = session_->robot().liveTopics() != nullptr;
    showAlerts(alertLines(session_->live().alerts, QDateTime::currentDateTime()), live && alerts_known_);
  } else {
    showSections({});
    showAlerts({}, false);
  }
  fields_->setEnabled(!greyed_);
  alert_box_->setEnabled(!greyed_);
}

void RobotDock::showSections(std::vector<StatusSection> sections) {
  if (sections == sections_) return;
  if (!sameShape(sections, sections_)) {
    while (QLayoutItem* item = grid_->takeAt(0)) {
      item->widget()->hide();
      item->widget()->deleteLater();
      delete item;
    }
    cells_.clear();
    int line = 0;
    for (const StatusSection& section : sections) {
      PlainLabel* title = robotHeading(section.title, fields_);
      grid_->addWidget(title, line++, 0, 1, 3);
      title->setContentsMargins(0, 4, 0, 0);
      for (const StatusField& field : section.fields) {
        auto* name = new PlainLabel(field.name, fields_);
        name->setSecondary(true);
        auto* value = new StateLabel(fields_);
        value->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        ThinBar* bar = field.bar ? new ThinBar(fields_) : nullptr;
        grid_->addWidget(name, line, 0);
        grid_->addWidget(value, line, 1, 1, bar ? 1 : 2);
        if (bar) grid_->addWidget(bar, line, 2);
        cells_.push_back({value, bar});
        ++line;
      }
    }
  }
  sections_ = std::move(sections);
  std::size_t at = 0;
  for (const StatusSection& section : sections_) {
    for (const StatusField& field : section.fields) {
      const Cells& cells = cells_[at++];
      cells.value->setState({field.mark, field.value});
      cells.value->setStrong(field.mark == Mark::Bad);
      if (cells.bar) cells.bar->setFraction(*field.bar);
    }
  }
}

QWidget* RobotDock::alertRow(const AlertLine& line) {
  auto* row = new QWidget(alert_box_);
  auto* head = new StateLabel(row);
  head->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  head->setState({line.mark, QStringLiteral("%1 %2%3").arg(
                                 line.level, line.code,
                                 line.since.isEmpty() ? QString() : tr(", since ") + line.since)});
  QLabel* text = textLabel(line.text, row);
  text->setContentsMargins(20, 0, 0, 0);
  row->setLayout(columnOf({head, text}, 0, QMargins()));
  text->setVisible(!line.text.isEmpty());
  return row;
}

void RobotDock::showAlerts(std::vector<AlertLine> lines, bool known) {
  if (lines == alerts_ && drawn_alerts_known_ == known) return;
  alerts_ = std::move(lines);
  drawn_alerts_known_ = known;
  while (QLayoutItem* item = alert_column_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  if (!known && alerts_.empty()) return;
  const QString title = alerts_.empty() ? tr("No alerts")
                                        : sentences::counted(tr("%1 alerts", nullptr, int(alerts_.size())),
                                                             qint64(alerts_.size()));
  alert_column_->addWidget(robotHeading(title, alert_box_));
  for (std::size_t i = 0; i < std::min(kMostAlerts, alerts_.size()); ++i)
    alert_column_->addWidget(alertRow(alerts_[i]));
  if (alerts_.size() > kMostAlerts) {
    alert_column_->addWidget(
        new PlainLabel(tr("and %1 more").arg(countText(qint64(alerts_.size() - kMostAlerts))), alert_box_));
  }
}

QString RobotDock::limitsShown() const { return limits_->isHidden() ? QString() : limits_->text(); }

QString RobotDock::shownText() const {
  QStringList lines{link_->state().text};
  if (!stale_->isHidden()) lines << stale_->text();
  if (!limits_->isHidden()) lines << limits_->text();
  if (alerts_known_ && alerts_.empty()) lines << tr("No alerts");
  for (const AlertLine& alert : alerts_)
    lines << tr("%1 %2 %3 since %4").arg(alert.level, alert.code, alert.text, alert.since);
  for (const StatusSection& section : sections_) {
    for (const StatusField& field : section.fields)
      lines << QStringLiteral("%1 / %2: %3").arg(section.title, field.name, field.value);
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace mapwright::ui

#include "moc_robot_dock.cpp"
