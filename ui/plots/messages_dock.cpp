#include "ui/plots/messages_dock.h"

#include <QCompleter>
#include <QElapsedTimer>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QStringListModel>
#include <QTableView>

#include "sentences/absence_sentence.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/pretty_json.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/wrapping_row.h"
#include "ui/plots/message_view.h"
#include "ui/view/replay_state.h"

namespace mapwright::ui {

namespace {

constexpr int kSideBySidePx = 620;  // the topics and a message
constexpr int kMessagesRefreshMs = 200, kIdleMs = 1'000;
const QString kOwner = QStringLiteral("messages");

/// Long lists in it are shortened: "… 68" stands for 68 items (net::rosbridge::Field::toJson).
bool isShortened(const QByteArray& text) { return text.contains("\"\xe2\x80\xa6 "); }

std::function<qint64()> elapsedClock() {
  QElapsedTimer timer;
  timer.start();
  return [timer] { return timer.elapsed(); };
}

}  // namespace

MessagesDock::MessagesDock(std::function<qint64()> monotonic, QWidget* parent)
    : QDockWidget(tr("Messages"), parent),
      monotonic_(monotonic ? std::move(monotonic) : elapsedClock()),
      model_(new TopicsModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QuietTableView(this)),
      message_(new MessageView(this)),
      caption_(new PlainLabel(this)),
      more_(wrappedLabel({}, this)),
      filter_(new QLineEdit(this)),
      topic_(new QLineEdit(this)),
      known_(new QStringListModel(this)),
      add_(new QPushButton(tr("Listen"), this)),
      pause_(new QPushButton(tr("Pause"), this)),
      clear_(new QPushButton(tr("Clear"), this)),
      copy_(new QPushButton(tr("Copy"), this)) {
  setObjectName(QStringLiteral("messages"));
  buildTable();
  message_->setReadOnly(true);
  message_->setUndoRedoEnabled(false);
  message_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  message_->setLineWrapMode(MessageView::NoWrap);
  message_->setFrameShape(QFrame::NoFrame);
  message_->setAccessibleName(tr("Last message"));
  connect(message_, &MessageView::plotWanted, this, &MessagesDock::plotWanted);
  more_->setContentsMargins(8, 2, 8, 4);
  caption_->setSecondary(true);
  caption_->setSample(QStringLiteral("x"));
  caption_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

  auto* right = new QWidget(this);
  right->setLayout(columnOf({caption_, {message_, 1}}, 2, QMargins(8, 2, 0, 0)));
  split_ = new QSplitter(Qt::Horizontal, this);
  split_->addWidget(table_);
  split_->addWidget(right);
  split_->setSizes({560, 300});
  split_->setStretchFactor(1, 1);
  split_->setHandleWidth(1);
  split_->setChildrenCollapsible(false);
  auto* body = new QWidget(this);
  body->setLayout(columnOf({buildControls(), {split_, 1}, more_}, 0, QMargins()));
  setWidget(body);

  refresh_timer_.setSingleShot(true);
  connect(&refresh_timer_, &QTimer::timeout, this, &MessagesDock::refresh);
  connect(this, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    on_screen_ = visible;
    updateWatching();
    if (visible) refresh();
  });
  // In a hidden tab the topics stay subscribed; closing the dock unsubscribes.
  connect(toggleViewAction(), &QAction::toggled, this, [this](bool open) {
    if (open || asked_.isEmpty()) return;
    asked_.clear();
    log_.setAskedFor(asked_);
    if (session_) session_->want(kOwner, {}, asked_);
  });
  refresh();
}

MessagesDock::~MessagesDock() {
  if (table_->selectionModel()) table_->selectionModel()->disconnect(this);
  // Only ours: what Qt keeps of it for screen readers would outlive it.
  disconnect(this, &QDockWidget::visibilityChanged, this, nullptr);
}

QWidget* MessagesDock::buildControls() {
  auto* box = new QWidget(this);
  auto* row = new WrappingRow;
  box->setLayout(row);
  filter_->setPlaceholderText(tr("Filter topics"));
  filter_->setClearButtonEnabled(true);
  filter_->setAccessibleName(tr("Filter topics"));
  topic_->setPlaceholderText(tr("/topic to subscribe to"));
  topic_->setAccessibleName(tr("Topic to subscribe to"));
  setLongest(*topic_, 300);
  auto* completer = new QCompleter(known_, topic_);
  completer->setFilterMode(Qt::MatchContains);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  topic_->setCompleter(completer);
  add_->setToolTip(tr("Subscribe to this topic while this panel is open"));
  pause_->setCheckable(true);
  pause_->setToolTip(tr("Freeze the display; nothing is received meanwhile"));
  clear_->setIcon(themedIcon(QStringLiteral("trash")));
  copy_->setIcon(themedIcon(QStringLiteral("copy")));
  copy_->setToolTip(tr("Copy the message as it was received"));
  for (QPushButton* button : {add_, pause_, clear_, copy_}) button->setObjectName(QStringLiteral("compact"));
  row->add(filter_, 2);
  row->add(topic_, 2, 180);
  for (QPushButton* button : {add_, pause_, clear_, copy_}) row->add(button);
  connect(filter_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
  connect(topic_, &QLineEdit::returnPressed, this, &MessagesDock::addTopic);
  connect(topic_, &QLineEdit::textChanged, this,
          [this](const QString& text) { add_->setEnabled(session_ && !text.trimmed().isEmpty()); });
  connect(add_, &QPushButton::clicked, this, &MessagesDock::addTopic);
  connect(pause_, &QPushButton::toggled, this, [this](bool paused) {
    pause_->setText(paused ? tr("Resume") : tr("Pause"));
    updateWatching();
    refresh();
  });
  connect(clear_, &QPushButton::clicked, this, [this] {
    log_.clear();
    log_.beginRatesAnew(now());
    shown_count_ = 0;
    refresh();
    showMessage(true);
  });
  connect(copy_, &QPushButton::clicked, this, [this] {
    const TopicTally* const tally = log_.find(chosen_);
    if (!tally) return;
    const bool all = !tally->cut && !isShortened(tally->text);
    Q_EMIT copyWanted(QString::fromUtf8(tally->text),
                      all ? tr("Message copied") : tr("Message copied as shown, shortened"));
  });
  return box;
}

void MessagesDock::resizeEvent(QResizeEvent* event) {
  QDockWidget::resizeEvent(event);
  const bool narrow = width() < kSideBySidePx;
  if (narrow == (split_->orientation() == Qt::Vertical)) return;
  split_->setOrientation(narrow ? Qt::Vertical : Qt::Horizontal);
  // The topics have more columns than the message has.
  narrow ? split_->setSizes({300, 300}) : split_->setSizes({560, 300});
}

void MessagesDock::buildTable() {
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(TopicsModel::kSortRole);
  sorted_->setFilterKeyColumn(TopicsModel::TopicColumn);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  showRows(*table_, sorted_, tr("Topics"), 22);
  table_->setSortingEnabled(true);
  table_->sortByColumn(TopicsModel::TopicColumn, Qt::AscendingOrder);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(40);
  const int digit = fontMetrics().horizontalAdvance(QLatin1Char('0'));
  const auto room = [&](int column, int digits) { header->resizeSection(column, digit * digits + 14); };
  room(TopicsModel::TypeColumn, 6);
  room(TopicsModel::CountColumn, 7);
  room(TopicsModel::RateColumn, 4);
  room(TopicsModel::BytesRateColumn, 7);
  room(TopicsModel::SizeColumn, 7);
  room(TopicsModel::TimeColumn, 7);
  new NameColumn(table_, header, TopicsModel::TopicColumn,
                 {{TopicsModel::TypeColumn},
                  {TopicsModel::SizeColumn},
                  {TopicsModel::BytesRateColumn},
                  {TopicsModel::TimeColumn},
                  {TopicsModel::CountColumn},
                  {TopicsModel::RateColumn}});
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            if (!index.isValid()) return;
            const QString topic = model_->topicAt(sorted_->mapToSource(index).row());
            if (topic == chosen_) return;
            chosen_ = topic;
            showMessage(true);
          });
  connect(table_, &QTableView::customContextMenuRequested, this, &MessagesDock::showMenu);
}

void MessagesDock::setSession(session::Session* session) {
  if (session_) {
    if (asks_ && session_->robot().liveTopics()) session_->robot().liveTopics()->setWatching(false);
    session_->robot().disconnect(this);
  }
  watching_ = asks_ = false;
  session_ = session;
  asked_.clear();
  log_ = {};
  log_.setRecorded(replayOf(session) != nullptr);
  chosen_.clear();
  shown_count_ = 0;
  robot::LiveTopics* const live = session ? session->robot().liveTopics() : nullptr;
  known_->setStringList(live ? live->known() : QStringList());
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, [this] {
      robot::LiveTopics* const now = session_->robot().liveTopics();
      known_->setStringList(now ? now->known() : QStringList());
      updateWatching();
      showMessage(true);
    });
    if (const replay::ReplayRobot* const replayed = replayOf(session))
      connect(replayed, &replay::ReplayRobot::jumped, this, [this] {
        expectAgain();
        if (now() == shown_ms_) return;  // only more data of the same time arrived
        shown_ms_ = now();
        log_.beginRatesAnew(shown_ms_);
      });
    connect(&session->robot(), &robot::Robot::rawReceived, this, [this](const robot::RawMessage& message) {
      if (!watching_) return;
      log_.record(message, replayOf(session_) ? message.received.toMSecsSinceEpoch() : now(),
                  retelling_ ? TopicLog::Telling::Again : TopicLog::Telling::New);
      if (dirty_) return;
      dirty_ = true;
      refresh_timer_.start(kMessagesRefreshMs);
    });
  }
  updateWatching();
  refresh();
  showMessage(true);
}

void MessagesDock::updateWatching() {
  robot::LiveTopics* const live = session_ ? session_->robot().liveTopics() : nullptr;
  const bool wanted = live && on_screen_ && !pause_->isChecked();
  for (QWidget* widget : {static_cast<QWidget*>(topic_), static_cast<QWidget*>(pause_)})
    widget->setEnabled(live != nullptr);
  add_->setEnabled(live && !topic_->text().trimmed().isEmpty());
  if (wanted && !watching_) log_.beginRatesAnew(now());
  watching_ = wanted;
  const bool asks = wanted || (live && wanted_elsewhere_);
  if (asks == asks_) return;
  asks_ = asks;
  if (live) live->setWatching(asks);
  if (asks) expectAgain();
}

void MessagesDock::setWantedElsewhere(bool wanted) {
  wanted_elsewhere_ = wanted;
  updateWatching();
}

void MessagesDock::refresh() {
  dirty_ = false;
  shown_ms_ = now();
  model_->sync(log_, shown_ms_);
  clear_->setEnabled(model_->rowCount() > 0);
  more_->setVisible(log_.dropped() > 0);
  more_->setText(
      tr("Only %1 topics are listed. Messages of others have come, too.").arg(TopicLog::kMaxTopics));
  showMessage(false);
  // Rates decrease even without messages: updated as long as there are rows. Those of a recording pause with
  // it.
  if (watching_ && model_->rowCount() > 0 && !replayOf(session_)) refresh_timer_.start(kIdleMs);
}

QString MessagesDock::moreShown() const { return more_->isHidden() ? QString() : more_->text(); }

void MessagesDock::expectAgain() {
  if (!replayOf(session_)) return;
  retelling_ = true;
  QMetaObject::invokeMethod(
      this, [this] { retelling_ = false; }, Qt::QueuedConnection);
}

qint64 MessagesDock::now() const {
  const replay::ReplayRobot* const replayed = replayOf(session_);
  return replayed ? qint64(replayed->at().value_or(0) * 1000) : monotonic_();
}

void MessagesDock::showMessage(bool force) {
  const TopicTally* const tally = log_.find(chosen_);
  copy_->setEnabled(tally && tally->count > 0);
  if (!tally || tally->count == 0) {
    if (force || shown_count_ > 0) message_->clear();
    shown_count_ = 0;
    QString hint;
    if (!session_) {
      hint = tr("Connect to a robot to see its messages.");
    } else if (!session_->robot().liveTopics()) {
      hint = sentences::absenceReason(robot::Capability::Live,
                                      session_->robot().unavailableReason(robot::Capability::Live));
    } else if (tally) {
      hint = tr("Nothing has arrived on %1 yet.").arg(plainWords(chosen_, 100));
    } else {
      hint = tr("Choose a topic to see its last message.");
    }
    caption_->setText(hint);
    return;
  }
  if (!force && tally->count == shown_count_) return;
  shown_count_ = tally->count;
  message_->setTopic(tally->binary ? QString() : chosen_);
  caption_->setText(tr("%1  %2, %3%4")
                        .arg(plainWords(chosen_, 100), tally->last.toString(QStringLiteral("HH:mm:ss.zzz")),
                             bytesText(tally->last_bytes),
                             tally->cut                 ? tr(", truncated")
                             : isShortened(tally->text) ? tr(", long lists shortened")
                                                        : QString()));
  const int down = message_->verticalScrollBar()->value();
  const int across = message_->horizontalScrollBar()->value();
  message_->setPlainText(prettyJson(tally->text));
  message_->verticalScrollBar()->setValue(down);
  message_->horizontalScrollBar()->setValue(across);
}

QStringList MessagesDock::knownTopics() const {
  QStringList topics = known_->stringList();
  for (const auto& [topic, tally] : log_.topics()) topics << topic;
  topics.removeDuplicates();
  return topics;
}

void MessagesDock::chooseTopic(const QString& topic) {
  refresh();
  if (!log_.find(topic)) listenTo(topic);
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (model_->topicAt(row) != topic) continue;
    const auto shown = [&] { return sorted_->mapFromSource(model_->index(row, 0)); };
    if (!shown().isValid()) filter_->clear();
    return table_->setCurrentIndex(shown());
  }
}

void MessagesDock::listenTo(const QString& topic) {
  if (!session_) return;
  if (!asked_.contains(topic)) asked_ << topic;
  log_.setAskedFor(asked_);
  session_->want(kOwner, {}, asked_);
  refresh();
}

void MessagesDock::addTopic() {
  QString topic = topic_->text().trimmed();
  if (topic.isEmpty() || !session_) return;
  if (!topic.startsWith(QLatin1Char('/'))) topic.prepend(QLatin1Char('/'));
  topic_->clear();
  listenTo(topic);
  chooseTopic(topic);
}

void MessagesDock::dropTopic(const QString& topic) {
  asked_.removeAll(topic);
  log_.setAskedFor(asked_);
  if (session_) session_->want(kOwner, {}, asked_);
  refresh();
}

void MessagesDock::showMenu(const QPoint& at) {
  const QModelIndex index = table_->indexAt(at);
  const QString topic = index.isValid() ? model_->topicAt(sorted_->mapToSource(index).row()) : QString();
  if (topic.isEmpty()) return;
  QMenu menu(this);
  menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy topic"), this,
                 [this, topic] { Q_EMIT copyWanted(topic, tr("Topic copied")); });
  if (asked_.contains(topic))
    menu.addAction(tr("Unsubscribe from it"), this, [this, topic] { dropTopic(topic); });
  menu.exec(table_->viewport()->mapToGlobal(at));
}

}  // namespace mapwright::ui

#include "moc_messages_dock.cpp"
