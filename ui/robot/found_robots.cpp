#include "ui/robot/found_robots.h"

#include <algorithm>
#include <chrono>

#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QToolButton>

#include "sentences/fault_sentence.h"
#include "sentences/found_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

/// What is silent for this long is no robot in the next room.
constexpr std::chrono::milliseconds kLookFor{6'000};
constexpr int kKindPx = 72;

}  // namespace

FoundRobots::FoundRobots(const robot::Addresses& addresses, QWidget* parent)
    : QWidget(parent),
      addresses_(addresses),
      state_(wrappedLabel({}, this)),
      list_(new QListWidget(this)),
      details_(new QToolButton(this)),
      reasons_(new QPlainTextEdit(this)) {
  list_->setObjectName(QStringLiteral("found"));
  list_->setAccessibleName(tr("Robots that answered"));
  list_->setUniformItemSizes(true);
  list_->setMinimumHeight(64);
  state_->setObjectName(QStringLiteral("foundState"));
  details_->setObjectName(QStringLiteral("foundDetails"));
  details_->setText(tr("Details"));
  details_->setToolTip(tr("Which ports were tried, and why no robot was found"));
  details_->setCheckable(true);
  details_->setAutoRaise(true);
  details_->setIcon(themedIcon(QStringLiteral("chevron-down")));
  details_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  reasons_->setObjectName(QStringLiteral("foundReasons"));
  reasons_->setAccessibleName(tr("Details"));
  reasons_->setReadOnly(true);
  reasons_->setTabChangesFocus(true);
  reasons_->setMinimumHeight(96);
  reasons_->hide();
  setLayout(columnOf(
      {rowOf({{state_, 1, Qt::AlignTop}, {details_, 0, Qt::AlignTop}}, 8), {list_, 1}, {reasons_, 1}}, 4,
      QMargins()));
  connect(details_, &QToolButton::toggled, reasons_, &QWidget::setVisible);
  connect(list_, &QListWidget::currentRowChanged, this, &FoundRobots::changed);
  connect(list_, &QListWidget::itemActivated, this, [this] {
    if (const auto robot = chosen()) Q_EMIT wanted(*robot);
  });
}

FoundRobots::~FoundRobots() { search_.reset(); }

void FoundRobots::look(const QString& called, std::vector<robot::Probe> probes) {
  called_ = called;
  stopped_ = false;
  found_.clear();
  list_->clear();
  search_ = std::make_unique<jobs::RobotSearch>(std::move(probes), kLookFor);
  connect(search_.get(), &jobs::RobotSearch::changed, this, &FoundRobots::refresh);
  connect(search_.get(), &jobs::RobotSearch::ended, this, &FoundRobots::refresh);
  refresh();
}

void FoundRobots::stop() {
  if (!looking()) return;
  stopped_ = true;
  // Not from within its own signal: what it has told stays.
  search_.release()->deleteLater();
  refresh();
}

bool FoundRobots::looking() const { return search_ && !search_->over(); }

std::optional<robot::FoundRobot> FoundRobots::chosen() const {
  const int row = list_->currentRow();
  return row >= 0 && row < int(found_.size()) ? std::optional(found_[std::size_t(row)]) : std::nullopt;
}

void FoundRobots::refresh() {
  if (search_) fill();
  const auto count = qint64(found_.size());
  QString text;
  if (looking()) {
    const auto& rows = search_->rows();
    const auto answered =
        std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.answer.has_value(); });
    text =
        tr("Looking at %1: %2 of %3 asked …").arg(words::plainName(called_)).arg(answered).arg(rows.size());
  } else if (count > 0) {
    text = sentences::counted(tr("%1 ways to connect to %2", nullptr, sentences::formOf(count)), count)
               .replace(QLatin1String("%2"), words::plainName(called_));
  } else {
    text = stopped_ ? tr("Stopped. Nothing has answered at %1 yet.").arg(words::plainName(called_))
                    : noneReason();
  }
  state_->setText(text);
  setTextColor(*state_,
               !looking() && count == 0 && !stopped_ ? appColors().error_text : appColors().secondary_text);
  list_->setVisible(count > 0 || looking());
  Q_EMIT changed();
}

QString FoundRobots::noneReason() const {
  const QString called = words::plainName(called_);
  const auto* const row = search_ ? search_->mostTelling() : nullptr;
  if (!row) return tr("No robot answers at %1. Is it switched on, and in this network?").arg(called);
  const QString reason = words::plainText(sentences::wordsOf(row->answer->reason));
  return row->answer->somebody
             ? tr("No robot answers at %1. %2: %3.").arg(called, row->server.toString(), reason)
             : tr("No robot answers at %1: %2. Is it switched on, and in this network?").arg(called, reason);
}

void FoundRobots::fill() {
  QStringList reasons;
  for (const auto& row : search_->rows()) {
    if (row.answer && row.answer->found.empty())
      reasons
          << tr("%1, %2: %3").arg(row.title, row.server.toString(), sentences::wordsOf(row.answer->reason));
  }
  reasons_->setPlainText(words::plainText(reasons.join(QLatin1Char('\n'))));
  const std::vector<robot::FoundRobot> found = search_->found();
  if (found == found_) return;
  const auto before = chosen();
  found_ = found;
  list_->clear();
  int selected = 0;
  for (const robot::FoundRobot& robot : found_) {
    if (before && robot == *before) selected = list_->count();
    auto* const item = new QListWidgetItem(list_);
    const QString kind = addresses_.titleOf(robot.address);
    const QString says = words::plainName(sentences::foundCalled(robot));
    item->setData(Qt::AccessibleTextRole, words::listed(QStringList{kind, says, robot.address}));
    item->setSizeHint({0, 28});
    auto* const row = new QWidget(list_);
    auto* const title = new PlainLabel(kind, row);
    title->setFixedWidth(kKindPx);
    auto* const told = new PlainLabel(says, row);
    auto* const address = new PlainLabel(robot.address, row);
    address->setSecondary(true);
    address->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    address->setElideMode(Qt::ElideMiddle);
    row->setLayout(rowOf({title, {told, 1}, {address, 1}}, 12, QMargins(8, 0, 8, 0)));
    list_->setItemWidget(item, row);
  }
  if (!found_.empty()) list_->setCurrentRow(selected);
}

}  // namespace mapwright::ui

#include "moc_found_robots.cpp"
